# Programs that nobody has written, wrong and right ones, and what becomes of them.
ggrade_test(generated_unit_test unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/generated_test.cpp LIBRARIES ggrade_generated)
target_compile_definitions(generated_unit_test PRIVATE GGRADE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
