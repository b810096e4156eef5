// What a submission honestly needs works inside: compiling, linking, running, rendering.
#include "sandbox_fixture.hpp"

#include <gmock/gmock.h>

#include <filesystem>

namespace fs = std::filesystem;
using namespace ggrade::sandbox;

class SandboxWork : public Sandbox {
protected:
  /// Compiles programs()/SOURCE inside into folder()/program.
  Result compile(const std::string& source, const std::vector<std::string>& more) {
    Command command;
    command.arguments = {"/usr/bin/g++",      "-std=c++20", "-Wall",           "-pipe",
                         "/source/" + source, "-o",         "/scratch/program"};
    command.arguments.insert(command.arguments.end(), more.begin(), more.end());
    command.environment = {{"PATH", "/usr/bin"}};
    command.mounts = {{programs(), "/source"}};
    command.collect = {{"/scratch/program", folder() + "/program"}};
    command.limits.wallSeconds = 60;
    command.limits.addressSpaceBytes = std::uint64_t{16} << 30; // as for submissions
    return run(command);
  }
  Command program() const {
    Command command;
    command.arguments = {"/program"};
    command.mounts = {{folder() + "/program", "/program"}};
    return command;
  }
};

INSTANTIATE_TEST_SUITE_P(As, SandboxWork, testing::Values("root", "user"),
                         [](const auto& parameter) { return std::string(parameter.param); });

TEST_P(SandboxWork, CompilesLinksAndRuns) {
  if (delegated()) return;
  for (const std::string name : {"mold", "gold", "bfd"}) {
    if (name == "gold" && !fs::exists("/usr/bin/ld.gold")) continue; // binutils has none any more
    const std::string linker = "-fuse-ld=" + name;
    const Result built = compile("hello.cpp", {linker});
    ASSERT_TRUE(built.collected) << linker << describe(built);
    EXPECT_EQ(built.standardError, "") << linker;
    const Result result = run(program());
    EXPECT_EQ(result.standardOutput, "hello 6 6\n") << describe(result);
    fs::remove(folder() + "/program");
  }
}

TEST_P(SandboxWork, CompilerMessagesComeBack) {
  if (delegated()) return;
  const Result built = compile("hello.cpp", {"-DINJECTED", "-Dmain=("});
  EXPECT_EQ(built.end, End::exited);
  EXPECT_EQ(built.exitCode, 1);
  EXPECT_FALSE(built.collected);
  EXPECT_THAT(built.standardError, testing::HasSubstr("/source/hello.cpp:"));
}

TEST_P(SandboxWork, RendersAFrame) {
  if (!fs::exists("/usr/include/GL/osmesa.h")) GTEST_SKIP() << "this system has no OSMesa";
  if (delegated()) return;
  const Result built = compile("osmesa.cpp", {"-lOSMesa"});
  ASSERT_TRUE(built.collected) << describe(built);
  fs::create_directory(folder() + "/cache");
  Command command = program();
  command.environment = {{"LP_NUM_THREADS", "1"}, {"MESA_SHADER_CACHE_DIR", "/cache"}};
  command.privateCopies = {{folder() + "/cache", "/cache"}};
  const Result result = run(command);
  EXPECT_EQ(result.standardOutput, "255 128 64 255\n") << describe(result);
  EXPECT_EQ(result.standardError, "");
  EXPECT_TRUE(fs::is_empty(folder() + "/cache"));
}
