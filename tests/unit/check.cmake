# What tells a student how far a program is, on made-up texts and pictures.
ggrade_test(check_test unit
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/check_begun_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/check_editor_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/check_expected_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/check_frustum_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/check_hints_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/check_known_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/check_places_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/check_rows_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/check_state_test.cpp
  LIBRARIES ggrade_expected)
