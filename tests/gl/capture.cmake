# Ordinary GLFW programs, linked with the installed libraries and run under the capture library.
set(capture_programs ${CMAKE_BINARY_DIR}/capture_programs)
function(ggrade_capture_program name source)
  add_executable(capture_${name} ${CMAKE_CURRENT_LIST_DIR}/capture_programs/${source})
  target_link_libraries(capture_${name} PRIVATE glfw ${ARGN})
  set_target_properties(capture_${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${capture_programs})
  set_property(GLOBAL APPEND PROPERTY GGRADE_CAPTURE_PROGRAMS capture_${name})
endfunction()
find_package(glfw3 3.3 REQUIRED)
foreach(name triangle resized two_windows errors framebuffer_left_bound encodes_srgb lit_scene threaded passes samples
    formats replaced state_kept hostile_passes)
  ggrade_capture_program(${name} ${name}.cpp gg_glad)
endforeach()
foreach(name compatible compatible_passes ignores_close waits_for_time calls_missing)
  ggrade_capture_program(${name} ${name}.cpp GL)
endforeach()
foreach(name clock meaningless never_swaps)
  ggrade_capture_program(${name} ${name}.cpp)
endforeach()
ggrade_capture_program(linked_gl linked.cpp GL)
ggrade_capture_program(linked_opengl linked.cpp OpenGL)
ggrade_capture_program(opened opened.c ${CMAKE_DL_LIBS})

execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=libasan.so
  OUTPUT_VARIABLE libasan OUTPUT_STRIP_TRAILING_WHITESPACE)
string(REPLACE ";" "," installed "${GGRADE_CAPTURE_INSTALLED}")

ggrade_test(capture_test gl
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/capture_run.cpp
    ${CMAKE_CURRENT_LIST_DIR}/capture_errors_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/capture_exports_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/capture_frames_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/capture_recorder_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/capture_recorder_copies_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/capture_recorder_limits_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/capture_replacements_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/capture_run_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/capture_tape_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/capture_traces.cpp
    ${CMAKE_CURRENT_LIST_DIR}/capture_unseen_test.cpp
  LIBRARIES ggrade_channel ggrade_tape COST 20)
target_compile_definitions(capture_test PRIVATE
  GGRADE_CAPTURE_FOLDER="${CMAKE_BINARY_DIR}/capture"
  GGRADE_CAPTURE_PROGRAMS="${capture_programs}"
  GGRADE_PLAYER="$<TARGET_FILE:ggrade_player>"
  GGRADE_INSTALLED_LIBRARIES="${installed}"
  GGRADE_NM="${CMAKE_NM}"
  GGRADE_LIBASAN="${libasan}")
get_property(programs GLOBAL PROPERTY GGRADE_CAPTURE_PROGRAMS)
add_dependencies(capture_test ggrade_capture ggrade_player ${programs})

# What machine code llvmpipe makes of the references' shaders.
if(EXISTS ${PROJECT_SOURCE_DIR}/solutions AND CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64" AND NOT GGRADE_ASAN)
  add_library(ggrade_code_dump SHARED ${CMAKE_CURRENT_LIST_DIR}/capture_programs/code_dump.c)
  target_link_libraries(ggrade_code_dump PRIVATE ${CMAKE_DL_LIBS})
  ggrade_test(exact_code_test gl
    SOURCES ${CMAKE_CURRENT_LIST_DIR}/exact_code_test.cpp COST 10)
  target_compile_definitions(exact_code_test PRIVATE
    GGRADE_CAPTURE_FOLDER="${CMAKE_BINARY_DIR}/capture"
    GGRADE_CAPTURE_PROGRAMS="${capture_programs}"
    GGRADE_SOLUTIONS="${CMAKE_BINARY_DIR}/solutions"
    GGRADE_CODE_DUMP="$<TARGET_FILE:ggrade_code_dump>")
  add_dependencies(exact_code_test ggrade_capture capture_hostile_passes ggrade_code_dump)
endif()

# GLFW's own contract, function by function, in a process that has the capture library on its run path.
ggrade_test(capture_glfw_test gl SEPARATE
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/capture_glfw_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/capture_glfw_window_test.cpp
  LIBRARIES glfw GL)
add_dependencies(capture_glfw_test ggrade_capture)
set_target_properties(capture_glfw_test PROPERTIES BUILD_RPATH ${CMAKE_BINARY_DIR}/capture)

# The same contract with the context that newer systems have alone. What Mesa's EGL keeps until the end is no leak of ours.
if(NOT GGRADE_ASAN)
  foreach(name capture_test capture_glfw_test)
    add_test(NAME egl_${name} COMMAND ${name})
    set_tests_properties(egl_${name} PROPERTIES LABELS gl COST 15 TIMEOUT 7200
      ENVIRONMENT "GGRADE_TEST_NAME=egl_${name};GGRADE_TEST_SECONDS=120;GG_CAPTURE_CONTEXT=egl")
  endforeach()
endif()
