# The truths themselves, in scenes that have a closed form: rays, filters, the floor's and the room's.
if(TARGET ggrade_truths)
  ggrade_test(truth_test unit SEPARATE
    SOURCES ${CMAKE_CURRENT_LIST_DIR}/truth_ray_test.cpp ${CMAKE_CURRENT_LIST_DIR}/truth_blur_test.cpp
      ${CMAKE_CURRENT_LIST_DIR}/truth_world_test.cpp ${CMAKE_CURRENT_LIST_DIR}/truth_pyramid_test.cpp
      ${CMAKE_CURRENT_LIST_DIR}/truth_judges_test.cpp ${CMAKE_CURRENT_LIST_DIR}/truth_room_test.cpp
      $<TARGET_OBJECTS:ggrade_truths> $<TARGET_OBJECTS:ggrade_rubrics>
    LIBRARIES ggrade_truth ggrade_rubric ggrade_assignment gg_scene)
  target_compile_definitions(truth_test PRIVATE GGRADE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
endif()
