#include "check/check.hpp"

#include "check/drawn.hpp"
#include "check/known.hpp"
#include "check/observed.hpp"
#include "diagnosis/generic.hpp"
#include "diagnosis/outcome.hpp"
#include "image/png.hpp"
#include "rubric/evidence.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>

namespace ggrade::check {

namespace fs = std::filesystem;
using diagnosis::SceneViews;
using gg::say;
using gg::words;

namespace {

/// So many mistakes that show the same are named; more are no help.
constexpr std::size_t kMostCauses = 6;
/// Share of a window of all effects that right ones may change together, each in another way.
constexpr double kOtherEffects = 0.2;

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
        const fs::path& work, Drawn drawn)
      : assignment_(assignment), expected_(expected), folder_(folder), work_(work),
        drawn_(std::move(drawn)) {}

  Checked run() {
    checked_.happened = drawn_.happened;
    checked_.messages = drawn_.messages;
    if (!isTogether(expected_)) dropPointless(checked_.messages, expected_, drawn_.step);
    checked_.rows = notJudged();
    checked_.drawn = drawn_.isJudged();
    if (drawn_.isBuilt) observed_ = observed();
    checked_.misread = observed_.misread;
    if (checked_.drawn) judge();
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
      rows.push_back({todo, drawn_.begun.count(todo) ? State::waits : State::notBegun});
    return rows;
  }

  /// What needs no picture to be told.
  Observed observed() const {
    return observe(expected_, drawn_.step, drawn_.trace, checked_.messages, drawn_.glMessages,
                   todos(), folder_);
  }

  /// What the frame doctor finds in a scene.
  std::vector<std::string> findingsIn(const Scene& scene) const {
    return doctorsFindings(messagesOf(grading::renderScene(
        assignment_.id, programIn(work_), scene.scene, scene.times, {work_ / "shaders"},
        sandbox::Isolation::none, grading::gradingRequest(), {}, true)));
  }

  /// Of all parts.
  std::vector<std::string> todos() const {
    std::vector<std::string> all;
    for (const Part& part : assignment_.parts)
      for (const Todo& todo : part.todos) all.push_back(todo.id);
    return all;
  }

