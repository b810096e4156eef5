# Quizzes: what is asked and answered, and how it is written for students, instructors and Moodle.
ggrade_test(quiz_test unit
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/quiz_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/quiz_gift_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/quiz_numbers_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/quiz_read_test.cpp
  LIBRARIES ggrade_authoring gg_scene)
target_compile_definitions(quiz_test PRIVATE GGRADE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
