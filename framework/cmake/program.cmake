# gg_program(target folder id output_folder) builds the student's program <folder>/<id>.cpp as
# <output_folder>/<id> and keeps copies of its shaders, scene and other files beside it, so that it
# runs from anywhere; source_folder.txt there says where the shaders are that are edited. Further folders may be named whose JSON files (scene, declarations) it needs, too.
function(gg_program target folder id output_folder)
  add_executable(${target} ${folder}/${id}.cpp)
  target_link_libraries(${target} PRIVATE gg)
  if(NOT MSVC)
    # A function that is still to be written uses none of its parameters.
    target_compile_options(${target} PRIVATE -Wno-unused-parameter)
  endif()
  target_precompile_headers(${target} REUSE_FROM gg_header)
  # $<1:...> keeps Visual Studio and Xcode from adding a folder for the configuration.
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${id} UNITY_BUILD OFF
    RUNTIME_OUTPUT_DIRECTORY $<1:${output_folder}>
    VS_DEBUGGER_WORKING_DIRECTORY ${output_folder})

  file(GLOB files CONFIGURE_DEPENDS ${folder}/*.json ${folder}/*.vert ${folder}/*.frag
    ${folder}/*.geom ${folder}/*.tesc ${folder}/*.tese ${folder}/*.glsl ${folder}/*.obj
    ${folder}/*.png)
  foreach(further ${ARGN})
    file(GLOB further_files CONFIGURE_DEPENDS ${further}/*.json)
    list(APPEND files ${further_files})
  endforeach()
  list(FILTER files EXCLUDE REGEX "/words\\.ja\\.json$") # the grader's, not the program's
  file(WRITE ${output_folder}/source_folder.txt ${folder})
  set(copies "")
  foreach(file ${files})
    get_filename_component(name ${file} NAME)
    add_custom_command(OUTPUT ${output_folder}/${name} DEPENDS ${file}
      COMMAND ${CMAKE_COMMAND} -E copy ${file} ${output_folder}/${name})
    list(APPEND copies ${output_folder}/${name})
  endforeach()
  add_custom_target(${target}_files DEPENDS ${copies})
  add_dependencies(${target} ${target}_files)
endfunction()

# gg_programs(folder output_folder suffix): every <folder>/<id>/<id>.cpp becomes the target
# <id><suffix>, built as <output_folder>/<id>/<id>.
function(gg_programs folder output_folder suffix)
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*/*.cpp)
  foreach(source ${sources})
    get_filename_component(id ${source} NAME_WE)
    get_filename_component(own_folder ${source} DIRECTORY)
    get_filename_component(own_name ${own_folder} NAME)
    if(own_name STREQUAL id)
      set(further "")
      if(EXISTS ${PROJECT_SOURCE_DIR}/assignments/${id} AND NOT suffix STREQUAL "")
        set(further ${PROJECT_SOURCE_DIR}/assignments/${id})
      endif()
      gg_program(${id}${suffix} ${own_folder} ${id} ${output_folder}/${id} ${further})
    endif()
  endforeach()
endfunction()
