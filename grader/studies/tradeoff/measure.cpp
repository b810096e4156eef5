#include "tradeoff/measure.hpp"

#include "report/picture.hpp"
#include "report/write_file.hpp"

#include <fmt/format.h>

#include <set>
#include <stdexcept>

namespace ggrade::tradeoff {

namespace fs = std::filesystem;

namespace {

constexpr int kThumbWidth = 240, kThumbHeight = 180; ///< pixels of the page's pictures

/// Every pass, timed; nothing is read back.
trace::Request timesRequest() {
  trace::Request request{};
  request.passes = request.times = 1;
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
  }
  return rendering;
}

std::vector<double> Bench::frames(const json& scene, const rubric::Moments& frame) {
  rubric::Moments times = frame;
  times.shown.resize(
      std::min<std::size_t>(kWarmUp + effort_.frames, channel::kMaxFrames - times.before.size()),
      frame.shown.at(0));
  const trace::Trace trace = run(scene, times, timesRequest()).capture.trace;
  if (trace.passesLost > 0) throw std::runtime_error("more passes than can be recorded");
  std::vector<double> all;
  for (std::size_t i = kWarmUp; i < trace.frames.size(); ++i) {
    double seconds = 0;
    for (const trace::PassRecord& pass : trace.passesOf(i)) seconds += pass.seconds;
    all.push_back(1000 * seconds);
  }
  return all;
}

Bench::Timed Bench::time(const std::vector<json>& scenes, const std::vector<std::size_t>& off,
                         const rubric::Moments& frame, const std::string& what) {
  Timed timed;
  timed.costs.resize(scenes.size());
  std::vector<std::vector<double>> wholes(scenes.size());
  std::size_t done = 0;
  for (unsigned round = 0; round < effort_.rounds; ++round) {
    const std::string text =
        fmt::format("{}: timing, round {} of {}", what, round + 1, effort_.rounds);
    std::vector<std::vector<double>> now(scenes.size());
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      progress_(text, done++, scenes.size() * effort_.rounds);
      const std::size_t index = round % 2 == 0 ? i : scenes.size() - 1 - i;
      now[index] = frames(scenes[index], frame);
    }
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      const double without = spreadOf(now[off[i]]).median;
      for (double ms : now[i]) timed.costs[i].push_back(ms - without);
      wholes[i].insert(wholes[i].end(), now[i].begin(), now[i].end());
    }
  }
  for (std::vector<double>& whole : wholes) timed.whole.push_back(spreadOf(std::move(whole)));
  return timed;
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
  // The scene without the part goes last.
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
  scenes.push_back(sweep.off);
  const std::vector<std::size_t> off(scenes.size(), scenes.size() - 1);
  Timed timed = time(scenes, off, {sweep.before, {sweep.time}}, what);
  for (std::size_t i = 0; i < settings.size(); ++i)
    measured.points[i].ms = spreadOf(std::move(timed.costs[i]));
  measured.offMs = timed.whole.back();
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
      // On and off by turns.
      std::vector<json> scenes;
      std::vector<std::size_t> off;
      GrowthRow row{part.part, series.name, {}, {}, {}};
      for (const Step& step : series.steps) {
        for (json scene : {part.on, part.off}) {
          scene.merge_patch(step.scene);
          scenes.push_back(std::move(scene));
          off.push_back(2 * row.values.size() + 1);
        }
        row.values.push_back(step.value);
      }
      const Timed timed = time(scenes, off, {0.0}, part.part + " against " + series.name);
      std::vector<double> medians;
      for (std::size_t i = 0; i < scenes.size(); i += 2) {
        row.ms.push_back(spreadOf(timed.costs[i]));
        medians.push_back(row.ms.back().median);
      }
      row.growth = growthOf(row.values, medians);
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

std::vector<SavedRow> Bench::saved(const Plan& plan) {
  std::vector<json> scenes;
  std::vector<std::size_t> off;
  for (const SavedCase& saved : plan.saved)
    for (const json& scene : {saved.scene, saved.against}) {
      off.push_back(scenes.size());
      scenes.push_back(scene);
    }
  const Timed timed = time(scenes, off, {0.0}, "work saved");
  trace::Request request{};
  request.passes = 1;
  std::vector<Need> needs;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const trace::Trace trace = run(scenes[i], {0.0}, request).capture.trace;
    needs.push_back({trace.passesOf(0).size(), trace.frames.at(0).imageBytes, timed.whole[i]});
  }
  std::vector<SavedRow> rows;
  for (std::size_t i = 0; i < plan.saved.size(); ++i)
    rows.push_back({plan.saved[i].name, needs[2 * i], needs[2 * i + 1]});
  return rows;
}

} // namespace ggrade::tradeoff
