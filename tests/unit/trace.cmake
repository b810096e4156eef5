# What was recorded of the passes: values, files, JSON, pictures; and its way to the rubric.
ggrade_test(trace_test unit
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/trace_test.cpp ${CMAKE_CURRENT_LIST_DIR}/trace_evidence_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/rubric_outputs_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/trace_json_test.cpp ${CMAKE_CURRENT_LIST_DIR}/trace_picture_test.cpp
  LIBRARIES ggrade_rubric)
target_compile_definitions(trace_test PRIVATE GGRADE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
