#include "grading/repair.hpp"

#include "diagnosis/proved.hpp"
#include "grading/carry.hpp"
#include "grading/charges.hpp"
#include "grading/grade.hpp"
#include "grading/parallel.hpp"
#include "grading/replay.hpp"
#include "report/summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>

namespace ggrade::grading {

namespace fs = std::filesystem;
using nlohmann::json;
using repair::kWidths;
using repair::Unit;
using repair::widthOf;
using results::ProvedCause;

namespace {

/// So much of what a scene can lose may be missing where it counts as right.
constexpr double kRight = 0.02;
constexpr double kRightPoints = 0.5;
/// A submission with more, or in the work of more steps, is another program, not a fault.
constexpr std::size_t kMostCauses = 24, kMostWorks = 6;
constexpr std::size_t kMostTried = 40; ///< differences of one submission

struct NotRepaired : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One scene of the submission, on a tape.
struct TapedScene {
  std::size_t index;
  channel::Capture drawn; ///< by the program
  std::vector<std::byte> tape;
  std::vector<repair::Difference> differences;
  repair::UnitsInDraws compared;
  double distance = 0;       ///< of what the program drew, see Drawn
  bool isDrawnAgain = false; ///< was the tape seen to draw just that?
};

/// What was drawn with one patch.
struct Drawn {
  /// As the judge wants it; nothing: no frame came.
  std::shared_ptr<TemporaryFolder> folder;
  bool changed = false;             ///< is anything else than without the patch?
  double distance = 0;              ///< of the last frame to the reference's
  std::optional<bool> isRight = {}; ///< once that was asked
};

/// How far the last frame is from the reference's: the sum of what all channels differ by.
double farOff(const channel::Capture& drawn, const rubric::SceneFolders& scene) {
  const std::vector<rubric::RawFrame> wanted = rubric::readFrames(scene.reference);
  const auto &a = drawn.frames.back().pixels, &b = wanted.back().pixels;
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(int(a[i]) - int(b[i]));
  return sum;
}

class Repairing {
public:
  Repairing(const Target& target, OwnTapes& own, Judge& judge, Graded& graded, unsigned threads)
      : charges_(target.items()), own_(own), judge_(judge), graded_(graded),
        items_(graded.result.items), threads_(threads) {
    for (const results::Item& item : items_)
      if (item.kind != results::ItemKind::bonus && report::lost(item) > 0)
        lossy_.push_back(item.id);
  }

  std::vector<ProvedCause> run() {
    const std::vector<std::size_t> scenes = lossyScenes();
    if (scenes.empty()) throw NotRepaired("a scene in which points were lost ended early");
    judge_.warm();
    scenes_.push_back(record(scenes[0]));
    std::vector<Unit> found = search(0, {});
    if (found.empty()) throw NotRepaired("the passes' differences don't explain it");
    if (const auto causes = causesOf(found);
        lossy_.size() == 1 && charges_.areWorkOf(causes, lossy_[0])) {
      charges_.settle(items_, items_, causes);
      return causes;
    }
    scenes_.resize(scenes.size());
    inParallel(scenes.size() - 1, threads_,
               [&](std::size_t i) { scenes_[i + 1] = record(scenes[i + 1]); });
    while (!settle(found)) {
    }
    return causesOf(found);
  }

private:
  /// Points that items lost in a scene, were it the only one.
  double lossIn(const std::vector<results::Item>& items, std::size_t scene) const {
    double loss = 0;
    for (const results::Item& item : items)
      for (const results::SceneCredit& one : item.credits)
        if (one.scene == graded_.scenes[scene].name && item.kind != results::ItemKind::bonus)
          loss += item.points * (1 - one.credit);
    return loss;
  }

  /// So much may still be lost in a scene that counts as right.
  double free(std::size_t scene) const {
    return std::max(kRight * lossIn(items_, scene), kRightPoints);
  }

  /// Scenes in which points were lost, the worst first.
  std::vector<std::size_t> lossyScenes() const {
    std::vector<std::pair<double, std::size_t>> found;
    for (std::size_t i = 0; i < graded_.scenes.size(); ++i) {
      const double loss = lossIn(items_, i);
      if (loss <= 0) continue;
      if (!graded_.scenes[i].rendering.happened.ok()) return {};
      found.emplace_back(-loss, i);
    }
    std::ranges::sort(found);
    std::vector<std::size_t> scenes;
    for (const auto& [loss, scene] : found) scenes.push_back(scene);
    return scenes;
  }

