# Whole submissions that attack the grader, graded by the real tool. A sanitized build grades nothing.
if(TARGET grading_tool)
  ggrade_test(submissions_hostile_test hostile SOURCES ${CMAKE_CURRENT_LIST_DIR}/submissions_test.cpp
    LIBRARIES grading_tool ggrade_report TIMEOUT 1200 COST 220)
  add_dependencies(submissions_hostile_test ggrade_author floor floor_solution)
endif()
