// ggrade check: how far is a student's own program, and what is wrong with it?

#include "check/begun.hpp"
#include "check/page.hpp"
#include "cli/help.hpp"
#include "grading/overlay.hpp"
#include "grading/toolchain.hpp"
#include "grading/workspace.hpp"
#include "report/write_file.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <thread>

#include <unistd.h>

namespace ggrade::check {

namespace fs = std::filesystem;
using gg::say;

namespace {

constexpr int kRight = 0, kWrong = 1, kUsage = 2, kInterrupted = 130;

struct Options {
  std::string id, folder, expected, out, language;
  bool watch = false, json = false;
};

using Saved = std::map<std::string, fs::file_time_type>;

/// When the files that count were saved.
Saved savedIn(const Assignment& assignment, const fs::path& folder) {
  Saved saved;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (grading::takes(assignment, entry.path().filename().string()))
      saved[entry.path().filename().string()] = entry.last_write_time(error);
  return saved;
}

fs::file_time_type lastSaved(const Assignment& assignment) {
  fs::file_time_type last = fs::file_time_type::min();
  for (const auto& [name, time] : savedIn(assignment, assignment.folder))
    last = std::max(last, time);
  return last;
}

/// The text of a part's steps, in the chosen language.
std::string handoutOf(const Assignment& assignment, const Part& part) {
  const std::string ending = gg::language() == gg::Language::english ? ".md" : ".ja.md";
  for (const std::string& name : {part.id, std::string("README")})
    if (fs::exists(assignment.folder / (name + ending)))
      return fs::relative(assignment.folder / (name + ending), toolchain::kSourceFolder);
  return "README.md";
}

/// What is named, or without a name the assignment whose files were saved last.
Target chosen(const std::string& id) {
  const fs::path folder = fs::path(toolchain::kSourceFolder) / "assignments";
  if (!id.empty()) return findTarget(folder, id);
  const std::vector<Assignment> all = loadAssignments(folder);
  if (all.empty()) throw UsageError(say("{} holds no assignment", folder.string()));
  return findTarget(folder, std::ranges::max_element(all, {}, lastSaved)->id);
}

class Command {
public:
  explicit Command(const Options& options)
      : options_(options), target_(chosen(options.id)),
        folder_(options.folder.empty() ? target_.assignment.folder : fs::path(options.folder)),
        out_(options.out.empty() ? fs::path("out") / ("check-" + target_.id + ".html")
                                 : fs::path(options.out)) {
    gg::addWords(target_.assignment.folder / "words.ja.json");
    const fs::path expected = options.expected.empty()
                                  ? fs::path(toolchain::kSourceFolder) / "expected"
                                  : fs::path(options.expected);
    for (const Part& part : target_.parts)
      if (fs::exists(expected / part.id)) {
        expected_.push_back(load(expected / part.id));
        gg::addWords(wordsFile(expected / part.id));
        parts_.push_back(&part);
      }
    if (parts_.empty())
      throw UsageError(say("{} doesn't say what to expect of {}: is this kit whole, and is {} one "
                           "of its parts?",
                           expected.string(), target_.id, target_.id));
  }

  int run() {
    if (!options_.watch) return look();
    fmt::print(stderr, "{}\n",
               say("ggrade: watching {}; the page is {}; Ctrl-C ends this", folder_.string(),
                   fs::absolute(out_).string()));
    while (!grading::interrupted) {
      const Saved saved = savedIn(target_.assignment, folder_);
      try {
        look();
      } catch (const UsageError& error) { // a file may be missing while it is being saved
        fmt::print(stderr, "ggrade: {}\n", error.what());
      }
      while (!grading::interrupted && savedIn(target_.assignment, folder_) == saved)
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return kInterrupted;
  }

private:
  /// Those that are named; else those that were begun, or the first one.
  std::vector<std::size_t> partsToLookAt() const {
    std::vector<std::size_t> all, begunOnes;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      all.push_back(i);
      const Begun text = begun(stubFolder(expected_[i].folder), folder_);
      if (std::ranges::any_of(parts_[i]->todos, [&](const Todo& todo) {
            return text.certain.count(todo.id) || text.possible.count(todo.id);
          }))
        begunOnes.push_back(i);
    }
    if (!options_.id.empty()) return all;
    return begunOnes.empty() ? std::vector<std::size_t>{0} : begunOnes;
  }

  /// Checks once, prints and writes the page.
  int look() {
    const bool terminal = isatty(STDOUT_FILENO) != 0;
    const fs::path work = fs::path(toolchain::kBuildFolder) / "check" / target_.assignment.id;
    std::vector<Looked> all;
    for (const std::size_t i : partsToLookAt())
      all.push_back({parts_[i], &expected_[i], handoutOf(target_.assignment, *parts_[i]),
                     check(target_.assignment, expected_[i], folder_, work)});
    report::makeFolder(fs::absolute(out_).parent_path());
    report::writeFile(out_, page("ggrade check " + target_.id, all, options_.watch));
    if (options_.watch && terminal) fmt::print("\033[2J\033[H");
    if (options_.json)
      fmt::print("{}\n", toJson(all).dump(2));
    else
      fmt::print("{}{}\n", table(all, terminal && !std::getenv("NO_COLOR")), out_.string());
    std::fflush(stdout);
    const bool right = std::ranges::all_of(all, [](const Looked& looked) {
      return looked.checked.happened.ok() && allRight(looked.checked.rows);
    });
    return right ? kRight : kWrong;
  }

  const Options& options_;
  Target target_;
  fs::path folder_, out_;
  std::vector<const Part*> parts_;
  std::vector<Expected> expected_;
};

int run(int argc, char** argv) {
  CLI::App app(
      say("Looks at your own program: which TODOs are done, which one is wrong, and the likely "
          "cause."),
      "ggrade check");
  Options options;
  cli::sayHelp(app);
  cli::sayErrors(app);
  app.add_option("ID", options.id,
                 say("Assignment or part (default: what was begun of the assignment whose files "
                     "were saved last)"));
  app.add_flag("--watch", options.watch,
               say("Again on every save, until Ctrl-C; the page follows by itself"));
  app.add_option("--folder", options.folder, say("Other files than those in assignments/ID"));
  app.add_option("--out", options.out, say("The page's file (default out/check-ID.html)"));
  app.add_option("--lang", options.language, say("en or ja (default: by GG_LANG, else LANG)"))
      ->check(CLI::IsMember({"en", "ja"}));
  app.add_flag("--json", options.json, say("Print JSON on stdout"));
  app.add_option("--expected", options.expected, say("What to compare with"))->group("");
  app.footer(say("The program is built and run on this machine, as you, without a sandbox.\n"
                 "Exit codes: 0 all that was begun is right, 1 something isn't, 2 usage.\n\n"
                 "Examples:\n"
                 "  ggrade check mirror\n"
                 "  ggrade check --watch"));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kRight : kUsage;
  }
  if (const auto language = gg::parseLanguage(options.language)) {
    gg::setLanguage(*language);
    setenv("GG_LANG", options.language.c_str(), 1);
  }
  return Command(options).run();
}

} // namespace

} // namespace ggrade::check

int main(int argc, char** argv) {
  using namespace ggrade;
  grading::catchInterrupts();
  try {
    return check::run(argc, argv);
  } catch (const grading::Interrupted&) {
    std::fputs("\nggrade: stopped\n", stderr);
    return 130;
  } catch (const UsageError& error) {
    fmt::print(stderr, "ggrade: {}\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "ggrade: {}\n", error.what());
    return 1;
  }
}
