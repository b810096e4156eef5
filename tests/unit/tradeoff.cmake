# What measured settings say, and what is to be measured.
ggrade_test(tradeoff_unit_test unit
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/tradeoff_analysis_test.cpp
          ${CMAKE_CURRENT_LIST_DIR}/tradeoff_cost_test.cpp
          ${CMAKE_CURRENT_LIST_DIR}/tradeoff_findings_test.cpp
          ${CMAKE_CURRENT_LIST_DIR}/tradeoff_plan_test.cpp
          ${CMAKE_CURRENT_LIST_DIR}/truth_registry_test.cpp
  LIBRARIES ggrade_tradeoff)
target_compile_definitions(tradeoff_unit_test PRIVATE GGRADE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
