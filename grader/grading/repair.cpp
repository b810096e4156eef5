#include "grading/repair.hpp"

#include "diagnosis/proved.hpp"
#include "grading/carry.hpp"
#include "grading/grade.hpp"
#include "grading/replay.hpp"
#include "report/summary.hpp"
#include "report/write_file.hpp"
#include "rubric/rubric.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ggrade::grading {

namespace fs = std::filesystem;
using nlohmann::json;
using repair::Unit;
using results::ProvedCause;

namespace {

/// So much of what a scene can lose may be missing where it counts as right.
constexpr double kRight = 0.02;
constexpr double kRightPoints = 0.5;
/// A submission that takes more is another program, not a fault.
constexpr std::size_t kMostCauses = 6;
constexpr std::size_t kMostTried = 40; ///< differences of one submission
/// So many are left out one by one to see which are needed; each is a run.
constexpr std::size_t kMostLeftOut = 16;
/// Variants that one run draws: so many frames fit a channel.
constexpr std::size_t kVariantFrames = 48;
/// What was right before and was spoiled costs so many points at most once that is proved.
constexpr double kSpoiledPoints = 10;

/// The frames `first` to `first + count` of a run, as a run of its own. Copies of its first frame
/// alone.
channel::Capture partOf(const channel::Capture& all, std::size_t first, std::size_t count,
                        const std::vector<double>& times) {
  channel::Capture part;
  part.frames.assign(all.frames.begin() + std::ptrdiff_t(first),
                     all.frames.begin() + std::ptrdiff_t(first + count));
  for (std::size_t i = 0; i < count; ++i) part.frames[i].time = times[i];
  const trace::Trace& from = all.trace;
  trace::Trace& to = part.trace;
  const std::uint32_t begin = from.frames[first].firstPass;
  const std::uint32_t end =
      from.frames[first + count - 1].firstPass + from.frames[first + count - 1].passCount;
  for (std::size_t i = 0; i < count; ++i) {
    to.frames.push_back(from.frames[first + i]);
    to.frames.back().firstPass -= begin;
  }
  to.matrices = from.matrices;
  to.samples = from.samples;
  for (trace::SampleRecord& sample : to.samples)
    sample.writer = sample.writer == trace::kNone || sample.writer < begin || sample.writer >= end
                        ? trace::kNone
                        : sample.writer - begin;
  to.steps = from.steps;
  for (trace::StepRecord& step : to.steps)
    step.pass -= begin; // those of other passes aren't asked for
  for (std::uint32_t p = begin; p < end; ++p) {
    to.passes.push_back(from.passes[p]);
    to.passes.back().frame -= std::uint32_t(first);
  }
  for (const trace::CopyRecord& copy : from.copies) {
    if (copy.pass < begin || copy.pass >= end || to.passes[copy.pass - begin].frame != 0) continue;
    trace::CopyRecord one = copy;
    one.pass -= begin;
    one.offset = to.pixels.size();
    const auto bytes = std::span(from.pixels).subspan(copy.offset, copy.bytes);
    to.pixels.insert(to.pixels.end(), bytes.begin(), bytes.end());
    to.copies.push_back(one);
  }
  return part;
}

/// One scene of the submission with everything that is tried on it.
struct TapedScene {
  std::size_t index;
  std::vector<std::byte> tape;
  std::vector<repair::Difference> differences;
};

class Repairing {
public:
  Repairing(const Target& target, OwnTapes& own, Judge& judge, Graded& graded)
      : own_(own), judge_(judge), graded_(graded), items_(graded.result.items) {
    for (const ItemDeclaration& declared : target.items()) declared_[declared.id] = declared;
  }

