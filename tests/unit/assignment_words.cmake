# What students read of the assignments, in Japanese.
ggrade_test(assignment_words_test unit
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/assignment_comments_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/assignment_layout_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/assignment_words_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/glossary_test.cpp
  LIBRARIES ggrade_authoring ggrade_expected ggrade_tradeoff)
target_compile_definitions(assignment_words_test PRIVATE GGRADE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