  TapedScene record(std::size_t index) {
    const GradedScene& scene = graded_.scenes[index];
    Rendering taped = graded_.program->render(scene.scene, scene.times, graded_.shaders,
                                              tapingRequest(scene.times));
    if (!taped.happened.ok()) throw NotRepaired("it ends otherwise when it is recorded");
    if (!taped.capture.tapeRefused.empty())
      throw NotRepaired("the program " + taped.capture.tapeRefused);
    const tape::Tape tape = tape::read(taped.capture.tape);
    taped.capture.tape.clear();
    repair::Comparison comparison =
        repair::compare(tape, own_.reference(index), scene.times.before.size());
    const double distance = farOff(taped.capture, scene);
    return {index,
            std::move(taped.capture),
            tape::write(comparison.tape),
            std::move(comparison.differences),
            std::move(comparison.compared),
            distance};
  }

  /// Draws a scene as each of these has it.
  std::vector<Drawn> draw(TapedScene& scene, const std::vector<std::vector<Unit>>& repaired) {
    const GradedScene& graded = graded_.scenes[scene.index];
    std::vector<json> patches;
    // As it is first: what was never cleared still holds nothing then.
    if (!scene.isDrawnAgain) patches.push_back(json::array());
    for (const std::vector<Unit>& units : repaired) patches.push_back(patchOf(scene, units));
    std::vector<channel::Capture> captures =
        playEach(scene.tape, patches, graded.scene.at("size").get<std::vector<std::uint32_t>>(),
                 graded.times, graded_.shaders, scene.drawn.trace.pixels.size());
    if (!scene.isDrawnAgain) {
      if (captures[0].frames.empty()) throw NotRepaired("it can't be drawn again");
      if (const std::string odd = differenceOf(scene.drawn, captures[0]); !odd.empty())
        throw NotRepaired("it is not drawn again as it was: " + odd);
      scene.isDrawnAgain = true;
      captures.erase(captures.begin());
    }
    std::vector<Drawn> all;
    for (std::size_t i = 0; i < captures.size(); ++i) {
      Drawn& one = all.emplace_back();
      if (captures[i].frames.empty()) continue;
      one.folder = std::make_shared<TemporaryFolder>(work_.path());
      trace::save(captures[i].trace, one.folder->path());
      rubric::writeFrames(one.folder->path(), rawFrames(captures[i]));
      one.changed = !differenceOf(scene.drawn, captures[i]).empty();
      one.distance = farOff(captures[i], graded);
    }
    return all;
  }

  /// What the rubric says of these items in the scenes that are given as drawn.
  std::vector<results::Item> judge(const std::map<std::size_t, fs::path>& drawn,
                                   const std::vector<std::string>& items) {
    std::vector<fs::path> students(graded_.scenes.size());
    for (const auto& [scene, folder] : drawn) students[scene] = folder;
    std::string problem;
    auto judged =
        judge_.judge({students, {fmt::format("--gtest_filter={}", fmt::join(items, ":"))}},
                     work_.path(), problem);
    if (!problem.empty()) throw NotRepaired(problem);
    return judged;
  }

  static json patchOf(const TapedScene& scene, const std::vector<Unit>& units) {
    json patch = json::array();
    for (const repair::Difference& one : scene.differences)
      if (std::ranges::find(units, one.unit) != units.end())
        patch.insert(patch.end(), one.patch.begin(), one.patch.end());
    return patch;
  }

  bool isRight(const TapedScene& scene, Drawn& drawn) {
    if (!drawn.folder || !drawn.changed) return false;
    if (!drawn.isRight)
      drawn.isRight = lossIn(judge({{scene.index, drawn.folder->path()}}, lossy_), scene.index) <=
                      free(scene.index);
    return *drawn.isRight;
  }

