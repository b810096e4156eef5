#include "grading/grade.hpp"

#include "grading/carry.hpp"
#include "grading/diagnose.hpp"
#include "image/compare.hpp"
#include "image/difference.hpp"
#include "image/flip.hpp"
#include "intake/unpack.hpp"
#include "report/reports.hpp"
#include "report/text.hpp"
#include "words/words.hpp"

#include <fmt/format.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>

namespace ggrade::grading {

namespace fs = std::filesystem;
using gg::say;
using results::Outcome;

namespace {

/// Adds the time since its construction to the result when it goes.
class Stopwatch {
public:
  Stopwatch(results::Result& result, std::string what) : result_(result), what_(std::move(what)) {}
  ~Stopwatch() {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    result_.timings.push_back({what_, passed.count()});
  }

private:
  results::Result& result_;
  std::string what_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

results::Frame compareFrames(const Image& student, const ReferencePictures::Frame& shown) {
  const Image& reference = shown.image;
  results::Frame frame;
  frame.time = shown.raw.time;
  frame.student = student;
  frame.reference = reference;
  frame.referencePng = shown.png;
  frame.wrongShare = 1;
  if (student.empty()) return frame;
  const Comparison comparison = compare(student, reference);
  frame.wrongShare = comparison.wrongShare;
  frame.difference = differencePicture(student, reference);
  if (!comparison.compared()) return frame;
  if (std::ranges::equal(student.values(), reference.values())) {
    frame.flip = 0;
    frame.flipPicture = heatPicture(Image(reference.width(), reference.height(), 1));
    return frame;
  }
  const Flip flip = ldrFlip(student, reference);
  frame.flip = flip.mean;
  frame.flipPicture = heatPicture(flip.map);
  return frame;
}

/// What the copies of a submission's passes may take on disk: of all scenes and of what is drawn
/// again together. Five times what the largest reference takes (160 MB, all of `deferred`).
constexpr std::uint64_t kCopyBytes = std::uint64_t{768} << 20;

/// Shares that out. A scene gets what the reference needs there, times the same for all, so that no
/// scene's room depends on what another has used: they may be drawn at the same time.
void shareCopyBytes(std::vector<GradedScene>& scenes) {
  double sum = 0;
  const auto weight = [](const GradedScene& scene) {
    std::error_code none;
    const auto bytes = fs::file_size(scene.reference / "copies.bin", none);
    return double(std::uint64_t{1} << 20) + (none ? 0 : double(bytes));
  };
  for (const GradedScene& scene : scenes) sum += weight(scene);
  for (GradedScene& scene : scenes)
    scene.copyBytes = std::min(gradingRequest().copyBytes,
                               std::uint64_t(double(kCopyBytes) * weight(scene) / sum));
}

std::string pixelsHash(const rubric::RawFrame& frame) {
  const XXH128_hash_t hash = XXH3_128bits(frame.pixels.data(), frame.pixels.size());
  return fmt::format("{}x{}:{:016x}{:016x}", frame.width, frame.height, hash.high64, hash.low64);
}

/// What the capture saw that a student would want to know, in words.
std::vector<std::string> remarks(const channel::Capture& capture) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < capture.frames.size(); ++i) {
    const channel::CapturedFrame& frame = capture.frames[i];
    // The cause before its effect: the first remark is the one that a table shows.
    if (frame.boundFramebuffer != 0)
      all.push_back(say("frame {}: a framebuffer object ({}) was still bound at the swap: bind 0 "
                        "before you draw to the window",
                        i + 1, frame.boundFramebuffer));
    if (frame.windowDraws == 0)
      all.push_back(say("frame {}: nothing was drawn to the window", i + 1));
    if (frame.windowSrgb)
      all.push_back(say("frame {}: GL_FRAMEBUFFER_SRGB was on, but the window is linear", i + 1));
  }
  for (const channel::CapturedMessage& message : capture.messages)
    if (message.kind != channel::MessageKind::capture)
      all.push_back(say("frame {}: {}", message.frame + 1, message.text));
  return all;
}

/// Holds two runs of one program in one scene against each other. The sentence says what differs;
/// empty: nothing.
std::string compareRuns(const Rendering& first, const Rendering& again, results::Scene& scene) {
  if (again.happened.outcome == Outcome::notGradable) return {}; // no fault of the submission
  if (first.happened.outcome != again.happened.outcome)
    return say("a second run of the same program ended in another way ({})",
               report::spaced(results::name(again.happened.outcome)));
  const auto frames = rawFrames(first.capture), others = rawFrames(again.capture);
  std::string where;
  for (std::size_t i = 0; i < frames.size() && i < others.size(); ++i) {
    if (frames[i].pixels == others[i].pixels) continue;
    const Image image = rubric::toImage(frames[i]), other = rubric::toImage(others[i]);
    double share = 1;
    if (sameSize(image, other)) {
      std::size_t different = 0;
      for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
          different += !std::ranges::equal(image.pixel(x, y), other.pixel(x, y));
      share = double(different) / double(image.pixelCount());
    }
    if (i < scene.frames.size()) {
      scene.frames[i].unsteadyShare = share;
      scene.frames[i].unsteadyPicture = differencePicture(image, other);
    }
    where += (where.empty() ? "" : ", ") + say("{} of frame {}", report::percent(share), i + 1);
  }
  if (where.empty()) return {};
  return say(
      "not deterministic: a second run of the same program draws something else ({}). Random "
      "numbers, the system's clock, or a variable or texture that was never set?",
      where);
}

results::Scene describe(const GradedScene& graded, ReferencePictures& pictures) {
  const Rendering& rendering = graded.rendering;
  results::Scene scene;
  scene.name = graded.name;
  scene.isPublic = graded.isPublic;
  scene.outcome = results::name(rendering.happened.outcome);
  scene.detail = rendering.happened.detail;
  scene.output = rendering.happened.output;
  scene.seconds = rendering.happened.seconds;
  scene.messages = remarks(rendering.capture);
  if (graded.copiesLost > 0)
    scene.messages.push_back(say("{} pictures of passes were left out: those of all scenes may "
                                 "take {} MiB together",
                                 graded.copiesLost, kCopyBytes >> 20));
  const auto student = rawFrames(rendering.capture);
  const auto& reference = pictures.of(graded.reference);
  for (std::size_t i = 0; i < reference.size(); ++i) {
    scene.frames.push_back(
        compareFrames(i < student.size() ? rubric::toImage(student[i]) : Image(), reference[i]));
    if (i < student.size()) scene.frames.back().hash = pixelsHash(student[i]);
  }
  return scene;
}

/// Byte for byte: whether a second run does the same is then no question.
bool drawsTheReference(const GradedScene& scene) {
  const auto same = [](const channel::CapturedFrame& frame, const rubric::RawFrame& reference) {
    return frame.written && frame.pixels == reference.pixels;
  };
  return std::ranges::equal(scene.rendering.capture.frames, rubric::readFrames(scene.reference),
                            same);
}

/// Items as declared, nothing earned: for submissions that never came to be judged.
std::vector<results::Item> unearned(const Target& target, const std::string& why) {
  std::vector<results::Item> items;
  for (const ItemDeclaration& declared : target.items()) {
    results::Item item = unjudgedItem(declared);
    item.message = why;
    items.push_back(std::move(item));
  }
  return items;
}

/// The outcome of all scenes together, the first remark or fault in words, and what drew them: by
/// the reference, since a submission can say anything.
void nameOutcome(const std::vector<GradedScene>& scenes, const References& references,
                 results::Result& result) {
  result.outcome = Outcome::graded;
  for (const GradedScene& scene : scenes) {
    const Happened& happened = scene.rendering.happened;
    // The first scene that didn't go well names the outcome; no frames outweighs a GL error, and a
    // fault of ours everything.
    const bool worse = result.outcome == Outcome::graded ||
                       (result.outcome == Outcome::glError && !happened.ok()) ||
                       happened.outcome == Outcome::notGradable;
    if (result.outcome != Outcome::notGradable && happened.outcome != Outcome::graded && worse) {
      result.outcome = happened.outcome;
      result.detail = fmt::format("{}: {}", scene.name, happened.detail);
    }
  }
  if (scenes.empty()) return;
  const channel::Capture& first = scenes[0].rendering.capture;
  if (result.outcome == Outcome::graded)
    if (const auto seen = remarks(first); !seen.empty())
      result.detail = scenes[0].name + ", " + seen[0];
  result.fingerprint = fingerprint(references.renderer(), rendererOf(first));
}

/// Says so where two runs of the first scene differ.
void nameUnsteady(const Rendering& first, const Rendering& again, results::Result& result) {
  if (result.scenes.empty()) return;
  results::Scene& scene = result.scenes[0];
  const std::string unsteady = compareRuns(first, again, scene);
  if (unsteady.empty()) return;
  scene.messages.insert(scene.messages.begin(), unsteady);
  if (result.outcome == Outcome::graded) result.detail = scene.name + ": " + unsteady;
}

} // namespace

