# What students receive, and the check that comes with it: made and used as they do.
grading_test_program(kit_grading_test TIMEOUT 1800 COST 250 SOURCES
  kit.cpp kit_bad_input_test.cpp kit_check_test.cpp kit_release_test.cpp kit_wrapper_test.cpp long_check_test.cpp long_kit_test.cpp
  previous_kit_test.cpp)
target_link_libraries(kit_grading_test PRIVATE ggrade_expected)
add_dependencies(kit_grading_test ggrade_check)