  /// The smallest set that makes a scene right with what is repaired already: one unit, narrow
  /// before wide; else of all that are no wider than need be, those that can't be left out. Empty:
  /// there is none.
  std::vector<Unit> search(std::size_t at, const std::vector<Unit>& already) {
    TapedScene& scene = scenes_[at];
    const auto with = [&](std::vector<Unit> units) {
      units.insert(units.end(), already.begin(), already.end());
      return units;
    };
    std::vector<Unit> all; // narrow ones first
    std::set<std::string> missing;
    for (const repair::Difference& one : scene.differences) {
      if (all.size() >= kMostTried || std::ranges::find(already, one.unit) != already.end())
        continue;
      all.push_back(one.unit);
      missing.merge(own_.owners().missingIn(one, scene.differences, scene.compared));
    }
    // Where the work of two steps lacks, no unit alone does.
    const bool mayBeOne = !already.empty() || missing.size() < 2;
    if (all.empty()) return {};
    std::vector<std::vector<Unit>> levels(kWidths), tried;
    const auto tryOut = [&](const std::vector<Unit>& units) { // once, however it came about
      const auto known = std::ranges::find(tried, units);
      if (known != tried.end()) return std::size_t(known - tried.begin());
      tried.push_back(units);
      return tried.size() - 1;
    };
    for (int width = 0; width < kWidths; ++width)
      for (const Unit& unit : all)
        if (widthOf(unit.name) <= width && !isWithinWider(unit, all, width))
          levels[std::size_t(width)].push_back(unit);
    std::vector<std::size_t> ofLevel, ofUnit; // in what was tried
    for (const auto& level : levels) ofLevel.push_back(tryOut(with(level)));
    for (std::size_t i = 0; mayBeOne && i < all.size(); ++i)
      ofUnit.push_back(tryOut(with({all[i]})));
    std::vector<Drawn> drawn = draw(scene, tried);
    // What isn't right with all of them isn't right with fewer.
    if (!isRight(scene, drawn[ofLevel.back()])) return {};
    std::vector<std::size_t> order(ofUnit.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](std::size_t i) {
      return std::tuple(widthOf(all[i].name), !stepsIn(all[i], scene).empty(),
                        drawn[ofUnit[i]].distance);
    });
    for (const std::size_t i : order) {
      Drawn& one = drawn[ofUnit[i]];
      // Where the window is wrong, what makes all right brings it nearer.
      if (one.distance > scene.distance || (one.distance == scene.distance && one.distance > 0))
        continue;
      if (isRight(scene, one)) return {all[i]};
    }
    for (std::size_t width = 0; width < kWidths; ++width)
      if (width + 1 == kWidths || isRight(scene, drawn[ofLevel[width]]))
        return narrowed(scene, withoutNeedless(scene, levels[width], already), already);
    return {};
  }

  /// Does a wider unit replace it anyway, of those that are no wider than `width`?
  static bool isWithinWider(const Unit& unit, const std::vector<Unit>& all, int width) {
    const auto has = [&](const std::string& wider) {
      return std::ranges::find(all, Unit{unit.role, wider}) != all.end();
    };
    return has(repair::functionOf(unit.name)) ||
           (width == kWidths - 1 && has(repair::shaderOf(unit.name)));
  }

  /// What a function is made of that can be put right alone: the lines of each step in it.
  static std::vector<Unit> stepsIn(const Unit& function, const TapedScene& scene) {
    std::vector<Unit> steps;
    for (const repair::Difference& one : scene.differences)
      if (one.unit.role == function.role && repair::functionOf(one.unit.name) == function.name)
        steps.push_back(one.unit);
    return steps;
  }

  /// The same with one step's lines in the place of their function, where that is enough.
  std::vector<Unit> narrowed(TapedScene& scene, std::vector<Unit> set,
                             const std::vector<Unit>& already) {
    for (Unit& unit : set) {
      const Unit function = unit;
      const std::vector<Unit> steps = stepsIn(function, scene);
      std::vector<std::vector<Unit>> tried;
      for (const Unit& step : steps) {
        unit = step;
        tried.push_back(already);
        tried.back().insert(tried.back().end(), set.begin(), set.end());
      }
      unit = function;
      if (steps.empty()) continue;
      std::vector<Drawn> drawn = draw(scene, tried);
      for (std::size_t i = 0; i < steps.size() && unit == function; ++i)
        if (isRight(scene, drawn[i])) unit = steps[i];
    }
    return set;
  }

