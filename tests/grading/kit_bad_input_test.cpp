// `ggrade check` on files as editors, disks and people leave them.

#include "../unit/another_layout.hpp"
#include "kit_check.hpp"

#include <gmock/gmock.h>

#include <iconv.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <thread>

using namespace tool;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

namespace {

const std::vector<std::string> kFour = {"done",      "done",      "done",     "done",
                                        "not_begun", "not_begun", "not_begun"};

std::vector<std::string> statesIn(const json& part) {
  std::vector<std::string> states;
  for (const json& todo : part.at("todos")) states.push_back(todo.at("state"));
  return states;
}

/// Changes the text of every file.
template <class Change> void rewrite(const fs::path& folder, Change change) {
  for (const std::string& name : names(folder)) {
    const std::string text = change(read(folder / name));
    std::ofstream(folder / name, std::ios::binary) << text;
  }
}

std::string inShiftJis(std::string text) {
  const iconv_t converter = iconv_open("CP932", "UTF-8");
  std::string out(2 * text.size() + 1, '\0');
  char *from = text.data(), *to = out.data();
  std::size_t left = text.size(), room = out.size();
  EXPECT_NE(iconv(converter, &from, &left, &to, &room), std::size_t(-1)) << from;
  iconv_close(converter);
  return out.substr(0, out.size() - room);
}

TEST_F(Check, KnowsAStepInAnotherLayout) {
  const Submission submission = Submission::firstSteps(4);
  rewrite(submission.path(), inAnotherLayout);
  EXPECT_EQ(statesIn(checked(submission.path())), kFour);
}

/// What editors in Japan may save. It compiles, and is told with the place and what to do.
TEST_F(Check, KnowsAStepInShiftJis) {
  const TemporaryFolder step;
  ASSERT_EQ(
      runTool({"derive", "mirror", "--done", "4", "--lang", "ja", "--out", step.path()}).exitCode,
      0);
  rewrite(step.path(), inShiftJis);
  const json part = checked(step.path());
  EXPECT_EQ(statesIn(part), kFour) << part.dump(1);
  ASSERT_EQ(part.at("messages").size(), 1u) << part.at("messages");
  EXPECT_THAT(part.at("messages").at(0).get<std::string>(),
              AllOf(StartsWith("bloom.hpp:1: warning: this file is not UTF-8"),
                    HasSubstr("Save it as UTF-8"), HasSubstr(", floor.cpp, mirror.hpp, ")));
  EXPECT_THAT(part.at("problems").dump(),
              HasSubstr((step.path() / "bloom.hpp").filename().string()));
}

/// The comment's last byte is a backslash.
TEST_F(Check, TellsOfALineThatShiftJisSwallows) {
  Submission submission = Submission::solution();
  submission.replace("floor.cpp", "    window.swapBuffers();",
                     "    // " + inShiftJis("表") + "\n    window.swapBuffers();");
  json part = checked(submission.path());
  EXPECT_THAT(part.at("cause").get<std::string>(), HasSubstr("a comment swallows the line"));
  EXPECT_THAT(part.at("messages").dump(), HasSubstr("this file is not UTF-8"));
  submission.replace("floor.cpp", "    window.swapBuffers();", "    window.swap();");
  submission.replace("floor.cpp", inShiftJis("表"), inShiftJis("裏"));
  part = checked(submission.path());
  EXPECT_EQ(part.at("outcome"), "build_failed");
  EXPECT_THAT(part.at("messages").dump(), HasSubstr("this file is not UTF-8"));
}

/// As an editor does that empties a file before it writes it: nothing is told of a state that never
/// was, nor of a half one.
TEST_F(Check, LooksAgainAtWhatIsSavedMeanwhile) {
  const Submission submission = Submission::firstSteps(2), four = Submission::firstSteps(4);
  Running looking(command(submission.path(), {"--json"}));
  const std::string program = read(four.path() / "floor.cpp");
  const auto latest = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (looking.errors().find("looking again") == std::string::npos &&
         std::chrono::steady_clock::now() < latest) {
    std::ofstream(submission.path() / "floor.cpp") << program.substr(0, program.size() / 2);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  for (const std::string& name : names(four.path()))
    fs::copy_file(four.path() / name, submission.path() / name,
                  fs::copy_options::overwrite_existing);
  const Ended ended = looking.wait(100);
  EXPECT_EQ(ended.exitCode, 0) << ended.errors;
  EXPECT_THAT(ended.errors, HasSubstr("files were saved meanwhile"));
  EXPECT_EQ(statesIn(json::parse(ended.out).at(0)), kFour);
}

TEST_F(Check, WorksInAFolderWithSpacesAndJapanese) {
  const TemporaryFolder folder;
  const fs::path files = folder.path() / "ゲーム グラフィックス's (1)";
  fs::copy(Submission::firstSteps(4).path(), files);
  EXPECT_EQ(statesIn(checked(files)), kFour);
  std::ofstream(files / "floor.cpp", std::ios::app) << "int x = y;\n";
  const Ended ended = Running(command(files)).wait(100);
  EXPECT_THAT(ended.out, HasSubstr((files / "floor.cpp:").relative_path().string()));
}

/// Somebody else's kit, or one that root has built.
TEST_F(Check, SaysWhereItMayNotWrite) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can become somebody else";
  const Submission submission = Submission::firstSteps(1);
  fs::permissions(folder_.path(), fs::perms::all);
  // What is compared with is a kit's, which everybody may read.
  fs::permissions(expected() / "mirror", fs::perms::others_read | fs::perms::others_exec,
                  fs::perm_options::add);
  const auto asNobody = [&](Arguments words) {
    Arguments all = {"/usr/bin/setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"};
    all.insert(all.end(), words.begin(), words.end());
    return Running(all).wait(20);
  };
  Running(command(submission.path())).wait(100); // as root
  const Ended ended = asNobody(command(submission.path()));
  EXPECT_EQ(ended.exitCode, 2);
  EXPECT_THAT(ended.errors, AllOf(HasSubstr((kBuild / "check/floor").string() +
                                            ", where you may not write. Copy the whole folder " +
                                            kSource.string()),
                                  HasSubstr("to one of your own")));
  EXPECT_EQ(ended.out, "");
}

} // namespace
