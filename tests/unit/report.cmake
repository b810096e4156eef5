find_package(nlohmann_json REQUIRED)
ggrade_test(report_unit_test unit
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/report_samples.cpp
          ${CMAKE_CURRENT_LIST_DIR}/report_text_test.cpp
          ${CMAKE_CURRENT_LIST_DIR}/report_summary_test.cpp
          ${CMAKE_CURRENT_LIST_DIR}/report_json_test.cpp
          ${CMAKE_CURRENT_LIST_DIR}/report_junit_test.cpp
          ${CMAKE_CURRENT_LIST_DIR}/report_reveal_test.cpp
          ${CMAKE_CURRENT_LIST_DIR}/report_html_test.cpp
          ${CMAKE_CURRENT_LIST_DIR}/report_page_test.cpp
          ${CMAKE_CURRENT_LIST_DIR}/report_class_samples.cpp
          ${CMAKE_CURRENT_LIST_DIR}/report_class_figures_test.cpp
          ${CMAKE_CURRENT_LIST_DIR}/report_class_test.cpp
          ${CMAKE_CURRENT_LIST_DIR}/report_adjustments_test.cpp
          ${CMAKE_CURRENT_LIST_DIR}/report_write_test.cpp
  LIBRARIES ggrade_report nlohmann_json::nlohmann_json)
