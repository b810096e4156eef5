# `ggrade compare` as a user runs it: the real program, its exit codes and its words.
find_package(nlohmann_json REQUIRED)
ggrade_test(compare_test grading SOURCES ${CMAKE_CURRENT_LIST_DIR}/compare_test.cpp
  LIBRARIES ggrade_files nlohmann_json::nlohmann_json COST 40)
add_dependencies(compare_test ggrade_compare)
target_compile_definitions(compare_test PRIVATE GGRADE_COMPARE="$<TARGET_FILE:ggrade_compare>")
