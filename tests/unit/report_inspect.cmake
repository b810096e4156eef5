find_package(ZLIB REQUIRED)
ggrade_test(report_inspect_unit_test unit
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/report_inspect_test.cpp
  LIBRARIES ggrade_report ZLIB::ZLIB)