  std::vector<ProvedCause> run(std::string& why) {
    const std::vector<std::size_t> lossy = lossyScenes();
    if (lossy.empty()) return why = "nothing was lost", std::vector<ProvedCause>{};
    if (!record(lossy.front(), why)) return {};
    const std::vector<Unit> found = search(why);
    if (found.empty()) return {};
    for (const std::size_t scene : lossy)
      if (scene != lossy.front() && !record(scene, why)) return {};
    std::vector<ProvedCause> causes;
    for (const Unit& unit : found)
      for (const repair::Difference& one : scenes_.front().differences)
        if (one.unit == unit) causes.push_back({unit.pass, unit.name, own_.ownersOf(one)});
    settle(causes);
    return causes;
  }

private:
  /// Points that items lost in a scene, were it the only one.
  double lossIn(const std::vector<results::Item>& items, const std::string& scene) const {
    double loss = 0;
    for (const results::Item& item : items)
      for (const results::SceneCredit& one : item.credits)
        if (one.scene == scene) loss += item.points * (1 - one.credit);
    return loss;
  }

  /// Scenes in which points were lost, the worst first.
  std::vector<std::size_t> lossyScenes() const {
    std::vector<std::pair<double, std::size_t>> found;
    for (std::size_t i = 0; i < graded_.scenes.size(); ++i) {
      const double loss = lossIn(items_, graded_.scenes[i].name);
      if (loss <= 0) continue;
      if (!graded_.scenes[i].rendering.happened.ok()) return {};
      found.emplace_back(-loss, i);
    }
    std::ranges::sort(found);
    std::vector<std::size_t> scenes;
    for (const auto& [loss, scene] : found) scenes.push_back(scene);
    return scenes;
  }

  bool record(std::size_t index, std::string& why) {
    const GradedScene& scene = graded_.scenes[index];
    const Rendering taped =
        graded_.program->render(scene.scene, scene.times, graded_.shaders,
                                tapingRequest(std::uint32_t(scene.times.size())));
    if (!taped.happened.ok()) return why = "it ends otherwise when it is recorded", false;
    if (!taped.capture.tapeRefused.empty())
      return why = "the program " + taped.capture.tapeRefused, false;
    repair::Comparison comparison =
        repair::compare(tape::read(taped.capture.tape), own_.reference(index));
    scenes_.push_back({index, tape::write(comparison.tape), std::move(comparison.differences)});
    const channel::Capture again = play(scenes_.back(), {json::array()}).at(0);
    if (const std::string difference = differenceOf(taped.capture, again); !difference.empty())
      return why = "it is not drawn again as it was: " + difference, false;
    return true;
  }

  /// The scene with each of these patches.
  std::vector<channel::Capture> play(const TapedScene& scene,
                                     const std::vector<json>& patches) const {
    const GradedScene& graded = graded_.scenes[scene.index];
    const std::size_t frames = graded.times.size();
    const std::size_t each = std::max<std::size_t>(1, kVariantFrames / frames);
    std::vector<channel::Capture> all;
    for (std::size_t at = 0; at < patches.size(); at += each) {
      const std::vector<json> some(patches.begin() + std::ptrdiff_t(at),
                                   patches.begin() +
                                       std::ptrdiff_t(std::min(at + each, patches.size())));
      trace::Request request = gradingRequest();
      request.copyFrames = channel::kMaxFrames;
      request.copyBytes = std::uint64_t{1} << 30;
      const Rendering played =
          grading::play(scene.tape, some, graded.scene.at("size").get<std::vector<std::uint32_t>>(),
                        std::uint32_t(frames), graded_.shaders, request);
      const std::size_t whole = played.capture.frames.size() / frames;
      for (std::size_t i = 0; i < some.size(); ++i)
        all.push_back(i < whole ? partOf(played.capture, i * frames, frames, graded.times)
                                : channel::Capture());
    }
    return all;
  }

  /// What the rubric says of the scenes as drawn here; `drawn` is one to each of `scenes_`, or only
  /// of the first ones.
  std::vector<results::Item> judge(const std::vector<channel::Capture>& drawn) {
    TemporaryFolder work;
    std::vector<fs::path> students(graded_.scenes.size());
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      if (drawn[i].frames.empty()) return {};
      const fs::path folder = work.path() / fmt::format("repaired-{}", i);
      fs::create_directories(folder);
      trace::save(drawn[i].trace, folder);
      rubric::writeFrames(folder, rawFrames(drawn[i]));
      students[scenes_[i].index] = folder;
    }
    std::string problem;
    std::vector<results::Item> items = judge_.judge({students}, work.path(), problem);
    return problem.empty() ? items : std::vector<results::Item>{};
  }

