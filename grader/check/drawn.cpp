#include "check/drawn.hpp"

#include "check/begun.hpp"
#include "check/build.hpp"
#include "grading/parallel.hpp"
#include "report/text.hpp"
#include "report/write_file.hpp"
#include "rubric/evidence.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <sstream>

namespace ggrade::check {

namespace fs = std::filesystem;
using gg::say;

namespace {

/// What is said once is enough.
void addOnce(std::vector<std::string>& lines, const std::string& line) {
  if (std::ranges::find(lines, line) == lines.end()) lines.push_back(line);
}

/// One program, scene by scene.
class Drawing {
public:
  Drawing(const Assignment& assignment, const Expected& expected, const fs::path& folder,
          const fs::path& work, const grading::Progress& progress)
      : assignment_(assignment), expected_(expected), folder_(folder), work_(work),
        program_(programIn(work)), progress_(progress) {
    drawn_.shown.resize(expected.scenes.size());
    drawn_.windows.resize(expected.scenes.size());
    drawn_.vertices.resize(expected.scenes.size());
  }

  Drawn run() {
    const Begun text = begun(stubFolder(expected_.folder), folder_);
    drawn_.begun = text.certain;
    possible_ = text.possible;
    if (isTogether(expected_)) drawn_.begun = {expected_.todos.front()};
    drawn_.step = expectedStep(expected_, drawn_.begun);
    report::makeFolder(program_);
    report::makeFolder(work_ / "shaders");
    progress_(say("building"), 0, expected_.scenes.size() + 1);
    drawn_.happened = buildChanged(assignment_, folder_, program_);
    drawn_.compilerOutput = drawn_.happened.output;
    drawn_.isBuilt = drawn_.happened.ok();
    if (drawn_.isBuilt) drawHandedOut();
    if (drawn_.isJudged()) {
      settleBegun();
      lookForNext();
      drawOthers();
    }
    return std::move(drawn_);
  }

private:
  /// The public scene first: where that fails no other needs to be drawn.
  void drawHandedOut() {
    const grading::Rendering first = drawScene(0);
    drawn_.messages = messagesOf(first);
    drawn_.facts = grading::factsOf(first.capture, first.capture.trace);
    drawn_.trace = first.capture.trace;
    drawn_.glMessages = first.capture.messages;
    drawn_.happened = first.happened;
    if (drawn_.happened.ok()) drawScenes(false);
  }

  /// Others are judged only where those that were handed out are right.
  void drawOthers() {
    const bool isRight = drawn_.happened.ok() && windowsPass(expected_, drawn_.shown, drawn_.step);
    if (isRight) drawScenes(true);
    drawn_.everywhere = drawn_.shown;
    if (isRight || drawn_.step < expected_.todos.size()) return;
    grading::inParallel(expected_.scenes.size(), grading::workers(), [&](std::size_t i) {
      if (drawn_.shown[i]) return;
      if (const grading::Rendering rendering = render(i); rendering.happened.ok())
        drawn_.everywhere[i] = diagnosis::views(
            rubric::toImages(grading::rawFrames(rendering.capture)), rendering.capture.trace, true);
    });
  }

  /// What somebody has done elsewhere than where it belongs, or left out, shows in its scene.
  bool isBeforeLast(const std::string& todo) const {
    const auto at = std::ranges::find(expected_.todos, todo) - expected_.todos.begin();
    return std::size_t(at) < drawn_.step;
  }

  /// Those after the public one, of TODOs that were begun, or come before one that was.
  void drawScenes(bool another) {
    std::vector<std::size_t> scenes;
    for (std::size_t i = 1; i < expected_.scenes.size(); ++i)
      if (const std::string& todo = expected_.scenes[i].todo;
          expected_.scenes[i].another == another && !drawn_.shown[i] &&
          (todo.empty() || drawn_.begun.count(todo) || possible_.count(todo) ||
           (!another && isBeforeLast(todo))))
        scenes.push_back(i);
    std::vector<grading::Happened> happened(scenes.size());
    std::vector<std::vector<std::string>> messages(scenes.size());
    grading::inParallel(scenes.size(), grading::workers(), [&](std::size_t k) {
      const grading::Rendering rendering = drawScene(scenes[k]);
      happened[k] = rendering.happened;
      if (!rendering.happened.ok()) messages[k] = messagesOf(rendering);
    });
    for (std::size_t k = 0; k < scenes.size(); ++k)
      if (!happened[k].ok() && drawn_.happened.ok()) {
        drawn_.happened = happened[k];
        drawn_.endedAt = expected_.scenes[scenes[k]].todo;
        for (const std::string& message : messages[k]) // its last words
          addOnce(drawn_.messages, message);
      }
  }