  void judge() {
    const std::optional<diagnosis::FirstWrong> first = firstWrong();
    if (first && first->scene != 0 && observed_.faults.empty() && observed_.guess.empty())
      observeElsewhere(observed_, expected_, findingsIn(expected_.scenes[first->scene]), todos(),
                       folder_);
    Suspect suspect;
    if (first)
      suspect = expected_.scenes[first->scene].another ? suspectInAnother(*first)
                                                       : suspectInHandedOut(*first);
    checked_.rows = rows(expected_, drawn_.shown, drawn_.begun, suspect);
    // Of several that show the same, or in a scene that was not handed out, none is likelier.
    // Nor where a pass is drawn that no step has, or where it is only like a known mistake.
    const auto& shown = drawn_.shown[0];
    const bool isVague = suspect.isGuess && (observed_.isFrustum ||
                                             (shown && !ownPasses(expected_, *shown, 0).empty()) ||
                                             (!resemblance_.empty() && observed_.todo.empty()));
    if (suspect.also.empty() && !suspect.showsNothing && !isVague) checked_.likely = suspect.todo;
    blameStorage();
    if (isTogether(expected_)) {
      checked_.rows.front().seen = true; // windows are compared
      settleTogether(suspect.isExplained);
    }
    // A call that fails does nothing, whether that is seen already or not.
    if (checked_.happened.outcome == results::Outcome::glError && allRight(checked_.rows))
      blameLast(observed_.todo);
    // What software draws all the same.
    if (const auto row = std::ranges::find(checked_.rows, observed_.cardTodo, &Row::todo);
        allRight(checked_.rows) && row != checked_.rows.end() && row->state == State::done)
      row->state = State::wrong;
    // It ended early in a scene that was not handed out.
    if (!checked_.happened.ok() && allRight(checked_.rows)) blameLast(drawn_.endedAt);
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
  /// are right, or nearly.
  std::optional<diagnosis::FirstWrong> firstWrong() const {
    std::optional<diagnosis::FirstWrong> little; // may be another right way
    double share = 0;                            // of that, where most is wrong
    for (const bool another : {false, true}) {
      diagnosis::Run student, should;
      std::vector<std::size_t> scenes;
      for (std::size_t i = 0; i < drawn_.shown.size(); ++i)
        if (drawn_.shown[i] && expected_.scenes[i].another == another) {
          student.push_back(*drawn_.shown[i]);
          should.push_back(expected_.steps[drawn_.step][i]);
          scenes.push_back(i);
          // There only windows count: passes may be made in another way.
          if (another) student.back().passes.clear(), should.back().passes.clear();
        }
      const auto most = diagnosis::firstWrong(student, should);
      if (!most) continue;
      // Of the scenes in which that picture is wrong the first, not the one where most of it is;
      // and of its frames likewise.
      for (std::size_t i = 0; i < scenes.size(); ++i) {
        auto here = diagnosis::firstWrong({student[i]}, {should[i]});
        if (!here || here->slot != most->slot) continue;
        for (std::size_t frames = 1; !here->slot && frames <= here->frame; ++frames) {
          SceneViews ours = student[i], theirs = should[i];
          ours.windows.resize(std::min(frames, ours.windows.size()));
          theirs.windows.resize(frames);
          if (const auto earlier = diagnosis::firstWrong({ours}, {theirs}, diagnosis::kFaintShare))
            here = earlier;
        }
        here->scene = scenes[i];
        if (little) return most->share > kMuchMore * share ? here : little;
        if (most->slot || most->share >= kNearly) return here;
        little = here;
        share = most->share;
        break;
      }
    }
    return little;
  }

  /// Do the windows of the handed-out scenes differ in nothing?
  bool isExactInHandedOut() const {
    for (std::size_t i = 0; i < drawn_.shown.size(); ++i)
      if (drawn_.shown[i] && !expected_.scenes[i].another)
        for (std::size_t k = 0; k < drawn_.shown[i]->windows.size() &&
                                k < expected_.steps[drawn_.step][i].windows.size();
             ++k)
          if (diagnosis::differingShare(&expected_.steps[drawn_.step][i].windows[k],
                                        &drawn_.shown[i]->windows[k]) > 0)
            return false;
    return true;
  }

  /// Are all windows of a finished program right? Then what is observed explains nothing wrong.
  bool isRightInWindows() const {
    if (drawn_.step < expected_.todos.size()) return false;
    for (std::size_t i = 0; i < drawn_.shown.size(); ++i)
      if (drawn_.shown[i] &&
          !diagnosis::sameWindows(*drawn_.shown[i], expected_.steps[drawn_.step][i]))
        return false;
    return true;
  }

  /// The TODOs that change the pass that is wrong first, about as much as it is wrong.
  std::set<std::string> drawing(const diagnosis::FirstWrong& first) const {
    std::set<std::string> todos;
    for (std::size_t k = 1; first.slot && k <= drawn_.step; ++k) {
      const Image *after = pictureOf(expected_.steps[k][first.scene], first),
                  *before = pictureOf(expected_.steps[k - 1][first.scene], first);
      if (after && (!before || diagnosis::differingShare(after, before) > first.share / 2))
        todos.insert(expected_.todos[k - 1]);
    }
    return todos;
  }

  KnownMistakes known() const { return {expected_, drawn_.everywhere, drawn_.begun, drawn_.step}; }

  Suspect suspectInHandedOut(const diagnosis::FirstWrong& first) {
    Suspect suspect;
    if (isRightInWindows()) return suspect;
    suspect.todo = likeliest(first.scene);
    // Of a TODO's own scene it isn't known what all mistakes of other TODOs show.
    for (std::size_t i = 0; i < drawn_.shown.size() && suspect.todo.empty(); ++i)
      if (i != first.scene && drawn_.shown[i] && !expected_.scenes[i].another &&
          (i == 0 || diagnosis::firstWrong({*drawn_.shown[i]}, {expected_.steps[drawn_.step][i]})))
        suspect.todo = likeliest(i);
    // One picture of one colour looks like the next, of windows even more than of textures; and
    // what is observed may explain all.
    const Image* wrong = pictureOf(*drawn_.shown[first.scene], first);
    const bool isAlone = checked_.titles.empty(); // a list is a doubt already
    if (observed_.isState || !drawn_.facts.incomplete.empty() ||
        ((isAlone || !first.slot) && (!wrong || diagnosis::isOneColour(*wrong))))
      doubtCatalogue();
    suspect.isSure = !checked_.cause.empty() || observed_.isSure;
    suspect.isGuess = checked_.cause.empty();
    if (suspect.isGuess) suspect.spoiling = known().spoiling(first);
    suspect.drawing = drawing(first);
    if ((checked_.cause.empty() || observed_.isSure) && drawn_.begun.count(observed_.todo)) {
      suspect.todo = observed_.todo;
      suspect.isGuess = !observed_.isSure;
    } else {
      suspect.also = also_;
      // What looks like a known mistake may be what was observed.
      if (drawn_.begun.count(observed_.todo) && observed_.todo != suspect.todo)
        suspect.also.insert(observed_.todo);
    }
    suspect.showsNothing = checked_.cause.empty() && !observed_.isSure && showsNothingNew();
    if (suspect.showsNothing) {
      suspect.todo = expected_.todos[drawn_.step - 1];
      suspect.also = known().hidingTheStep();
      suspect.isGuess = false;
    }
    nothingNew_ = suspect.showsNothing;
    suspect.isExplained = nothingNew_ || !checked_.cause.empty() || !observed_.faults.empty() ||
                          !observed_.guess.empty() ||
                          checked_.happened.outcome == results::Outcome::glError;
    if (!suspect.isExplained && suspect.todo.empty() && isWrongLater(first)) {
      suspect.isLater = true;
      checked_.cause = laterCause(first);
    }
    return suspect;
  }

  Suspect suspectInAnother(const diagnosis::FirstWrong& first) {
    Suspect suspect;
    suspect.todo = expected_.scenes[first.scene].todo; // it is there for this one
    suspect.also = expected_.scenes[first.scene].also;
    suspect.isGuess = true;
    suspect.binding = bindingForTheWindow(expected_, drawn_.step, drawn_.trace);
    if (drawn_.begun.count(observed_.todo)) { // of the public scene, which hardly shows it
      suspect.todo = observed_.todo;
      suspect.also.clear();
      suspect.isExplained = true;
    }
    std::string likely = likeliest(first.scene);
    for (std::size_t i = 0; i < drawn_.shown.size() && likely.empty(); ++i)
      if (i != first.scene && drawn_.shown[i] && expected_.scenes[i].another &&
          !diagnosis::sameWindows(*drawn_.shown[i], expected_.steps[drawn_.step][i]))
        likely = likeliest(i);
    resemblance_.clear(); // what is only like a mistake may as well be a number typed in
    if (!checked_.cause.empty()) {
      suspect.todo = likely;
      suspect.also = also_;
      suspect.isGuess = false;
      suspect.isExplained = true;
      return suspect;
    }
    checked_.cause =
        isWrongLater(first)
            ? say("In another scene the first frame is right, and the one after it isn't: is "
                  "something that a frame changes not put back, not cleared, or made only once?")
        : isExactInHandedOut()
            ? say("It is as it should be in the handed-out scenes, and differs in another one: is "
                  "a number typed in that comes from the scene, the window or a texture, or is "
                  "something missing or too much that only this scene has? Compare the scenes' "
                  "files.")
            : say("It is nearly as it should be in the handed-out scenes, and differs more in "
                  "another one: is something wrong that shows little there, or is a number typed "
                  "in that comes from the scene, the window or a texture?");
    return suspect;
  }

  /// Of those that are done the last one; rather this one, if it is among them.
  void blameLast(const std::string& todo) {
    Row* last = nullptr;
    for (Row& row : checked_.rows)
      if (row.state == State::done && drawn_.begun.count(row.todo) && (!last || last->todo != todo))
        last = &row;
    if (last) last->state = State::wrong;
  }

  /// Each effect is right, so all of them may be so in another way: where nothing but pictures
  /// tells of a mistake, it is none. Of one TODO there is no other one to doubt.
  void settleTogether(bool isExplained) {
    Row& row = checked_.rows.front();
    if (row.state != State::wrong && row.state != State::maybe) return;
    row.state = isExplained || !isNearlyTogether() ? State::wrong : State::nearly;
    if (!isExplained)
      checked_.cause =
          say("each effect is right alone, or nearly; where all are drawn, does one leave a "
              "state, a texture unit or a framebuffer that the next one doesn't expect, or a "
              "texture of another format than the one asked for?");
  }

  bool isNearlyTogether() const {
    return std::ranges::equal(expected_.steps[drawn_.step][0].windows, drawn_.shown[0]->windows,
                              [](const Image& should, const Image& is) {
                                return diagnosis::differingShare(&should, &is) <= kOtherEffects;
                              });
  }

  /// A texture of another size is made in the step before those that draw into it, and nobody sees
  /// that one: of the unseen ones right before what looks wrong, the first.
  void blameStorage() {
    if (!observed_.isStorage) return;
    std::vector<Row>& rows = checked_.rows;
    const auto wrong = std::ranges::find(rows, State::wrong, &Row::state);
    const auto unseen = std::ranges::find_if(
        rows, [](const Row& row) { return row.state == State::maybe && !row.seen; });
    if (wrong == rows.end() && unseen != rows.end()) checked_.likely = unseen->todo;
    auto first = wrong;
    while (wrong != rows.end() && first != rows.begin() && !std::prev(first)->seen) --first;
    if (first == wrong) return;
    first->state = State::wrong;
    for (auto row = std::next(first); row != std::next(wrong); ++row) row->state = State::waits;
  }

  /// Of a step that leaves out what isn't needed: no picture tells.
  void countVertices() {
    for (std::size_t i = 0; i < drawn_.shown.size(); ++i) {
      const Scene& scene = expected_.scenes[i];
      if (!drawn_.shown[i] || scene.mostVertices == 0 || drawn_.vertices[i] <= scene.mostVertices)
        continue;
      for (Row& row : checked_.rows)
        if (row.todo == scene.todo && row.state == State::done) {
          row.state = State::wrong;
          checked_.cause = say("The picture is right, but a frame draws {} vertices where {} are "
                               "more than enough: is something drawn that this step leaves out?",
                               drawn_.vertices[i], scene.mostVertices);
        }
    }
  }

  /// Is all that was drawn as before the last step that was begun?
  bool showsNothingNew() const {
    if (drawn_.step == 0) return false;
    for (std::size_t i = 0; i < drawn_.shown.size(); ++i)
      if (drawn_.shown[i] &&
          !diagnosis::samePictures(*drawn_.shown[i], expected_.steps[drawn_.step - 1][i]))
        return false;
    return true;
  }

  static const Image* pictureOf(const SceneViews& views, const diagnosis::FirstWrong& first) {
    if (!first.slot)
      return first.frame < views.windows.size() ? &views.windows[first.frame] : nullptr;
    const diagnosis::PassView* pass = views.find(*first.slot);
    return pass ? &pass->picture : nullptr;
  }

  /// Is only a window wrong, after a first frame of which all is right?
  static bool isWrongLater(const diagnosis::FirstWrong& first) {
    return !first.slot && first.frame > 0;
  }

  /// Why a later frame is wrong: because it is a later one, or at its time.
  std::string laterCause(const diagnosis::FirstWrong& first) {
    const Scene& scene = expected_.scenes[first.scene];
    const double time = scene.times.shown[first.frame];
    const std::vector<Image> alone = rubric::toImages(grading::rawFrames(
        grading::renderScene(assignment_.id, programIn(work_), scene.scene, scene.times.of(time),
                             {work_ / "shaders"}, sandbox::Isolation::none)
            .capture));
    if (alone.empty()) return {};
    const Image window = diagnosis::reduced(alone.front(), 3);
    return diagnosis::alike(&window,
                            &expected_.steps[drawn_.step][first.scene].windows[first.frame])
               ? say("The picture at {} s is right where it is the first one, and wrong after "
                     "another: something that a frame changes is not put back, not cleared, or "
                     "made only once.",
                     time)
               : say("The picture at {} s is wrong, and the one at {} s right: what changes with "
                     "time, and is something made only once that does?",
                     time, scene.times.shown.front());
  }

  /// Names the known mistakes that show the same in one scene, in `cause` and `hint`: ones made
  /// just now, else ones in the finished program (whose window may be like an unfinished one's
  /// that is right); in `resemblance_`, what is only like one. Returns the TODO of the first;
  /// empty: none is known. Those of the others go into `also_`.
  std::string likeliest(std::size_t scene) {
    also_.clear();
    const KnownMistakes known = this->known();
    const std::vector<const Fault*> alike = known.like(scene);
    // Those that show the very same are told apart by what was observed.
    const auto isObservedOtherwise = [&](const Fault* fault) {
      return fault->todo != observed_.todo && std::ranges::any_of(alike, [&](const Fault* other) {
               return other->todo == observed_.todo &&
                      other->signature.group == fault->signature.group;
             });
    };
    std::vector<const Fault*> faults;
    std::ranges::remove_copy_if(alike, std::back_inserter(faults), isObservedOtherwise);
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
                                  expected_.scenes[first.scene].times.shown[first.frame]);
    wrong.scene = first.scene;
    wrong.another = expected_.scenes[first.scene].another;
    wrong.share = first.differing;
    if (first.missing)
      wrong.missing = first.slot->stencil
                          ? say("it holds only 0 at the frame's end")
                          : say("not found among the pictures that the program draws");
    // Where another texture is drawn into it may be an attachment that is missing.
    if (first.missing && first.slot->mesh &&
        std::ranges::none_of(drawn_.shown[first.scene]->passes,
                             [&](const diagnosis::PassView& pass) {
                               return pass.slot.mesh && pass.slot.depth == first.slot->depth;
                             }))
      change_ = first.slot->depth
                    ? say("No object is drawn into a depth texture: is anything drawn "
                          "while its framebuffer object is bound?")
                    : say("No object is drawn into a texture of colours: is anything "
                          "drawn while its framebuffer object is bound?");
    if (first.slot && first.scene == 0) nameSamplers(*first.slot, wrong);
    const Image* ours = pictureOf(*drawn_.shown[first.scene], first);
    const Image* expected = pictureOf(expected_.steps[drawn_.step][first.scene], first);
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

  /// Which uniforms read the public scene's picture in this slot, as a student knows textures by
  /// them, and which the pass that draws it reads.
  void nameSamplers(const diagnosis::Slot& slot, Wrong& wrong) const {
    const diagnosis::PassView* view = drawn_.shown[0]->find(slot);
    if (!view || view->pass >= drawn_.trace.passes.size()) return;
    const trace::Trace& trace = drawn_.trace;
    const std::uint32_t texture = trace.passes[view->pass].images[view->attachment].name;
    const auto nameOf = [](const trace::SampleRecord& sample) { // of an array's, the array's
      const std::string name = sample.uniform;
      return name.substr(0, name.find('['));
    };
    std::set<std::string> readers;
    for (const trace::PassRecord& pass : trace.passesOf(0))
      for (const trace::StepRecord& step : trace.stepsOf(pass))
        for (const trace::SampleRecord& sample : trace.samplesOf(step)) {
          if (trace.indexOf(pass) == view->pass) wrong.samplers.insert(nameOf(sample));
          if (sample.writer == view->pass && sample.image.name == texture)
            readers.insert(nameOf(sample));
        }
    readers.erase("");
    wrong.samplers.erase("");
    if (!readers.empty()) wrong.name = say("{}, read as {}", wrong.name, fmt::join(readers, ", "));
  }

  /// What needs no picture to be told goes before what pictures tell: how the run ended, what was
  /// observed.
  void outcome() {
    if (allRight(checked_.rows) && checked_.happened.outcome == results::Outcome::graded) return;
    results::Result result;
    result.outcome = checked_.happened.outcome;
    result.detail = checked_.happened.detail;
    result.compilerOutput = drawn_.compilerOutput;
    diagnosis::Facts facts = drawn_.facts;
    facts.endedItself = !checked_.happened.signalled;
    if (const auto observed = diagnosis::outcomeDiagnosis(result, facts)) {
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
    if (nothingNew_)
      found.insert(found.begin(), say("nothing of {} shows yet: all is as it was before it. Is all "
                                      "of it written, and is it called?",
                                      expected_.todos[drawn_.step - 1]));
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
    else if (drawn_.step > 0 && allRight(checked_.rows))
      for (std::size_t i = 0; i < expected_.scenes.size(); ++i)
        if (!expected_.scenes[i].another &&
            expected_.scenes[i].todo == expected_.todos[drawn_.step - 1])
          scene = i;
    checked_.scene = scene;
    checked_.window = std::move(drawn_.windows[scene]);
    checked_.expectedWindow = readPng(stepPicture(expected_.folder, drawn_.step, scene));
    checked_.finishedWindow = readPng(stepPicture(expected_.folder, expected_.todos.size(), scene));
  }

  const Assignment& assignment_;
  const Expected& expected_;
  const fs::path &folder_, &work_;
  Drawn drawn_;
  Observed observed_;          // of the public scene
  std::set<std::string> also_; // TODOs of mistakes that show the same as the likeliest one
  bool nothingNew_ = false;    // is all as before the last step that was begun?
  std::string change_;         // what turns the right picture into the wrong one
  std::string resemblance_;    // to a known mistake
  Checked checked_;
};

} // namespace

Checked check(const Assignment& assignment, const Expected& expected, const fs::path& folder,
              const fs::path& work, const grading::Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  Checked checked =
      Check(assignment, expected, folder, work, draw(assignment, expected, folder, work, progress))
          .run();
  checked.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return checked;
}

} // namespace ggrade::check
