/// \file
/// What the programs `ggrade` and `ggrade-author` share: the frame of a command line, exit codes,
/// and what several commands ask of it.

#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/terminal.hpp"

#include "assignment/assignment.hpp"
#include "grading/program.hpp"
#include "grading/scenes.hpp"
#include "grading/toolchain.hpp"
#include "grading/workspace.hpp"
#include "sandbox/sandbox.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <system_error>

#include <unistd.h>

namespace ggrade::cli {

namespace fs = std::filesystem;

int exitCode = kDone;
std::vector<std::string> afterDashes;

namespace {

/// Takes `--lang WORD` out of what stands before `--`. Programs and judges that are started follow.
void takeLanguage(std::vector<char*>& words) {
  const auto dashes = [&] {
    return std::ranges::find_if(words,
                                [](const char* word) { return word == std::string_view("--"); });
  };
  for (auto word = words.begin(); word != dashes();) {
    const std::string_view text = *word;
    const bool joined = text.starts_with("--lang=");
    if (!joined && text != "--lang") {
      ++word;
      continue;
    }
    if (!joined && std::next(word) == dashes())
      throw UsageError(gg::say("--lang needs a value: en or ja"));
    const std::string_view named = joined ? text.substr(7) : std::string_view(*std::next(word));
    const auto language = gg::parseLanguage(named);
    if (!language) throw UsageError(gg::say("--lang {}: there are en and ja", named));
    gg::setLanguage(*language);
    setenv("GG_LANG", std::string(named).c_str(), 1);
    word = words.erase(word, std::next(word, joined ? 1 : 2));
  }
}

/// No sandbox: an outcome of its own, with its own exit code.
struct NoSandbox : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Commands that are a program of their own, so that nothing else builds or loads what they stand
/// on: it gets the same words, and `compare`, which has no subcommands, those behind the first.
/// Returns if the command is none of them.
void startElsewhere(const std::string& command, char** words) {
  constexpr std::pair<const char*, const char*> kPrograms[] = {
      {"list", "ggrade-look"},       {"render", "ggrade-look"},      {"inspect", "ggrade-look"},
      {"compare", "ggrade-compare"}, {"calibrate", "ggrade-author"}, {"tradeoff", "ggrade-author"},
      {"derive", "ggrade-author"},   {"new", "ggrade-author"},       {"release", "ggrade-author"},
      {"expect", "ggrade-author"}};
  for (const auto& [name, file] : kPrograms) {
    if (command != name) continue;
    const std::string program = fmt::format("{}/bin/{}", toolchain::kBuildFolder, file);
    execv(program.c_str(), command == "compare" ? words + 1 : words);
    throw UsageError(gg::say("can't start {}: {}", program, std::strerror(errno)));
  }
}

/// Also what keeps submissions away from this machine, tried now: who reports a fault, or prepares
/// a machine for a class, must know.
std::string versionText() {
  const sandbox::SelfTest test = sandbox::selfTest();
  std::string text = fmt::format("ggrade {}\n", toolchain::kVersion);
  text +=
      gg::say("sandbox: {}", sandbox::isInstalled() ? sandbox::version() : gg::say("none")) + '\n';
  text += test.problem ? gg::say("self-test: failed: {}", *test.problem)
                       : gg::say("self-test: passed, {} escapes were tried and refused",
                                 test.refused.size());
  try {
    const grading::Drawing& drawing = grading::drawing();
    text += '\n' + gg::say("drawing: {}, {}, {}", drawing.context, drawing.renderer.version,
                           drawing.renderer.name);
  } catch (const grading::CannotDraw& error) {
    text += '\n' + gg::say("drawing: {}", error.what());
  }
  return text;
}

int run(int count, char** given, const std::vector<AddCommand>& commands) {
  std::vector<char*> words(given, given + count);
  takeLanguage(words);
  const int argc = int(words.size());
  words.push_back(nullptr);
  char** const argv = words.data();
  CLI::App app("Teaches and grades real-time graphics: builds a submission in a sandbox, renders "
               "it and the\n"
               "reference offscreen, and says in words and pictures what is right and what is not.",
               "ggrade");
  app.footer(
      "Examples:\n"
      "  ggrade demo\n"
      "  ggrade grade mirror uploads/ada --out out/ada\n"
      "  ggrade batch mirror uploads --out class\n"
      "  ggrade COMMAND --help\n\n"
      "Also: ggrade run ID (a window), ggrade list, render, inspect, ggrade test (all tests),\n"
      "ggrade compare A B (two images),\n"
      "for authors of assignments ggrade calibrate, tradeoff, derive, new, release.\n"
      "Every command: --lang en|ja, what students read (default: by GG_LANG, else the locale).");
  app.set_version_flag("--version", versionText);
  app.require_subcommand(1);
  sayErrors(app);
  for (const AddCommand add : commands) add(app);
  const std::string command = argc > 1 ? argv[1] : "";
  if (std::ranges::none_of(app.get_subcommands({}),
                           [&](const CLI::App* ours) { return ours->get_name() == command; }))
    startElsewhere(command, argv);
  // Not CLI11's own `--`, which gives the next word to whatever positional is still open.
  char** const end = argv + argc;
  char** const dashes =
      std::find_if(argv + 1, end, [](const char* word) { return std::strcmp(word, "--") == 0; });
  if (dashes != end) afterDashes.assign(dashes + 1, end);
  if (!afterDashes.empty() && command != "grade" && command != "render" && command != "judge")
    throw UsageError(gg::say("{} takes nothing after --: run with --help", command));
  try {
    app.parse(int(dashes - argv), argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kDone : kUsage;
  }
  return exitCode;
}

} // namespace

fs::path assignmentsFolder() {
  return fs::path(toolchain::kSourceFolder) / "assignments";
}

fs::path solutionFolder(const std::string& assignment) {
  const fs::path folder = fs::path(toolchain::kSourceFolder) / "solutions" / assignment;
  if (!fs::is_directory(folder))
    throw UsageError(gg::say("{} is not there: this command needs the solutions", folder.string()));
  return folder;
}

std::vector<std::string> requireSandbox() {
  grading::drawing();
  sandbox::SelfTest test = sandbox::selfTest();
  if (test.problem)
    throw NoSandbox(
        gg::say("no sandbox: {}\n"
                "Submissions are not run without one, unless you trust them all and say --sandbox "
                "none.",
                *test.problem));
  return std::move(test.refused);
}

std::string notAWholeNumber(const std::string& text) {
  const bool digits = !text.empty() && text.find_first_not_of("0123456789") == text.npos;
  return digits ? std::string() : text + " is not a whole number from 0";
}

CLI::Option* declareQuality(CLI::App& app, std::string& quality, const std::string& about) {
  return app
      .add_option("--quality", quality,
                  about + ": fast (a fifth less time; no scenes that are like another but for a "
                          "change, no second run), balanced, thorough (hidden scenes drawn twice)")
      ->check(CLI::IsMember(
          std::vector<std::string>(std::begin(grading::kQualities), std::end(grading::kQualities))))
      ->capture_default_str();
}

void declareContext(CLI::App& app, bool measures) {
  std::vector<std::string> names = {"auto", "osmesa", "egl"};
  if (measures) names.emplace_back("gpu");
  app.add_option_function<std::string>(
         "--context", grading::chooseContext,
         gg::say("What draws: auto (OSMesa, or EGL where that isn't installed), osmesa, egl{}",
                 measures ? gg::say(", gpu (the first graphics card)") : ""))
      ->check(CLI::IsMember(names));
}

std::vector<std::string> chooseSandbox(const std::string& word) {
  if (word != "none") return requireSandbox();
  grading::isolation() = sandbox::Isolation::none;
  tell("ggrade: no sandbox: every submission runs as you, with your files and your "
       "network\n");
  return {};
}

fs::path outputFolder(const std::string& named) {
  fs::path folder = fs::path(named).lexically_normal();
  if (!folder.has_filename()) folder = folder.parent_path();
  if (folder.empty() || folder == "." || folder == "..")
    folder = fs::canonical(fs::absolute(named));
  grading::requireReplaceable(folder);
  // Tried, not asked: root may write everywhere but in /proc.
  fs::path there = fs::absolute(folder).parent_path();
  std::error_code error;
  while (!fs::exists(there, error) && there.has_relative_path()) there = there.parent_path();
  if (!fs::is_directory(there, error))
    throw UsageError(gg::say("{} is not a folder: name another one with --out", there.string()));
  grading::TemporaryFolder probe(there);
  return folder;
}

int runCommands(int argc, char** argv, const std::vector<AddCommand>& commands) {
  grading::catchInterrupts();
  const auto end = [](int code, const std::string& text) {
    // What Ctrl-C broke off may have failed for that alone.
    if (grading::interrupted) {
      code = kInterrupted;
      tell(fmt::format("\n{}\n", gg::say("ggrade: stopped; nothing half-written was left behind")));
    } else {
      tell(fmt::format("ggrade: {}\n", text));
    }
    return code;
  };
  try {
    const int code = run(argc, argv, commands);
    errno = 0;
    const bool isWritten = std::cout.flush() && std::fflush(stdout) == 0 && !std::ferror(stdout);
    if (!isWritten && errno != EPIPE) // a reader that has read enough
      throw std::system_error(errno ? errno : EIO, std::generic_category(),
                              gg::say("can't write what the command prints"));
    return code;
  } catch (const grading::Interrupted&) {
    grading::interrupted = true;
    return end(kInterrupted, {});
  } catch (const NoSandbox& error) {
    return end(kNoSandbox, error.what());
  } catch (const grading::CannotDraw& error) {
    return end(kNoSandbox, error.what());
  } catch (const UsageError& error) {
    return end(kUsage, error.what());
  } catch (const std::system_error& error) {
    // The disk, memory, descriptors: nobody's mistake, and to be mended outside.
    return end(kNotGradable, gg::say("{}. Mend that, then run the command again", error.what()));
  } catch (const std::exception& error) {
    // Not the caller's doing: our own programs.
    return end(kNotGradable, error.what());
  }
}

void declareRepair(CLI::App& app) {
  app.add_flag_callback(
      "--no-repair", [] { grading::repairs() = false; },
      "Don't draw submissions that lost points again with one thing of the reference's "
      "after the other: some seconds less for each, but a fault may cost more than its "
      "step, and what was wrong is only likely");
}

} // namespace ggrade::cli
