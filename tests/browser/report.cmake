ggrade_test(report_browser_test browser
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/report_browser_test.cpp
          ${CMAKE_CURRENT_LIST_DIR}/../unit/report_samples.cpp
  LIBRARIES ggrade_report ggrade_png
  TIMEOUT 300 COST 30)
ggrade_test(class_browser_test browser
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/class_browser_test.cpp
          ${CMAKE_CURRENT_LIST_DIR}/../unit/report_class_samples.cpp
          ${CMAKE_CURRENT_LIST_DIR}/../unit/report_samples.cpp
  LIBRARIES ggrade_report ggrade_png
  TIMEOUT 300 COST 30)
