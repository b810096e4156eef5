#include "tradeoff/measure.hpp"

#include "grading/drawing.hpp"
#include "report/picture.hpp"
#include "report/write_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace ggrade::tradeoff {

namespace fs = std::filesystem;

namespace {

constexpr int kThumbWidth = 240, kThumbHeight = 180; ///< pixels of the page's pictures

/// Every pass, timed; nothing is read back. A graphics card draws while the processor waits.
trace::Request timesRequest() {
  trace::Request request{};
  request.passes = 1;
  const bool card = grading::drawing().context == "gpu";
  request.times = std::uint32_t(card ? trace::Times::wall : trace::Times::processor);
  return request;
}

/// Every attachment of the first frame; not timed.
trace::Request copiesRequest() {
  trace::Request request{};
  request.passes = 1;
  request.copies = request.windowCopies = request.renderbufferCopies = trace::kAllAttachments;
  request.copyFrames = 1;
  request.copyBytes = std::uint64_t{1} << 30;
  return request;
}

} // namespace

void requireTruths(const Plan& plan, const fs::path& solutionFolder) {
  try {
    for (const Sweep& sweep : plan.sweeps) truth::judgeOf(sweep.part);
  } catch (const std::invalid_argument& error) {
    throw UsageError(fmt::format("{}: {}", (solutionFolder / "truth.cpp").string(), error.what()));
  }
}

Bench::Bench(const Assignment& assignment, const fs::path& solutionFolder, Effort effort,
             grading::Progress progress)
    : program_(assignment, {solutionFolder}, sandbox::Isolation::none), effort_(effort),
      progress_(std::move(progress)), shaders_(work_.makeVisible("shaders")) {
  progress_("building the reference", 0, 1);
  const grading::Happened& built = program_.build();
  if (!built.ok())
    throw UsageError(fmt::format("{} doesn't build: {}\n{}", solutionFolder.string(), built.detail,
                                 built.output));
}

grading::Rendering Bench::run(const json& scene, const rubric::Moments& times,
                              const trace::Request& request) {
  const auto render = [&] { return program_.render(scene, times, {shaders_}, request); };
  grading::Rendering rendering = render();
  // The reference doesn't hang: the machine was busy for a while.
  if (rendering.happened.outcome == results::Outcome::timeout) rendering = render();
  if (rendering.happened.outcome != results::Outcome::graded)
    throw std::runtime_error(fmt::format("the reference fails with quality {}: {}\n{}",
                                         scene.at("quality").dump(), rendering.happened.detail,
                                         rendering.happened.output));
  if (machine_.empty()) {
    const grading::Renderer renderer = grading::rendererOf(rendering.capture);
    machine_ = grading::fingerprint(renderer, renderer);
    const bool wall = timesRequest().times == std::uint32_t(trace::Times::wall);
    machine_.emplace_back("clock", wall ? "wall" : "processor");
  }
  return rendering;
}

/// The least of a run's frames: what disturbs one (another program, caches) only adds to it.
double Bench::frameMs(const json& scene, const rubric::Moments& frame) {
  rubric::Moments times = frame;
  // The same frame again and again; by turns with the one before it, so that what moves goes on
  // moving.
  times.shown.assign(
      std::min<std::size_t>(kWarmUp + effort_.frames, channel::kMaxFrames - times.before.size()),
      frame.shown.at(0));
  if (!frame.before.empty())
    for (std::size_t i = 1; i < times.shown.size(); i += 2)
      times.shown[i] -= frame.before.back().earlier;
  const trace::Trace trace = run(scene, times, timesRequest()).capture.trace;
  if (trace.passesLost > 0) throw std::runtime_error("more passes than can be recorded");
  std::vector<double> all;
  for (std::size_t i = kWarmUp; i < trace.frames.size(); ++i) {
    double seconds = 0;
    for (const trace::PassRecord& pass : trace.passesOf(i)) seconds += pass.seconds;
    all.push_back(1000 * seconds);
  }
  return *std::ranges::min_element(all);
}

std::vector<Pairs> Bench::time(const std::vector<Compared>& scenes, const rubric::Moments& frame,
                               const std::string& what) {
  std::vector<Pairs> all(scenes.size());
  for (unsigned round = 0; round < effort_.rounds; ++round) {
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < scenes.size(); ++i)
      if (needsMore(all[i])) left.push_back(i);
    if (left.empty()) break;
    const bool forth = round % 2 == 0;
    if (!forth) std::ranges::reverse(left);
    for (std::size_t done = 0; done < left.size(); ++done) {
      progress_(fmt::format("{}: timing, round {} of at most {}", what, round + 1, effort_.rounds),
                done, left.size());
      const Compared& pair = scenes[left[done]];
      const double first = frameMs(forth ? pair.with : pair.without, frame);
      const double second = frameMs(forth ? pair.without : pair.with, frame);
      all[left[done]].with.push_back(forth ? first : second);
      all[left[done]].without.push_back(forth ? second : first);
    }
  }
  return all;
}

