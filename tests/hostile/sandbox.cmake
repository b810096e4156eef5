# The sandbox under attack. The attacker must not be changed by sanitizers: it runs under memory limits.
add_executable(sandbox_attacker
  sandbox_programs/attacker.cpp sandbox_programs/attack_files.cpp sandbox_programs/attack_kernel.cpp
  sandbox_programs/attack_memory.cpp sandbox_programs/attack_processes.cpp)
set_target_properties(sandbox_attacker PROPERTIES
  COMPILE_OPTIONS "-Wall;-Wextra;-Wno-infinite-recursion"
  LINK_OPTIONS "")

ggrade_test(sandbox_hostile_test hostile
  SOURCES sandbox_fixture.cpp sandbox_ends_test.cpp sandbox_files_test.cpp sandbox_kernel_test.cpp
    sandbox_memory_test.cpp sandbox_processes_test.cpp sandbox_work_test.cpp
  LIBRARIES ggrade_sandbox SHARDS 2 COST 30)
target_compile_definitions(sandbox_hostile_test PRIVATE GGRADE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
add_dependencies(sandbox_hostile_test sandbox_attacker)
# Next to the test, where it finds them also when it runs as a copy for an ordinary user.
add_custom_command(TARGET sandbox_hostile_test POST_BUILD
  COMMAND ${CMAKE_COMMAND} -E copy_directory
    ${CMAKE_CURRENT_LIST_DIR}/sandbox_programs $<TARGET_FILE_DIR:sandbox_hostile_test>/sandbox_programs)