void addUp(results::Result& result) {
  double sum = 0, bonus = 0;
  for (const results::Item& item : result.items)
    (item.kind == results::ItemKind::bonus ? bonus : sum) += item.earned;
  result.score = std::max(0.0, std::round(sum * 10) / 10);
  // A bonus comes on top of something.
  result.bonus = result.score > 0 ? std::round(bonus * 10) / 10 : 0;
}

results::Result ungraded(const Target& target, const ScenePlan& plan, Outcome outcome,
                         const std::string& detail) {
  results::Result result;
  result.assignment = target.assignment.id;
  result.part = target.id;
  result.title = target.title();
  result.maxScore = target.maxScore();
  result.sandbox = isolation() == sandbox::Isolation::bwrap ? "bwrap" : "none";
  result.thresholds = {{"tolerance", kTolerance}, {"radius", kRadius}, {"window", kWindowSide}};
  result.seed = plan.seed;
  result.quality = nameOf(plan.quality);
  result.outcome = outcome;
  result.detail = detail;
  result.items = unearned(target, say("the program was not built"));
  return result;
}

std::vector<fs::path> Graded::students() const {
  std::vector<fs::path> all;
  for (const GradedScene& scene : scenes) all.push_back(scene.student);
  return all;
}

Grader::Grader(const Target& target, fs::path solutionFolder, ScenePlan plan, GraderOptions options,
               std::optional<References> references)
    : target_(target), solutionFolder_(std::move(solutionFolder)), plan_(std::move(plan)),
      options_(std::move(options)), references_(std::move(references)) {}

