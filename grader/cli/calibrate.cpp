#include "cli/commands.hpp"
#include "cli/drift.hpp"

#include "calibration/adopt.hpp"
#include "calibration/diagnosis.hpp"
#include "calibration/measure.hpp"
#include "calibration/page.hpp"
#include "calibration/replay.hpp"
#include "calibration/tolerances.hpp"
#include "calibration/trade.hpp"
#include "calibration/verdicts.hpp"
#include "cli/terminal.hpp"
#include "generated/measure.hpp"
#include "grading/grade.hpp"
#include "report/write_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iostream>

namespace ggrade::cli {

namespace fs = std::filesystem;

namespace {

struct CalibrateOptions {
  std::string id, out, catalogue, adopt, as, name, quality = "balanced";
  std::vector<std::string> only;
  unsigned seeds = 10, jobs = grading::workers();
  std::size_t generated = 0;
  std::uint64_t firstSeed = 1, seed = 1;
  bool haveFirstSeed = false, skipTrials = false, skipDiagnosis = false, json = false;
  bool diagnosisOnly = false, trade = false, drift = false, replay = false;
};

/// The parts that an ID names, each a target of its own.
std::vector<Target> partsOf(const std::string& id) {
  std::vector<Target> all;
  for (const Assignment& assignment : loadAssignments(assignmentsFolder()))
    for (const Part& part : assignment.parts)
      if (id == "all" || id == assignment.id || id == part.id)
        all.push_back({assignment, {part}, part.id});
  if (all.empty()) findTarget(assignmentsFolder(), id); // says what there is
  return all;
}

/// The assignment's own seed and 1, 2, ...; or those from the one that was named.
std::vector<std::uint64_t> seedsOf(const CalibrateOptions& options, const Target& target,
                                   const fs::path& solutions) {
  std::vector<std::uint64_t> seeds;
  if (!options.haveFirstSeed) seeds.push_back(grading::drawScenes(target, solutions).seed);
  for (std::uint64_t seed = options.firstSeed; seeds.size() < options.seeds; ++seed)
    if (seeds.empty() || seed != seeds[0]) seeds.push_back(seed);
  return seeds;
}

/// Where mistakes/ and variants/ are.
fs::path catalogueFolder(const CalibrateOptions& options, const fs::path& solutions) {
  if (options.catalogue.empty()) return solutions;
  if (!fs::is_directory(options.catalogue))
    throw UsageError(fmt::format("--catalogue {}: there is no such folder", options.catalogue));
  return options.catalogue;
}

fs::path resultsFolder(const CalibrateOptions& options) {
  return outputFolder(options.out.empty() ? (fs::path("out/calibrate") / options.id).string()
                                          : options.out);
}

void adopt(const CalibrateOptions& options) {
  if (options.as.empty()) throw UsageError("--adopt needs --as variant or --as mistake");
  const std::vector<Target> targets = partsOf(options.id);
  if (targets.size() != 1)
    throw UsageError(
        fmt::format("{} has several parts: say which one the submission answers", options.id));
  const Target& target = targets[0];
  const fs::path solutions = solutionFolder(target.assignment.id);
  const bool mistake = options.as == "mistake";
  std::vector<results::Item> items;
  if (mistake) {
    requireSandbox();
    Progress progress("calibrate");
    grading::GraderOptions how;
    how.pictures = how.twice = how.diagnosis = false;
    how.progress = std::ref(progress);
    grading::Grader grader(target, solutions, grading::drawScenes(target, solutions), how);
    const auto submission =
        std::make_shared<grading::Program>(target.assignment, grading::Recipe{options.adopt},
                                           grading::isolation(), grading::Program::Use::once);
    items = grader.grade(submission, false).items;
  }
  const fs::path path = calibration::adopt(
      target, solutions, catalogueFolder(options, solutions), options.adopt,
      mistake ? calibration::AdoptAs::mistake : calibration::AdoptAs::variant, options.name, items);
  fmt::print("{}\n\nOpen it and\n"
             "- look through the code's comments: they are as they were handed in, and may name a "
             "person;\n"
             "- write a Title that says what is {}{};\n",
             path.string(), mistake ? "wrong" : "done in another way",
             mistake ? ",\n  what one sees (Symptom) and what to tell the student (Hint);\n"
                       "- check the item that must fail (Fails), the step to read again (Step)\n"
                       "  and the scenes that show it (Shows): they are a guess from its grading"
                     : "");
  fmt::print("then run: ggrade calibrate {} --only {}\n", target.id, path.stem().string());
}

/// One seed: every program is judged with each of 18 settings. The last one, on which nobody has
/// tuned a rubric.
calibration::CrossValidation crossValidate(const CalibrateOptions& options, const Target& target,
                                           const fs::path& solutions,
                                           std::vector<calibration::KnownAnswer> programs,
                                           std::vector<std::uint64_t> seeds) {
  std::erase_if(programs, [](const calibration::KnownAnswer& program) {
    return program.kind != calibration::Kind::variant && program.kind != calibration::Kind::mistake;
  });
  seeds = {seeds.back()};
  Progress progress("calibrating " + target.id);
  const auto trials = calibration::tryTolerances(target, solutions, programs, seeds,
                                                 grading::parseQuality(options.quality),
                                                 options.jobs, std::ref(progress));
  return calibration::crossValidate(target.id, target.items(), trials);
}

/// Two seeds that the diagnosis was not tuned on.
calibration::DiagnosisFigures diagnoseAll(const CalibrateOptions& options, const Target& target,
                                          const fs::path& solutions,
                                          const grading::Catalogue& catalogue) {
  Progress progress("calibrating " + target.id);
  calibration::DiagnosisOptions how;
  how.seeds = {109, 110};
  if (options.haveFirstSeed) {
    how.seeds.clear();
    for (unsigned i = 0; i < options.seeds; ++i) how.seeds.push_back(options.firstSeed + i);
  }
  for (const std::string& name : options.only)
    for (const std::string& full : {name, target.id + '_' + name})
      if (catalogue.mistake(full)) how.only.push_back(full);
  how.quality = grading::parseQuality(options.quality);
  how.jobs = options.jobs;
  how.progress = std::ref(progress);
  return calibration::measureDiagnosis(target, solutions, how);
}

/// What of the diagnosis doesn't hold, a line each.
std::string failuresOf(const calibration::DiagnosisFigures& figures, const std::string& part) {
  std::string failures;
  const auto add = [&](double share, const char* what) {
    failures += fmt::format("{}: {:.1f}% of {}\n", part, 100 * share, what);
  };
  if (const auto right = figures.rightShare(false); right && *right < calibration::kRightAnswers)
    add(*right, "the mistakes are named right: too few");
  if (const auto right = figures.rightShare(true); right && *right < calibration::kRightElsewhere)
    add(*right,
        "the mistakes in programs that are written in another way are named right: too few");
  if (figures.wrongShare() > calibration::kWrongAnswers)
    add(figures.wrongShare(), "unknown mistakes are given a wrong name: too many");
  return failures;
}

/// The page's part where only this was measured.
calibration::PagePart pageOf(const Target& target, std::vector<calibration::Section> sections,
                             const std::string& alone) {
  calibration::PagePart page{target.parts[0].title, {}, {}, std::move(sections), alone};
  page.verdicts.part = target.id;
  return page;
}

/// Puts the page and the figures of all parts where results go, and prints them or `text`.
/// \param work what else goes there lies in it already
/// \param file of the figures
void publish(const CalibrateOptions& options, grading::TemporaryFolder& work, const fs::path& out,
             const nlohmann::json& parts, const std::string& file,
             const std::vector<calibration::PagePart>& pages, const std::string& text) {
  const nlohmann::json all = {{"parts", parts}};
  report::writeFile(work.path() / file, all.dump(1) + '\n');
  report::writeFile(work.path() / "index.html", calibration::calibrationPage(pages, file));
  work.publish(out);
  if (options.json)
    std::cout << all.dump(2) << '\n';
  else
    std::cout << text << (out / "index.html").string() << '\n';
}

/// Ends with an error if something doesn't hold.
void endWith(const std::string& what, const std::string& failures) {
  if (failures.empty()) return;
  std::cout.flush();
  fmt::print(stderr, "ggrade: {}:\n{}", what, failures);
  exitCode = kNotGradable;
}

void calibrate(const CalibrateOptions& options) {
  const std::vector<Target> targets = partsOf(options.id);
  const fs::path out = resultsFolder(options);
  requireSandbox();
  nlohmann::json parts = nlohmann::json::array();
  std::vector<calibration::PagePart> pages;
  std::string tables, failures;
  for (const Target& target : targets) {
    const fs::path solutions = solutionFolder(target.assignment.id);
    const auto catalogue = grading::loadCatalogue(target.assignment, target.parts[0], solutions,
                                                  catalogueFolder(options, solutions));
    if (options.diagnosisOnly) {
      const auto figures = diagnoseAll(options, target, solutions, catalogue);
      parts.push_back({{"part", target.id}, {"diagnosis", calibration::toJson(figures)}});
      pages.push_back(pageOf(target, {calibration::sectionOf(figures)}, "the diagnosis"));
      tables += pages.back().sections[0].text + "\n\n";
      failures += failuresOf(figures, target.id);
      continue;
    }
    Progress progress("calibrating " + target.id);
    calibration::MeasureOptions how;
    how.seeds = seedsOf(options, target, solutions);
    how.looks[0].quality = grading::parseQuality(options.quality);
    how.jobs = options.jobs;
    how.progress = std::ref(progress);
    const auto programs =
        calibration::programsOf(target.assignment, catalogue, solutions, options.only);
    const auto measured = calibration::measure(target, solutions, programs, how)[0];
    progress.clear();
    const auto verdicts = calibration::judge(target.id, target.items(), measured);
    tables += calibration::tableOf(verdicts) + '\n';
    for (const std::string& failure : verdicts.failures()) failures += failure + '\n';
    parts.push_back(calibration::toJson(verdicts, measured));
    pages.push_back({target.parts[0].title, verdicts, measured, {}});
    if (!options.skipDiagnosis && options.only.empty()) {
      const auto figures = diagnoseAll(options, target, solutions, catalogue);
      parts.back()["diagnosis"] = calibration::toJson(figures);
      pages.back().sections.push_back(calibration::sectionOf(figures));
      tables += pages.back().sections.back().text + "\n\n";
      failures += failuresOf(figures, target.id);
    }
    if (options.skipTrials || !options.only.empty()) continue;
    const auto crossed = crossValidate(options, target, solutions, programs, how.seeds);
    parts.back()["cross_validation"] = calibration::toJson(crossed);
    pages.back().sections.push_back(calibration::sectionOf(crossed));
    tables += pages.back().sections.back().text + "\n\n";
  }
  grading::TemporaryFolder work(fs::absolute(out).lexically_normal().parent_path());
  publish(options, work, out, parts, "calibration.json", pages, tables);
  endWith("right and wrong answers don't separate", failures);
}

/// Those of the catalogue that were asked for.
std::vector<calibration::KnownAnswer> programsOf(const CalibrateOptions& options,
                                                 const Target& target, const fs::path& solutions) {
  return calibration::programsOf(target.assignment,
                                 grading::loadCatalogue(target.assignment, target.parts[0],
                                                        solutions,
                                                        catalogueFolder(options, solutions)),
                                 solutions, options.only);
}

/// Errors and seconds of looking less closely, and of whole-image measures.
void trade(const CalibrateOptions& options) {
  const std::vector<Target> targets = partsOf(options.id);
  const fs::path out = resultsFolder(options);
  requireSandbox();
  std::vector<calibration::Trade> all;
  std::vector<calibration::PagePart> pages;
  std::string texts;
  nlohmann::json parts = nlohmann::json::array();
  for (const Target& target : targets) {
    const fs::path solutions = solutionFolder(target.assignment.id);
    const auto programs = programsOf(options, target, solutions);
    Progress progress("calibrating " + target.id);
    all.push_back(calibration::measureTrade(
        target, solutions, programs,
        {seedsOf(options, target, solutions), options.jobs, std::ref(progress)}));
    parts.push_back(calibration::toJson(all.back()));
    pages.push_back(pageOf(target, calibration::sectionsOf(all.back()),
                           "the grader's trade of time against errors"));
    texts += calibration::textOf(all.back()) + '\n';
  }
  grading::TemporaryFolder work(fs::absolute(out).lexically_normal().parent_path());
  report::writeFile(work.path() / "trade.csv", calibration::csvOf(all));
  publish(options, work, out, parts, "trade.json", pages, texts);
}

/// A section for the terminal.
std::string textOf(const Target& target, const calibration::Section& section) {
  std::string text = fmt::format("{}: {}\n\n", target.id, section.text);
  for (const auto& row : section.rows) text += fmt::format("  {}\n", fmt::join(row, " | "));
  return text;
}

/// Every program of the catalogue, drawn again from its tape.
void replay(const CalibrateOptions& options) {
  const std::vector<Target> targets = partsOf(options.id);
  const fs::path out = resultsFolder(options);
  requireSandbox();
  std::vector<calibration::PagePart> pages;
  std::string texts, failures;
  nlohmann::json parts = nlohmann::json::array();
  for (const Target& target : targets) {
    const fs::path solutions = solutionFolder(target.assignment.id);
    const auto programs = programsOf(options, target, solutions);
    Progress progress("calibrating " + target.id);
    const auto figures =
        calibration::measureReplay(target, solutions, programs, options.jobs, std::ref(progress));
    progress.clear();
    parts.push_back(calibration::toJson(figures));
    pages.push_back(pageOf(target, {calibration::sectionOf(figures)}, "tapes"));
    texts += textOf(target, pages.back().sections[0]);
    for (const calibration::Replayed& one : figures.all)
      if (!one.difference.empty() && !one.refused)
        failures +=
            fmt::format("{} {}, {}: {}\n", target.id, one.program, one.scene, one.difference);
  }
  grading::TemporaryFolder work(fs::absolute(out).lexically_normal().parent_path());
  publish(options, work, out, parts, "replay.json", pages, texts + '\n');
  endWith("these are not drawn again as they were", failures);
}

/// Scores and diagnoses of programs that nobody has written.
void generate(const CalibrateOptions& options) {
  const std::vector<Target> targets = partsOf(options.id);
  const fs::path out = resultsFolder(options);
  requireSandbox();
  grading::TemporaryFolder work(fs::absolute(out).lexically_normal().parent_path());
  std::vector<calibration::PagePart> pages;
  std::string texts, failures;
  nlohmann::json parts = nlohmann::json::array();
  for (const Target& target : targets) {
    const fs::path solutions = solutionFolder(target.assignment.id);
    Progress progress("calibrating " + target.id);
    generated::MeasureOptions how;
    how.count = options.generated;
    how.seed = options.seed;
    how.quality = grading::parseQuality(options.quality);
    how.jobs = options.jobs;
    how.progress = std::ref(progress);
    const auto figures = generated::measure(target, solutions, work.path(), how);
    progress.clear();
    nlohmann::json json = generated::toJson(figures);
    json["part"] = target.id;
    parts.push_back(std::move(json));
    pages.push_back(pageOf(target, {generated::sectionOf(figures, target)}, "generated programs"));
    texts += textOf(target, pages.back().sections[0]);
    failures += generated::failuresOf(figures);
  }
  publish(options, work, out, parts, "generated.json", pages, texts + '\n');
  endWith("this doesn't hold of generated programs", failures);
}

void measureDrift(const CalibrateOptions& options, unsigned seeds) {
  const fs::path out = resultsFolder(options);
  requireSandbox();
  std::vector<std::string> words = {"calibrate",
                                    options.id,
                                    "--skip-tolerances",
                                    "--skip-diagnosis",
                                    "--seeds",
                                    std::to_string(seeds),
                                    "--jobs",
                                    std::to_string(options.jobs),
                                    "--quality",
                                    options.quality};
  if (options.haveFirstSeed)
    words.insert(words.end(), {"--first-seed", std::to_string(options.firstSeed)});
  if (!options.catalogue.empty()) words.insert(words.end(), {"--catalogue", options.catalogue});
  if (!options.only.empty()) words.emplace_back("--only");
  words.insert(words.end(), options.only.begin(), options.only.end());
  drift(words, out, options.json);
}

} // namespace

void addCalibrate(CLI::App& app) {
  auto* command = app.add_subcommand(
      "calibrate", "Grades every catalogued mistake and right answer; fails where they don't "
                   "separate");
  auto options = std::make_shared<CalibrateOptions>();
  command->add_option("ID", options->id, "A part, an assignment, or all")->required();
  auto* seeds =
      command->add_option("--seeds", options->seeds, "Each program is graded with so many seeds")
          ->check(CLI::Range(1, 1000))
          ->capture_default_str();
  auto* first = command
                    ->add_option("--first-seed", options->firstSeed,
                                 "Seeds from here on (default: the assignment's, then 1, 2, ...)")
                    ->check(notAWholeNumber);
  auto* quality = declareQuality(*command, options->quality, "How closely gradings look");
  command->add_option("--only", options->only,
                      "Names or kinds: reference, variant, mistake, pair, pictures, stub");
  declareContext(*command);
  command->add_option("--out", options->out, "Where the results go (default out/calibrate/ID)");
  command->add_option("--catalogue", options->catalogue,
                      "The folder with mistakes/ and variants/ (default: the solution's)");
  command->add_option("--jobs", options->jobs, "Gradings at a time")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command->add_flag("--skip-tolerances", options->skipTrials,
                    "Don't try other tolerances than the published ones (--only skips it, too)");
  command->add_flag("--skip-diagnosis", options->skipDiagnosis,
                    "Don't measure whether mistakes are named right (--only skips it, too)");
  auto* diagnosis = command->add_flag("--diagnosis", options->diagnosisOnly,
                                      "Measure nothing but whether mistakes are named right");
  command
      ->add_flag("--trade", options->trade,
                 "Measure nothing but what looking less closely saves and costs: each --quality, "
                 "smaller windows, fewer hidden scenes, whole-image measures instead of a rubric")
      ->excludes(diagnosis)
      ->excludes(quality);
  command
      ->add_flag("--drift", options->drift,
                 "Measure nothing but how far scores move where EGL draws, or another processor's "
                 "instructions (one seed, unless --seeds says more)")
      ->excludes(diagnosis);
  command
      ->add_flag("--replay", options->replay,
                 "Measure nothing but whether programs are drawn again, bit for bit, from tapes of "
                 "what they drew")
      ->excludes(diagnosis);
  auto* generated =
      command
          ->add_option("--generated", options->generated,
                       "Measure nothing but so many wrong programs, each of one changed line, and "
                       "as many right ones, written in other ways: drawn, not listed")
          ->check(CLI::Range(1, 100000))
          ->excludes(diagnosis);
  command
      ->add_option("--seed", options->seed, "What generated programs and their scenes are drawn by")
      ->check(notAWholeNumber)
      ->needs(generated)
      ->capture_default_str();
  declareRepair(*command);
  command->add_flag("--json", options->json,
                    "Print calibration.json (trade.json, generated.json) on stdout");
  auto* adopted = command->add_option("--adopt", options->adopt,
                                      "Take this submission into the catalogue, anonymously");
  command->add_option("--as", options->as, "What the submission is: variant or mistake")
      ->check(CLI::IsMember({"variant", "mistake"}))
      ->needs(adopted);
  command->add_option("--name", options->name, "Name of the adopted patch, without the part")
      ->needs(adopted);
  command->footer(
      "What must hold on every seed: a right answer scores at least 98; a mistake loses 30% of "
      "its\n"
      "item's points (60% of a keep item's) and, where that is required, 7.5 in all; pictures\n"
      "without a program and the stub score 0; two mistakes cost no less than the dearer one; a "
      "right answer's score moves by at\n"
      "most 1 from seed to seed. Gradings are kept in the cache: what was broken off goes on.\n"
      "Exit codes: 0 all of it holds, 1 it doesn't, 2 usage, 3 no sandbox, 130 broken off.\n\n"
      "Examples:\n"
      "  ggrade calibrate all\n"
      "  ggrade calibrate mirror --seeds 2 --only light_not_mirrored variant\n"
      "  ggrade calibrate mirror --drift\n"
      "  ggrade calibrate mirror --generated 100 --seed 7\n"
      "  ggrade calibrate all --trade --seeds 1 --out out/trade\n"
      "  ggrade calibrate mirror --adopt uploads/disputed --as variant --name two_textures");
  command->callback([options, first, seeds, adopted, generated] {
    options->haveFirstSeed = first->count() > 0;
    if (adopted->count() > 0)
      adopt(*options);
    else if (generated->count() > 0)
      generate(*options);
    else if (options->replay)
      replay(*options);
    else if (options->trade)
      trade(*options);
    else if (options->drift)
      measureDrift(*options, seeds->count() > 0 ? options->seeds : 1);
    else
      calibrate(*options);
  });
}

} // namespace ggrade::cli
