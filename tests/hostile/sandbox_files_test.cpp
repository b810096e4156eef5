// Nothing of the host can be read or changed beyond what is mounted.
#include "sandbox_fixture.hpp"

#include <gmock/gmock.h>

#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/mman.h>
#include <sys/mount.h>
#include <unistd.h>

namespace fs = std::filesystem;
using namespace ggrade::sandbox;
using testing::HasSubstr;
using testing::Not;

SANDBOX_SUITE(SandboxFiles);

TEST_P(SandboxFiles, CannotRemount) {
  if (delegated()) return;
  expectRefused("remount");
}

TEST_P(SandboxFiles, CannotReadTheFirstProcess) {
  if (delegated()) return;
  expectRefused("proc");
}

TEST_P(SandboxFiles, SeesOnlyItsOwnEnvironment) {
  if (delegated()) return;
  setenv("GGRADE_SECRET_VARIABLE", "the solution", 1);
  Command command = attack("reveal");
  command.environment = {{"GIVEN", "value"}};
  const Result result = run(command);
  unsetenv("GGRADE_SECRET_VARIABLE");
  EXPECT_THAT(result.standardOutput, Not(HasSubstr("SECRET"))) << describe(result);
  // Neither bwrap's arguments nor a path of the host.
  EXPECT_EQ(result.standardOutput, "\nvariable GIVEN=value\n");
}

TEST_P(SandboxFiles, OfProcThereIsItsOwnProgramAlone) {
  if (delegated()) return;
  Command command;
  command.arguments = {"/usr/bin/find", "/proc", "-printf", "%p %l\n"};
  const Result result = run(command);
  EXPECT_EQ(result.standardOutput, "/proc \n/proc/self \n/proc/self/exe /usr/bin/find\n")
      << describe(result);
}

TEST_P(SandboxFiles, CannotReadTheHostsFigures) {
  if (delegated()) return;
  expectRefused("figures", {"/", "/usr", "/usr/bin", "/attack", "/dev/null"});
}

TEST_P(SandboxFiles, CannotReadTheHost) {
  if (delegated()) return;
  const std::string secret = folder() + "/secret";
  std::ofstream(secret) << "the solution";
  expectRefused("readHost", {"/root",
                             "/home",
                             "/etc/passwd",
                             "/etc/shadow",
                             "/etc/hostname",
                             "/var",
                             "/sys",
                             "/boot",
                             "/mnt",
                             "/opt",
                             "/srv",
                             "/usr/local",
                             "/usr/src",
                             secret,
                             folder() + "/data/file",
                             programs(),
                             GGRADE_SOURCE_DIR,
                             GGRADE_SOURCE_DIR "/solutions",
                             "/attack/data/../../secret",
                             "/run/user",
                             "/proc/self/mountinfo",
                             "/proc/self/maps",
                             "/proc/loadavg",
                             "/proc/cmdline",
                             "/proc/meminfo",
                             "/proc/stat",
                             "/proc/pressure/cpu",
                             "/dev/fd",
                             "/newroot",
                             "/oldroot"});
}

TEST_P(SandboxFiles, CannotWriteOutside) {
  if (delegated()) return;
  const std::string name = "ggrade-" + marker();
  const std::vector<std::string> folders = {"/",    "/usr",         "/usr/bin", "/usr/lib",
                                            "/etc", "/attack/data", "/attack",  "/dev",
                                            "/run", "/proc"};
  std::vector<std::string> arguments = {name};
  arguments.insert(arguments.end(), folders.begin(), folders.end());
  expectRefused("writeOutside", arguments);
  for (const std::string& place :
       {std::string("/"), std::string("/usr/bin/"), std::string("/usr/lib/"), std::string("/etc/"),
        folder() + "/data/", folder() + "/"})
    EXPECT_FALSE(fs::exists(place + name)) << place;
}

TEST_P(SandboxFiles, CannotLeaveItsRoot) {
  if (delegated()) return;
  expectRefused("chroot");
}

TEST_P(SandboxFiles, CannotGainRights) {
  if (delegated()) return;
  expectRefused("setuid");
}

TEST_P(SandboxFiles, HasNoDevices) {
  if (delegated()) return;
  expectRefused("device");
}

TEST_P(SandboxFiles, InheritsNoDescriptor) {
  if (delegated()) return;
  // Open here without close-on-exec, as careless code leaves them.
  const int careless = open("/dev/null", O_WRONLY);
  const int high = fcntl(careless, F_DUPFD, 900);
  const Result result = run(attack("listDescriptors"));
  EXPECT_EQ(result.standardOutput, "open 0\nopen 1\nopen 2\n") << describe(result);
  expectRefused("writeDescriptors");
  close(careless);
  close(high);
}

TEST_P(SandboxFiles, InheritsTheOneDescriptorThatIsGiven) {
  if (delegated()) return;
  const int low = memfd_create("channel", MFD_CLOEXEC);
  for (const int wanted : {low, fcntl(low, F_DUPFD_CLOEXEC, 500)}) {
    const std::string number = std::to_string(wanted);
    Command command = attack("listDescriptors");
    command.inheritedDescriptor = wanted;
    EXPECT_EQ(run(command).standardOutput, "open 0\nopen 1\nopen 2\nopen " + number + "\n");
    lseek(wanted, 0, SEEK_SET);
    command.arguments = {"/attack/attacker", "writeInherited", number};
    const Result result = run(command);
    EXPECT_EQ(result.exitCode, 0) << describe(result);
    char text[12] = {};
    EXPECT_EQ(pread(wanted, text, 11, 0), 11);
    EXPECT_STREQ(text, "from inside");
    close(wanted);
  }
}

