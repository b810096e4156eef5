#include "generated/measure.hpp"

#include "calibration/classifier.hpp"
#include "calibration/subject.hpp"
#include "calibration/whole_image.hpp"
#include "generated/mutants.hpp"
#include "generated/rewrites.hpp"
#include "grading/catalogue.hpp"
#include "image/compare.hpp"
#include "report/write_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <mutex>

namespace ggrade::generated {

namespace fs = std::filesystem;
using calibration::SeedPictures;
using grading::Graded;
using grading::ScenePlan;
using nlohmann::json;

namespace {

/// Seeds of the scenes that survivors are looked at in begin here, far from those of classes.
constexpr std::uint64_t kOtherSeeds = 1000000;
/// Share of a window whose pixels are wrong, from which on a scene shows a fault.
constexpr double kShown = 0.002;
/// Most changes that keep what a program means.
constexpr std::size_t kMostRewrites = 12;

/// A program on its way.
struct Generated {
  Case found;
  std::shared_ptr<grading::Program> program;
};

class Measurement {
public:
  Measurement(const Target& target, const fs::path& solutionFolder, const fs::path& folder,
              const MeasureOptions& options)
      : target_(target), part_(target.parts.at(0)), solutionFolder_(solutionFolder),
        folder_(folder), options_(options) {
    figures_.part = part_.id;
    figures_.seed = options.seed;
    figures_.scenes = options.scenes;
  }

  Figures run() {
    makeRight();
    makeWrong();
    gradeAll();
    lookAtUnseen();
    for (Generated& one : all_) {
      one.found.bonusLost = bonusOf(one.found);
      settle(one.found, target_.maxScore(), grading::stepHeading(part_, one.found.todo));
      figures_.cases.push_back(one.found);
    }
    measureAreas();
    return std::move(figures_);
  }

private:
  /// The program of what stands in `files`, which are those of a finished one.
  void add(Case found, const fs::path& files) {
    all_.push_back({std::move(found), std::make_shared<grading::Program>(target_.assignment,
                                                                         grading::Recipe{files})});
  }

  fs::path folderOf(const std::string& name) const {
    return folder_ / "programs" / part_.id / name;
  }

  void makeRight() {
    const auto catalogue =
        grading::loadCatalogue(target_.assignment, part_, solutionFolder_, solutionFolder_);
    std::vector<const grading::Variant*> bases = {nullptr}; // the reference
    for (const grading::Variant& variant : catalogue.variants)
      if (variant.loses.empty()) bases.push_back(&variant);
    Chance chance(options_.seed, "right " + part_.id);
    for (std::size_t i = 0; i < options_.count; ++i) {
      Case found;
      found.isRight = true;
      found.name = fmt::format("right-{:03}", i);
      found.allowed = kFree;
      const grading::Variant* base = chance.of(bases);
      found.program = base ? base->name : "reference";
      const fs::path files = folderOf(found.name);
      grading::Recipe recipe{solutionFolder_};
      if (base) recipe.patches = {base->patch};
      grading::writeFiles(target_.assignment, recipe, files);
      std::vector<std::string> names; // of those that students of this part write in
      for (const std::string& file : target_.assignment.files)
        if (fs::is_regular_file(files / file) &&
            readFile(files / file).find(fmt::format("BEGIN SOLUTION({}.", part_.id)) !=
                std::string::npos)
          names.push_back(file);
      std::map<std::string, std::size_t> times;
      for (std::size_t n = 2 + chance.below(kMostRewrites - 1); n > 0; --n)
        ++times[chance.of(names)];
      std::vector<std::string> changes;
      for (const auto& [file, count] : times) {
        const Rewritten done = rewrite(readFile(files / file), file, count, chance);
        report::writeFile(files / file, done.text);
        changes.insert(changes.end(), done.changes.begin(), done.changes.end());
      }
      found.change = fmt::format("{}", fmt::join(changes, "\n"));
      add(std::move(found), files);
    }
  }

