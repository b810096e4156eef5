#include "sandbox_fixture.hpp"

#include <array>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <unistd.h>

namespace fs = std::filesystem;
using namespace ggrade::sandbox;

namespace {

constexpr int kOrdinaryUid = 60500;

fs::path binaries() {
  return fs::read_symlink("/proc/self/exe").parent_path();
}

std::string makeFolder() {
  std::string path = (fs::temp_directory_path() / "ggrade-sandbox-XXXXXX").string();
  if (!mkdtemp(path.data())) throw std::runtime_error("cannot make " + path);
  fs::permissions(path, fs::perms(0755));
  return path;
}

/// This test once more, in a copy that the ordinary user can reach, as that user.
void runAsOrdinaryUser() {
  const std::string copy = makeFolder();
  const fs::path self = fs::read_symlink("/proc/self/exe");
  for (const fs::path& file :
       {self, binaries() / "ggrade-sandbox-helper", binaries() / "sandbox_attacker"})
    fs::copy_file(file, copy / file.filename());
  fs::copy(binaries() / "sandbox_programs", copy + "/sandbox_programs",
           fs::copy_options::recursive);
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::string uid = std::to_string(kOrdinaryUid);
  const std::string command = "cd / && /usr/bin/setpriv --reuid=" + uid + " --regid=" + uid +
                              " --clear-groups " + copy + "/" + self.filename().string() +
                              " --gtest_filter='" + test->test_suite_name() + "." + test->name() +
                              "' 2>&1";
  std::string output;
  FILE* pipe = popen(command.c_str(), "r"); // NOLINT: fixed text
  std::array<char, 4096> block{};
  while (pipe && std::fgets(block.data(), block.size(), pipe)) output += block.data();
  EXPECT_TRUE(pipe && pclose(pipe) == 0) << output;
  EXPECT_NE(output.find("[  PASSED  ] 1 test"), std::string::npos) << output;
  fs::remove_all(copy);
}

} // namespace

void Sandbox::SetUp() {
  if (std::string(GetParam()) == "root" && geteuid() != 0) GTEST_SKIP() << "needs root";
  folder_ = makeFolder();
  programs_ = (binaries() / "sandbox_programs").string();
  fs::create_directory(folder_ + "/data");
  std::ofstream(folder_ + "/data/file") << "the host's data";
}

void Sandbox::TearDown() {
  if (folder_.empty()) return;
  std::string content;
  std::getline(std::ifstream(folder_ + "/data/file"), content);
  EXPECT_EQ(content, "the host's data");
  fs::remove_all(folder_);
}

bool Sandbox::delegated() {
  if (std::string(GetParam()) != "user" || geteuid() != 0) return false;
  runAsOrdinaryUser();
  return true;
}

Command Sandbox::attack(const std::string& name, const std::vector<std::string>& arguments) const {
  Command command;
  command.arguments = {"/attack/attacker", name};
  command.arguments.insert(command.arguments.end(), arguments.begin(), arguments.end());
  command.mounts = {{binaries() / "sandbox_attacker", "/attack/attacker"},
                    {folder_ + "/data", "/attack/data"}};
  command.limits.wallSeconds = 2;
  command.limits.cpuSeconds = 3;
  command.limits.memoryBytes = 100 << 20;
  command.limits.addressSpaceBytes = 1 << 30;
  command.limits.fileBytes = 8 << 20;
  command.limits.scratchBytes = 16 << 20;
  command.limits.processes = 20;
  command.limits.outputBytes = 64 << 10;
  return command;
}

Result Sandbox::run(const Command& command) {
  return ggrade::sandbox::run(command, Isolation::bwrap);
}

void Sandbox::expectRefused(const std::string& name,
                            const std::vector<std::string>& arguments) const {
  const Result result = run(attack(name, arguments));
  EXPECT_EQ(result.end, End::exited) << describe(result);
  EXPECT_EQ(result.exitCode, 0) << describe(result);
  EXPECT_EQ(result.standardOutput.find("ESCAPED"), std::string::npos) << describe(result);
  EXPECT_NE(result.standardOutput.find("refused"), std::string::npos) << describe(result);
}

std::string Sandbox::marker() const {
  static int count = 0;
  return "marker-" + std::to_string(getpid()) + "-" + std::to_string(++count);
}

std::vector<int> Sandbox::processesWith(const std::string& marker) const {
  std::vector<int> found;
  std::error_code error;
  for (fs::directory_iterator entry("/proc"); entry != fs::directory_iterator();
       entry.increment(error)) {
    const std::string name = entry->path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    // Not a stream: it throws when the process ends in between.
    std::array<char, 1024> line{};
    const int file = open((entry->path() / "cmdline").c_str(), O_RDONLY | O_CLOEXEC);
    const ssize_t size = read(file, line.data(), line.size());
    close(file);
    if (size > 0 && std::string_view(line.data(), static_cast<std::size_t>(size)).find(marker) !=
                        std::string_view::npos)
      found.push_back(std::stoi(name));
  }
  return found;
}

std::string describe(const Result& result) {
  static constexpr const char* kEnds[] = {"exited",      "signalled",   "timeLimit",
                                          "memoryLimit", "interrupted", "setupFailed"};
  return std::string("end ") + kEnds[static_cast<int>(result.end)] + ", exit code " +
         std::to_string(result.exitCode) + ", signal " + std::to_string(result.signal) + ", wall " +
         std::to_string(result.wallSeconds) + " s, cpu " + std::to_string(result.cpuSeconds) +
         " s, peak " + std::to_string(result.peakMemoryBytes) + " bytes\ndetail: " + result.detail +
         "\nstdout: " + result.standardOutput.substr(0, 4000) +
         "\nstderr: " + result.standardError.substr(0, 4000);
}