  /// Leaves out what a right set doesn't need.
  std::vector<Unit> withoutNeedless(TapedScene& scene, std::vector<Unit> set,
                                    const std::vector<Unit>& already) {
    const auto without = [&](const std::vector<Unit>& some) {
      std::vector<Unit> rest = already;
      for (const Unit& unit : set)
        if (std::ranges::find(some, unit) == some.end()) rest.push_back(unit);
      return rest;
    };
    std::vector<std::vector<Unit>> tried;
    for (const Unit& unit : set) tried.push_back(without({unit}));
    std::vector<Drawn> drawn = draw(scene, tried);
    std::vector<Unit> needless;
    for (std::size_t i = 0; i < set.size(); ++i)
      if (isRight(scene, drawn[i])) needless.push_back(set[i]);
    if (needless.size() > 1) {
      // Each alone is needless; together they may not be.
      std::vector<std::vector<Unit>> first; // without the first 1, 2, ... of them
      for (std::size_t i = 1; i <= needless.size(); ++i)
        first.push_back(without({needless.begin(), needless.begin() + std::ptrdiff_t(i)}));
      std::vector<Drawn> fewer = draw(scene, first);
      const auto enough =
          std::ranges::partition_point(fewer, [&](Drawn& one) { return isRight(scene, one); });
      needless.resize(std::size_t(enough - fewer.begin()));
    }
    std::erase_if(
        set, [&](const Unit& unit) { return std::ranges::find(needless, unit) != needless.end(); });
    return set;
  }

  /// What other scenes need besides, where that makes them right.
  std::vector<Unit> searchOthers(const std::vector<results::Item>& repaired,
                                 const std::vector<Unit>& found) {
    std::vector<Unit> more;
    for (std::size_t i = 1; i < scenes_.size() && more.empty(); ++i)
      if (lossIn(repaired, scenes_[i].index) > free(scenes_[i].index)) more = search(i, found);
    return more;
  }

  std::vector<ProvedCause> causesOf(const std::vector<Unit>& found) {
    std::vector<ProvedCause> causes;
    missing_.clear();
    for (const Unit& unit : found) {
      const auto& [scene, one] = differenceIn(unit);
      causes.push_back({one.passes, unit.role, unit.name, ownersOf(one, found), one.isUnseen});
      // A hidden scene's numbers come through uniforms; the first scene is the public one.
      if (!unit.name.starts_with("uniform ") || scene.index == 0) causes.back().own = one.own;
      missing_.merge(own_.owners().missingIn(one, scene.differences, scene.compared));
    }
    std::set<std::set<std::string>> works;
    for (const ProvedCause& cause : causes) works.insert(cause.todos);
    if (causes.size() > kMostCauses || works.size() > kMostWorks)
      throw NotRepaired(fmt::format("it takes {} changes to make it right", causes.size()));
    blameDeciders(causes);
    // What is right and passed to the wrong place is the work of who draws.
    for (ProvedCause& cause : causes)
      if (differenceIn({cause.role, cause.unit}).second.isAnothers)
        if (const auto drawers = own_.owners().drawersOf(cause.role); !drawers.empty())
          cause.todos = drawers;
    // A state that is left reaches passes of several steps: one fault, of what was right before.
    for (const ProvedCause& left : causes)
      if (left.todos.empty() && repair::isState(left.unit))
        for (ProvedCause& cause : causes)
          if (cause.unit == left.unit) cause.todos.clear();
    for (ProvedCause& cause : causes) {
      std::ranges::set_intersection(cause.todos, missing_,
                                    std::inserter(cause.notBegun, cause.notBegun.end()));
      std::ranges::copy_if(cause.todos, std::inserter(cause.untouched, cause.untouched.end()),
                           [&](const std::string& todo) { return isUntouched(todo); });
    }
    return causes;
  }

  /// Of a function in which a step's lines are another cause: that of the rest.
  std::set<std::string> ownersOf(repair::Difference one, const std::vector<Unit>& found) const {
    std::set<std::string> others;
    for (const Unit& unit : found)
      if (unit.role == one.unit.role && repair::functionOf(unit.name) == one.unit.name) {
        const repair::Difference& lines = differenceIn(unit).second;
        for (const std::string& line : lines.lacks) one.lacks.erase(line);
        others.merge(own_.owners().ownersOf(lines));
      }
    const std::set<std::string> all = own_.owners().ownersOf(one);
    std::set<std::string> rest;
    std::ranges::set_difference(all, others, std::inserter(rest, rest.end()));
    return rest.empty() ? all : rest;
  }

