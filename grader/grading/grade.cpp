#include "grading/grade.hpp"

#include "grading/carry.hpp"
#include "grading/diagnose.hpp"
#include "grading/judge_process.hpp"
#include "image/compare.hpp"
#include "image/difference.hpp"
#include "image/flip.hpp"
#include "report/text.hpp"
#include "words/words.hpp"

#include <fmt/format.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <thread>

namespace ggrade::grading {

namespace fs = std::filesystem;
using gg::say;
using report::Outcome;

namespace {

/// Adds the time since its construction to the result when it goes.
class Stopwatch {
public:
  Stopwatch(report::Result& result, std::string what) : result_(result), what_(std::move(what)) {}
  ~Stopwatch() {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    result_.timings.push_back({what_, passed.count()});
  }

private:
  report::Result& result_;
  std::string what_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

report::Frame compareFrames(const Image& student, const ReferencePictures::Frame& shown) {
  const Image& reference = shown.image;
  report::Frame frame;
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

std::string hashOf(const rubric::RawFrame& frame) {
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
std::string compareRuns(const Rendering& first, const Rendering& again, report::Scene& scene) {
  if (again.happened.outcome == Outcome::notGradable) return {}; // no fault of the submission
  if (first.happened.outcome != again.happened.outcome)
    return say("a second run of the same program ended in another way ({})", again.happened.detail);
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

report::Scene describe(const rubric::SceneFolders& folders, const Rendering& rendering,
                       ReferencePictures& pictures) {
  report::Scene scene;
  scene.name = folders.name;
  scene.isPublic = folders.isPublic;
  scene.outcome = report::name(rendering.happened.outcome);
  scene.detail = rendering.happened.detail;
  scene.output = rendering.happened.output;
  scene.seconds = rendering.happened.seconds;
  scene.messages = remarks(rendering.capture);
  const auto student = rawFrames(rendering.capture);
  const auto& reference = pictures.of(folders.reference);
  for (std::size_t i = 0; i < reference.size(); ++i) {
    scene.frames.push_back(
        compareFrames(i < student.size() ? rubric::toImage(student[i]) : Image(), reference[i]));
    if (i < student.size()) scene.frames.back().hash = hashOf(student[i]);
  }
  return scene;
}

/// Byte for byte: whether a second run does the same is then no question.
bool drawsTheReference(const Rendering& rendering, const rubric::SceneFolders& scene) {
  const auto same = [](const channel::CapturedFrame& frame, const rubric::RawFrame& reference) {
    return frame.written && frame.pixels == reference.pixels;
  };
  return std::ranges::equal(rendering.capture.frames, rubric::readFrames(scene.reference), same);
}

/// Items as declared, nothing earned: for submissions that never came to be judged.
std::vector<report::Item> unearned(const Target& target, const std::string& why) {
  std::vector<report::Item> items;
  for (const ItemDeclaration& declared : target.items()) {
    report::Item item = unjudgedItem(declared);
    item.message = why;
    items.push_back(std::move(item));
  }
  return items;
}

struct Renderings {
  std::vector<Rendering> scenes;
  std::optional<Rendering> again; ///< the first scene's second run
};

/// Renders every scene of `references` with a built program into `studentFolder(i)`: frames and
/// passes. The public scene goes first and leaves its shader cache in `shaderFolder` for the hidden
/// ones: so no run can tell another what it saw of a hidden scene.
template <class StudentFolder>
Renderings renderScenes(const Built& built, const ScenePlan& plan, const References& references,
                        const StudentFolder& studentFolder, const fs::path& shaderFolder,
                        const GradeOptions& options,
                        const std::function<void(std::size_t done)>& progress) {
  std::vector<Rendering> renderings(references.scenes.size());
  std::optional<Rendering> again;
  std::atomic<std::size_t> done{1}, firstHung{renderings.size()};
  ShaderCache shaders = references.shaders;
  const auto run = [&](std::size_t i, const trace::Request& request) {
    return built.program->render(plan.scenes[i].scene, plan.scenes[i].times, shaders, request);
  };
  const auto render = [&](std::size_t i) {
    if (i > firstHung) return;
    renderings[i] = run(i, gradingRequest());
    // Copies of a whole frame's passes are too much to keep in memory for every scene.
    trace::save(renderings[i].capture.trace, studentFolder(i));
    renderings[i].capture.trace = {};
    const Happened& happened = renderings[i].happened;
    if (!happened.ok() && happened.seconds >= kRunSeconds)
      for (std::size_t before = firstHung; i < before;)
        if (firstHung.compare_exchange_weak(before, i)) break;
    progress(++done);
  };
  std::size_t first = 0;
  bool twice = false;
  if (!references.scenes.empty() && references.scenes[0].isPublic) {
    if (isolation() == sandbox::Isolation::none) {
      fs::copy(references.shaders.folder, shaderFolder, fs::copy_options::recursive);
      shaders = {shaderFolder, {}};
    } else {
      shaders.keep = shaderFolder;
    }
    render(first++);
    shaders = {shaderFolder, {}};
    twice = options.twice && plan.quality != Quality::fast && renderings[0].happened.ok() &&
            !drawsTheReference(renderings[0], references.scenes[0]);
  }
  inParallel(renderings.size() - first + twice, options.threads, [&](std::size_t i) {
    if (first + i < renderings.size())
      render(first + i);
    else if (firstHung == renderings.size())
      again = run(0, {});
  });
  // One scene that hangs is enough to wait for. What comes after the first counts as not run,
  // whether somebody was fast enough or not: so a result doesn't depend on how many go at a time.
  if (firstHung < renderings.size()) again.reset();
  for (std::size_t i = firstHung + 1; i < renderings.size(); ++i) {
    renderings[i] = {};
    renderings[i].happened = {
        renderings[firstHung].happened.outcome,
        say("not run: the program hung in scene {}", references.scenes[firstHung].name),
        {},
        0};
    fs::remove_all(studentFolder(i));
  }
  for (std::size_t i = 0; i < renderings.size(); ++i)
    rubric::writeFrames(studentFolder(i), rawFrames(renderings[i].capture));
  return {std::move(renderings), std::move(again)};
}

/// The outcome of all scenes together, and the first remark or fault in words.
void nameOutcome(const std::vector<Rendering>& renderings,
                 const std::vector<rubric::SceneFolders>& folders, report::Result& result) {
  result.outcome = Outcome::graded;
  for (std::size_t i = 0; i < renderings.size(); ++i) {
    const Happened& happened = renderings[i].happened;
    // The first scene that didn't go well names the outcome; no frames outweighs a GL error, and a
    // fault of ours everything.
    const bool worse =
        result.outcome == Outcome::graded || (result.outcome == Outcome::glError && !happened.ok());
    if (happened.outcome != Outcome::graded && worse) {
      result.outcome = happened.outcome;
      result.detail = fmt::format("{}: {}", folders[i].name, happened.detail);
    }
  }
  if (renderings.empty()) return;
  if (result.outcome == Outcome::graded)
    if (const auto seen = remarks(renderings[0].capture); !seen.empty())
      result.detail = folders[0].name + ", " + seen[0];
  result.fingerprint = fingerprint(renderings[0].capture);
}

Judging judgeAlone(const Target& target, const GradeOptions& options) {
  return [&](const std::vector<rubric::SceneFolders>& scenes, const fs::path& work,
             std::string& problem, const std::vector<std::string>& again) {
    const fs::path evidence = work / "evidence.json";
    rubric::writeEvidence(evidence, target.assignment.folder, target.id, scenes, again);
    // A file of test results that the caller asked for is about the first judging.
    return judge(target, evidence, work,
                 again.empty() ? options.judgeArguments : std::vector<std::string>(), problem);
  };
}

/// Judges the scenes and, where a pass failed, what follows it once more with the reference's. A
/// fault of ours makes the result not gradable.
void judgeAll(const FirstRun& first, const fs::path& work, report::Result& result) {
  std::string problem;
  {
    const Stopwatch time(result, "judge");
    result.items = first.judging(first.folders, work, problem, {});
  }
  if (problem.empty()) {
    int runs = 0;
    {
      const Stopwatch time(result, "carry forward");
      runs = carryForward(first, result.items, problem);
    }
    if (runs == 0) result.timings.pop_back();
  }
  if (!problem.empty()) {
    result.outcome = Outcome::notGradable;
    result.detail = problem;
  }
}

/// Says so where two runs of the first scene differ.
void nameUnsteady(const Rendering& first, const Rendering& again, report::Result& result) {
  if (result.scenes.empty()) return;
  report::Scene& scene = result.scenes[0];
  const std::string unsteady = compareRuns(first, again, scene);
  if (unsteady.empty()) return;
  scene.messages.insert(scene.messages.begin(), unsteady);
  if (result.outcome == Outcome::graded) result.detail = scene.name + ": " + unsteady;
}

} // namespace

void nameScenes(const ScenePlan& plan, report::Result& result) {
  result.seed = plan.seed;
  result.quality = nameOf(plan.quality);
}

void addUp(report::Result& result) {
  double sum = 0, bonus = 0;
  for (const report::Item& item : result.items)
    (item.kind == report::ItemKind::bonus ? bonus : sum) += item.earned;
  result.score = std::max(0.0, std::round(sum * 10) / 10);
  // A bonus comes on top of something.
  result.bonus = result.score > 0 ? std::round(bonus * 10) / 10 : 0;
}

report::Result ungraded(const Target& target, Outcome outcome, const std::string& detail) {
  report::Result result;
  result.assignment = target.assignment.id;
  result.part = target.id;
  result.title = target.title();
  result.maxScore = target.maxScore();
  result.sandbox = isolation() == sandbox::Isolation::bwrap ? "bwrap" : "none";
  result.thresholds = {{"tolerance", kTolerance}, {"radius", kRadius}, {"window", kWindowSide}};
  result.outcome = outcome;
  result.detail = detail;
  result.items = unearned(target, say("the program was not built"));
  return result;
}

Built buildSubmission(const Target& target, const GradeOptions& options) {
  return buildSubmission(target,
                         std::make_shared<Program>(target.assignment, Recipe{options.upload},
                                                   isolation(), Program::Use::once),
                         options);
}

Built buildSubmission(const Target& target, std::shared_ptr<Program> program,
                      const GradeOptions& options) {
  Built built{ungraded(target, Outcome::buildFailed, {}), std::move(program)};
  report::Result& result = built.result;
  result.submission =
      report::sanitizeLine(fs::weakly_canonical(options.upload).filename().string());
  const Overlay& taken = built.program->files();
  if (!options.solution) result.unusedFiles = taken.unused;
  for (const std::string& name : taken.missing)
    result.unusedFiles.push_back(say("{}: not in the upload; the handed-out file stands in", name));

  if (options.progress) options.progress("building", 0, 1);
  Happened happened;
  {
    const Stopwatch time(result, "build");
    happened = built.program->build();
  }
  result.compilerOutput = happened.output;
  result.outcome = happened.outcome;
  result.detail = happened.detail;
  if (happened.ok())
    result.items.clear();
  else if (const auto observed = diagnosis::outcomeDiagnosis(result, {});
           observed && options.examining)
    result.diagnoses = {*observed};
  return built;
}

report::Result gradeBuilt(const Target& target, const ScenePlan& plan, const References& references,
                          const Built& built, const GradeOptions& options) {
  const Progress progress =
      options.progress ? options.progress : Progress([](const auto&, auto, auto) {});
  report::Result result = built.result;
  nameScenes(plan, result);
  if (result.outcome != Outcome::graded) return result;

  const auto kept =
      options.referencePictures ? options.referencePictures : std::make_shared<ReferencePictures>();
  ReferencePictures& pictures = *kept;
  const std::size_t steps = references.scenes.size() + 2;
  TemporaryFolder work;
  std::vector<rubric::SceneFolders> folders = references.scenes;
  const auto studentFolder = [&](std::size_t i) {
    return work.path() / fmt::format("student-{}", i);
  };
  for (std::size_t i = 0; i < folders.size(); ++i) folders[i].student = studentFolder(i);
  const fs::path shaders = work.makeVisible("shaders");
  Renderings renderings;
  {
    const Stopwatch time(result, "render");
    progress("rendering", 1, steps);
    renderings = renderScenes(built, plan, references, studentFolder, shaders, options,
                              [&](std::size_t done) { progress("rendering", done, steps); });
  }
  nameOutcome(renderings.scenes, folders, result);

  progress("judging", steps - 1, steps);
  // The pictures for the report are compared while the rubric judges, or after it.
  const auto when = options.threads > 1 ? std::launch::async : std::launch::deferred;
  std::future<std::vector<report::Scene>> scenes = std::async(when, [&] {
    std::vector<report::Scene> all;
    if (options.pictures)
      for (std::size_t i = 0; i < folders.size(); ++i)
        all.push_back(describe(folders[i], renderings.scenes[i], pictures));
    return all;
  });
  const Judging judging = options.judging ? options.judging : judgeAlone(target, options);
  judgeAll({target,
            plan,
            references,
            built.program->folder(),
            {shaders},
            folders,
            judging,
            options.threads},
           work.path(), result);
  addUp(result);
  result.scenes = scenes.get();
  if (renderings.again) nameUnsteady(renderings.scenes[0], *renderings.again, result);
  if (options.examining && !folders.empty()) {
    const Stopwatch time(result, "diagnose");
    Submitted submitted{plan, references, {}, {}};
    for (const rubric::SceneFolders& scene : folders) submitted.folders.push_back(scene.student);
    submitted.facts = factsOf(renderings.scenes[0].capture, trace::load(submitted.folders[0]));
    options.examining(submitted, result);
  }
  progress("done", steps, steps);
  return result;
}

Examining diagnosing(const Target& target, const fs::path& solutionFolder,
                     const Progress& progress) {
  const auto kept = std::make_shared<std::optional<Diagnosing>>();
  return [=, &target](const Submitted& submitted, report::Result& result) {
    try {
      if (!*kept)
        kept->emplace(target, solutionFolder, submitted.plan, submitted.references, progress);
      result.diagnoses = (**kept)(submitted, result);
    } catch (const UsageError&) {
      // The catalogue is the instructor's; its faults cost nobody a grade.
      report::Diagnosis none;
      none.text = say("No cause was looked for: the catalogue of mistakes has a fault, which "
                      "ggrade calibrate names.");
      result.diagnoses = {none};
    }
  };
}

report::Result grade(const Target& target, const fs::path& solutionFolder,
                     const GradeOptions& options) {
  const ScenePlan plan = drawScenes(target, solutionFolder, options.draw);
  const Progress progress =
      options.progress ? options.progress : Progress([](const auto&, auto, auto) {});
  GradeOptions how = options;
  if (options.diagnosis) how.examining = diagnosing(target, solutionFolder, progress);
  const Built built = buildSubmission(target, how);
  const References references = prepareReferences(target, solutionFolder, plan, progress);
  return gradeBuilt(target, plan, references, built, how);
}

} // namespace ggrade::grading
