#include "check/expected.hpp"

#include "report/write_file.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>

namespace ggrade::diagnosis {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Sampled, isDepth, width, height, byObject, isComplete)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Slot, depth, mesh, octave, nth, stencil)

} // namespace ggrade::diagnosis

namespace ggrade::check {

namespace fs = std::filesystem;
using diagnosis::Run;
using diagnosis::SceneViews;
using gg::say;
using nlohmann::json;

namespace {

fs::path viewsFile(const fs::path& folder, const std::string& program, std::size_t scene) {
  return folder / "views" / fmt::format("{}-{}.views", program, scene);
}

/// What is empty isn't written.
void saveRun(const Run& run, const Run* base, const fs::path& folder, const std::string& program) {
  for (std::size_t i = 0; i < run.size(); ++i)
    if (!run[i].windows.empty())
      diagnosis::save(run[i], base ? &(*base)[i] : nullptr, viewsFile(folder, program, i));
}

Run loadRun(std::size_t scenes, const Run* base, const fs::path& folder,
            const std::string& program) {
  Run run;
  for (std::size_t i = 0; i < scenes; ++i)
    run.push_back(diagnosis::load(viewsFile(folder, program, i), base ? &(*base)[i] : nullptr));
  return run;
}

/// Of each scene in which a fault spoils anything: the scene, the pass that is wrong first or null,
/// and whether the window is wrong.
json spoiledBy(const Fault& fault, const Expected& expected) {
  json spoils = json::array();
  for (const std::size_t scene : fault.scenes) {
    const SceneViews &shows = fault.signature.run[scene],
                     &should = expected.steps[fault.step][scene];
    if (const auto first = diagnosis::firstWrong({shows}, {should}))
      spoils.push_back({scene, first->slot ? json(*first->slot) : json(),
                        !diagnosis::sameWindows(shows, should)});
  }
  return spoils;
}

void readSpoiled(const json& spoils, Fault& fault) {
  for (const json& one : spoils) {
    Spoiled& spoiled = fault.spoils[one.at(0)];
    if (!one.at(1).is_null()) spoiled.first = one.at(1).get<diagnosis::Slot>();
    one.at(2).get_to(spoiled.window);
  }
}

std::string nameOfFault(std::size_t number) {
  return fmt::format("fault-{}", number);
}

} // namespace

Part togetherOf(const Assignment& assignment) {
  const std::string title = say("All effects together");
  Part part;
  part.id = assignment.id;
  part.title = title;
  part.todos = {{assignment.id, title}};
  return part;
}

bool isDrawnAfter(const Expected& expected, std::size_t scene, std::size_t step) {
  const std::string& todo = expected.scenes[scene].todo;
  const auto before = expected.todos | std::views::take(step);
  return todo.empty() || std::ranges::find(before, todo) != before.end();
}

std::uint64_t verticesOf(const trace::Trace& trace) {
  std::uint64_t sum = 0;
  for (const trace::PassRecord& pass : trace.passesOf(0)) sum += pass.vertices;
  return sum;
}

fs::path stubFolder(const fs::path& folder) {
  return folder / "handed_out";
}

fs::path referenceFolder(const fs::path& folder) {
  return folder / "reference";
}

fs::path stepPicture(const fs::path& folder, std::size_t step, std::size_t scene) {
  return folder / "windows" / fmt::format("step-{}-{}.png", step, scene);
}

fs::path sceneFile(const fs::path& folder, std::size_t scene) {
  return folder / fmt::format("scene-{}.json", scene);
}

fs::path wordsFile(const fs::path& folder) {
  return folder / "words.ja.json";
}

void save(const Expected& expected, const fs::path& folder) {
  report::makeFolder(folder / "views");
  json scenes = json::array(), faults = json::array();
  for (const Scene& scene : expected.scenes)
    scenes.push_back({{"name", scene.name},
                      {"scene", scene.scene},
                      {"times", scene.times.shown},
                      {"before", rubric::toJson(scene.times.before)},
                      {"todo", scene.todo},
                      {"another", scene.another},
                      {"most_vertices", scene.mostVertices},
                      {"also", scene.also}});
  for (const Fault& fault : expected.faults)
    faults.push_back({{"title", fault.title},
                      {"hint", fault.hint},
                      {"experiment", fault.experiment},
                      {"also", fault.also},
                      {"todo", fault.todo},
                      {"step", fault.step},
                      {"scenes", fault.scenes},
                      {"spoils", spoiledBy(fault, expected)},
                      {"group", fault.signature.group}});
  report::writeFile(folder / "expected.json", json{{"assignment", expected.assignment},
                                                   {"part", expected.part},
                                                   {"todos", expected.todos},
                                                   {"scenes", scenes},
                                                   {"samplers", expected.samplers},
                                                   {"frustum", expected.frustum},
                                                   {"others", expected.others.size()},
                                                   {"faults", faults}}
                                                  .dump(1));
  for (std::size_t i = 0; i < expected.scenes.size(); ++i)
    if (expected.scenes[i].another)
      report::writeFile(sceneFile(folder, i), expected.scenes[i].scene.dump(2) + '\n');
  saveRun(expected.reference, nullptr, folder, "reference");
  for (std::size_t k = 0; k < expected.steps.size(); ++k)
    saveRun(expected.steps[k], &expected.reference, folder, fmt::format("step-{}", k));
  for (std::size_t k = 0; k < expected.others.size(); ++k)
    saveRun(expected.others[k], &expected.reference, folder, fmt::format("other-{}", k));
  for (std::size_t k = 0; k < expected.faults.size(); ++k)
    saveRun(expected.faults[k].signature.run, &expected.steps[expected.faults[k].step], folder,
            nameOfFault(k));
}

Expected load(const fs::path& folder) {
  const fs::path file = folder / "expected.json";
  Expected expected;
  expected.folder = folder;
  try {
    const json all = readJson(file);
    all.at("assignment").get_to(expected.assignment);
    all.at("part").get_to(expected.part);
    all.at("todos").get_to(expected.todos);
    all.at("samplers").get_to(expected.samplers);
    all.at("frustum").get_to(expected.frustum);
    for (const json& scene : all.at("scenes"))
      expected.scenes.push_back(
          {scene.at("name"),
           scene.at("scene"),
           {rubric::readBefore(scene.value("before", json::array()), file.string()),
            scene.at("times").get<std::vector<double>>()},
           scene.at("todo"),
           scene.at("another"),
           scene.at("most_vertices"),
           scene.at("also")});
    const std::size_t scenes = expected.scenes.size();
    expected.reference = loadRun(scenes, nullptr, folder, "reference");
    for (std::size_t k = 0; k <= expected.todos.size(); ++k)
      expected.steps.push_back(
          loadRun(scenes, &expected.reference, folder, fmt::format("step-{}", k)));
    for (std::size_t k = 0; k < all.at("others"); ++k)
      expected.others.push_back(
          loadRun(scenes, &expected.reference, folder, fmt::format("other-{}", k)));
    for (const json& one : all.at("faults")) {
      const std::string name = nameOfFault(expected.faults.size());
      expected.faults.push_back({one.at("title"),
                                 one.at("hint"),
                                 one.at("experiment"),
                                 one.at("todo"),
                                 one.at("also"),
                                 one.at("step"),
                                 one.at("scenes"),
                                 {name, one.at("group"), {}}});
      readSpoiled(one.at("spoils"), expected.faults.back());
      if (const std::size_t step = expected.faults.back().step; step > expected.todos.size())
        throw UsageError(
            fmt::format("{}: faults: step {} of {}", file.string(), step, expected.todos.size()));
    }
  } catch (const json::exception& error) {
    throw UsageError(fmt::format("{}: {}", file.string(), error.what()));
  }
  return expected;
}

diagnosis::SceneViews viewsOf(const Expected& expected, std::size_t fault, std::size_t scene) {
  return diagnosis::load(viewsFile(expected.folder, nameOfFault(fault), scene),
                         &expected.steps[expected.faults[fault].step][scene]);
}

} // namespace ggrade::check
