# The real tool on real submissions: every kind of end, every score that is promised.
add_library(grading_tool STATIC tool.cpp)
target_link_libraries(grading_tool PUBLIC ggrade_grading ggrade_authoring ggrade_png GTest::gmock)
target_compile_definitions(grading_tool PUBLIC GGRADE_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
  GGRADE_BUILD_DIR="${CMAKE_BINARY_DIR}")
file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/grade_*_test.cpp)
# The judge's own filters, to compose a frame from its passes.
foreach(part passes pyramid)
  list(APPEND sources ${PROJECT_SOURCE_DIR}/solutions/floor/rubric_${part}.cpp)
endforeach()
ggrade_test(grading_test grading SOURCES ${sources} LIBRARIES grading_tool TIMEOUT 1800)
add_dependencies(grading_test ggrade_tool ggrade_compare floor floor_solution)
# What a copy of the tree is built with, as this one is.
find_package(Git REQUIRED)
target_compile_definitions(grading_test PRIVATE GGRADE_CMAKE="${CMAKE_COMMAND}"
  GGRADE_NINJA="${CMAKE_MAKE_PROGRAM}" GGRADE_GIT="${GIT_EXECUTABLE}"
  GGRADE_BUILD_TYPE="${CMAKE_BUILD_TYPE}")
ggrade_test(window_test gl SOURCES ${CMAKE_CURRENT_LIST_DIR}/window_test.cpp
  LIBRARIES grading_tool TIMEOUT 120)
add_dependencies(window_test ggrade_tool floor_solution)
file(GLOB batch CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/batch_*_test.cpp)
ggrade_test(batch_grading_test grading SOURCES ${batch} LIBRARIES grading_tool TIMEOUT 600)
add_dependencies(batch_grading_test ggrade_tool)
