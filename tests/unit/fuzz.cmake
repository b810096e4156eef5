# What the fuzzers have found and keep in tests/fuzz/corpus, through the same functions, with any compiler.
if(TARGET ggrade_batch)
  find_package(LibArchive REQUIRED)
  set(fuzz ${PROJECT_SOURCE_DIR}/tests/fuzz)
  set(fuzzers fuzz_assignment fuzz_bundle fuzz_csv fuzz_names fuzz_overrides fuzz_passes fuzz_record fuzz_scene
    fuzz_tape fuzz_trace fuzz_unpack fuzz_worksheet)
  set(fuzz_sources ${CMAKE_CURRENT_LIST_DIR}/fuzz_corpus_test.cpp
    ${PROJECT_SOURCE_DIR}/grader/intake/archive_reader.cpp)
  foreach(fuzzer ${fuzzers})
    list(APPEND fuzz_sources ${fuzz}/${fuzzer}.cpp)
    set_source_files_properties(${fuzz}/${fuzzer}.cpp PROPERTIES
      COMPILE_DEFINITIONS LLVMFuzzerTestOneInput=${fuzzer})
  endforeach()
  ggrade_test(fuzz_corpus_test unit SEPARATE SOURCES ${fuzz_sources}
    LIBRARIES ggrade_batch ggrade_diagnosis ggrade_channel ggrade_repair gg_scene LibArchive::LibArchive)
  target_compile_definitions(fuzz_corpus_test PRIVATE GGRADE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
endif()