  /// What is another without a TODO may be so only because that TODO's own work lacks, too: a
  /// texture that isn't made can't be bound. Where no other cause proves that, it is the TODO's
  /// whose statement decides it.
  void blameDeciders(std::vector<ProvedCause>& causes) {
    std::vector<std::set<std::string>> deciders;
    for (ProvedCause& cause : causes) {
      const Unit unit{cause.role, cause.unit};
      deciders.push_back(own_.owners().decidersOf(unit, isOnlyElsewhere(unit)));
      if (cause.todos.empty()) cause.changedBy = deciders.back();
      if (cause.todos.empty() || cause.isUnseen || deciders.back().empty())
        deciders.back() = cause.todos;
    }
    for (std::size_t i = 0; i < causes.size(); ++i) {
      if (causes[i].unit.starts_with("shader ")) continue; // all whose lines it brings
      std::set<std::string> lacking; // of those that it may be, by other causes
      for (std::size_t k = 0; k < causes.size(); ++k)
        if (k != i)
          std::ranges::set_intersection(causes[i].todos, deciders[k],
                                        std::inserter(lacking, lacking.end()));
      causes[i].todos = lacking.empty() ? deciders[i] : lacking;
    }
    // Of several steps whose work it may be, one that another cause proves: one fault.
    std::set<std::string> proved;
    for (const ProvedCause& cause : causes)
      if (cause.todos.size() == 1) proved.insert(*cause.todos.begin());
    for (ProvedCause& cause : causes) {
      if (repair::isShader(cause.unit) || cause.isUnseen) continue; // lines and draws tell
      std::set<std::string> both;
      std::ranges::set_intersection(cause.todos, proved, std::inserter(both, both.end()));
      if (!both.empty()) cause.todos = both;
    }
  }

  /// Is it another in no scene but those of other steps?
  bool isOnlyElsewhere(const Unit& unit) const {
    return std::ranges::all_of(scenes_, [&](const TapedScene& scene) {
      return isOfOtherSteps(graded_.scenes[scene.index]) ||
             std::ranges::find(scene.differences, unit, &repair::Difference::unit) ==
                 scene.differences.end();
    });
  }

  /// In the worst of the scenes that have it.
  std::pair<const TapedScene&, const repair::Difference&> differenceIn(const Unit& unit) const {
    for (const TapedScene& scene : scenes_)
      for (const repair::Difference& one : scene.differences)
        if (one.unit == unit) return {scene, one};
    throw std::logic_error("a cause that no scene has: " + unit.name);
  }

  /// What is put right, and the items that are judged by that.
  struct Variant {
    std::vector<Unit> repaired;
    std::vector<std::string> items;
  };

  /// For each item that lost points all causes but those that are its own work; first all of them,
  /// which tells if they are enough.
  std::vector<Variant> variantsOf(const std::vector<Unit>& found,
                                  const std::vector<ProvedCause>& causes) const {
    std::vector<Variant> variants = {{found, {}}};
    for (const results::Item& item : items_) {
      // Of work that isn't there, what the reference's in its place shows says nothing.
      if (report::lost(item) <= 0 ||
          (item.kind != results::ItemKind::keep && missing_.contains(charges_.stepOf(item.id))))
        continue;
      std::vector<Unit> repaired;
      for (std::size_t i = 0; i < causes.size(); ++i)
        if (!charges_.isWorkOf(causes[i], item.id, causes)) repaired.push_back(found[i]);
      if (repaired.empty()) continue;
      auto variant = std::ranges::find(variants, repaired, &Variant::repaired);
      if (variant == variants.end()) variant = variants.insert(variant, {std::move(repaired), {}});
      variant->items.push_back(item.id);
    }
    return variants;
  }