const References& Grader::references() {
  std::call_once(prepared_, [&] {
    if (!references_)
      references_ = prepareReferences(target_, solutionFolder_, plan_, options_.progress);
  });
  return *references_;
}

Judge& Grader::theJudge() {
  std::call_once(started_, [&] { judge_.emplace(target_, references().scenes, options_.many); });
  return *judge_;
}

void Grader::prepare() {
  references();
  theJudge();
}

results::Result Grader::gradeUpload(const intake::Upload& upload) {
  options_.begins(Runs::told);
  TemporaryFolder work;
  const fs::path folder = work.path() / "upload";
  const intake::Unpacked unpacked =
      intake::unpack(upload, target_.assignment.files, folder, isolation(), &interrupted);
  results::Result result;
  try {
    if (!unpacked.problem.empty()) throw NothingToGrade(unpacked.problem);
    result = grade(std::make_shared<Program>(target_.assignment, Recipe{folder}, isolation(),
                                             Program::Use::once),
                   false);
  } catch (const NothingToGrade& error) {
    result = ungraded(target_, plan_, Outcome::buildFailed, error.what());
  }
  options_.begins(Runs::none);
  result.refused = unpacked.refused;
  if (!unpacked.problem.empty()) result.refused.push_back(unpacked.problem);
  for (const auto* list : {&unpacked.refused, &unpacked.remarks})
    result.unusedFiles.insert(result.unusedFiles.end(), list->begin(), list->end());
  return result;
}

results::Result Grader::gradeTrusted(const fs::path& folder) {
  return grade(std::make_shared<Program>(target_.assignment, Recipe{folder}, isolation(),
                                         Program::Use::once),
               true);
}

results::Result Grader::grade(const std::shared_ptr<Program>& program, bool trusted) {
  program->files(); // nothing to grade: said before the references are rendered for it
  prepare();        // the judge reads while the compiler runs
  Graded graded = draw(build(program, trusted));
  judge(graded);
  if (options_.diagnosis) diagnose(graded);
  options_.progress("done", 1, 1);
  return std::move(graded.result);
}