  /// Where somebody has written anything, pictures tell what of it is done, wherever it stands. Of
  /// what may have been begun, that is what comes before something that has: steps are taken in
  /// order.
  void settleBegun() {
    drawn_.step = expectedStep(expected_, drawn_.begun);
    if (!drawn_.begun.empty() || !possible_.empty()) {
      std::set<std::string> more = drawn_.begun;
      more.merge(doneInPictures(expected_, drawn_.shown));
      // What looks like a later step's may come of a mistake, unless the windows are right, too.
      const std::size_t step = expectedStep(expected_, more);
      const bool isLater = step > drawn_.step && !windowsPass(expected_, drawn_.shown, step);
      for (const std::string& todo : more)
        if (!isLater || possible_.count(todo) || isBeforeLast(todo)) drawn_.begun.insert(todo);
      drawn_.step = expectedStep(expected_, drawn_.begun);
    }
    for (std::size_t k = 0; k < drawn_.step; ++k)
      if (possible_.count(expected_.todos[k])) drawn_.begun.insert(expected_.todos[k]);
    // Nobody has done that of which it isn't known what to expect.
    for (std::size_t i = 0; i < drawn_.shown.size(); ++i)
      if (!isDrawnAfter(expected_, i, drawn_.step)) drawn_.shown[i].reset();
  }

  /// Somebody may have written the next step among the lines of another one: where nothing else
  /// tells, its own scene does.
  void lookForNext() {
    if (!drawn_.happened.ok() || drawn_.step == 0 || drawn_.step == expected_.todos.size() ||
        !windowsPass(expected_, drawn_.shown, drawn_.step) ||
        !possible_.insert(expected_.todos[drawn_.step]).second)
      return;
    const grading::Happened happened = drawn_.happened;
    drawScenes(false);
    possible_.erase(expected_.todos[drawn_.step]);
    settleBegun();
    drawn_.happened = happened; // nobody has to draw it yet
    drawn_.endedAt.clear();
  }

  grading::Rendering render(std::size_t i) const {
    const Scene& scene = expected_.scenes[i];
    return grading::renderScene(assignment_.id, program_, scene.scene, scene.times,
                                {work_ / "shaders"}, sandbox::Isolation::none,
                                grading::gradingRequest(), {}, i == 0);
  }

  /// Keeps what one scene shows, if it could be drawn.
  grading::Rendering drawScene(std::size_t i) {
    progress_(say("rendering"), i + 1, expected_.scenes.size() + 1);
    grading::Rendering rendering = render(i);
    const std::vector<rubric::RawFrame> frames = grading::rawFrames(rendering.capture);
    if (!frames.empty()) {
      drawn_.windows[i] = rubric::toImage(frames.front());
      drawn_.vertices[i] = verticesOf(rendering.capture.trace);
    }
    if (rendering.happened.ok())
      drawn_.shown[i] = diagnosis::views(rubric::toImages(frames), rendering.capture.trace, true);
    return rendering;
  }

  const Assignment& assignment_;
  const Expected& expected_;
  const fs::path &folder_, &work_;
  const fs::path program_;
  const grading::Progress& progress_;
  std::set<std::string> possible_; // TODOs that may have been begun
  Drawn drawn_;
};

} // namespace

std::vector<std::string> messagesOf(const grading::Rendering& rendering) {
  std::vector<std::string> lines;
  const auto add = [&](const std::string& line) {
    const std::string clean = report::sanitizeLine(line);
    if (clean.empty()) return;
    // Below a line of a shader stands a mark under the place that is wrong.
    if (line.starts_with(' '))
      lines.push_back(report::sanitize(std::string_view(line).substr(0, 400)));
    else
      addOnce(lines, clean);
  };
  std::istringstream output(rendering.happened.output);
  for (std::string line; std::getline(output, line);) add(line);
  for (const channel::CapturedMessage& message : rendering.capture.messages)
    if (message.kind != channel::MessageKind::capture)
      add(message.text); // that is about drawing offscreen
  return lines;
}

fs::path programIn(const fs::path& work) {
  return work / "program";
}

Drawn draw(const Assignment& assignment, const Expected& expected, const fs::path& folder,
           const fs::path& work, const grading::Progress& progress) {
  return Drawing(assignment, expected, folder, work, progress).run();
}

} // namespace ggrade::check
