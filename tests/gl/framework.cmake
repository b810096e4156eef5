# The framework on OpenGL: in a process that has the capture library on its run path, so that a
# gg::Window needs no display.
ggrade_test(framework_gl gl
  SOURCES
    ${CMAKE_CURRENT_LIST_DIR}/framework_debug_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/framework_doctor_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/framework_drawing_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/framework_live_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/framework_program_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/framework_reload_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/framework_uniform_test.cpp
  LIBRARIES gg_core gg_words)
add_dependencies(framework_gl ggrade_capture)
target_include_directories(framework_gl PRIVATE ${CMAKE_CURRENT_LIST_DIR}/../unit)
set_target_properties(framework_gl PROPERTIES BUILD_RPATH ${CMAKE_BINARY_DIR}/capture)

# Whole programs with the framework's own main.
set(framework_programs ${CMAKE_BINARY_DIR}/framework_programs)
add_executable(framework_loop ${CMAKE_CURRENT_LIST_DIR}/framework_programs/loop.cpp)
target_link_libraries(framework_loop PRIVATE gg)
set_target_properties(framework_loop PROPERTIES OUTPUT_NAME capture_loop
  RUNTIME_OUTPUT_DIRECTORY ${framework_programs})
file(GLOB files CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/framework_programs/*.json
  ${CMAKE_CURRENT_LIST_DIR}/framework_programs/*.frag
  ${CMAKE_CURRENT_LIST_DIR}/framework_programs/*.vert)
add_custom_command(TARGET framework_loop POST_BUILD
  COMMAND ${CMAKE_COMMAND} -E copy ${files} ${framework_programs})

ggrade_test(framework_run gl
  SOURCES
    ${CMAKE_CURRENT_LIST_DIR}/capture_run.cpp
    ${CMAKE_CURRENT_LIST_DIR}/framework_run_test.cpp
  LIBRARIES ggrade_channel)
target_include_directories(framework_run PRIVATE ${CMAKE_CURRENT_LIST_DIR}/../unit)
target_compile_definitions(framework_run PRIVATE
  GGRADE_CAPTURE_FOLDER="${CMAKE_BINARY_DIR}/capture"
  GGRADE_CAPTURE_PROGRAMS="${framework_programs}")
add_dependencies(framework_run framework_loop ggrade_capture)