  static json patchOf(const TapedScene& scene, const std::vector<Unit>& units) {
    json patch = json::array();
    for (const repair::Difference& one : scene.differences)
      if (std::ranges::find(units, one.unit) != units.end())
        patch.insert(patch.end(), one.patch.begin(), one.patch.end());
    return patch;
  }

  /// The first set with which the worst scene is right; nothing: with none. All are drawn in one
  /// run, and judged until one is right.
  std::optional<std::vector<Unit>> firstRight(const std::vector<std::vector<Unit>>& sets) {
    if (sets.empty()) return std::nullopt;
    const TapedScene& worst = scenes_.front();
    std::vector<json> patches;
    for (const auto& set : sets) patches.push_back(patchOf(worst, set));
    const std::vector<channel::Capture> drawn = play(worst, patches);
    for (std::size_t i = 0; i < sets.size(); ++i) {
      const auto items = judge({drawn[i]});
      if (!items.empty() &&
          lossIn(items, graded_.scenes[worst.index].name) <= std::max(kRight * lost_, kRightPoints))
        return sets[i];
    }
    return std::nullopt;
  }

  /// The smallest set that makes the worst scene right: one unit, narrow before wide; else what
  /// remains of a pass's units, or of all, when those that aren't needed are left out one by one.
  std::vector<Unit> search(std::string& why) {
    const TapedScene& worst = scenes_.front();
    lost_ = lossIn(items_, graded_.scenes[worst.index].name);
    std::vector<std::vector<Unit>> singles, passes;
    std::map<std::size_t, std::vector<Unit>> byPass;
    std::vector<Unit> all;
    for (const repair::Difference& one : worst.differences) {
      if (all.size() == kMostTried) break;
      all.push_back(one.unit);
      singles.push_back({one.unit});
      byPass[one.unit.pass].push_back(one.unit);
    }
    if (const auto found = firstRight(singles)) return *found;
    for (const auto& [pass, units] : byPass)
      if (units.size() > 1) passes.push_back(units);
    if (byPass.size() > 1) passes.push_back(all);
    auto found = firstRight(passes);
    if (!found || found->size() > kMostLeftOut) {
      why = fmt::format("the passes' {} differences don't explain it", all.size());
      return {};
    }
    for (std::size_t i = found->size(); i-- > 0;) {
      std::vector<Unit> fewer = *found;
      fewer.erase(fewer.begin() + std::ptrdiff_t(i));
      if (!fewer.empty() && firstRight({fewer})) *found = fewer;
    }
    if (found->size() > kMostCauses) {
      why = fmt::format("it takes {} changes to make it right", found->size());
      return {};
    }
    return *found;
  }

  /// Each item keeps the better of what it had and what it has when all causes are repaired but
  /// those that are its own work.
  void settle(const std::vector<ProvedCause>& causes) {
    std::map<std::vector<Unit>, std::vector<std::string>> variants; // what is repaired: for whom
    for (const results::Item& item : items_) {
      std::vector<Unit> repaired;
      for (const ProvedCause& cause : causes)
        if (!isWorkOf(cause, item)) repaired.push_back({cause.pass, cause.unit});
      if (!repaired.empty()) variants[repaired].push_back(item.id);
    }
    const std::vector<results::Item> before = items_;
    std::vector<std::vector<channel::Capture>> drawn(variants.size());
    for (const TapedScene& scene : scenes_) {
      std::vector<json> patches;
      for (const auto& [repaired, ids] : variants) patches.push_back(patchOf(scene, repaired));
      auto captures = play(scene, patches);
      for (std::size_t i = 0; i < captures.size(); ++i) drawn[i].push_back(std::move(captures[i]));
    }
    std::size_t i = 0;
    for (const auto& [repaired, ids] : variants)
      for (const results::Item& again : judge(drawn[i++]))
        if (std::ranges::find(ids, again.id) != ids.end()) keepBetter(again, causes);
    chargeOnce(before);
    double spoiled = 0;
    for (const results::Item& item : items_)
      if (item.kind == results::ItemKind::keep) spoiled -= item.earned;
    for (results::Item& item : items_)
      if (item.kind == results::ItemKind::keep && spoiled > kSpoiledPoints)
        item.earned *= kSpoiledPoints / spoiled;
  }

