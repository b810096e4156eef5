# The framework's parts that need no OpenGL.
ggrade_test(framework_unit unit SEPARATE
  SOURCES
    ${CMAKE_CURRENT_LIST_DIR}/framework_arguments_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/framework_handle_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/framework_image_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/framework_mesh_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/framework_obj_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/framework_parts_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/framework_shader_log_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/framework_shader_source_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/scene_camera_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/scene_declarations_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/scene_json_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/scene_test.cpp
  LIBRARIES gg_core gg_words)
target_include_directories(framework_unit PRIVATE ${PROJECT_SOURCE_DIR}/framework/src)
