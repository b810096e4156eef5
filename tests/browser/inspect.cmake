ggrade_test(inspect_browser_test browser
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/inspect_browser_test.cpp
  LIBRARIES ggrade_report ggrade_png
  TIMEOUT 300)
