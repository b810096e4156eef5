# Is everything that a student reads translated?
ggrade_test(words_test unit
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/words_test.cpp
  LIBRARIES gg_words nlohmann_json::nlohmann_json)
target_compile_definitions(words_test PRIVATE GGRADE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
