ggrade_test(channel_test unit
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/channel_replacements_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/channel_test.cpp ${CMAKE_CURRENT_LIST_DIR}/channel_tables_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/channel_utf8_test.cpp
  LIBRARIES ggrade_channel)
