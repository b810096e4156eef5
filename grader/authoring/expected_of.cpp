#include "authoring/expected_of.hpp"

#include "authoring/derive.hpp"
#include "authoring/solution_blocks.hpp"
#include "check/expected.hpp"
#include "diagnosis/outcome.hpp"
#include "grading/catalogue.hpp"
#include "grading/signatures.hpp"
#include "grading/workspace.hpp"
#include "image/png.hpp"
#include "report/pass_files.hpp"
#include "report/write_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <map>
#include <optional>
#include <span>

namespace ggrade::authoring {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// The public scene with the effects of all parts.
std::vector<check::Scene> scenesOfAll(const Assignment& assignment, const fs::path& solutions) {
  std::vector<std::string> ids;
  for (const Part& part : assignment.parts) ids.push_back(part.id);
  const Target target{assignment, assignment.parts, assignment.id};
  const auto scenes = grading::drawScenes(target, solutions).scenes;
  const auto isPublic = [](const grading::SceneCase& scene) { return scene.isPublic; };
  return {{"public", grading::partScene(assignment, ids),
           std::ranges::find_if(scenes, isPublic)->times, "", false}};
}

/// Seconds from the first frame of another scene to its second, which shows what the first one left
/// behind.
constexpr double kNextFrame = 0.4;

/// handout.json; an empty object if there is none.
json handoutSettings(const fs::path& solutions) {
  const fs::path file = solutions / "handout.json";
  return fs::exists(file) ? readJson(file) : json::object();
}

/// The scenes that a student may see.
std::vector<check::Scene> scenesOf(const Assignment& assignment, const Part& part,
                                   const fs::path& solutions, const std::set<std::string>& blank) {
  std::vector<check::Scene> scenes;
  const Target target{assignment, {part}, part.id};
  for (const grading::SceneCase& scene : grading::drawScenes(target, solutions).scenes)
    if (scene.isPublic) scenes.push_back({scene.name, scene.scene, scene.times, "", false});
  const fs::path file = solutions / "handout.json";
  const json settings = handoutSettings(solutions);
  if (settings.empty()) return scenes;
  const json steps = settings.value("steps", json::object()),
             others = settings.value("others", json::object());
  const auto addOthers = [&](const std::string& of, const std::string& todo, const json& base) {
    const json list = others.value(of, json::array());
    if (!list.is_array())
      throw UsageError(fmt::format("{}: others: {}: must be a list of scenes", file.string(), of));
    for (const json& other : list) {
      json scene = base;
      scene.merge_patch(other.at("scene"));
      grading::checkScene(assignment, scene, file.string() + ": others: " + of);
      const double time = other.at("time");
      grading::Moments times{time, time + kNextFrame};
      times.before = rubric::readBefore(other.value("before", json::array()),
                                        file.string() + ": others: " + of);
      const auto also = other.value("also", std::set<std::string>{});
      for (const std::string& one : also)
        if (std::ranges::find(part.todos, one, &Todo::id) == part.todos.end() || todo.empty())
          throw UsageError(fmt::format(
              "{}: others: {}: also: {}: must be another TODO of part {}, in a scene of a TODO",
              file.string(), of, one, part.id));
      scenes.push_back(
          {fmt::format("another scene for {}", of), scene, times, todo, true, 0, also});
    }
  };
  addOthers(part.id, "", grading::partScene(assignment, {part.id}));
  for (std::size_t k = 1; k <= part.todos.size(); ++k) {
    const std::string& todo = part.todos[k - 1].id;
    if (!blank.count(todo)) continue;
    const json scene = grading::handoutScene(assignment, part, settings, k);
    if (steps.contains(todo))
      scenes.push_back({fmt::format("the handout's step {}", k), scene,
                        grading::handoutTimes(part, settings, k), todo, false});
    addOthers(todo, todo, scene);
  }
  return scenes;
}

/// handout.json's "frustum": { "shadow.2": ["uProjection", "uView"] }.
check::Frustum frustumOf(const std::vector<std::string>& todos, const fs::path& solutions) {
  const json frusta = handoutSettings(solutions).value("frustum", json::object());
  for (const auto& [todo, matrices] : frusta.items())
    if (std::ranges::find(todos, todo) != todos.end()) return {todo, matrices, {}, {}};
  return {};
}

std::set<std::string> allTodos(const Assignment& assignment) {
  std::set<std::string> all;
  for (const Part& part : assignment.parts)
    for (const Todo& todo : part.todos) all.insert(todo.id);
  return all;
}

/// Views of programs in scenes with these numbers.
using Showing = std::function<std::vector<diagnosis::Signature>(
    const std::vector<grading::Candidate>& candidates, const std::vector<std::size_t>& scenes)>;

/// Where programs come from.
struct Source {
  const Assignment& assignment;
  const fs::path& solutions;
};

/// All that a program's own files say; empty where it can't be made.
std::string textOf(const Assignment& assignment, const grading::Recipe& recipe) {
  const grading::TemporaryFolder folder;
  try {
    grading::writeFiles(assignment, recipe, folder.path());
  } catch (const UsageError&) {
    return {};
  }
  std::string text;
  for (const std::string& file : assignment.files)
    text += file + '\n' + readFile(folder.path() / file);
  return text;
}

/// By TODO, the text of its blocks in all files.
std::map<std::string, std::string> blocksIn(const Assignment& assignment, const fs::path& folder) {
  std::map<std::string, std::string> all;
  for (const std::string& file : assignment.files)
    for (const auto& [todo, text] :
         authoring::blocksByTodo(readFile(folder / file), (folder / file).string()))
      all[todo] += file + '\n' + text;
  return all;
}

/// The TODOs in whose blocks a patch changes anything.
///   right: what `blocksIn` has of the solution
std::set<std::string> changedBy(const Source& source, const fs::path& patch,
                                const std::map<std::string, std::string>& right) {
  const grading::TemporaryFolder folder;
  grading::writeFiles(source.assignment, {source.solutions, {patch}}, folder.path());
  const auto wrong = blocksIn(source.assignment, folder.path());
  std::set<std::string> todos;
  for (const auto& [todo, text] : right)
    if (const auto found = wrong.find(todo); found == wrong.end() || found->second != text)
      todos.insert(todo);
  return todos;
}

/// Of mistakes in an unfinished program those that are there already. One that is larger than
/// another and of which no more is there is left out: the other one is likelier.
std::vector<const grading::Mistake*> thereAlready(const Source& source,
                                                  const std::vector<const grading::Mistake*>& all,
                                                  const std::set<std::string>& filled) {
  std::vector<std::string> texts(all.size());
  grading::inParallel(all.size(), grading::workers(), [&](std::size_t i) {
    texts[i] = textOf(source.assignment, {source.solutions, {all[i]->patch}, filled});
  });
  const std::string right = textOf(source.assignment, {source.solutions, {}, filled});
  std::map<std::string, const grading::Mistake*> smallest; // by text
  for (std::size_t i = 0; i < all.size(); ++i) {
    const grading::Mistake* mistake = all[i];
    const std::string& text = texts[i];
    if (text.empty() || text == right) continue;
    const auto [known, fresh] = smallest.emplace(text, mistake);
    if (!fresh && fs::file_size(mistake->patch) < fs::file_size(known->second->patch))
      known->second = mistake;
  }
  std::vector<const grading::Mistake*> there;
  for (const grading::Mistake* mistake : all)
    if (std::ranges::any_of(smallest, [&](const auto& one) { return one.second == mistake; }))
      there.push_back(mistake);
  return there;
}

/// The part's mistakes in TODOs that are to be done, each in the finished program and in the first
/// unfinished one in which it shows. `filled`: TODOs that are done, by step.
std::vector<check::Fault> faultsOf(const Source& source, const Part& part,
                                   const check::Expected& expected,
                                   const std::vector<std::set<std::string>>& filled,
                                   const Showing& showing) {
  const grading::Catalogue catalogue =
      grading::loadCatalogue(source.assignment, part, source.solutions, source.solutions);
  std::vector<check::Fault> faults;
  std::set<std::string> shown; // in an unfinished program
  std::map<std::string, std::set<std::string>> changed;
  const auto right = blocksIn(source.assignment, source.solutions);
  for (const grading::Mistake& mistake : catalogue.mistakes)
    changed[mistake.name] = changedBy(source, mistake.patch, right);
  for (std::size_t k = 1; k < filled.size(); ++k) {
    const bool finished = k + 1 == filled.size();
    std::vector<const grading::Mistake*> mistakes;
    for (const grading::Mistake& mistake : catalogue.mistakes) {
      const auto draws = mistake.outcome == results::Outcome::graded ||
                         mistake.outcome == results::Outcome::glError;
      const auto done = std::span(expected.todos).first(k);
      if (draws && std::ranges::find(done, mistake.step) != done.end())
        mistakes.push_back(&mistake);
    }
    if (!finished) {
      mistakes = thereAlready(source, mistakes, filled[k]);
      std::erase_if(mistakes, [&](const auto* mistake) { return shown.count(mistake->name) > 0; });
    }
    std::vector<check::Fault> made;
    std::vector<grading::Candidate> candidates;
    for (const grading::Mistake* mistake : mistakes) {
      const std::string group = mistake->same.empty() ? mistake->name : mistake->same;
      std::set<std::string> also = changed.at(mistake->name);
      also.erase(mistake->step);
      made.push_back({mistake->title,
                      mistake->hint,
                      mistake->experiment,
                      mistake->step,
                      also,
                      k,
                      {},
                      {mistake->name, group, diagnosis::Run(expected.scenes.size())}});
      candidates.push_back({mistake->name,
                            group,
                            {source.solutions,
                             {mistake->patch},
                             finished ? std::nullopt : std::optional(filled[k])}});
    }
    std::set<std::string> visible;
    const auto show = [&](std::size_t i, const auto& isAsked) {
      std::vector<grading::Candidate> here;
      std::vector<check::Fault*> theirs;
      for (std::size_t m = 0; m < made.size(); ++m)
        if (isAsked(made[m])) {
          here.push_back(candidates[m]);
          theirs.push_back(&made[m]);
        }
      std::vector<diagnosis::Signature> signatures = showing(here, {i});
      for (std::size_t m = 0; m < here.size(); ++m) {
        diagnosis::SceneViews& views = signatures[m].run.at(0);
        // One that can't be built at this step shows nothing.
        if (!views.windows.empty() && diagnosis::firstWrong({views}, {expected.steps[k][i]}))
          visible.insert(here[m].name);
        theirs[m]->scenes.insert(i);
        theirs[m]->signature.run[i] = std::move(views);
      }
    };
    const auto isOwn = [](const check::Scene& scene, const check::Fault& fault) {
      return !scene.another && (scene.todo.empty() || scene.todo == fault.todo);
    };
    for (std::size_t i = 0; i < expected.scenes.size(); ++i)
      show(i, [&](const check::Fault& fault) { return isOwn(expected.scenes[i], fault); });
    // What shows in none of these may do so in another TODO's, or in one that wasn't handed out and
    // is there for all or its own. One that is another TODO's, too, tells apart what looks alike
    // elsewhere.
    for (const bool another : {false, true}) {
      const std::set<std::string> visibleThere = visible;
      for (std::size_t i = 0; finished && i < expected.scenes.size(); ++i) {
        const check::Scene& scene = expected.scenes[i];
        show(i, [&](const check::Fault& fault) {
          if (scene.another != another || isOwn(scene, fault)) return false;
          if (scene.also.count(fault.todo)) return true;
          return (!another || scene.todo.empty() || scene.todo == fault.todo) &&
                 !visibleThere.count(fault.signature.name);
        });
      }
    }
    for (check::Fault& fault : made)
      if (finished || visible.count(fault.signature.name)) {
        shown.insert(fault.signature.name);
        faults.push_back(std::move(fault));
      }
  }
  return faults;
}

/// Only what is said of these faults: the solution's table tells more than students should know.
void writeWords(const check::Expected& expected, const fs::path& solutions, const fs::path& into) {
  const fs::path table = solutions / "words.ja.json";
  if (!fs::exists(table)) return;
  const json all = readJson(table);
  json told = json::object();
  for (const check::Fault& fault : expected.faults)
    for (const std::string& text : {fault.title, fault.hint, fault.experiment})
      if (all.contains(text)) told[text] = all[text];
  report::writeFile(check::wordsFile(into), told.dump(1));
}

/// What people see of each step, in every scene in which it is looked at, and what samplers read
/// then.
void writePictures(const Assignment& assignment, const fs::path& solutions,
                   const std::vector<std::set<std::string>>& filled,
                   const grading::ShaderCache& shaders, check::Expected& expected,
                   const fs::path& into, const grading::Progress& progress) {
  const json shares = handoutSettings(solutions).value("vertices", json::object());
  report::makeFolder(check::stepPicture(into, 0, 0).parent_path());
  expected.samplers.resize(filled.size());
  std::atomic<std::size_t> done{0};
  grading::inParallel(filled.size(), grading::workers(), [&](std::size_t k) {
    progress("pictures of the steps", done++, filled.size());
    const std::string name = fmt::format("{} after {} TODOs", expected.part, k);
    grading::Program program(assignment, {solutions, {}, filled[k]});
    if (const grading::Happened& built = program.build(); !built.ok())
      throw UsageError(fmt::format("{} doesn't build:\n{}", name, built.output));
    for (std::size_t i = 0; i < expected.scenes.size(); ++i) {
      if (!check::isDrawnAfter(expected, i, k)) continue;
      const check::Scene& scene = expected.scenes[i];
      const bool isCounted =
          k + 1 == filled.size() && !scene.another && shares.contains(scene.todo);
      const grading::Rendering rendering =
          program.render(scene.scene, scene.times.first(), shaders,
                         i == 0 || isCounted ? grading::gradingRequest() : trace::Request{});
      if (rendering.happened.outcome != results::Outcome::graded)
        throw UsageError(fmt::format("{} doesn't render: {}\n{}", name, rendering.happened.detail,
                                     rendering.happened.output));
      writePng(check::stepPicture(into, k, i),
               rubric::toImage(grading::rawFrames(rendering.capture).at(0)));
      if (isCounted)
        expected.scenes[i].mostVertices =
            std::uint64_t(double(check::verticesOf(rendering.capture.trace)) *
                          shares.at(scene.todo).get<double>());
      if (i > 0) continue;
      expected.samplers[k] = diagnosis::sampledTextures(rendering.capture.trace);
      if (k + 1 < filled.size()) continue;
      report::writePassFiles(rendering.capture.trace, check::referenceFolder(into), true);
      if (!expected.frustum.todo.empty() &&
          !check::takePoints(expected.frustum, rendering.capture.trace))
        throw UsageError(fmt::format("{}: frustum: no pass draws depths alone with {}",
                                     (solutions / "handout.json").string(),
                                     fmt::join(expected.frustum.matrices, " and ")));
    }
  });
}

} // namespace

