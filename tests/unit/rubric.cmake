# What the floor's rubrics are made of, on made-up pictures.
set(floor ${PROJECT_SOURCE_DIR}/solutions/floor)
if(EXISTS ${floor}/rubric_follows.cpp)
  ggrade_test(rubric_unit_test unit
    SOURCES ${CMAKE_CURRENT_LIST_DIR}/rubric_follows_test.cpp ${floor}/rubric_follows.cpp
      ${floor}/rubric_common.cpp
    LIBRARIES ggrade_rubric)
endif()