  /// Each item keeps the better of what it had and what it has when all causes are repaired but
  /// those that are its own work. False: a scene needs more than `found`, which now has that, too.
  bool settle(std::vector<Unit>& found) {
    const std::vector<ProvedCause> causes = causesOf(found);
    const std::vector<Variant> variants = variantsOf(found, causes);
    std::vector<std::vector<Unit>> repaired;
    for (const Variant& variant : variants) repaired.push_back(variant.repaired);
    std::vector<std::vector<Drawn>> drawn(scenes_.size());
    inParallel(scenes_.size(), threads_,
               [&](std::size_t i) { drawn[i] = draw(scenes_[i], repaired); });
    const auto judged = [&](std::size_t variant, const std::vector<std::string>& items) {
      std::map<std::size_t, fs::path> folders;
      for (std::size_t i = 0; i < scenes_.size(); ++i)
        if (const auto& folder = drawn[i][variant].folder)
          folders[scenes_[i].index] = folder->path();
      return judge(folders, items);
    };
    std::vector<std::string> lost = lossy_;
    for (const std::string& id : variants[0].items)
      if (std::ranges::find(lost, id) == lost.end()) lost.push_back(id); // a bonus
    const std::vector<results::Item> allRepaired = judged(0, lost);
    if (const std::vector<Unit> more = searchOthers(allRepaired, found); !more.empty()) {
      found.insert(found.end(), more.begin(), more.end());
      return false;
    }
    const std::vector<results::Item> before = items_;
    for (std::size_t k = 0; k < variants.size(); ++k) {
      const auto& items = variants[k].items;
      for (const results::Item& again : k == 0 ? allRepaired : judged(k, items))
        if (std::ranges::find(items, again.id) != items.end()) keepBetter(again, causes);
    }
    takeFromUntouched();
    charges_.settle(items_, before, causes);
    return true;
  }

  /// Does nothing that is drawn show this step's work?
  bool isUntouched(const std::string& todo) const {
    return std::ranges::all_of(scenes_, [&](const TapedScene& scene) {
      return own_.owners().isUntouched(todo, scene.differences, scene.compared);
    });
  }

  /// What is seen of a step of which nothing is written is another one's work, or a fault's.
  void takeFromUntouched() {
    for (results::Item& item : items_)
      if (item.kind == results::ItemKind::gain && report::lost(item) > 0 && item.earned > 0 &&
          missing_.contains(charges_.stepOf(item.id)) && isUntouched(charges_.stepOf(item.id))) {
        item.earned = 0;
        for (results::SceneCredit& one : item.credits) one.credit = 0;
      }
  }

  void keepBetter(const results::Item& again, const std::vector<ProvedCause>& causes) {
    const auto item = std::ranges::find(items_, again.id, &results::Item::id);
    if (item == items_.end() || !again.judged) return;
    if (!takeBetter(*item, again)) return; // scenes that weren't drawn again have no credit
    if (report::lost(*item) <= 0) item->cause = item->step = "";
    item->repaired.clear();
    for (const ProvedCause& cause : causes)
      if (const std::string name = diagnosis::nameOf(cause);
          !charges_.isWorkOf(cause, item->id, causes) &&
          std::ranges::find(item->repaired, name) == item->repaired.end())
        item->repaired.push_back(name);
  }

  const Charges charges_;
  OwnTapes& own_;
  Judge& judge_;
  Graded& graded_;
  std::vector<results::Item>& items_;
  const unsigned threads_;
  std::vector<std::string> lossy_; ///< items that lost points, but the bonus
  std::vector<TapedScene> scenes_; ///< the worst one first
  std::set<std::string> missing_;  ///< TODOs of whose work there is nothing to judge
  TemporaryFolder work_;
};

} // namespace

bool areUnfinished(const std::vector<ProvedCause>& causes) {
  return std::ranges::any_of(causes, &ProvedCause::isUnseen);
}

bool isWorthRepair(const results::Result& result) {
  return report::scored(result.outcome) &&
         std::ranges::any_of(result.items, [](const results::Item& item) {
           return item.kind != results::ItemKind::bonus && report::lost(item) > 0;
         });
}

std::vector<results::ProvedCause> repairFaults(const Target& target, OwnTapes& own, Judge& judge,
                                               Graded& graded, unsigned threads, std::string& why) {
  const std::vector<results::Item> before = graded.result.items;
  try {
    return Repairing(target, own, judge, graded, threads).run();
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