TEST_P(SandboxFiles, CollectsARegularFile) {
  if (delegated()) return;
  Command command = attack("collect", {"regular"});
  command.collect = {{"/scratch/product", folder() + "/product"}};
  const Result result = run(command);
  EXPECT_TRUE(result.collected) << describe(result) << result.collectProblem;
  std::string content;
  std::getline(std::ifstream(folder() + "/product"), content);
  EXPECT_EQ(content, "product");
  // Executable, but never setuid.
  EXPECT_EQ(fs::status(folder() + "/product").permissions(), fs::perms(0755));
}

TEST_P(SandboxFiles, CollectsAllFilesOrNone) {
  if (delegated()) return;
  Command command = attack("collect", {"regular"});
  command.collect = {{"/scratch/product", folder() + "/first"},
                     {"/attack/data/plain", folder() + "/second"}};
  std::ofstream(folder() + "/data/plain") << "plain";
  ASSERT_TRUE(run(command).collected);
  EXPECT_EQ(fs::file_size(folder() + "/first"), 7u);
  EXPECT_EQ(fs::file_size(folder() + "/second"), 5u);
  EXPECT_EQ(fs::status(folder() + "/first").permissions(), fs::perms(0755));
  EXPECT_EQ(fs::status(folder() + "/second").permissions(), fs::perms(0644));
  command.collect = {{"/scratch/product", folder() + "/third"},
                     {"/scratch/missing", folder() + "/fourth"}};
  const Result result = run(command);
  EXPECT_FALSE(result.collected);
  EXPECT_EQ(result.collectProblem, "/scratch/missing cannot be opened: No such file or directory");
  EXPECT_FALSE(fs::exists(folder() + "/third"));
}

// Else a program that is right would be told that it doesn't compile.
TEST_P(SandboxFiles, AFullDiskOfOursIsNoFaultOfTheCommands) {
  if (delegated()) return;
  const std::string small = folder() + "/small";
  fs::create_directory(small);
  if (mount("tmpfs", small.c_str(), "tmpfs", 0, "size=4k,nr_inodes=8") != 0)
    return; // only root can make a disk that is full
  std::ofstream(small + "/taken") << std::string(4096, 't') << std::flush;
  Command command = attack("collect", {"regular"});
  command.collect = {{"/scratch/product", small + "/product"}};
  const Result result = run(command);
  umount(small.c_str());
  EXPECT_FALSE(result.collected);
  EXPECT_TRUE(result.collectIsOurs) << describe(result);
  EXPECT_EQ(result.collectProblem, "/scratch/product cannot be stored: No space left on device");
}

TEST_P(SandboxFiles, CollectsNothingElse) {
  if (delegated()) return;
  const struct {
    const char* kind;
    const char* path;
    const char* problem;
  } cases[] = {
      {"symlink", "/scratch/product", "is reached through a symbolic link"},
      {"loop", "/scratch/product", "is reached through a symbolic link"},
      {"linkedFolder", "/scratch/folder/environ", "is reached through a symbolic link"},
      {"fifo", "/scratch/product", "is not a regular file"},
      {"folder", "/scratch/product", "is not a regular file"},
      {"large", "/attack/data/large", "has 3145728 bytes, the limit is 2097152"},
      {"none", "/scratch/product", "cannot be opened: No such file or directory"},
  };
  std::ofstream(folder() + "/data/large") << std::string(3 << 20, 'l');
  for (const auto& [kind, path, problem] : cases) {
    Command command = attack("collect", {kind});
    command.collect = {{path, folder() + "/product"}};
    command.limits.fileBytes = 2 << 20;
    const Result result = run(command);
    EXPECT_FALSE(result.collected) << kind;
    EXPECT_THAT(result.collectProblem, HasSubstr(problem)) << kind << " " << describe(result);
  }
  // Neither the file nor its temporary name is left.
  for (const auto& entry : fs::directory_iterator(folder()))
    EXPECT_EQ(entry.path().filename(), "data");
}

TEST_P(SandboxFiles, CopiesFoldersThatMayBeChanged) {
  if (delegated()) return;
  fs::create_directories(folder() + "/cache/deep");
  std::ofstream(folder() + "/cache/deep/entry") << "warm";
  fs::permissions(folder() + "/cache/deep/entry", fs::perms(0444));
  Command command;
  command.arguments = {"/bin/sh", "-c",
                       "cat /cache/deep/entry && echo changed > /cache/deep/entry && "
                       "echo new > /cache/new && cat /cache/deep/entry"};
  command.environment = {{"PATH", "/usr/bin"}};
  command.privateCopies = {{folder() + "/cache", "/cache"}};
  for (int round = 0; round < 2; ++round) {
    const Result result = run(command);
    EXPECT_EQ(result.standardOutput, "warmchanged\n") << describe(result);
    EXPECT_FALSE(fs::exists(folder() + "/cache/new"));
  }
}
