#include "grading/carry.hpp"

#include "rubric/rubric.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace ggrade::grading {

namespace fs = std::filesystem;

namespace {

/// In its worst scene.
double leastCredit(const results::Item& item) {
  double least = 1;
  for (const results::SceneCredit& one : item.credits) least = std::min(least, one.credit);
  return least;
}

bool madeAlike(const trace::ImageRef& a, const trace::ImageRef& b) {
  return a.kind == b.kind && a.target == b.target && a.level == b.level && a.layer == b.layer &&
         a.format == b.format && a.width == b.width && a.height == b.height &&
         a.samples == b.samples;
}

bool samePass(const trace::PassRecord& a, const trace::PassRecord& b) {
  return a.kind == b.kind && a.status == b.status && a.drawBuffers == b.drawBuffers &&
         a.cleared == b.cleared && a.written == b.written && a.draws == b.draws &&
         a.vertices == b.vertices && std::equal(a.viewport, a.viewport + 4, b.viewport) &&
         std::equal(a.images, a.images + trace::kAttachments, b.images, madeAlike);
}

/// A program that does something else once its outputs are replaced shows nothing about what it did
/// before.
bool samePasses(const trace::Trace& first, const trace::Trace& again) {
  if (first.frames.empty() || again.frames.empty()) return false;
  const auto a = first.passesOf(0), b = again.passesOf(0);
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), samePass);
}

class Carrying {
public:
  Carrying(const Target& target, Judge& judge, Graded& graded, unsigned threads,
           const std::function<void()>& begins, std::string& problem)
      : judge_(judge), graded_(graded), items_(graded.result.items), threads_(threads),
        begins_(begins), problem_(problem), pixels_(graded.scenes.size()) {
    for (const ItemDeclaration& declared : target.items()) declared_[declared.id] = declared;
  }

  int run() {
    int runs = 0;
    while (const results::Item* next = nextFailed()) {
      replaced_.push_back(next->id);
      std::set<std::size_t> scenes;
      for (const results::PassOutputs& outputs : next->outputs)
        if (replaceIn(outputs)) scenes.insert(outputs.scene);
      if (scenes.empty()) continue;
      if (runs++ == 0) begins_();
      judgeAgain(scenes);
      if (!problem_.empty()) break;
    }
    return runs;
  }

private:
  /// Is the item after one that is replaced, whatever stands between them?
  bool isAfter(const std::string& item, const std::string& earlier) const {
    for (std::string at = declared_.at(item).after; !at.empty(); at = declared_.at(at).after)
      if (at == earlier) return true;
    return false;
  }

  bool isReplaced(const std::string& item) const {
    return std::find(replaced_.begin(), replaced_.end(), item) != replaced_.end();
  }

  /// Items that the replaced ones hold back, and that have something to gain.
  std::vector<std::string> heldBack(const std::vector<std::string>& earlier) const {
    std::vector<std::string> ids;
    for (const results::Item& item : items_)
      if (item.judged && leastCredit(item) < 1 && !isReplaced(item.id) &&
          std::any_of(earlier.begin(), earlier.end(),
                      [&](const std::string& one) { return isAfter(item.id, one); }))
        ids.push_back(item.id);
    return ids;
  }

  /// How many items it is after: those that come first are replaced first.
  std::size_t depth(const std::string& item) const {
    std::size_t depth = 0;
    for (std::string at = declared_.at(item).after; !at.empty(); at = declared_.at(at).after)
      ++depth;
    return depth;
  }

  const results::Item* nextFailed() const {
    const results::Item* next = nullptr;
    for (const results::Item& item : items_)
      if (item.judged && !item.outputs.empty() && !isReplaced(item.id) &&
          leastCredit(item) < rubric::kNearlyAll && (!next || depth(item.id) < depth(next->id)) &&
          !heldBack({item.id}).empty())
        next = &item;
    return next;
  }

  /// Adds the reference's pixels of these outputs to what is replaced in their scene.
  bool replaceIn(const results::PassOutputs& outputs) {
    const GradedScene& folders = graded_.scenes.at(outputs.scene);
    const trace::Trace student = trace::load(folders.student);
    const trace::Trace reference = trace::load(folders.reference);
    std::vector<channel::PassPixels>& pixels = pixels_[outputs.scene];
    if (pixels.size() + outputs.pairs.size() > channel::kMaxReplacements) return false;
    for (const results::PassOutputs::Pair& pair : outputs.pairs) {
      const trace::CopyRecord* copy =
          reference.copyOf(pair.referencePass, pair.referenceAttachment);
      const trace::ImageRef& image = student.passes.at(pair.pass).images[pair.attachment];
      if (!copy) return false;
      pixels.push_back({pair.pass, pair.attachment, trace::PixelType(copy->type), image.format,
                        copy->width, copy->height, reference.bytesOf(*copy)});
    }
    return true;
  }

