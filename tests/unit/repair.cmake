# Tapes as bytes, and what two of them differ in.
ggrade_test(repair_unit_test unit
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/tape_test.cpp ${CMAKE_CURRENT_LIST_DIR}/repair_test.cpp
          ${CMAKE_CURRENT_LIST_DIR}/proved_test.cpp
  LIBRARIES ggrade_repair ggrade_diagnosis)
