// Processors of two vendors give the same pictures only where the code that llvmpipe makes of
// shaders asks for nothing that each of them rounds in its own way. Division and square root are
// exact by IEEE 754. rcpps and rsqrtps are good to 12 bits, the rest is the vendor's (Intel SDM
// 2B, AMD APM 4).

#include <gmock/gmock.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include <unistd.h>

namespace {

namespace fs = std::filesystem;

/// Runs a shell command; what it printed.
std::string output(const std::string& command) {
  std::string text;
  FILE* const pipe = popen(command.c_str(), "r");
  std::array<char, 4096> block;
  while (pipe && std::fgets(block.data(), block.size(), pipe)) text += block.data();
  if (pipe) pclose(pipe);
  return text;
}

/// How often each instruction that divides or takes a root stands in the code that llvmpipe makes
/// for `program`, without the `v` of AVX.
std::map<std::string, int> instructions(const std::string& program, const std::string& pins) {
  const fs::path dump =
      fs::temp_directory_path() / ("ggrade-code-" + std::to_string(getpid()) + ".bin");
  output("cd / && " + pins +
         " MESA_SHADER_CACHE_DISABLE=true GG_CAPTURE_FRAMES=3 GG_DOCTOR=0 GG_CODE_DUMP=" +
         dump.string() +
         " LD_PRELOAD=" GGRADE_CODE_DUMP " LD_LIBRARY_PATH=" GGRADE_CAPTURE_FOLDER " " + program +
         " 2>&1");
  std::istringstream lines(
      output("objdump -D -b binary -m i386:x86-64 --no-show-raw-insn " + dump.string()));
  fs::remove(dump);
  std::map<std::string, int> counts;
  for (std::string address, name, line; std::getline(lines, line);) {
    std::istringstream words(line);
    words >> address >> name;
    if (name.starts_with('v')) name.erase(0, 1);
    for (const char* kind : {"rcp", "rsqrt", "div", "sqrt"})
      if (name == kind + std::string("ps") || name == kind + std::string("ss")) ++counts[name];
  }
  return counts;
}

class ExactCode : public testing::TestWithParam<const char*> {};

TEST_P(ExactCode, NoReferenceIsDrawnByApproximations) {
  const std::string id = GetParam();
  const std::string program = GGRADE_SOLUTIONS "/" + id + "/" + id;
  ASSERT_TRUE(fs::exists(program));
  for (const std::string caps : {"avx", "sse4.1"}) {
    SCOPED_TRACE(caps);
    const auto found = instructions(
        program, "LP_NUM_THREADS=0 GALLIVM_PERF=nopt GALLIUM_OVERRIDE_CPU_CAPS=" + caps);
    EXPECT_GT(found.contains("divps") ? found.at("divps") : 0, 5) << "was there any code?";
    EXPECT_GT(found.contains("sqrtps") ? found.at("sqrtps") : 0, 1);
    for (const char* inexact : {"rcpps", "rcpss", "rsqrtps", "rsqrtss"})
      EXPECT_FALSE(found.contains(inexact)) << inexact;
  }
}

INSTANTIATE_TEST_SUITE_P(Of, ExactCode,
                         testing::Values("floor", "shadow_volume", "deferred", "ssao", "post"),
                         [](const auto& parameter) { return std::string(parameter.param); });

// The one place where llvmpipe does approximate: it shows that such an instruction is found.
TEST(ExactCode, EncodingToSrgbIsNotExact) {
  const auto found =
      instructions(GGRADE_CAPTURE_PROGRAMS "/capture_hostile_passes srgb_target",
                   "LP_NUM_THREADS=0 GALLIVM_PERF=nopt GALLIUM_OVERRIDE_CPU_CAPS=avx");
  EXPECT_TRUE(found.contains("rsqrtps")) << "then sRGB targets are as exact as all others";
}

} // namespace
