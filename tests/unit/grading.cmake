# Assignments, solution blocks, scene plans, the rubric engine: what needs no submission to run.
ggrade_test(grading_unit_test unit
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/assignment_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/authoring_comments_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/authoring_new_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/authoring_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/grading_catalogue_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/grading_catalogues_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/grading_parts_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/grading_diagnose_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/grading_rubric_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/grading_scenes_test.cpp
  LIBRARIES ggrade_grading ggrade_authoring)
target_compile_definitions(grading_unit_test PRIVATE GGRADE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
