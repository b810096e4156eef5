#include "check/editor.hpp"

#include "assignment/usage_error.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <string_view>
#include <vector>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ggrade::check {

using gg::say;

namespace {

constexpr std::array<std::string_view, 15> kInTerminal = {
    "vi", "vim", "vim.basic", "vim.tiny", "nvim", "nano",   "pico", "micro",
    "hx", "kak", "joe",       "ne",       "ed",   "mcedit", "helix"};
/// These take a place as file:line, behind -g.
constexpr std::array<std::string_view, 4> kLikeCode = {"code", "code-insiders", "codium", "cursor"};

std::vector<std::string> wordsOf(const std::string& command) {
  std::istringstream in(command);
  std::vector<std::string> all;
  for (std::string word; in >> word;) all.push_back(word);
  return all;
}

/// The program's name without its folder.
std::string programOf(const std::string& command) {
  const std::vector<std::string> all = wordsOf(command);
  return all.empty() ? "" : all[0].substr(all[0].find_last_of('/') + 1);
}

template <class List> bool isOneOf(const List& list, const std::string& name) {
  return std::ranges::find(list, name) != list.end();
}

std::string quoted(const std::string& text) {
  std::string all = "'";
  for (const char c : text) all += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return all + "'";
}

void replaceAll(std::string& text, std::string_view what, const std::string& by) {
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

[[noreturn]] void becomeShell(const std::string& command) {
  signal(SIGPIPE, SIG_DFL); // ignored here, which a program inherits
  execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
  _exit(127);
}

} // namespace

std::string editorCommand(const std::string& given) {
  if (!given.empty()) {
    if (given.find("{file}") == given.npos)
      throw UsageError(say("--edit-cmd \"{}\" has no {{file}}: such as --edit-cmd "
                           "\"code -g {{file}}:{{line}}\"",
                           given));
    return given;
  }
  for (const char* variable : {"VISUAL", "EDITOR"})
    if (const char* editor = std::getenv(variable); editor && *editor)
      return std::string(editor) +
             (isOneOf(kLikeCode, programOf(editor)) ? " -g {file}:{line}" : " +{line} {file}");
  throw UsageError(say("--open: no editor is known: set VISUAL or EDITOR, or name one, such as "
                       "--edit-cmd \"code -g {{file}}:{{line}}\""));
}

bool needsTerminal(const std::string& command) {
  const std::vector<std::string> all = wordsOf(command);
  // One that asks an editor elsewhere to open the file ends at once.
  return isOneOf(kInTerminal, programOf(command)) &&
         std::ranges::none_of(all, [](const std::string& w) { return w.starts_with("--remote"); });
}

std::string withPlace(const std::string& command, const Place& place) {
  std::string text = command;
  replaceAll(text, "{line}", std::to_string(place.line));
  replaceAll(text, "{file}", quoted(place.file));
  return text;
}

void Beside::open(const std::string& command) {
  const pid_t child = fork();
  if (child > 0) running_.push_back(child);
  if (child != 0) return;
  setsid();
  if (const int null = ::open("/dev/null", O_RDWR); null >= 0)
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
      dup2(null, descriptor);
  close_range(STDERR_FILENO + 1, ~0U, 0); // whoever locks the build with one waits for no editor
  becomeShell(command);
}

std::optional<int> Beside::failed() {
  std::optional<int> code;
  std::erase_if(running_, [&](pid_t child) {
    int status = 0;
    if (waitpid(child, &status, WNOHANG) == 0) return false;
    if (WIFEXITED(status) && WEXITSTATUS(status) != 0) code = WEXITSTATUS(status);
    return true;
  });
  return code;
}

void openHere(const std::string& command) {
  const pid_t child = fork();
  if (child == 0) becomeShell(command);
  int status = 0;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
}

} // namespace ggrade::check
