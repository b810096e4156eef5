ggrade_test(report_browser_test browser
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/report_browser_test.cpp
          ${CMAKE_CURRENT_LIST_DIR}/../unit/report_samples.cpp
  LIBRARIES ggrade_report ggrade_png
  TIMEOUT 300)
