// ggrade check: how far is a student's own program, and what is wrong with it?

#include "check/begun.hpp"
#include "check/editor.hpp"
#include "check/keys.hpp"
#include "check/observed.hpp"
#include "check/page.hpp"
#include "check/terminal.hpp"
#include "cli/help.hpp"
#include "cli/terminal.hpp"
#include "grading/overlay.hpp"
#include "grading/toolchain.hpp"
#include "grading/workspace.hpp"
#include "report/write_file.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <map>
#include <optional>
#include <span>
#include <thread>

#include <unistd.h>

namespace ggrade::check {

namespace fs = std::filesystem;
using gg::say;

namespace {

constexpr std::chrono::milliseconds kBetweenLooks{100};
/// Files that are being saved are waited for so long, and looked at so often.
constexpr std::chrono::milliseconds kQuiet{100}, kLongestSave{3000};
constexpr int kMostLooks = 4;
constexpr int kRight = 0, kWrong = 1, kUsage = 2, kInterrupted = 130;

struct Options {
  std::string id, folder, expected, out, language, format = "text", editor;
  bool watch = false, hint = false, json = false, open = false;
};

using Saved = std::map<std::string, std::pair<fs::file_time_type, std::uintmax_t>>;

/// When the files that count were saved, and how large they are.
Saved savedIn(const Assignment& assignment, const fs::path& folder) {
  Saved saved;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (grading::takes(assignment, entry.path().filename().string()))
      saved[entry.path().filename().string()] = {entry.last_write_time(error),
                                                 entry.file_size(error)};
  return saved;
}

/// Waits until nothing has been saved for a moment.
Saved savedAtRest(const Assignment& assignment, const fs::path& folder) {
  Saved saved = savedIn(assignment, folder);
  for (auto waited = std::chrono::milliseconds(0); waited < kLongestSave && !grading::interrupted;
       waited += kQuiet) {
    std::this_thread::sleep_for(kQuiet);
    Saved now = savedIn(assignment, folder);
    if (now == saved) break;
    saved = std::move(now);
  }
  return saved;
}

fs::file_time_type lastSaved(const Assignment& assignment) {
  fs::file_time_type last = fs::file_time_type::min();
  for (const auto& [name, saved] : savedIn(assignment, assignment.folder))
    last = std::max(last, saved.first);
  return last;
}

/// Makes the folder if it isn't there.
bool canWriteIn(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  return access(folder.c_str(), W_OK) == 0;
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

/// The parts of which it is known what to expect: "mirror, shadow".
std::string toDoIn(const fs::path& expected) {
  std::string all;
  for (const Assignment& assignment :
       loadAssignments(fs::path(toolchain::kSourceFolder) / "assignments"))
    for (const Part& part : assignment.parts)
      if (fs::exists(expected / part.id)) all += (all.empty() ? "" : ", ") + part.id;
  return all;
}

bool isFinished(const Checked& checked) {
  return checked.happened.ok() && doneRows(checked) == checked.rows.size();
}

class Command {
public:
  explicit Command(const Options& options)
      : options_(options), target_(chosen(options.id)),
        folder_(options.folder.empty() ? target_.assignment.folder : fs::path(options.folder)),
        out_(options.out.empty() ? fs::path("out") / ("check-" + target_.id + ".html")
                                 : fs::path(options.out)),
        work_(fs::path(toolchain::kBuildFolder) / "check" / target_.assignment.id),
        told_(work_ / "told.json") {
    gg::addWords(target_.assignment.folder / "words.ja.json");
    const fs::path expected = options.expected.empty()
                                  ? fs::path(toolchain::kSourceFolder) / "expected"
                                  : fs::path(options.expected);
    const auto isToDo = [&](const Part& part) { return fs::exists(expected / part.id); };
    for (const Part& part : target_.parts)
      if (isToDo(part)) {
        expected_.push_back(load(expected / part.id));
        gg::addWords(wordsFile(expected / part.id));
        parts_.push_back(&part);
      }
    // Looked at where all that is to be done is named, and a picture can show it.
    const fs::path all = expected / target_.assignment.id;
    const auto toDo = std::size_t(std::ranges::count_if(target_.assignment.parts, isToDo));
    if (hasTogether(target_.assignment) && parts_.size() == toDo && fs::exists(all)) {
      together_ = togetherOf(target_.assignment);
      expectedTogether_ = load(all);
    }
    if (const std::string toDo = toDoIn(expected); parts_.empty() && !toDo.empty())
      throw UsageError(
          say("nothing of {} is to be done here, so there is nothing to check of it. To do: {}",
              target_.id, toDo));
    if (parts_.empty())
      throw UsageError(say("{} doesn't say what to expect of {}: is this kit whole, and is {} one "
                           "of its parts?",
                           expected.string(), target_.id, target_.id));
    if (options_.open) editor_ = editorCommand(options_.editor);
    if (options_.watch && needsTerminal(editor_))
      throw UsageError(say(
          "--open: {} writes to this terminal, as --watch does. Name an editor with a window, such "
          "as --edit-cmd \"code -g {{file}}:{{line}}\", or open it elsewhere, such as --edit-cmd "
          "\"tmux split-window vim +{{line}} {{file}}\"; or leave --watch out",
          editor_));
  }

  int run() {
    if (!options_.watch) {
      look();
      tell(options_.hint);
      print(say("add --hint"));
      openEditor();
      return isAllRight() ? kRight : kWrong;
    }
    fmt::print(stderr, "{}\n",
               say("ggrade: watching {}; the page is {}; Ctrl-C ends this", folder_.string(),
                   fs::absolute(out_).string()));
    Keys keys;
    for (bool more = options_.hint; !grading::interrupted; more = false) {
      try {
        // Editors take this line and the page's name for begin and end of a look.
        if (!options_.json) fmt::print("{}\n", say("ggrade: looking at {} ...", folder_.string()));
        std::fflush(stdout);
        look();
        tell(more);
        printWatched(keys);
        openEditor();
      } catch (const UsageError& error) { // a file may be missing while it is being saved
        fmt::print(stderr, "ggrade: {}\n", error.what());
      }
      while (!grading::interrupted && savedIn(target_.assignment, folder_) == saved_) {
        if (keys.next(kBetweenLooks) == 'h') {
          tell(true);
          printWatched(keys);
        }
        if (const auto code = beside_.failed())
          fmt::print(stderr, "{}\n", say("ggrade: the editor ended with {}: {}", *code, editor_));
      }
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

  /// Checks and writes the page. What is saved meanwhile would be half in what is told, or half
  /// written: it is looked at again.
  void look() {
    saved_ = savedIn(target_.assignment, folder_);
    if (!canWriteIn(work_))
      throw UsageError(say("check builds in {}, where you may not write. Copy the whole folder "
                           "{} to one of your own, and call the ggrade there",
                           work_.string(), toolchain::kSourceFolder));
    if (const fs::path pages = fs::absolute(out_).parent_path(); !canWriteIn(pages))
      throw UsageError(say("check writes its page to {}, where you may not write: name another "
                           "file for it with --out",
                           pages.string()));
    // Two looks at once, such as a watch's and somebody's own, would build in one place.
    const grading::FileLock turn(work_ / "lock");
    saved_ = savedIn(target_.assignment, folder_);
    for (int looks = 1;; ++looks) {
      std::exception_ptr failure; // a file may be missing while it is being saved
      try {
        lookOnce();
      } catch (const std::exception&) {
        failure = std::current_exception();
      }
      const bool isSame = savedIn(target_.assignment, folder_) == saved_;
      if (failure && (isSame || looks == kMostLooks)) std::rethrow_exception(failure);
      if (isSame || grading::interrupted) return;
      fmt::print(stderr, "{}\n",
                 looks < kMostLooks
                     ? say("ggrade: files were saved meanwhile; looking again")
                     : say("ggrade: files are being saved all the time; what is told may be of "
                           "several states of them: look again when they are at rest"));
      if (looks == kMostLooks) return;
      saved_ = savedAtRest(target_.assignment, folder_);
    }
  }

  void lookOnce() {
    std::vector<Looked> all;
    for (const std::size_t i : partsToLookAt()) all.push_back(lookAt(*parts_[i], expected_[i]));
    if (expectedTogether_ && all.size() == parts_.size() &&
        std::ranges::all_of(all, [](const Looked& looked) { return isFinished(looked.checked); })) {
      all.push_back(lookAt(together_, *expectedTogether_));
      doubtReader(all);
    }
    report::writeFile(out_, page("ggrade check " + target_.id, all, options_.watch));
    looked_ = std::move(all);
  }

  /// Where all effects are drawn, and a sampler reads what another effect bound, whoever reads it
  /// may have left a texture unit active.
  ///   all: the parts, and all effects together
  void doubtReader(std::vector<Looked>& all) const {
    const Checked& together = all.back().checked;
    if (together.misread.empty() || allRight(together.rows)) return;
    for (Looked& looked : std::span(all).first(parts_.size())) {
      std::vector<Row>& rows = looked.checked.rows;
      const auto row =
          std::ranges::find(rows, readerOf(*looked.expected, together.misread), &Row::todo);
      if (row == rows.end()) continue;
      row->state = State::maybe;
      looked.checked.cause =
          say("Alone it is right, and where all effects are drawn it isn't: {}", together.cause);
      findPlaces(looked);
    }
  }

  Looked lookAt(const Part& part, const Expected& expected) const {
    Looked looked;
    looked.part = &part;
    looked.expected = &expected;
    looked.handout = handoutOf(target_.assignment, part);
    looked.folder = folder_;
    cli::Progress progress("check");
    looked.checked = check(target_.assignment, expected, folder_, work_,
                           [&](const std::string& what, std::size_t done, std::size_t total) {
                             if (isatty(STDERR_FILENO) != 0) progress(what, done, total);
                           });
    findPlaces(looked);
    return looked;
  }

  void findPlaces(Looked& looked) const {
    const auto placesOf = [&](const Row& row) {
      std::vector<Place> places = check::placesOf(row.todo, target_.assignment.files,
                                                  stubFolder(looked.expected->folder), folder_);
      if (looked.checked.firstWrong) putReaderFirst(places, looked.checked.firstWrong->samplers);
      return places;
    };
    const Row* now = rowToLookAt(looked.checked);
    for (const Row* row : rowsToLookAt(looked.checked))
      if (row == now)
        looked.places = placesOf(*row);
      else if (const std::vector<Place> places = placesOf(*row); !places.empty())
        looked.otherPlaces.emplace(row->todo, places.front());
  }

  /// How much is told of each part: where it is wrong alone, or in a watch or where more is asked
  /// for, all that was told. Asking tells one level more of the first part that has one.
  void tell(bool more) {
    for (const Looked& looked : looked_) told_.settle(keyOf(looked), looked.checked);
    if (more && !options_.json)
      for (const Looked& looked : looked_)
        if (told_.of(keyOf(looked), looked.checked) < lastLevel(looked.checked)) {
          told_.tellMore(keyOf(looked), looked.checked);
          break;
        }
    askedInVain_ = more && std::ranges::all_of(looked_, [](const Looked& looked) {
                     return lastLevel(looked.checked) == Level::where &&
                            !(looked.checked.drawn && allRight(looked.checked.rows));
                   });
    bool isAsked = false;
    for (Looked& looked : looked_) {
      looked.level =
          more || options_.watch ? told_.of(keyOf(looked), looked.checked) : Level::where;
      looked.canAsk = !isAsked && looked.level < lastLevel(looked.checked);
      isAsked = isAsked || looked.canAsk;
    }
  }

  /// What was told of other files is nothing of these.
  std::string keyOf(const Looked& looked) const {
    return looked.part->id + ' ' + fs::absolute(folder_).lexically_normal().string();
  }

  void print(const std::string& ask) const {
    const bool colour = isatty(STDOUT_FILENO) != 0 && !std::getenv("NO_COLOR");
    if (options_.json)
      fmt::print("{}\n", toJson(looked_).dump(2));
    else
      fmt::print("{}{}{}\n", table(looked_, colour, ask),
                 askedInVain_ ? say("There is no hint: all that is known stands above.") + '\n'
                              : "",
                 out_.string());
    std::fflush(stdout);
  }

  void printWatched(const Keys& keys) const {
    if (isatty(STDOUT_FILENO) != 0) fmt::print("\033[2J\033[H");
    print(keys.areThere() ? say("press h") : say("add --hint"));
  }

  /// Where a TODO has become the next one.
  void openEditor() {
    if (!options_.open) return;
    for (const Looked& looked : looked_) {
      const Row* row = rowToLookAt(looked.checked);
      if (!row || looked.places.empty()) continue;
      if (row->todo == opened_) return;
      opened_ = row->todo;
      const std::string command = withPlace(editor_, looked.places.front());
      options_.watch ? beside_.open(command) : openHere(command);
      return;
    }
  }

  bool isAllRight() const {
    return std::ranges::all_of(looked_, [](const Looked& looked) {
      return looked.checked.happened.ok() && allRight(looked.checked.rows);
    });
  }

  const Options& options_;
  Target target_;
  fs::path folder_, out_, work_;
  Told told_;
  std::vector<const Part*> parts_;
  std::vector<Expected> expected_;
  Part together_;
  std::optional<Expected> expectedTogether_;
  std::vector<Looked> looked_;
  bool askedInVain_ = false; // for a hint
  Saved saved_;              // what was looked at last
  std::string editor_;       // a command with places in it
  Beside beside_;
  std::string opened_; // the TODO at which it was opened last
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
               say("Again on every save, until Ctrl-C; the page follows by itself, and the key h "
                   "tells a hint"));
  app.add_flag(
      "--hint", options.hint,
      say("Tell more of what is wrong: first the likely cause; asked once more, what to look at, "
          "where that is known"));
  CLI::Option* open = app.add_flag(
      "--open", options.open,
      say("Open the editor ($VISUAL, else $EDITOR) at the next TODO; with --watch whenever another "
          "one is next"));
  app.add_option("--edit-cmd", options.editor,
                 say("Another editor; {{file}} and {{line}} are put in, and the shell runs it"))
      ->needs(open);
  app.add_option("--folder", options.folder,
                 say("Other files than those in assignments/ID; what it lacks comes from there"));
  app.add_option("--out", options.out, say("The page's file (default out/check-ID.html)"));
  app.add_option("--lang", options.language, say("en or ja (default: by GG_LANG, else the locale)"))
      ->check(CLI::IsMember({"en", "ja"}));
  app.add_option("--format", options.format,
                 say("text, whose lines editors understand, or json, for programs: states, places, "
                     "cause, hints"))
      ->check(CLI::IsMember({"text", "json"}));
  app.add_flag("--json", options.json, say("The same as --format json"));
  app.add_option("--expected", options.expected, say("What to compare with"))->group("");
  app.footer(say("The program is built and run on this machine, as you, without a sandbox.\n"
                 "Exit codes: 0 all that was begun is done, as far as can be told,\n"
                 "1 something isn't, or may not be, 2 usage.\n\n"
                 "Examples:\n"
                 "  ggrade check mirror\n"
                 "  ggrade check mirror --hint\n"
                 "  ggrade check --watch\n"
                 "  ggrade check --watch --open --edit-cmd \"code -g {{file}}:{{line}}\"\n"
                 "  ggrade check mirror --format json"));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kRight : kUsage;
  }
  options.json = options.json || options.format == "json";
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