Built Grader::build(const std::shared_ptr<Program>& program, bool trusted) {
  Built built{ungraded(target_, plan_, Outcome::buildFailed, {}), program};
  results::Result& result = built.result;
  const Overlay& taken = program->files();
  if (!trusted) result.unusedFiles = taken.unused;
  for (const std::string& name : taken.missing)
    result.unusedFiles.push_back(say("{}: not in the upload; the handed-out file stands in", name));
  options_.progress("building", 0, 1);
  options_.begins(Runs::told);
  Happened happened;
  {
    const Stopwatch time(result, "build");
    happened = program->build();
  }
  result.compilerOutput = happened.output;
  result.outcome = happened.outcome;
  result.detail = happened.detail;
  if (happened.ok()) result.items.clear();
  return built;
}

Graded Grader::draw(const Built& built, std::size_t count) {
  Graded graded;
  graded.result = built.result;
  graded.result.seed = plan_.seed;
  graded.result.quality = nameOf(plan_.quality);
  graded.program = built.program;
  if (built.result.outcome != Outcome::graded) return graded;

  const References& known = references();
  graded.work = std::make_unique<TemporaryFolder>();
  const fs::path shaderFolder = graded.work->makeVisible("shaders");
  std::vector<GradedScene>& scenes = graded.scenes;
  for (const rubric::SceneFolders& scene : known.scenes) {
    if (scenes.size() == count) break;
    scenes.push_back({scene, {}});
    scenes.back().student = graded.work->path() / fmt::format("student-{}", scenes.size() - 1);
  }
  shareCopyBytes(scenes);
  std::optional<Stopwatch> time(std::in_place, graded.result, "render");
  const std::size_t steps = scenes.size() + 2;
  options_.progress("rendering", 1, steps);
  std::atomic<std::size_t> done{1}, firstHung{scenes.size()};
  graded.shaders = known.shaders;
  const auto run = [&](std::size_t i, const trace::Request& request) {
    return graded.program->render(scenes[i].scene, scenes[i].times, graded.shaders, request);
  };
  const auto render = [&](std::size_t i) {
    if (i > firstHung) return;
    trace::Request request = gradingRequest();
    request.copyBytes = scenes[i].copyBytes;
    Rendering& rendering = scenes[i].rendering = run(i, request);
    // Copies of a whole frame's passes are too much to keep in memory for every scene.
    trace::save(rendering.capture.trace, scenes[i].student);
    scenes[i].copyBytes -= rendering.capture.trace.pixels.size();
    scenes[i].copiesLost = rendering.capture.trace.copiesLost;
    rendering.capture.trace = {};
    const Happened& happened = rendering.happened;
    if (!happened.ok() && happened.seconds >= kRunSeconds)
      for (std::size_t before = firstHung; i < before;)
        if (firstHung.compare_exchange_weak(before, i)) break;
    options_.progress("rendering", ++done, steps);
  };
  std::size_t first = 0;
  if (!scenes.empty() && scenes[0].isPublic) {
    if (isolation() == sandbox::Isolation::none) {
      fs::copy(known.shaders.folder, shaderFolder, fs::copy_options::recursive);
      graded.shaders = {shaderFolder, {}};
    } else {
      graded.shaders.keep = shaderFolder;
    }
    render(first++);
    graded.shaders = {shaderFolder, {}};
    // Before any hidden scene is drawn: what this run does is told its student.
    if (options_.twice && plan_.quality != Quality::fast && scenes[0].rendering.happened.ok() &&
        !drawsTheReference(scenes[0]))
      graded.again = run(0, {});
  }
  if (first < scenes.size()) options_.begins(Runs::hidden);
  inParallel(scenes.size() - first, options_.threads, [&](std::size_t i) { render(first + i); });
  options_.begins(Runs::none);
  // One scene that hangs is enough to wait for. What comes after the first counts as not run,
  // whether somebody was fast enough or not: so a result doesn't depend on how many go at a time.
  if (firstHung < scenes.size()) graded.again.reset();
  for (std::size_t i = firstHung + 1; i < scenes.size(); ++i) {
    scenes[i].rendering = {};
    scenes[i].rendering.happened = {
        scenes[firstHung].rendering.happened.outcome,
        say("not run: the program hung in scene {}", scenes[firstHung].name),
        {},
        0};
    fs::remove_all(scenes[i].student);
  }
  for (const GradedScene& scene : scenes)
    rubric::writeFrames(scene.student, rawFrames(scene.rendering.capture));
  time.reset();
  nameOutcome(scenes, known, graded.result);
  if (scenes.empty()) return graded;
  graded.facts = factsOf(scenes[0].rendering.capture, trace::load(scenes[0].student));
  const auto ended = std::ranges::find_if(
      scenes, [](const GradedScene& scene) { return !scene.rendering.happened.ok(); });
  graded.facts.endedItself = ended != scenes.end() && !ended->rendering.happened.signalled;
  return graded;
}