void writeExpected(const Assignment& assignment, const Part& part, const fs::path& solutions,
                   const std::set<std::string>& blank, const fs::path& into,
                   const grading::Progress& progress) {
  check::Expected expected;
  expected.assignment = assignment.id;
  expected.part = part.id;
  for (const Todo& todo : part.todos)
    if (blank.count(todo.id) || todo.id == assignment.id) expected.todos.push_back(todo.id);
  std::vector<std::set<std::string>> filled; // by step
  Target target{assignment, {part}, part.id};
  if (check::isTogether(expected)) {
    target.parts = assignment.parts;
    expected.scenes = scenesOfAll(assignment, solutions);
    filled = {allTodos(assignment), allTodos(assignment)};
    for (const std::string& todo : blank) filled.front().erase(todo);
  } else {
    expected.scenes = scenesOf(assignment, part, solutions, blank);
    // What this part shows doesn't depend on the other parts' TODOs.
    filled = {allTodos(assignment)};
    for (const std::string& todo : expected.todos) filled.front().erase(todo);
    for (const std::string& todo : expected.todos) {
      filled.push_back(filled.back());
      filled.back().insert(todo);
    }
  }
  grading::ScenePlan plan;
  std::vector<std::size_t> numbers;
  for (const check::Scene& scene : expected.scenes) {
    numbers.push_back(plan.scenes.size());
    plan.scenes.push_back({scene.name, true, {}, scene.times, scene.scene, "", {}});
  }
  const auto tell = [&](const std::string& what, std::size_t done, std::size_t total) {
    progress(part.id + ": " + what, done, total);
  };
  const grading::References references = grading::prepareReferences(target, solutions, plan, tell);
  for (const rubric::SceneFolders& scene : references.scenes)
    expected.reference.push_back(grading::viewsIn(scene.reference, true));
  const Showing showing = [&](const std::vector<grading::Candidate>& candidates,
                              const std::vector<std::size_t>& scenes) {
    return grading::renderSignatures(
        target, solutions, candidates, scenes, references,
        [&](std::size_t scene) -> const diagnosis::SceneViews& {
          return expected.reference[scene];
        },
        tell, true);
  };

  std::vector<grading::Candidate> steps;
  for (std::size_t k = 0; k < filled.size(); ++k)
    steps.push_back({fmt::format("step.{}", k), "", {solutions, {}, filled[k]}});
  for (diagnosis::Signature& step : showing(steps, numbers))
    expected.steps.push_back(std::move(step.run));

  const grading::Catalogue catalogue =
      grading::loadCatalogue(assignment, part, solutions, solutions);
  std::vector<grading::Candidate> variants;
  for (const grading::Variant& variant : catalogue.variants)
    if (variant.loses.empty())
      variants.push_back({variant.name, variant.name, {solutions, {variant.patch}}});
  for (diagnosis::Signature& variant : showing(variants, numbers))
    if (!std::ranges::equal(variant.run, expected.reference, diagnosis::sameWindows))
      expected.others.push_back(std::move(variant.run));
  expected.faults = faultsOf({assignment, solutions}, part, expected, filled, showing);
  std::set<std::string> handedOut = allTodos(assignment);
  for (const std::string& todo : blank) handedOut.erase(todo);
  report::makeFolder(check::stubFolder(into));
  writeSources(assignment, solutions, handedOut, gg::Language::english, check::stubFolder(into));
  expected.frustum = frustumOf(expected.todos, solutions);
  writePictures(assignment, solutions, filled, references.ownShaders, expected, into, tell);
  check::save(expected, into);
  writeWords(expected, solutions, into);
}

