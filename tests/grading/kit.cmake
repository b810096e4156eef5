# What students receive, and the check that comes with it: made and used as they do.
file(GLOB kit CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/kit_*_test.cpp)
ggrade_test(kit_grading_test grading SOURCES ${kit} LIBRARIES grading_tool TIMEOUT 1800 PROCESSORS 2)
add_dependencies(kit_grading_test ggrade_tool ggrade_check)