truth::Judgement Bench::judge(const Sweep& sweep, const json& scene) {
  const grading::Rendering rendering = run(scene, {sweep.before, {sweep.time}}, copiesRequest());
  if (rendering.capture.trace.copiesLost > 0)
    throw std::runtime_error(
        fmt::format("no room for all pictures of quality {}", scene.at("quality").dump()));
  truth::Rendered rendered;
  rendered.scene = scene;
  rendered.time = sweep.time;
  rendered.before = sweep.before;
  rendered.truth = sweep.truth;
  rendered.window = rubric::toImage(grading::rawFrames(rendering.capture).at(0));
  rendered.trace = &rendering.capture.trace;
  truth::Judgement answer = truth::judgeOf(sweep.part)(rendered);
  if (answer.errors.empty())
    throw std::logic_error(fmt::format("the truth of part {} names no error", sweep.part));
  if (answer.rendered.empty()) answer.rendered = rendered.window;
  return answer;
}

Measured Bench::measure(const Sweep& sweep) {
  const std::string what = sweep.part == sweep.name ? sweep.part : sweep.part + ", " + sweep.name;
  Measured measured{sweep, {}, {}, {}};
  const std::vector<json> settings = allSettings(sweep);
  std::vector<json> scenes;
  for (const json& setting : settings) scenes.push_back(withSetting(sweep.scene, setting));
  for (std::size_t i = 0; i < settings.size(); ++i) {
    progress_(what + ": against the truth", i, settings.size());
    truth::Judgement answer = judge(sweep, scenes[i]);
    measured.points.push_back({settings[i],
                               {},
                               std::move(answer.errors),
                               report::thumbnail(answer.rendered, kThumbWidth, kThumbHeight),
                               report::thumbnail(answer.difference, kThumbWidth, kThumbHeight)});
    if (measured.truth.empty())
      measured.truth = report::thumbnail(answer.truth, kThumbWidth, kThumbHeight);
  }
  std::vector<Compared> compared;
  for (const json& scene : scenes) compared.push_back({scene, sweep.off});
  const std::vector<Pairs> timed = time(compared, {sweep.before, {sweep.time}}, what);
  std::vector<double> off;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    measured.points[i].cost = costOf(timed[i]);
    off.insert(off.end(), timed[i].without.begin(), timed[i].without.end());
  }
  measured.offMs = medianOf(std::move(off));
  return measured;
}

std::vector<GrowthRow> Bench::growth(const Plan& plan) {
  std::set<int> spheres;
  for (const Series& series : plan.growth)
    for (const Step& step : series.steps)
      if (step.sphere > 0) spheres.insert(step.sphere);
  for (int rings : spheres)
    report::writeFile(program_.folder() / sphereFile(rings), sphereObj(rings));
  std::vector<GrowthRow> rows;
  for (const Series& series : plan.growth) {
    for (const PartScenes& part : plan.parts) {
      std::vector<Compared> compared;
      GrowthRow row{part.part, series.name, {}, {}, {}};
      for (const Step& step : series.steps) {
        Compared pair{part.on, part.off};
        pair.with.merge_patch(step.scene);
        pair.without.merge_patch(step.scene);
        compared.push_back(std::move(pair));
        row.values.push_back(step.value);
      }
      std::vector<double> known; // 0 of a hidden cost, which no line is laid through
      for (const Pairs& pairs : time(compared, {0.0}, part.part + " against " + series.name)) {
        row.costs.push_back(costOf(pairs));
        known.push_back(row.costs.back().hidden() ? 0 : row.costs.back().median);
      }
      row.growth = growthOf(row.values, known);
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

std::vector<SavedRow> Bench::saved(const Plan& plan) {
  std::vector<Compared> compared;
  for (const SavedCase& saved : plan.saved) compared.push_back({saved.against, saved.scene});
  const std::vector<Pairs> timed = time(compared, {0.0}, "work saved");
  trace::Request request{};
  request.passes = 1;
  const auto needOf = [&](const json& scene, const std::vector<double>& ms) {
    const trace::Trace trace = run(scene, {0.0}, request).capture.trace;
    return Need{trace.passesOf(0).size(), trace.frames.at(0).imageBytes, medianOf(ms)};
  };
  std::vector<SavedRow> rows;
  for (std::size_t i = 0; i < plan.saved.size(); ++i)
    rows.push_back({plan.saved[i].name, needOf(plan.saved[i].scene, timed[i].without),
                    needOf(plan.saved[i].against, timed[i].with), costOf(timed[i])});
  return rows;
}

} // namespace ggrade::tradeoff
