ggrade_test(inspect_browser_test browser
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/inspect_browser_test.cpp
  LIBRARIES ggrade_report ggrade_png
  TIMEOUT 300)
ggrade_test(inspect_tool_test browser
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/inspect_tool_test.cpp
  LIBRARIES grading_tool ggrade_report ggrade_png
  TIMEOUT 300)
add_dependencies(inspect_tool_test ggrade_tool)
