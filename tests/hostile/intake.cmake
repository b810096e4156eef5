# Archives that students send, honest and hostile, unpacked in the sandbox and without it.
find_package(LibArchive REQUIRED)
find_package(ZLIB REQUIRED)
ggrade_test(intake_hostile_test hostile
  SOURCES intake_archives.cpp intake_bombs_test.cpp intake_class_test.cpp intake_honest_test.cpp
    intake_refused_test.cpp
  LIBRARIES ggrade_intake LibArchive::LibArchive ZLIB::ZLIB)
target_include_directories(intake_hostile_test PRIVATE ${PROJECT_SOURCE_DIR}/tests/unit)
