#include "check/check.hpp"

#include "check/begun.hpp"
#include "check/build.hpp"
#include "check/known.hpp"
#include "check/observed.hpp"
#include "diagnosis/generic.hpp"
#include "diagnosis/outcome.hpp"
#include "grading/parallel.hpp"
#include "image/png.hpp"
#include "report/text.hpp"
#include "report/write_file.hpp"
#include "rubric/evidence.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <chrono>
#include <sstream>

namespace ggrade::check {

namespace fs = std::filesystem;
using diagnosis::SceneViews;
using gg::say;
using gg::words;

namespace {

/// So many mistakes that show the same are named; more are no help.
constexpr std::size_t kMostCauses = 6;

/// What is said once is enough.
void addOnce(std::vector<std::string>& lines, const std::string& line) {
  if (std::ranges::find(lines, line) == lines.end()) lines.push_back(line);
}

std::vector<std::string> messagesOf(const grading::Rendering& rendering) {
  std::vector<std::string> lines;
  const auto add = [&](const std::string& line) {
    const std::string clean = report::sanitizeLine(line);
    if (!clean.empty()) addOnce(lines, clean);
  };
  std::istringstream output(rendering.happened.output);
  for (std::string line; std::getline(output, line);) add(line);
  for (const channel::CapturedMessage& message : rendering.capture.messages)
    if (message.kind != channel::MessageKind::capture)
      add(message.text); // that is about drawing offscreen
  return lines;
}

/// Of English sentences; what begins with a name in code, such as glClear, stays.
std::string capitalized(std::string text) {
  const std::string word = text.substr(0, text.find(' '));
  const bool isWord = std::ranges::all_of(word, [](char c) { return c >= 'a' && c <= 'z'; });
  if (isWord && !text.empty() && gg::language() == gg::Language::english)
    text[0] = char(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

/// One look, step by step.
class Check {
public:
  Check(const Assignment& assignment, const Expected& expected, const fs::path& folder,
        const fs::path& work, const grading::Progress& progress)
      : assignment_(assignment), expected_(expected), folder_(folder), work_(work),
        progress_(progress), windows_(expected.scenes.size()), vertices_(expected.scenes.size()) {}

  Checked run() {
    const Begun text = begun(stubFolder(expected_.folder), folder_);
    begun_ = text.certain;
    possible_ = text.possible;
    if (isTogether(expected_)) begun_ = {expected_.todos.front()};
    step_ = expectedStep(expected_, begun_);
    checked_.rows = notJudged();
    const fs::path program = work_ / "program";
    report::makeFolder(program);
    report::makeFolder(work_ / "shaders");
    progress_(say("building"), 0, expected_.scenes.size() + 1);
    checked_.happened = buildChanged(assignment_, folder_, program);
    compilerOutput_ = checked_.happened.output;
    if (checked_.happened.ok()) {
      drawHandedOut(program);
      settleBegun();
      lookForNext(program);
      drawOthers(program);
      observed_ = observed();
      checked_.drawn = !shown_.empty() && shown_[0].has_value();
      if (checked_.drawn) judge(program);
    }
    outcome();
    if (std::string text = wrongEncoding(assignment_, folder_); !text.empty())
      checked_.messages.push_back(std::move(text));
    showWindows();
    return std::move(checked_);
  }

private:
  std::vector<Row> notJudged() const {
    std::vector<Row> rows;
    for (const std::string& todo : expected_.todos)
      rows.push_back({todo, begun_.count(todo) ? State::waits : State::notBegun});
    return rows;
  }

  /// The public scene first: where that fails no other needs to be drawn.
  void drawHandedOut(const fs::path& program) {
    shown_.resize(expected_.scenes.size());
    const grading::Rendering first = drawScene(program, 0);
    checked_.messages = messagesOf(first);
    facts_ = grading::factsOf(first.capture, first.capture.trace);
    trace_ = first.capture.trace;
    glMessages_ = first.capture.messages;
    checked_.happened = first.happened;
    if (checked_.happened.ok()) drawScenes(program, false);
  }

  /// Nobody needs other scenes where those that were handed out are wrong.
  void drawOthers(const fs::path& program) {
    if (checked_.happened.ok() && windowsPass(expected_, shown_, step_)) drawScenes(program, true);
  }

  /// What somebody has done elsewhere than where it belongs, or left out, shows in its scene.
  bool isBeforeLast(const std::string& todo) const {
    const auto at = std::ranges::find(expected_.todos, todo) - expected_.todos.begin();
    return std::size_t(at) < step_;
  }

  /// Those after the public one, of TODOs that were begun, or come before one that was.
  void drawScenes(const fs::path& program, bool another) {
    std::vector<std::size_t> scenes;
    for (std::size_t i = 1; i < expected_.scenes.size(); ++i)
      if (const std::string& todo = expected_.scenes[i].todo;
          expected_.scenes[i].another == another && !shown_[i] &&
          (todo.empty() || begun_.count(todo) || possible_.count(todo) ||
           (!another && isBeforeLast(todo))))
        scenes.push_back(i);
    std::vector<grading::Happened> happened(scenes.size());
    std::vector<std::vector<std::string>> messages(scenes.size());
    grading::inParallel(scenes.size(), grading::workers(), [&](std::size_t k) {
      const grading::Rendering rendering = drawScene(program, scenes[k]);
      happened[k] = rendering.happened;
      if (!rendering.happened.ok()) messages[k] = messagesOf(rendering);
    });
    for (std::size_t k = 0; k < scenes.size(); ++k)
      if (!happened[k].ok() && checked_.happened.ok()) {
        checked_.happened = happened[k];
        endedAt_ = expected_.scenes[scenes[k]].todo;
        for (const std::string& message : messages[k]) // its last words
          addOnce(checked_.messages, message);
      }
  }

  /// Where somebody has written anything, pictures tell what of it is done, wherever it stands. Of
  /// what may have been begun, that is what comes before something that has: steps are taken in
  /// order.
  void settleBegun() {
    step_ = expectedStep(expected_, begun_);
    if (!begun_.empty() || !possible_.empty()) {
      std::set<std::string> more = begun_;
      more.merge(doneInPictures(expected_, shown_));
      // What looks like a later step's may come of a mistake, unless the windows are right, too.
      const std::size_t step = expectedStep(expected_, more);
      const bool isLater = step > step_ && !windowsPass(expected_, shown_, step);
      for (const std::string& todo : more)
        if (!isLater || possible_.count(todo) || isBeforeLast(todo)) begun_.insert(todo);
      step_ = expectedStep(expected_, begun_);
    }
    for (std::size_t k = 0; k < step_; ++k)
      if (possible_.count(expected_.todos[k])) begun_.insert(expected_.todos[k]);
    // Nobody has done that of which it isn't known what to expect.
    for (std::size_t i = 0; i < shown_.size(); ++i)
      if (!isDrawnAfter(expected_, i, step_)) shown_[i].reset();
  }

  /// Somebody may have written the next step among the lines of another one: where nothing else
  /// tells, its own scene does.
  void lookForNext(const fs::path& program) {
    if (!checked_.happened.ok() || step_ == 0 || step_ == expected_.todos.size() ||
        !windowsPass(expected_, shown_, step_) || !possible_.insert(expected_.todos[step_]).second)
      return;
    const grading::Happened happened = checked_.happened;
    drawScenes(program, false);
    possible_.erase(expected_.todos[step_]);
    settleBegun();
    checked_.happened = happened; // nobody has to draw it yet
    endedAt_.clear();
  }

  /// What needs no picture to be told.
  Observed observed() const {
    std::vector<std::string> todos;
    for (const Part& part : assignment_.parts)
      for (const Todo& todo : part.todos) todos.push_back(todo.id);
    return observe(expected_, step_, trace_, checked_.messages, glMessages_, todos, folder_);
  }

  /// Keeps what one scene shows, if it could be drawn.
  grading::Rendering drawScene(const fs::path& program, std::size_t i) {
    const Scene& scene = expected_.scenes[i];
    progress_(say("rendering"), i + 1, expected_.scenes.size() + 1);
    grading::Rendering rendering =
        grading::renderScene(assignment_.id, program, scene.scene, scene.times, {work_ / "shaders"},
                             sandbox::Isolation::none, grading::gradingRequest(), {}, i == 0);
    const std::vector<rubric::RawFrame> frames = grading::rawFrames(rendering.capture);
    if (!frames.empty()) {
      windows_[i] = rubric::toImage(frames.front());
      vertices_[i] = verticesOf(rendering.capture.trace);
    }
    if (rendering.happened.ok())
      shown_[i] = diagnosis::views(rubric::toImages(frames), rendering.capture.trace, true);
    return rendering;
  }

  void judge(const fs::path& program) {
    const std::optional<diagnosis::FirstWrong> first = firstWrong();
    Suspect suspect;
    if (first)
      suspect = expected_.scenes[first->scene].another ? suspectInAnother(*first)
                                                       : suspectInHandedOut(*first, program);
    checked_.rows = rows(expected_, shown_, begun_, suspect);
    blameStorage();
    if (isTogether(expected_)) settleTogether(suspect.isExplained);
    // A call that fails does nothing, whether that is seen already or not.
    if (checked_.happened.outcome == results::Outcome::glError && allRight(checked_.rows))
      blameLast(observed_.todo);
    // It ended early in a scene that was not handed out.
    if (!checked_.happened.ok() && allRight(checked_.rows)) blameLast(endedAt_);
    // Right is what the windows show, however the passes are made.
    if (allRight(checked_.rows)) {
      checked_.cause.clear();
      checked_.hint.clear();
      countVertices();
    } else if (first) {
      describe(*first);
    }
  }

  /// The first wrong picture. Another scene tells something only where those that were handed out
  /// are right.
  std::optional<diagnosis::FirstWrong> firstWrong() const {
    for (const bool another : {false, true}) {
      diagnosis::Run student, should;
      std::vector<std::size_t> scenes;
      for (std::size_t i = 0; i < shown_.size(); ++i)
        if (shown_[i] && expected_.scenes[i].another == another) {
          student.push_back(*shown_[i]);
          should.push_back(expected_.steps[step_][i]);
          scenes.push_back(i);
          // There only windows count: passes may be made in another way.
          if (another) student.back().passes.clear(), should.back().passes.clear();
        }
      const auto most = diagnosis::firstWrong(student, should);
      if (!most) continue;
      // Of the scenes in which that picture is wrong the first, not the one where most of it is.
      for (std::size_t i = 0; i < scenes.size(); ++i)
        if (auto here = diagnosis::firstWrong({student[i]}, {should[i]});
            here && here->slot == most->slot) {
          here->scene = scenes[i];
          return here;
        }
    }
    return std::nullopt;
  }

  /// Are all windows of a finished program right? Then what is observed explains nothing wrong.
  bool isRightInWindows() const {
    if (step_ < expected_.todos.size()) return false;
    for (std::size_t i = 0; i < shown_.size(); ++i)
      if (shown_[i] && !diagnosis::sameWindows(*shown_[i], expected_.steps[step_][i])) return false;
    return true;
  }

  Suspect suspectInHandedOut(const diagnosis::FirstWrong& first, const fs::path& program) {
    Suspect suspect;
    if (isRightInWindows()) return suspect;
    suspect.todo = likeliest(first.scene);
    // Of a TODO's own scene it isn't known what all mistakes of other TODOs show.
    for (std::size_t i = 0; i < shown_.size() && suspect.todo.empty(); ++i)
      if (i != first.scene && shown_[i] && !expected_.scenes[i].another &&
          (i == 0 || diagnosis::firstWrong({*shown_[i]}, {expected_.steps[step_][i]})))
        suspect.todo = likeliest(i);
    // One picture of one colour looks like the next, of windows even more than of textures; and
    // what is observed may explain all.
    const Image* wrong = pictureOf(*shown_[first.scene], first);
    const bool isAlone = checked_.titles.empty(); // a list is a doubt already
    if (observed_.isState ||
        ((isAlone || !first.slot) && (!wrong || diagnosis::isOneColour(*wrong))))
      doubtCatalogue();
    suspect.isSure = !checked_.cause.empty() || observed_.isSure;
    suspect.isGuess = checked_.cause.empty();
    if (suspect.isGuess)
      suspect.spoiling = KnownMistakes(expected_, shown_, begun_, step_).spoiling(first.slot);
    if ((checked_.cause.empty() || observed_.isSure) && begun_.count(observed_.todo)) {
      suspect.todo = observed_.todo;
      suspect.isGuess = !observed_.isSure;
    } else {
      suspect.also = also_;
    }
    suspect.isExplained = !checked_.cause.empty() || !observed_.faults.empty() ||
                          !observed_.guess.empty() ||
                          checked_.happened.outcome == results::Outcome::glError;
    if (!suspect.isExplained && suspect.todo.empty() && isWrongLater(first)) {
      suspect.isLater = true;
      checked_.cause = laterCause(program, first);
    }
    return suspect;
  }

  Suspect suspectInAnother(const diagnosis::FirstWrong& first) {
    Suspect suspect;
    suspect.todo = expected_.scenes[first.scene].todo; // it is there for this one
    suspect.also = expected_.scenes[first.scene].also;
    suspect.isGuess = true;
    if (begun_.count(observed_.todo)) { // of the public scene, which hardly shows it
      suspect.todo = observed_.todo;
      suspect.also.clear();
      suspect.isExplained = true;
    }
    checked_.cause =
        isWrongLater(first)
            ? say("Each first frame is right, and the one after it isn't: is something that a "
                  "frame changes not put back, not cleared, or made only once?")
            : say("It is as it should be in the handed-out scenes, or nearly, and differs in "
                  "another one: is a number typed in that comes from the scene, the window or a "
                  "texture, or is something missing or too much that hardly shows in the others?");
    return suspect;
  }

  /// Of those that are done the last one; rather this one, if it is among them.
  void blameLast(const std::string& todo) {
    Row* last = nullptr;
    for (Row& row : checked_.rows)
      if (row.state == State::done && begun_.count(row.todo) && (!last || last->todo != todo))
        last = &row;
    if (last) last->state = State::wrong;
  }

  /// Each effect is right, so all of them may be so in another way: where nothing but pictures
  /// tells of a mistake, it is none. Of one TODO there is no other one to doubt.
  void settleTogether(bool isExplained) {
    Row& row = checked_.rows.front();
    if (row.state != State::wrong && row.state != State::maybe) return;
    row.state = isExplained ? State::wrong : State::nearly;
    if (!isExplained)
      checked_.cause =
          say("each effect is right alone, or nearly; where all are drawn, does one leave a "
              "state, a texture unit or a framebuffer that the next one doesn't expect?");
  }

  /// A texture of another size is made in the step before those that draw into it, and nobody sees
  /// that one: of the unseen ones right before what looks wrong, the first.
  void blameStorage() {
    if (!observed_.isStorage) return;
    std::vector<Row>& rows = checked_.rows;
    const auto wrong = std::ranges::find(rows, State::wrong, &Row::state);
    auto first = wrong;
    while (wrong != rows.end() && first != rows.begin() && !std::prev(first)->seen) --first;
    if (first == wrong) return;
    first->state = State::wrong;
    for (auto row = std::next(first); row != std::next(wrong); ++row) row->state = State::waits;
  }

  /// Of a step that leaves out what isn't needed: no picture tells.
  void countVertices() {
    for (std::size_t i = 0; i < shown_.size(); ++i) {
      const Scene& scene = expected_.scenes[i];
      if (!shown_[i] || scene.mostVertices == 0 || vertices_[i] <= scene.mostVertices) continue;
      for (Row& row : checked_.rows)
        if (row.todo == scene.todo && row.state == State::done) {
          row.state = State::wrong;
          checked_.cause = say("The picture is right, but a frame draws {} vertices where {} are "
                               "more than enough: is something drawn that this step leaves out?",
                               vertices_[i], scene.mostVertices);
        }
    }
  }

  static const Image* pictureOf(const SceneViews& views, const diagnosis::FirstWrong& first) {
    if (!first.slot)
      return first.frame < views.windows.size() ? &views.windows[first.frame] : nullptr;
    const diagnosis::PassView* pass = views.find(*first.slot);
    return pass ? &pass->picture : nullptr;
  }

  /// Is only a window wrong, after a first frame of which all is right?
  bool isWrongLater(const diagnosis::FirstWrong& first) const {
    return !first.slot && first.frame > 0 &&
           diagnosis::alike(&shown_[first.scene]->windows.front(),
                            &expected_.steps[step_][first.scene].windows.front());
  }

  /// Why a later frame is wrong: because it is a later one, or at its time.
  std::string laterCause(const fs::path& program, const diagnosis::FirstWrong& first) {
    const Scene& scene = expected_.scenes[first.scene];
    const double time = scene.times[first.frame];
    const std::vector<Image> alone = rubric::toImages(
        grading::rawFrames(grading::renderScene(assignment_.id, program, scene.scene, {time},
                                                {work_ / "shaders"}, sandbox::Isolation::none)
                               .capture));
    if (alone.empty()) return {};
    const Image window = diagnosis::reduced(alone.front(), 3);
    return diagnosis::alike(&window, &expected_.steps[step_][first.scene].windows[first.frame])
               ? say("The picture at {} s is right where it is the first one, and wrong after "
                     "another: something that a frame changes is not put back, not cleared, or "
                     "made only once.",
                     time)
               : say("The picture at {} s is wrong, and the one at {} s right: what changes with "
                     "time, and is something made only once that does?",
                     time, scene.times.front());
  }

  /// Names the known mistakes that show the same in one scene, in `cause` and `hint`: ones made
  /// just now, else ones in the finished program (whose window may be like an unfinished one's
  /// that is right); in `resemblance_`, what is only like one. Returns the TODO of the first;
  /// empty: none is known. Those of the others go into `also_`.
  std::string likeliest(std::size_t scene) {
    also_.clear();
    const KnownMistakes known(expected_, shown_, begun_, step_);
    const std::vector<const Fault*> faults = known.like(scene);
    if (faults.empty() || faults.size() > kMostCauses) return {};
    if (faults.size() == 1) {
      checked_.cause = words(faults[0]->title);
      checked_.hint = words(faults[0]->hint);
      if (!known.isExactly(*faults[0], scene)) doubtCatalogue();
    } else {
      checked_.cause =
          say("it may be one of these {} mistakes, which look alike so far", faults.size());
      for (const Fault* fault : faults) {
        also_.insert(fault->todo);
        checked_.titles.emplace_back(words(fault->title));
        checked_.hint += fmt::format("{}- {}\n  {}", checked_.hint.empty() ? "" : "\n",
                                     words(fault->title), words(fault->hint));
        if (!fault->experiment.empty())
          checked_.hint += "\n  " + say("To find out: {}", words(fault->experiment));
      }
    }
    for (const Fault* fault : faults) also_.insert(fault->also.begin(), fault->also.end());
    also_.erase(faults[0]->todo);
    return faults[0]->todo;
  }

  /// Makes a guess of what the catalogue told.
  void doubtCatalogue() {
    if (checked_.cause.empty()) return;
    resemblance_ =
        checked_.titles.empty()
            ? say("It looks like this mistake, but may be another one: {}. If it is this: {}",
                  checked_.cause, checked_.hint)
            : say("It looks like one of these mistakes, but may be another one:\n{}",
                  checked_.hint);
    checked_.cause.clear();
    checked_.hint.clear();
    checked_.titles.clear();
  }

  /// `first.scene` is one of `Expected::scenes`.
  void describe(const diagnosis::FirstWrong& first) {
    Wrong wrong;
    wrong.name = first.slot ? diagnosis::describe(*first.slot)
                            : say("the window at {:.4g} s",
                                  expected_.scenes[first.scene].times[first.frame]);
    wrong.scene = first.scene;
    wrong.another = expected_.scenes[first.scene].another;
    wrong.share = first.differing;
    if (first.missing)
      wrong.missing = first.slot->stencil ? say("it holds only 0 at the frame's end")
                                          : say("the program draws no such picture");
    // Where another texture is drawn into it may be an attachment that is missing.
    if (first.missing && first.slot->mesh &&
        std::ranges::none_of(shown_[first.scene]->passes, [&](const diagnosis::PassView& pass) {
          return pass.slot.mesh && pass.slot.depth == first.slot->depth;
        }))
      change_ = first.slot->depth
                    ? say("No object is drawn into a depth texture: is anything drawn "
                          "while its framebuffer object is bound?")
                    : say("No object is drawn into a texture of colours: is anything "
                          "drawn while its framebuffer object is bound?");
    const Image* ours = pictureOf(*shown_[first.scene], first);
    const Image* expected = pictureOf(expected_.steps[step_][first.scene], first);
    if (ours) wrong.ours = *ours;
    if (expected) wrong.expected = *expected;
    // How bright a depth or a count is says nothing.
    const bool isColours = !first.slot || (!first.slot->depth && !first.slot->stencil);
    if (ours && expected && isColours && ours->channels() == expected->channels()) {
      const Image fitted = diagnosis::resized(*ours, expected->width(), expected->height());
      const diagnosis::Pair pair{&fitted, expected, nullptr, nullptr};
      using Kind = diagnosis::Generic::Kind;
      const auto change = diagnosis::generic({&pair, 1});
      // Nothing but a window is encoded for a display.
      if (change &&
          (!first.slot || (change->kind != Kind::encodedTwice && change->kind != Kind::notEncoded)))
        change_ = diagnosis::describe(*change, capitalized(wrong.name));
    }
    checked_.firstWrong = std::move(wrong);
  }

  /// What needs no picture to be told goes before what pictures tell: how the run ended, what was
  /// observed.
  void outcome() {
    if (allRight(checked_.rows) && checked_.happened.outcome == results::Outcome::graded) return;
    results::Result result;
    result.outcome = checked_.happened.outcome;
    result.detail = checked_.happened.detail;
    result.compilerOutput = compilerOutput_;
    if (const auto observed = diagnosis::outcomeDiagnosis(result, facts_)) {
      checked_.cause = observed->text;
      checked_.hint.clear();
      // A program that ended itself has said why, in its last words.
      if (result.outcome == results::Outcome::crash && !checked_.messages.empty() &&
          !checked_.happened.signalled)
        checked_.cause = say("The program ended itself, and said: {}", lastWords());
      for (const std::string& beside : observed->beside) checked_.hint += beside + '\n';
      return;
    }
    std::vector<std::string> said; // by the program, and vaguer than a known mistake
    if (!observed_.guess.empty()) said.push_back(observed_.guess);
    for (const std::string& message : checked_.messages)
      if (message.find(": warning: ") != message.npos) said.push_back(message);
    checked_.isPuzzle = observed_.faults.empty() && (!checked_.cause.empty() || said.empty());
    std::vector<std::string> found = observed_.faults;
    if (!checked_.cause.empty()) {
      found.push_back(checked_.cause);
      if (!checked_.hint.empty())
        found.push_back(checked_.titles.empty() ? say("If it is this: {}", checked_.hint)
                                                : checked_.hint);
    }
    // Beside a puzzle it stays among the messages, told at once.
    if (!checked_.isPuzzle) found.insert(found.end(), said.begin(), said.end());
    if (found.empty()) { // what may be is no help beside what is
      if (!change_.empty()) found.push_back(change_);
      if (!resemblance_.empty()) found.push_back(resemblance_);
    }
    if (found.empty()) return;
    checked_.cause = capitalized(found.front());
    checked_.hint.clear();
    for (std::size_t k = 1; k < found.size(); ++k) checked_.hint += (k > 1 ? "\n" : "") + found[k];
    // Once is enough.
    std::erase_if(checked_.messages, [&](const std::string& message) {
      return std::ranges::any_of(found, [&](const std::string& text) {
        return message == text || message == doctorsPrefix() + text;
      });
    });
  }

  /// Of the program's messages the last that is its own, not the driver's or OpenGL's.
  std::string lastWords() const {
    const std::string own = assignment_.id + ": ";
    const auto last =
        std::ranges::find_if(checked_.messages.rbegin(), checked_.messages.rend(),
                             [&](const std::string& message) { return message.starts_with(own); });
    return last == checked_.messages.rend() ? checked_.messages.front() : *last;
  }

  /// The windows of the scene that is spoken of: of the first wrong picture; if all is right, of
  /// the last TODO's own scene, which shows what it has done.
  void showWindows() {
    std::size_t scene = 0;
    if (checked_.firstWrong)
      scene = checked_.firstWrong->scene;
    else if (step_ > 0 && allRight(checked_.rows))
      for (std::size_t i = 0; i < expected_.scenes.size(); ++i)
        if (!expected_.scenes[i].another && expected_.scenes[i].todo == expected_.todos[step_ - 1])
          scene = i;
    checked_.scene = scene;
    checked_.window = std::move(windows_[scene]);
    checked_.expectedWindow = readPng(stepPicture(expected_.folder, step_, scene));
    checked_.finishedWindow = readPng(stepPicture(expected_.folder, expected_.todos.size(), scene));
  }

  const Assignment& assignment_;
  const Expected& expected_;
  const fs::path& folder_;
  const fs::path& work_;
  const grading::Progress& progress_;
  std::set<std::string> begun_, possible_;
  trace::Trace trace_;   // of the public scene
  std::size_t step_ = 0; // up to which the program should be right
  std::string compilerOutput_;
  diagnosis::Facts facts_;
  std::vector<channel::CapturedMessage> glMessages_; // of the public scene
  Observed observed_;                                // likewise
  std::set<std::string> also_; // TODOs of mistakes that show the same as the likeliest one
  std::string endedAt_;     // the TODO in whose scene, not the public one, the program ended early
  std::string change_;      // what turns the right picture into the wrong one
  std::string resemblance_; // to a known mistake
  Shown shown_;
  std::vector<Image> windows_;          // by scene; empty: none came
  std::vector<std::uint64_t> vertices_; // of the first frame, by scene
  Checked checked_;
};

} // namespace

Checked check(const Assignment& assignment, const Expected& expected, const fs::path& folder,
              const fs::path& work, const grading::Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  Checked checked = Check(assignment, expected, folder, work, progress).run();
  checked.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return checked;
}

} // namespace ggrade::check