  void makeWrong() {
    const std::vector<Mutant> mutants =
        drawMutants(target_.assignment, part_, solutionFolder_, options_.count, options_.seed);
    for (std::size_t i = 0; i < mutants.size(); ++i) {
      const Mutant& mutant = mutants[i];
      Case found;
      found.name = fmt::format("wrong-{:03}", i);
      found.program = "reference";
      found.todo = mutant.todo;
      found.change = mutant.change + ": " + describe(mutant);
      found.allowed = kBeyondStep;
      for (const ItemDeclaration& item : target_.items())
        if (item.step == mutant.todo && item.kind != results::ItemKind::keep)
          found.allowed += item.points;
      const fs::path files = folderOf(found.name);
      grading::writeFiles(target_.assignment, {solutionFolder_}, files);
      report::writeFile(files / mutant.file, withChange(readFile(files / mutant.file), mutant));
      add(std::move(found), files);
    }
  }

  void gradeAll() {
    const ScenePlan plan =
        grading::drawScenes(target_, solutionFolder_, {options_.seed, options_.quality});
    const std::string common = "generated " + grading::gradingKey(target_, solutionFolder_, plan) +
                               grading::wordsKey(target_.assignment, solutionFolder_);
    std::vector<Generated*> missing;
    for (Generated& one : all_)
      if (!load(common, one)) missing.push_back(&one);
    done_ = all_.size() - missing.size();
    tell("grading", all_.size());
    if (missing.empty()) return;
    const SeedPictures pictures(target_, solutionFolder_, plan);
    grading::Grader grader(target_, solutionFolder_, plan, calibration::graderOptions(),
                           pictures.references);
    grader.prepare();
    grading::inParallel(missing.size(), options_.jobs, [&](std::size_t i) {
      if (grading::interrupted) throw grading::Interrupted{};
      grade(*missing[i], grader);
      keep(common, *missing[i]);
      const std::lock_guard lock(mutex_);
      ++done_;
      tell("grading", all_.size());
    });
  }

  void grade(Generated& one, grading::Grader& grader) {
    Case& found = one.found;
    Graded graded = grader.draw(grader.build(one.program, true));
    grader.judge(graded);
    grader.diagnose(graded);
    found.score = calibration::scoreOf(graded.result);
    if (graded.scenes.empty()) return;
    found.score.measures =
        calibration::measurePictures({graded.scenes.begin(), graded.scenes.end()});
    found.shownIn = shownIn(graded);
    if (graded.result.diagnoses.empty()) return;
    const results::Diagnosis& first = graded.result.diagnoses[0];
    found.answer = first.id;
    found.step = first.step;
  }

  /// The first scene with a window that isn't as the reference's.
  static std::string shownIn(const Graded& graded) {
    const auto windowsIn = [](const fs::path& folder) {
      return rubric::toImages(rubric::readFrames(folder));
    };
    for (const grading::GradedScene& scene : graded.scenes)
      if (isAnother(windowsIn(scene.student), windowsIn(scene.reference))) return scene.name;
    return {};
  }

  /// Wrong programs that no scene of the grading shows are looked at in others, until one does.
  void lookAtUnseen() {
    std::vector<Generated*> unseen;
    for (Generated& one : all_)
      if (!one.found.isRight && one.found.shownIn.empty() && isDrawn(one.found))
        unseen.push_back(&one);
    grading::Program reference(target_.assignment, {solutionFolder_});
    std::size_t scenes = 0;
    for (std::uint64_t seed = kOtherSeeds + options_.seed;
         scenes < options_.scenes && !unseen.empty(); ++seed) {
      ScenePlan plan = grading::drawScenes(target_, solutionFolder_, {seed, options_.quality});
      std::erase_if(plan.scenes, [](const grading::SceneCase& one) { return one.isPublic; });
      const std::string common =
          "unseen " + grading::describe(plan) + reference.key() + grading::toolKey();
      std::vector<std::vector<Image>> wanted(plan.scenes.size());
      std::once_flag drawn;
      done_ = scenes;
      tell(fmt::format("{} that no scene shows", unseen.size()), options_.scenes);
      grading::inParallel(unseen.size(), options_.jobs, [&](std::size_t i) {
        const fs::path file = calibration::scoreFile(common + unseen[i]->program->key());
        if (const auto kept = calibration::loadKept(file)) {
          unseen[i]->found.shownIn = kept->value("shown_in", "");
          return;
        }
        std::call_once(drawn, [&] {
          for (std::size_t k = 0; k < wanted.size(); ++k)
            wanted[k] = windowsOf(reference, plan.scenes[k]);
        });
        unseen[i]->found.shownIn = shownIn(*unseen[i]->program, plan, wanted);
        calibration::saveKept(file, {{"shown_in", unseen[i]->found.shownIn}});
      });
      scenes += plan.scenes.size();
      std::erase_if(unseen, [](const Generated* one) { return !one->found.shownIn.empty(); });
    }
  }

