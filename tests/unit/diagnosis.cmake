# Which fault a picture shows: on made-up pictures.
ggrade_test(diagnosis_test unit
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/diagnosis_correspondence_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/diagnosis_generic_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/diagnosis_match_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/diagnosis_outcome_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/diagnosis_views_test.cpp
  LIBRARIES ggrade_diagnosis)