  /// A fault is never free: where none of those whose work it is lost anything, the item that lost
  /// the largest share keeps its loss.
  void chargeOnce(const std::vector<results::Item>& before) {
    const auto share = [](const results::Item& item) {
      return item.kind == results::ItemKind::bonus ? 0 : report::lost(item) / item.points;
    };
    if (std::ranges::any_of(items_, [&](const results::Item& item) { return share(item) > 0.05; }))
      return;
    const auto worst = std::ranges::max_element(before, {}, share);
    items_[std::size_t(worst - before.begin())] = *worst;
  }

  /// Items say what their work is; else it is the step's that they stand for. What was right from
  /// the start is the work of those that keep it.
  bool isWorkOf(const ProvedCause& cause, const results::Item& item) const {
    if (cause.todos.empty()) return item.kind == results::ItemKind::keep;
    if (item.kind == results::ItemKind::keep) return false;
    const bool isNamed = std::ranges::any_of(
        declared_, [&](const auto& one) { return names(one.second, cause.unit); });
    const ItemDeclaration& declared = declared_.at(item.id);
    return isNamed ? names(declared, cause.unit) : cause.todos.contains(declared.step);
  }

  static bool names(const ItemDeclaration& declared, const std::string& unit) {
    return std::ranges::find(declared.work, unit) != declared.work.end();
  }

  void keepBetter(const results::Item& again, const std::vector<ProvedCause>& causes) {
    const auto item = std::ranges::find(items_, again.id, &results::Item::id);
    if (item == items_.end() || !again.judged) return;
    const double before = item->earned;
    for (std::size_t i = 0; i < again.credits.size(); ++i)
      for (std::size_t k = 0; k < item->credits.size(); ++k)
        if (item->credits[k].scene == again.credits[i].scene && isTaped(again.credits[i].scene) &&
            item->credits[k].credit < again.credits[i].credit) {
          item->credits[k].credit = again.credits[i].credit;
          item->messages[k] = again.messages[i];
        }
    item->earned =
        rubric::pointsOf(item->kind, item->points, results::creditOf(item->kind, item->credits));
    if (item->earned <= before) {
      item->earned = before;
      return;
    }
    if (report::lost(*item) <= 0) item->cause = item->step = "";
    item->message = worstMessage(*item);
    item->repaired.clear();
    for (const ProvedCause& cause : causes)
      if (!isWorkOf(cause, *item)) item->repaired.push_back(diagnosis::nameOf(cause));
  }

  bool isTaped(const std::string& scene) const {
    return std::ranges::any_of(
        scenes_, [&](const TapedScene& one) { return graded_.scenes[one.index].name == scene; });
  }

  OwnTapes& own_;
  Judge& judge_;
  Graded& graded_;
  std::vector<results::Item>& items_;
  std::map<std::string, ItemDeclaration> declared_;
  std::vector<TapedScene> scenes_; ///< the worst one first
  double lost_ = 0;                ///< in it
};

} // namespace

OwnTapes::OwnTapes(const Target& target, fs::path solutionFolder, const References& references)
    : target_(target), solutionFolder_(std::move(solutionFolder)), references_(references) {}