  /// Draws one scene's first frame with its replacements into `folder`; false if that is no
  /// evidence.
  bool render(std::size_t scene, const fs::path& folder) const {
    const GradedScene& first = graded_.scenes.at(scene);
    trace::Request request = gradingRequest();
    request.copyBytes = first.copyBytes;
    const Rendering rendering = graded_.program->render(first.scene, first.times.first(),
                                                        graded_.shaders, request, pixels_[scene]);
    const channel::Capture& capture = rendering.capture;
    // Without this run the student would lose what it may give back.
    if (rendering.happened.outcome == results::Outcome::notGradable)
      throw std::runtime_error(rendering.happened.detail);
    const auto done = [](channel::ReplacementAnswer answer) {
      return answer == channel::ReplacementAnswer::done;
    };
    if (!rendering.happened.ok() ||
        !std::all_of(capture.replacements.begin(), capture.replacements.end(), done) ||
        !samePasses(trace::load(first.student), capture.trace))
      return false;
    trace::save(capture.trace, folder);
    rubric::writeFrames(folder, rawFrames(capture));
    return true;
  }

  void judgeAgain(const std::set<std::size_t>& scenes) {
    TemporaryFolder work;
    std::vector<fs::path> students(graded_.scenes.size());
    const std::vector<std::size_t> order(scenes.begin(), scenes.end());
    inParallel(order.size(), threads_, [&](std::size_t i) {
      const fs::path folder = work.path() / fmt::format("again-{}", order[i]);
      fs::create_directories(folder);
      if (render(order[i], folder)) students[order[i]] = folder;
    });
    const std::vector<std::string> wanted = heldBack(replaced_);
    const std::vector<results::Item> again =
        judge_.judge({students, {}, wanted}, work.path(), problem_);
    for (const results::Item& one : again)
      if (std::find(wanted.begin(), wanted.end(), one.id) != wanted.end() && one.judged)
        keepBetter(one);
  }

  void keepBetter(const results::Item& again) {
    const auto item = std::find_if(items_.begin(), items_.end(),
                                   [&](const results::Item& one) { return one.id == again.id; });
    if (!takeBetter(*item, again)) return;
    if (item->earned >= item->points) item->cause = item->step = "";
    item->carried.clear();
    for (const std::string& id : replaced_)
      if (isAfter(item->id, id)) item->carried.push_back(declared_.at(id).output);
  }

  Judge& judge_;
  Graded& graded_;
  std::vector<results::Item>& items_;
  unsigned threads_;
  const std::function<void()>& begins_;
  std::string& problem_;
  std::map<std::string, ItemDeclaration> declared_;
  std::vector<std::string> replaced_;                    ///< items, in the order of the runs
  std::vector<std::vector<channel::PassPixels>> pixels_; ///< what is replaced, by scene
};

} // namespace

bool takeBetter(results::Item& item, const results::Item& again) {
  for (std::size_t i = 0; i < again.credits.size(); ++i)
    for (std::size_t k = 0; k < item.credits.size(); ++k)
      if (item.credits[k].scene == again.credits[i].scene &&
          item.credits[k].credit < again.credits[i].credit) {
        item.credits[k].credit = again.credits[i].credit;
        item.messages[k] = again.messages[i];
      }
  const double earned =
      rubric::pointsOf(item.kind, item.points, results::creditOf(item.kind, item.credits));
  if (earned <= item.earned) return false;
  item.earned = earned;
  const auto worst = std::ranges::min_element(item.credits, {}, &results::SceneCredit::credit);
  item.message =
      fmt::format("{}: {}", worst->scene, item.messages[std::size_t(worst - item.credits.begin())]);
  return true;
}

int carryForward(const Target& target, Judge& judge, Graded& graded, unsigned threads,
                 const std::function<void()>& begins, std::string& problem) {
  return Carrying(target, judge, graded, threads, begins, problem).run();
}

} // namespace ggrade::grading