namespace {

/// All that `writeExpected` depends on.
std::string madeOf(const Target& target, const fs::path& solutions) {
  std::set<fs::path> files{solutions / "handout.json"};
  for (const char* folder : {"mistakes", "variants"})
    if (fs::exists(solutions / folder))
      for (const fs::directory_entry& entry : fs::directory_iterator(solutions / folder))
        files.insert(entry.path());
  std::string all = grading::gradingKey(target, solutions, grading::drawScenes(target, solutions)) +
                    grading::wordsKey(target.assignment, solutions);
  for (const fs::path& file : files)
    if (fs::is_regular_file(file))
      all += file.filename().string() + grading::hashOf(readFile(file)) + '\n';
  return all;
}

} // namespace

void updateExpected(const Target& target, const fs::path& solutions, const fs::path& into,
                    const grading::Progress& progress) {
  report::makeFolder(into);
  const auto update = [&](const Part& part, const std::vector<Part>& parts) {
    const std::string key = madeOf({target.assignment, parts, part.id}, solutions);
    const fs::path note = into / part.id / "made-of";
    if (fs::exists(note) && readFile(note) == key) return;
    std::set<std::string> blank;
    for (const Part& one : parts)
      for (const Todo& todo : one.todos) blank.insert(todo.id);
    grading::TemporaryFolder work(into);
    writeExpected(target.assignment, part, solutions, blank, work.path(), progress);
    report::writeFile(work.path() / "made-of", key);
    fs::remove_all(into / part.id);
    fs::rename(work.path(), into / part.id);
  };
  for (const Part& part : target.parts) update(part, {part});
  // Who is to do one part looks at it in a folder in which the others may not be done.
  if (target.parts.size() > 1 && check::hasTogether(target.assignment))
    update(check::togetherOf(target.assignment), target.parts);
}

} // namespace ggrade::authoring
