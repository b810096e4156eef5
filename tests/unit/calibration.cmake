# What gradings of known answers say of the grader.
ggrade_test(calibration_unit_test unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/calibration_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/calibration_drift_test.cpp ${CMAKE_CURRENT_LIST_DIR}/calibration_trade_test.cpp
  LIBRARIES ggrade_calibration)
target_compile_definitions(calibration_unit_test PRIVATE GGRADE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