void Grader::judge(Graded& graded) {
  if (!graded.work) return; // not built
  results::Result& result = graded.result;
  options_.progress("judging", graded.scenes.size() + 1, graded.scenes.size() + 2);
  // The pictures for the report are compared while the rubric judges, or after it.
  const auto when = options_.threads > 1 ? std::launch::async : std::launch::deferred;
  std::future<std::vector<results::Scene>> scenes = std::async(when, [&] {
    std::vector<results::Scene> all;
    if (options_.pictures)
      for (const GradedScene& scene : graded.scenes) all.push_back(describe(scene, pictures_));
    return all;
  });
  std::string problem;
  {
    const Stopwatch time(result, "judge");
    result.items = theJudge().judge({graded.students(), options_.judgeArguments},
                                    graded.work->path(), problem);
  }
  if (problem.empty() && options_.repair && isWorthRepair(result)) {
    result.asDrawn = result.items;
    const Stopwatch time(result, "repair");
    options_.begins(Runs::hidden);
    std::call_once(taped_, [&] { tapes_.emplace(target_, solutionFolder_, references()); });
    result.causes =
        repairFaults(target_, *tapes_, theJudge(), graded, options_.threads, result.causesSought);
    options_.begins(Runs::none);
  }
  if (problem.empty() && (result.causes.empty() || areUnfinished(result.causes))) {
    int runs = 0;
    {
      const Stopwatch time(result, "carry forward");
      runs = carryForward(
          target_, theJudge(), graded, options_.threads, [&] { options_.begins(Runs::hidden); },
          problem);
    }
    options_.begins(Runs::none);
    if (runs == 0) result.timings.pop_back();
  }
  if (!problem.empty()) {
    result.outcome = Outcome::notGradable;
    result.detail = problem;
  }
  addUp(result);
  result.scenes = scenes.get();
  if (graded.again) nameUnsteady(graded.scenes[0].rendering, *graded.again, result);
}

void Grader::diagnose(Graded& graded, const std::set<std::string>& leftOut) {
  results::Result& result = graded.result;
  if (!graded.work) { // not built
    if (const auto observed = diagnosis::outcomeDiagnosis(result, {}))
      result.diagnoses = {*observed};
    return;
  }
  if (graded.scenes.empty()) return;
  const Stopwatch time(result, "diagnose");
  const std::lock_guard lock(diagnosing_);
  try {
    const Agrees agrees = [&](const Mistake& mistake, const auto& causes) {
      const auto& units = tapes_->unitsOf(mistake.patch);
      return std::ranges::any_of(causes, [&](const results::ProvedCause& cause) {
        const auto same = units.find({cause.role, cause.unit});
        // A sampler may read something else in several ways.
        return same != units.end() &&
               (!cause.unit.starts_with("texture ") || same->second == cause.own);
      });
    };
    const auto diagnoserOf = [&](const Part& part) -> Diagnoser& {
      const auto known = diagnosers_.find(part.id);
      if (known != diagnosers_.end()) return known->second;
      return diagnosers_
          .try_emplace(part.id, target_, part, solutionFolder_, references(), options_.progress,
                       options_.suspects)
          .first->second;
    };
    result.diagnoses = diagnosesOf(target_, graded, diagnoserOf, agrees, leftOut);
  } catch (const UsageError&) {
    // The catalogue is the instructor's; its faults cost nobody a grade.
    results::Diagnosis none;
    none.text = say("No cause was looked for: the catalogue of mistakes has a fault, which "
                    "ggrade calibrate names.");
    result.diagnoses = {none};
  }
}

void publishReports(const results::Result& result, const fs::path& out, report::Reveal reveal) {
  // Beside the destination, so that it can be moved there in one step.
  TemporaryFolder work(fs::absolute(out).lexically_normal().parent_path());
  report::writeReports(work.path(), result, reveal);
  work.publish(out);
}

} // namespace ggrade::grading
