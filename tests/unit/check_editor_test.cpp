// The student's editor, and keys of the terminal.
#include "assignment/usage_error.hpp"
#include "check/editor.hpp"
#include "check/keys.hpp"
#include "grading/workspace.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <thread>

#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace ggrade;
using namespace ggrade::check;
using namespace std::chrono_literals;
using testing::HasSubstr;

namespace {

namespace fs = std::filesystem;

/// With these variables alone, as they were after it.
struct Editors {
  Editors(const char* visual, const char* editor) {
    visual ? setenv("VISUAL", visual, 1) : unsetenv("VISUAL");
    editor ? setenv("EDITOR", editor, 1) : unsetenv("EDITOR");
  }
  ~Editors() {
    unsetenv("VISUAL");
    unsetenv("EDITOR");
  }
};

std::string refusalOf(const std::string& given) {
  try {
    return editorCommand(given);
  } catch (const UsageError& error) {
    return std::string("refused: ") + error.what();
  }
}

TEST(CheckEditor, IsTheOneThatIsNamedElseTheUsersOwn) {
  {
    const Editors both("gvim", "nano");
    EXPECT_EQ(editorCommand("kate -l {line} {file}"), "kate -l {line} {file}");
    EXPECT_EQ(editorCommand(""), "gvim +{line} {file}");
    EXPECT_THAT(refusalOf("kate"), HasSubstr("--edit-cmd \"kate\" has no {file}"));
  }
  const Editors code("", "/usr/bin/code --wait");
  EXPECT_EQ(editorCommand(""), "/usr/bin/code --wait -g {file}:{line}");
  const Editors none(nullptr, nullptr);
  EXPECT_THAT(refusalOf(""), HasSubstr("set VISUAL or EDITOR"));
}

TEST(CheckEditor, SomeNeedTheTerminal) {
  for (const char* command : {"vim +{line} {file}", "/usr/bin/nvim {file}", "nano {file}", "vi"})
    EXPECT_TRUE(needsTerminal(command)) << command;
  for (const char* command :
       {"", "code -g {file}", "gvim {file}", "nvim --server s --remote {file}",
        "vim --remote +{line} {file}", "tmux split-window vim {file}"})
    EXPECT_FALSE(needsTerminal(command)) << command;
}

TEST(CheckEditor, APlaceIsQuotedForTheShell) {
  EXPECT_EQ(withPlace("code -g {file}:{line}", {"it's a/m.cpp", 12, 3}),
            R"(code -g 'it'\''s a/m.cpp':12)");
}

TEST(CheckEditor, OpensBesideAndSaysHowItEnded) {
  const grading::TemporaryFolder folder;
  const fs::path made = folder.path() / "it's";
  Beside beside;
  beside.open(withPlace("echo {line} > {file}; test -t 0 || exit 3", {made.string(), 7, 0}));
  std::optional<int> failed;
  for (int i = 0; i < 200 && !(failed = beside.failed()); ++i) std::this_thread::sleep_for(10ms);
  EXPECT_EQ(failed, 3) << "it has no terminal";
  EXPECT_EQ(beside.failed(), std::nullopt) << "told once";
  std::ifstream in(made);
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, "7");
}

TEST(CheckKeys, ComeOneAtATimeAndTheTerminalIsAsBefore) {
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
  ASSERT_GE(child, 0);
  if (child == 0) {
    char key = 0;
    {
      Keys keys;
      if (!keys.areThere() || write(STDOUT_FILENO, "?", 1) != 1) _exit(2);
      key = keys.next(5s);
    }
    termios after{};
    tcgetattr(STDIN_FILENO, &after);
    _exit((after.c_lflag & ICANON) && (after.c_lflag & ECHO) ? key : 1);
  }
  char asked = 0;
  EXPECT_EQ(read(terminal, &asked, 1), 1);
  termios within{};
  tcgetattr(terminal, &within);
  EXPECT_FALSE(within.c_lflag & (ICANON | ECHO));
  EXPECT_TRUE(within.c_lflag & ISIG) << "Ctrl-C";
  EXPECT_EQ(write(terminal, "h", 1), 1); // without Enter
  int status = 0;
  waitpid(child, &status, 0);
  close(terminal);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 'h');
}

TEST(CheckKeys, NoneComeWithoutATerminal) {
  const pid_t child = fork();
  if (child == 0) {
    int ends[2] = {-1, -1};
    if (pipe(ends) != 0 || write(ends[1], "h", 1) != 1 || dup2(ends[0], STDIN_FILENO) < 0) _exit(2);
    Keys keys;
    const auto start = std::chrono::steady_clock::now();
    const char key = keys.next(20ms);
    const bool waited = std::chrono::steady_clock::now() - start >= 15ms;
    _exit(!keys.areThere() && key == 0 && waited ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

} // namespace
