ggrade_test(sandbox_unit_test unit SOURCES sandbox_test.cpp LIBRARIES ggrade_sandbox)
