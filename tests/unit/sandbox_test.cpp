#include "grader/sandbox/bwrap_arguments.hpp"
#include "grader/sandbox/helper_plan.hpp"
#include "grader/sandbox/seccomp_filter.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

using namespace ggrade::sandbox;
using testing::ElementsAre;

namespace {

bool holds(const std::vector<std::string>& list, const std::vector<std::string>& part) {
  return std::search(list.begin(), list.end(), part.begin(), part.end()) != list.end();
}

Command commandWithMount(const std::string& host, const std::string& inside) {
  Command command;
  command.arguments = {"/program"};
  command.mounts = {{host, inside}};
  return command;
}

} // namespace

TEST(HelperPlan, SurvivesTheTrip) {
  HelperPlan plan;
  plan.uid = 60578;
  plan.staged = {"/a", "", "/c d"};
  plan.kept = {17, 3};
  plan.arguments = {"/program", "", "two\nlines"};
  plan.environment = {"A=b"};
  plan.collect = {"/scratch/product", "/scratch/other"};
  plan.processes = 65;
  const HelperPlan copy = decode(encode(plan));
  EXPECT_EQ(encode(copy), encode(plan));
  EXPECT_EQ(copy.uid, 60578);
  EXPECT_THAT(copy.staged, ElementsAre("/a", "", "/c d"));
  EXPECT_THAT(copy.kept, ElementsAre(17, 3));
  EXPECT_THAT(copy.arguments, ElementsAre("/program", "", "two\nlines"));
  EXPECT_THAT(copy.collect, ElementsAre("/scratch/product", "/scratch/other"));
  EXPECT_EQ(copy.inherited, -1);
  EXPECT_EQ(copy.processes, 65u);
}

TEST(HelperPlan, TornBytesAreNoTrouble) {
  const std::string whole = encode(HelperPlan{});
  for (std::size_t length = 0; length < whole.size(); ++length) decode(whole.substr(0, length));
  EXPECT_TRUE(decode("").arguments.empty());
}

TEST(View, NamesSourcesByPathOrByStage) {
  const Command command = commandWithMount("/usr/bin/env", "/program");
  const View plain = composeView(command, "/usr/bin/true", false, 7, 8);
  EXPECT_TRUE(holds(plain.arguments, {"--ro-bind", "/usr/bin/env", "/program"}));
  EXPECT_TRUE(holds(plain.arguments, {"--seccomp", "7", "--info-fd", "8"}));
  const View staged = composeView(command, "/usr/bin/true", true, 7, 8);
  const std::string last = "/tmp/" + std::to_string(staged.sources.size() - 1);
  EXPECT_EQ(staged.sources.back(), "/usr/bin/env");
  EXPECT_TRUE(holds(staged.arguments, {"--ro-bind", last, "/program"}));
}

TEST(View, HasTheLockedDoorsAndASizeForEveryWritableFolder) {
  Command command;
  command.arguments = {"/program"};
  command.limits.scratchBytes = 12345678;
  command.privateCopies = {{"/usr/bin", "/cache"}};
  const View view = composeView(command, "/usr/bin/true", false, 7, 8);
  for (const char* option : {"--unshare-all", "--unshare-user", "--disable-userns",
                             "--die-with-parent", "--new-session", "--clearenv"})
    EXPECT_TRUE(holds(view.arguments, {option})) << option;
  EXPECT_TRUE(holds(view.arguments, {"--cap-drop", "ALL"}));
  EXPECT_THAT(view.writableFolders, ElementsAre("/scratch", "/tmp", "/cache"));
  for (const std::string& folder : view.writableFolders)
    EXPECT_TRUE(holds(view.arguments, {"--size", "12345678", "--tmpfs", folder})) << folder;
  EXPECT_THAT(view.copies, ElementsAre("/run/originals/0", "/cache"));
  EXPECT_EQ(std::count(view.arguments.begin(), view.arguments.end(), "--bind"), 0);
#ifndef __SANITIZE_ADDRESS__
  EXPECT_EQ(std::count(view.arguments.begin(), view.arguments.end(), "--proc"), 0);
#endif
  EXPECT_TRUE(holds(view.arguments, {"--ro-bind", "/usr/bin", "/usr/bin"}));
  // Nothing may be added after the root has become read-only.
  EXPECT_EQ(*std::prev(view.arguments.end(), 2), "--remount-ro");
  EXPECT_EQ(view.arguments.back(), "/");
}

TEST(View, HasTheSystemsFilesAloneWhereTheyAreNamed) {
  Command command;
  command.arguments = {"/program"};
  command.systemFiles = {"/usr/bin/env"};
  const View view = composeView(command, "/usr/bin/true", false, 7, 8);
  EXPECT_TRUE(holds(view.arguments, {"--ro-bind", "/usr/bin/env", "/usr/bin/env"}));
  EXPECT_FALSE(holds(view.arguments, {"--ro-bind", "/usr/bin", "/usr/bin"}));
  EXPECT_FALSE(holds(view.arguments, {"--ro-bind", "/usr/lib", "/usr/lib"}));
}

TEST(View, RefusesMountsThatCoverTheSystem) {
  for (const char* inside : {"/", "/usr", "/etc", "/proc", "/dev", "/run", "/scratch", "/tmp",
                             "relative", "/a/../b", "/usr/"})
    EXPECT_THROW(composeView(commandWithMount("/usr/bin", inside), "/usr/bin/true", false, 7, 8),
                 std::runtime_error)
        << inside;
}

// bubblewrap before 0.12.0 follows a link in a mount point's parent: nobody else may have made one.
TEST(View, NoMountPointLiesInAFolderFromOutside) {
  Command command = commandWithMount("/usr/bin", "/submission");
  command.arguments = {"/submission/program"};
  command.systemFiles = {"/usr/bin/env", "/usr/bin/true"};
  command.privateCopies = {{"/usr/bin", "/shaders"}};
  for (const char* inside : {"/scene", "/capture/libGL.so.1", "/capture/libglfw.so.3"})
    command.mounts.push_back({"/usr/bin/env", inside});
  const View view = composeView(command, "/usr/bin/true", false, 7, 8);
  std::vector<std::filesystem::path> folders;
  std::size_t places = 0;
  for (std::size_t i = 0; i + 2 < view.arguments.size(); ++i) {
    if (view.arguments[i] != "--ro-bind" && view.arguments[i] != "--dev-bind") continue;
    const std::filesystem::path place = view.arguments[i + 2];
    for (const std::filesystem::path& folder : folders)
      EXPECT_EQ(*place.lexically_relative(folder).begin(), "..") << place << " in " << folder;
    if (std::filesystem::is_directory(view.arguments[i + 1])) folders.push_back(place);
    ++places;
  }
  EXPECT_GT(places, 9U);
  EXPECT_EQ(folders.size(), 2U) << "submission and originals";
  command.mounts.push_back({"/usr/bin/env", "/submission/data"});
  EXPECT_THROW(composeView(command, "/usr/bin/true", false, 7, 8), std::runtime_error);
}

TEST(SeccompFilter, IsOneProgramOfWholeInstructions) {
  const std::string& filter = seccompFilter(true);
  EXPECT_GT(filter.size(), 1000u);
  EXPECT_EQ(filter.size() % 8, 0u);
  EXPECT_EQ(&filter, &seccompFilter(true));
  EXPECT_NE(filter, seccompFilter(false));
}
