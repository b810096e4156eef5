# Names, layouts, bundles and folder uploads: what needs no archive and no sandbox.
ggrade_test(intake_unit_test unit
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/intake_bundle_test.cpp
          ${CMAKE_CURRENT_LIST_DIR}/intake_contents_test.cpp
          ${CMAKE_CURRENT_LIST_DIR}/intake_find_test.cpp
          ${CMAKE_CURRENT_LIST_DIR}/intake_folder_test.cpp
          ${CMAKE_CURRENT_LIST_DIR}/intake_layouts_test.cpp
          ${CMAKE_CURRENT_LIST_DIR}/intake_names_test.cpp
          ${CMAKE_CURRENT_LIST_DIR}/intake_top_folder_test.cpp
  LIBRARIES ggrade_intake)
