#include "calibration/replay.hpp"

#include "calibration/subject.hpp"
#include "grading/parallel.hpp"
#include "grading/replay.hpp"
#include "grading/scenes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ggrade::calibration {

namespace {

constexpr std::uint32_t kFrames = 2;

/// Nothing: the program draws no frame.
std::optional<Replayed> replay(grading::Program& program, const KnownAnswer& known,
                               const grading::SceneCase& scene) {
  Replayed one;
  one.program = known.name;
  one.scene = scene.name;
  grading::Moments times = scene.times;
  times.shown.resize(std::min<std::size_t>(times.shown.size(), kFrames));
  trace::Request request = grading::gradingRequest();
  request.copyFrames = kFrames;
  request.copies = request.windowCopies = request.renderbufferCopies = trace::kAllAttachments;
  const grading::Rendering drawn = program.render(scene.scene, times, {}, request);
  if (!drawn.happened.ok()) return std::nullopt;
  trace::Request taping = grading::tapingRequest(times);
  taping.copyFrames = request.copyFrames;
  taping.windowCopies = taping.renderbufferCopies = trace::kAllAttachments;
  const grading::Rendering taped = program.render(scene.scene, times, {}, taping);
  one.drawn = drawn.happened.seconds;
  one.taped = taped.happened.seconds;
  one.megabytes = double(taped.capture.tape.size()) / (1 << 20);
  if (!taped.capture.tapeRefused.empty()) {
    one.refused = true;
    one.difference = "the program " + taped.capture.tapeRefused;
    return one;
  }
  const auto size = scene.scene.at("size").get<std::vector<std::uint32_t>>();
  const grading::Rendering played =
      grading::play(taped.capture.tape, {nlohmann::json::array()}, size, times, {}, request);
  one.played = played.happened.seconds;
  one.difference = grading::differenceOf(drawn.capture, played.capture);
  if (one.difference.empty() && played.capture.frames.size() != times.shown.size())
    one.difference = "the player ended early";
  if (!played.happened.ok()) one.difference += ": " + played.happened.detail;
  return one;
}

} // namespace

std::size_t ReplayFigures::equal() const {
  return std::size_t(
      std::ranges::count_if(all, [](const Replayed& one) { return one.difference.empty(); }));
}

ReplayFigures measureReplay(const Target& target, const std::filesystem::path& solutionFolder,
                            const std::vector<KnownAnswer>& programs, unsigned jobs,
                            const grading::Progress& progress) {
  const grading::ScenePlan plan = grading::drawScenes(target, solutionFolder);
  std::vector<KnownAnswer> drawing;
  for (const KnownAnswer& known : programs)
    if (known.kind != Kind::pictures) drawing.push_back(known);
  auto subjects = subjectsOf(target, drawing);
  std::vector<std::vector<Replayed>> found(subjects.size());
  std::atomic<std::size_t> done = 0;
  grading::inParallel(subjects.size(), jobs, [&](std::size_t i) {
    for (const grading::SceneCase& scene : plan.scenes) {
      if (!subjects[i]->program) break;
      auto one = replay(*subjects[i]->program, subjects[i]->measured.program, scene);
      if (one) found[i].push_back(std::move(*one));
    }
    progress("programs drawn again", ++done, subjects.size());
  });
  ReplayFigures figures{target.id, {}};
  for (auto& some : found)
    figures.all.insert(figures.all.end(), std::make_move_iterator(some.begin()),
                       std::make_move_iterator(some.end()));
  return figures;
}

nlohmann::json toJson(const ReplayFigures& figures) {
  nlohmann::json all = nlohmann::json::array();
  for (const Replayed& one : figures.all)
    all.push_back({{"program", one.program},
                   {"scene", one.scene},
                   {"difference", one.difference},
                   {"megabytes", one.megabytes},
                   {"drawn", one.drawn},
                   {"taped", one.taped},
                   {"played", one.played}});
  return {{"part", figures.part}, {"equal", figures.equal()}, {"runs", all}};
}

Section sectionOf(const ReplayFigures& figures) {
  Section section;
  section.title = "Drawn again from tapes";
  double drawn = 0, taped = 0, played = 0, most = 0;
  std::size_t refused = 0;
  for (const Replayed& one : figures.all) {
    drawn += one.drawn;
    taped += one.taped;
    played += one.played;
    most = std::max(most, one.megabytes);
    refused += one.refused;
  }
  section.text = fmt::format(
      "{} of {} runs are drawn again bit for bit, {} refused a tape. A tape takes at most {:.1f} "
      "MB; with it a run takes {:.2f} times as long, and {:.2f} times as long from the tape alone.",
      figures.equal(), figures.all.size(), refused, most, drawn > 0 ? taped / drawn : 0,
      drawn > 0 ? played / drawn : 0);
  section.columns = {"program", "scene", "what differs"};
  for (const Replayed& one : figures.all)
    if (!one.difference.empty()) section.rows.push_back({one.program, one.scene, one.difference});
  return section;
}

} // namespace ggrade::calibration