  static std::vector<Image> windowsOf(grading::Program& program, const grading::SceneCase& scene) {
    if (grading::interrupted) throw grading::Interrupted{};
    return rubric::toImages(
        grading::rawFrames(program.render(scene.scene, scene.times, {}).capture));
  }

  /// The first of these scenes with a window that isn't as it should be.
  static std::string shownIn(grading::Program& program, const ScenePlan& plan,
                             const std::vector<std::vector<Image>>& wanted) {
    for (std::size_t k = 0; k < wanted.size(); ++k)
      if (isAnother(windowsOf(program, plan.scenes[k]), wanted[k]))
        return fmt::format("{} of seed {}", plan.scenes[k].name, plan.seed);
    return {};
  }

  static bool isAnother(const std::vector<Image>& windows, const std::vector<Image>& wanted) {
    if (windows.size() < wanted.size()) return true;
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (compare(windows[i], wanted[i]).wrongShare > kShown) return true;
    return false;
  }

  /// What the bonus items of a wrong program's step lost: such a fault may cost nothing else.
  double bonusOf(const Case& found) const {
    double lost = 0;
    for (const ItemDeclaration& item : target_.items()) {
      const auto earned = found.score.earned.find(item.id);
      if (item.kind == results::ItemKind::bonus && item.step == found.todo &&
          earned != found.score.earned.end())
        lost += item.points - earned->second;
    }
    return lost;
  }

  void measureAreas() {
    std::map<std::string, std::vector<calibration::Rated>> rated;
    for (const Case& one : figures_.cases) {
      if (one.fate == Fate::notDrawn || one.fate == Fate::equivalent) continue;
      rated["points lost"].push_back({one.isRight, 0, one.lost});
      for (const auto& [name, error] : one.score.measures)
        rated[name].push_back({one.isRight, 0, error.worst});
    }
    for (const auto& [name, all] : rated)
      if (const auto area = calibration::areaUnderRoc(all))
        figures_.areas.emplace_back(name, *area);
  }

  static bool load(const std::string& common, Generated& one) {
    const auto kept = calibration::loadKept(calibration::scoreFile(common + one.program->key()));
    if (!kept) return false;
    try {
      one.found.score = calibration::scoreFrom(kept->at("score"));
      one.found.shownIn = kept->at("shown_in");
      one.found.answer = kept->at("answer");
      one.found.step = kept->at("step");
    } catch (const json::exception&) {
      return false;
    }
    return true;
  }

  static void keep(const std::string& common, const Generated& one) {
    const Case& found = one.found;
    calibration::saveKept(calibration::scoreFile(common + one.program->key()),
                          {{"score", calibration::toJson(found.score)},
                           {"shown_in", found.shownIn},
                           {"answer", found.answer},
                           {"step", found.step}});
  }

  void tell(const std::string& what, std::size_t total) const {
    if (options_.progress) options_.progress(what, std::min(done_, total), total);
  }

  const Target& target_;
  const Part& part_;
  const fs::path &solutionFolder_, &folder_;
  const MeasureOptions& options_;
  std::vector<Generated> all_;
  std::mutex mutex_;
  std::size_t done_ = 0;
  Figures figures_;
};

} // namespace

Figures measure(const Target& target, const fs::path& solutionFolder, const fs::path& folder,
                const MeasureOptions& options) {
  return Measurement(target, solutionFolder, folder, options).run();
}

} // namespace ggrade::generated
