# Gradebooks: tables that keep their bytes, worksheets, overrides, lateness.
foreach(source csv cells look_alike neutral moodle canvas overrides lateness)
  list(APPEND gradebook_sources ${CMAKE_CURRENT_LIST_DIR}/gradebook_${source}_test.cpp)
endforeach()
ggrade_test(gradebook_test unit SOURCES ${gradebook_sources} LIBRARIES ggrade_gradebook)