tape::Tape OwnTapes::record(const Recipe& recipe, const rubric::SceneFolders& scene) {
  Program program(target_.assignment, recipe);
  const Rendering taped = program.render(scene.scene, scene.times, references_.ownShaders,
                                         tapingRequest(std::uint32_t(scene.times.size())));
  if (!taped.happened.ok() || !taped.capture.tapeRefused.empty())
    throw std::runtime_error("our own program has no tape: " + taped.happened.detail +
                             taped.capture.tapeRefused);
  return tape::read(taped.capture.tape);
}

const tape::Tape& OwnTapes::reference(std::size_t scene) {
  const std::lock_guard lock(mutex_);
  const auto found = reference_.find(scene);
  if (found != reference_.end()) return found->second;
  return reference_.emplace(scene, record({solutionFolder_}, references_.scenes.at(scene)))
      .first->second;
}

void OwnTapes::learnOwners() {
  const rubric::SceneFolders& scene = references_.scenes.at(0);
  const fs::path file =
      cacheFolder() / "owners" /
      hashOf(referenceKey(target_, solutionFolder_) + target_.id + scene.scene.dump());
  if (fs::exists(file)) {
    for (const json& one : readJson(file))
      changedBy_[{one.at("pass"), one.at("unit")}] =
          one.at("todos").get<std::map<std::string, std::set<std::string>>>();
    return;
  }
  const tape::Tape& right = reference(0);
  std::set<std::string> filled;
  tape::Tape before = record({solutionFolder_, {}, filled}, scene);
  for (const Part& part : target_.parts)
    for (const auto& todo : part.todos) {
      filled.insert(todo.id);
      tape::Tape after = record({solutionFolder_, {}, filled}, scene);
      const repair::Comparison step = repair::compare(before, after);
      const auto inReference = repair::compare(after, right).passes;
      const auto changed = [&](const Unit& unit, const std::set<std::string>& lines) {
        if (const auto pass = inReference.find(unit.pass); pass != inReference.end())
          changedBy_[{pass->second, unit.name}][todo.id] = lines;
      };
      for (const repair::Difference& one : step.differences) changed(one.unit, one.lacks);
      // What the step draws that was not there before is its work, whole.
      for (const Unit& unit : repair::compare(after, after).compared)
        if (!step.compared.contains(unit)) changed(unit, {});
      before = std::move(after);
    }
  json kept = json::array();
  for (const auto& [unit, todos] : changedBy_)
    kept.push_back({{"pass", unit.pass}, {"unit", unit.name}, {"todos", todos}});
  TemporaryFolder work(file.parent_path());
  report::writeFile(work.path() / "owners", kept.dump());
  keep(work.path() / "owners", file);
}

std::set<std::string> OwnTapes::ownersOf(const repair::Difference& difference) {
  const std::lock_guard lock(owners_);
  if (!learned_) {
    learnOwners();
    learned_ = true;
  }
  const auto found = changedBy_.find(difference.unit);
  if (found == changedBy_.end()) return {};
  std::set<std::string> all, byLine;
  for (const auto& [todo, lines] : found->second) {
    all.insert(todo);
    if (std::ranges::any_of(
            lines, [&](const std::string& line) { return difference.lacks.contains(line); }))
      byLine.insert(todo);
  }
  return byLine.empty() ? all : byLine;
}

bool& repairs() {
  static bool on = false;
  return on;
}

bool isWorthRepair(const results::Result& result) {
  if (!report::scored(result.outcome)) return false;
  return std::ranges::count_if(result.items, [](const results::Item& item) {
           return item.kind != results::ItemKind::bonus && report::lost(item) > 0;
         }) > 1;
}

std::vector<results::ProvedCause> repairFaults(const Target& target, OwnTapes& own, Judge& judge,
                                               Graded& graded, std::string& why) {
  const std::vector<results::Item> before = graded.result.items;
  try {
    return Repairing(target, own, judge, graded).run(why);
  } catch (const UsageError&) {
    throw; // a full disk is nobody's fault of these
  } catch (const std::exception& error) {
    // A tape is a claim, and may be anything: the rubric's word stands.
    graded.result.items = before;
    why = error.what();
    return {};
  }
}

} // namespace ggrade::grading
