# Real submissions: every kind of end, every score that is promised, by the library and by the real tool.
add_library(grading_tool STATIC tool.cpp handout.cpp)
target_link_libraries(grading_tool PUBLIC ggrade_calibration ggrade_grading ggrade_authoring ggrade_png GTest::gmock)
target_compile_definitions(grading_tool PUBLIC GGRADE_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
  GGRADE_BUILD_DIR="${CMAKE_BINARY_DIR}")
# grading_test_program(NAME SOURCES source... [options of ggrade_test]) makes a program that grades, by the library or by
# the real tool.
function(grading_test_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES" ${ARGN})
  list(TRANSFORM ARG_SOURCES PREPEND ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/)
  ggrade_test(${name} grading ${ARG_UNPARSED_ARGUMENTS}
    SOURCES ${ARG_SOURCES} LIBRARIES grading_tool)
  add_dependencies(${name} ggrade_author)
endfunction()
grading_test_program(grading_test TIMEOUT 300 COST 120 SOURCES
  grade_bloom_test.cpp grade_carry_test.cpp grade_catalogue_test.cpp grade_deferred_test.cpp grade_faults_test.cpp
  grade_moments_test.cpp grade_repair_test.cpp grade_same_test.cpp grade_scores_test.cpp grade_shadow_test.cpp grade_together_test.cpp grade_unsteady_test.cpp
  long_catalogue_test.cpp long_same_test.cpp)
# The rubrics' own filters, to compose a frame from its passes.
target_sources(grading_test PRIVATE $<TARGET_OBJECTS:ggrade_rubrics>)
grading_test_program(steps_grading_test TIMEOUT 400 COST 80 SOURCES grade_steps_test.cpp long_derive_test.cpp)
# What is drawn for one diagnosis is there for the next one.
grading_test_program(diagnosis_grading_test TIMEOUT 1800 COST 200 SOURCES
  grade_demo_test.cpp grade_diagnosis_test.cpp grade_language_test.cpp)
grading_test_program(command_grading_test TIMEOUT 300 COST 100 SOURCES
  grade_drawing_test.cpp grade_full_disk_test.cpp grade_input_test.cpp grade_interrupt_test.cpp grade_outcomes_test.cpp
  grade_render_test.cpp)
add_dependencies(command_grading_test ggrade_compare floor floor_solution)
grading_test_program(study_grading_test TIMEOUT 600 COST 60 SOURCES
  grade_calibrate_test.cpp grade_tradeoff_test.cpp)
grading_test_program(new_grading_test TIMEOUT 600 COST 60 SOURCES grade_new_test.cpp)
# What a copy of the tree is built with, as this one is.
find_package(Git REQUIRED)
target_compile_definitions(new_grading_test PRIVATE GGRADE_CMAKE="${CMAKE_COMMAND}"
  GGRADE_NINJA="${CMAKE_MAKE_PROGRAM}" GGRADE_GIT="${GIT_EXECUTABLE}"
  GGRADE_BUILD_TYPE="${CMAKE_BUILD_TYPE}")
ggrade_test(window_test gl SOURCES ${CMAKE_CURRENT_LIST_DIR}/window_test.cpp
  LIBRARIES grading_tool TIMEOUT 120)
add_dependencies(window_test ggrade_tool floor_solution)
grading_test_program(batch_grading_test TIMEOUT 300 COST 60 SOURCES batch_class_test.cpp)
# A class whose system calls fail, with a worker that is quick. It stands where the tool stands, and finds what it starts.
add_executable(canned_batch ${CMAKE_CURRENT_LIST_DIR}/canned_batch.cpp ${CMAKE_CURRENT_LIST_DIR}/failing_calls.cpp
  ${PROJECT_SOURCE_DIR}/grader/cli/batch.cpp ${PROJECT_SOURCE_DIR}/grader/cli/batch_options.cpp)
target_link_libraries(canned_batch PRIVATE ggrade_cli ggrade_batch ggrade_report ggrade_png)
set_target_properties(canned_batch PROPERTIES UNITY_BUILD OFF) # its main is no part of the tool
add_dependencies(canned_batch ggrade_tool)
grading_test_program(failing_calls_grading_test TIMEOUT 3600 COST 30 SOURCES
  batch_failing_calls_test.cpp failing_calls.cpp)
add_dependencies(failing_calls_grading_test canned_batch)
