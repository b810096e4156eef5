# What rubrics are made of, on made-up pictures.
ggrade_test(rubric_unit_test unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/rubric_follows_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/rubric_light_test.cpp
  LIBRARIES ggrade_rubric)
