if(TARGET ggrade_batch)
  ggrade_test(batch_test unit
    SOURCES
      ${CMAKE_CURRENT_LIST_DIR}/batch_job_test.cpp
      ${CMAKE_CURRENT_LIST_DIR}/batch_pool_test.cpp
      ${CMAKE_CURRENT_LIST_DIR}/batch_record_test.cpp
      ${CMAKE_CURRENT_LIST_DIR}/batch_state_test.cpp
      ${CMAKE_CURRENT_LIST_DIR}/batch_turns_test.cpp
    LIBRARIES ggrade_batch)
endif()
