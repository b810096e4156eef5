// Every input that tests/fuzz keeps, through the function that the fuzzer calls: whatever it
// requires holds, or the program ends and names the input.

#include <gtest/gtest.h>

#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <string>

#include <unistd.h>

extern "C" {
int LLVMFuzzerInitialize(int*, char***); // of fuzz_unpack
int fuzz_assignment(const std::uint8_t*, std::size_t);
int fuzz_bundle(const std::uint8_t*, std::size_t);
int fuzz_csv(const std::uint8_t*, std::size_t);
int fuzz_names(const std::uint8_t*, std::size_t);
int fuzz_overrides(const std::uint8_t*, std::size_t);
int fuzz_passes(const std::uint8_t*, std::size_t);
int fuzz_record(const std::uint8_t*, std::size_t);
int fuzz_scene(const std::uint8_t*, std::size_t);
int fuzz_tape(const std::uint8_t*, std::size_t);
int fuzz_trace(const std::uint8_t*, std::size_t);
int fuzz_unpack(const std::uint8_t*, std::size_t);
int fuzz_worksheet(const std::uint8_t*, std::size_t);
}

namespace {

namespace fs = std::filesystem;

const std::map<std::string, int (*)(const std::uint8_t*, std::size_t)> kFuzzers = {
    {"fuzz_assignment", fuzz_assignment},
    {"fuzz_bundle", fuzz_bundle},
    {"fuzz_csv", fuzz_csv},
    {"fuzz_names", fuzz_names},
    {"fuzz_overrides", fuzz_overrides},
    {"fuzz_passes", fuzz_passes},
    {"fuzz_record", fuzz_record},
    {"fuzz_scene", fuzz_scene},
    {"fuzz_tape", fuzz_tape},
    {"fuzz_trace", fuzz_trace},
    {"fuzz_unpack", fuzz_unpack},
    {"fuzz_worksheet", fuzz_worksheet}};

const fs::path kFuzz = fs::path(GGRADE_SOURCE_DIR) / "tests" / "fuzz";

std::string current; ///< input
constexpr int kFatal[] = {SIGABRT, SIGSEGV};
struct sigaction before[std::size(kFatal)];

/// Then goes on to what would have happened.
void nameInput(int) {
  const std::string line = "the input is " + current + '\n';
  for (std::size_t i = 0; i < std::size(kFatal); ++i) sigaction(kFatal[i], &before[i], nullptr);
  if (write(STDERR_FILENO, line.data(), line.size()) < 0) return;
}

TEST(FuzzCorpus, EveryFuzzerHasOneAndIsCalledHere) {
  for (const fs::directory_entry& entry : fs::directory_iterator(kFuzz)) {
    const fs::path file = entry.path();
    if (file.extension() != ".cpp" || file.stem() == "fuzz_seeds") continue;
    EXPECT_TRUE(kFuzzers.contains(file.stem().string())) << file;
    EXPECT_FALSE(fs::is_empty(kFuzz / "corpus" / file.stem())) << file;
  }
}

TEST(FuzzCorpus, EveryInputIsTakenOrRefused) {
  ASSERT_EQ(LLVMFuzzerInitialize(nullptr, nullptr), 0);
  struct sigaction name {};
  name.sa_handler = nameInput;
  for (std::size_t i = 0; i < std::size(kFatal); ++i) sigaction(kFatal[i], &name, &before[i]);
  std::uintmax_t bytes = 0;
  for (const auto& [name, fuzzer] : kFuzzers)
    for (const fs::directory_entry& entry : fs::directory_iterator(kFuzz / "corpus" / name)) {
      current = entry.path().string();
      std::ifstream in(entry.path(), std::ios::binary);
      const std::string input{std::istreambuf_iterator<char>(in), {}};
      bytes += input.size();
      EXPECT_EQ(fuzzer(reinterpret_cast<const std::uint8_t*>(input.data()), input.size()), 0)
          << current;
    }
  for (std::size_t i = 0; i < std::size(kFatal); ++i) sigaction(kFatal[i], &before[i], nullptr);
  EXPECT_LT(bytes, 300'000u) << "minimise it";
}

} // namespace
