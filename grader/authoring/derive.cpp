#include "authoring/derive.hpp"

#include "authoring/comments.hpp"
#include "authoring/handout.hpp"
#include "authoring/pass_picture.hpp"
#include "authoring/quiz.hpp"
#include "authoring/solution_blocks.hpp"
#include "grading/scenes.hpp"
#include "grading/store.hpp"
#include "image/png.hpp"
#include "report/write_file.hpp"
#include "tradeoff/adopted.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <atomic>

namespace ggrade::authoring {

namespace fs = std::filesystem;
using nlohmann::json;

std::set<std::string> firstTodos(const Part& part, std::size_t count) {
  std::set<std::string> filled;
  for (std::size_t i = 0; i < count; ++i) filled.insert(part.todos.at(i).id);
  return filled;
}

namespace {

Translations translationsFor(gg::Language language, const fs::path& solutions) {
  return language == gg::Language::japanese ? translationsIn(solutions) : Translations();
}

} // namespace

void writeSources(const Assignment& assignment, const fs::path& solutions,
                  const std::set<std::string>& filled, gg::Language comments,
                  const fs::path& into) {
  const Translations translations = translationsFor(comments, solutions);
  for (const std::string& file : assignment.files) {
    const fs::path from = solutions / file;
    report::writeFile(into / file,
                      withFilled(translated(readFile(from), translations), from.string(), filled));
  }
}

namespace {

/// A picture of a handout: what a program draws, or what one of its passes left.
struct Picture {
  std::string name; ///< of the file, and for errors
  std::set<std::string> filled;
  json scene;
  grading::Moments times;
  json pass;         ///< see passPicture; null: the window
  std::string where; ///< it is asked for, for errors
};

/// Raise it when a picture's bytes change though programs and scenes don't.
constexpr int kPictures = 1;

/// Writes the picture to `file`, from the cache if it was drawn before. Throws UsageError where the
/// program fails.
void draw(const Assignment& assignment, const fs::path& solutions, const Picture& picture,
          const fs::path& file) {
  grading::Program program(assignment, {solutions, {}, picture.filled}, sandbox::Isolation::none);
  const fs::path kept =
      grading::cacheFolder() / "pictures" /
      (grading::hashOf(fmt::format("{} {} {} {} {}", kPictures, program.key(), picture.scene.dump(),
                                   json(picture.times).dump(), picture.pass.dump())) +
       ".png");
  std::error_code none;
  if (fs::copy_file(kept, file, fs::copy_options::overwrite_existing, none)) return;
  const grading::Happened& built = program.build();
  if (!built.ok())
    throw UsageError(fmt::format("{} doesn't build:\n{}", picture.name, built.output));
  const grading::Rendering rendering =
      program.render(picture.scene, picture.times, {},
                     picture.pass.is_null() ? trace::Request{} : grading::gradingRequest());
  if (rendering.happened.outcome != results::Outcome::graded)
    throw UsageError(fmt::format("{} doesn't render: {}\n{}", picture.name,
                                 rendering.happened.detail, rendering.happened.output));
  writePng(file, picture.pass.is_null()
                     ? rubric::toImage(grading::rawFrames(rendering.capture).at(0))
                     : passPicture(rendering.capture.trace, picture.pass, picture.where));
  try {
    grading::TemporaryFolder made(kept.parent_path());
    fs::copy_file(file, made.path() / "picture");
    grading::keep(made.path() / "picture", kept);
  } catch (const std::exception&) {
    // No room in the cache: it is drawn again next time.
  }
}

/// The window after each step of each part, as `part-k.png`; where handout.json names a pass for a
/// step, what it drew as `part-k-pass.png`; and further pictures by their names there.
std::vector<Picture> picturesOf(const Assignment& assignment, const fs::path& file,
                                const json& settings) {
  const json passes = settings.value("passes", json::object());
  std::vector<Picture> all, ofPasses;
  for (const Part& part : assignment.parts) {
    for (std::size_t k = 0; k <= part.todos.size(); ++k) {
      const std::string name = fmt::format("{}-{}", part.id, k);
      const json scene = grading::handoutScene(assignment, part, settings, k);
      const grading::Moments times = grading::handoutTimes(part, settings, k);
      all.push_back({name, firstTodos(part, k), scene, times, nullptr, ""});
      const std::string step = k > 0 ? part.todos[k - 1].id : "";
      if (passes.contains(step))
        ofPasses.push_back({name + "-pass", all.back().filled, scene, times, passes.at(step),
                            fmt::format("{}: passes: {}", file.string(), step)});
    }
  }
  const json pictures = settings.value("pictures", json::object());
  for (const auto& [name, picture] : pictures.items()) {
    std::set<std::string> filled;
    std::vector<std::string> parts;
    for (const json& done : picture.at("done")) {
      // "shadow.5": the first five TODOs of that part.
      const std::string id = done.get<std::string>().substr(0, done.get<std::string>().find('.'));
      const Target target = findTarget(assignment.folder.parent_path(), id);
      parts.push_back(id);
      for (const Todo& todo : target.parts.at(0).todos) {
        filled.insert(todo.id);
        if (todo.id == done.get<std::string>()) break;
      }
    }
    json scene = grading::partScene(assignment, parts);
    scene.merge_patch(settings.value("scene", json::object()));
    scene.merge_patch(picture.value("scene", json::object()));
    all.push_back(
        {name, filled, scene, grading::handoutTimes(settings, picture, name), nullptr, ""});
  }
  // Last: their programs are built by then.
  all.insert(all.end(), ofPasses.begin(), ofPasses.end());
  return all;
}

void writePictures(const Assignment& assignment, const fs::path& solutions, const fs::path& into,
                   const grading::Progress& progress) {
  const fs::path file = solutions / "handout.json";
  const json settings = readJson(file);
  const std::vector<Picture> all = picturesOf(assignment, file, settings);
  std::atomic<std::size_t> done{0};
  grading::inParallel(all.size(), grading::workers(), [&](std::size_t i) {
    progress("drawing", done++, all.size());
    draw(assignment, solutions, all[i], into / (all[i].name + ".png"));
  });
}

/// presets.json of what `tradeoff --adopt` kept. Returns its figures; null if it has kept nothing.
json writeMeasured(const fs::path& adopted, const fs::path& into) {
  if (!fs::exists(adopted)) return nullptr;
  const json figures = readJson(adopted / "figures.json");
  const json presets = tradeoff::adoptedPresets(figures);
  std::string text;
  for (const auto& [name, numbers] : presets.items())
    text += fmt::format("{}  \"{}\": {}", text.empty() ? "" : ",\n", name, numbers.dump());
  report::writeFile(into / "presets.json", "{\n" + text + "\n}\n");
  return figures;
}

/// PART.quiz.md of the solution's PART.quiz.json, without answers. Returns a link to it for the end
/// of the part's handout; empty if there is no quiz in this language.
std::string writeQuiz(const Part& part, const fs::path& solutions, const Written& written,
                      const fs::path& into) {
  const auto quiz = quizOf(solutions, part.id);
  if (!quiz) return "";
  const std::string name = part.id + ".quiz";
  std::string links;
  for (const Written& other : kWritten)
    if (quiz->japanese && other.language != written.language)
      links += fmt::format("[{}]({}{})\n\n", other.name, name, other.ending);
  report::writeFile(into / (name + written.ending), links + quizPage(*quiz, part.title, false));
  return fmt::format("\n[{}]({}{})\n", gg::say("Test yourself: the quiz of this part"), name,
                     written.ending);
}

/// README.md from the solution's handout.md, and PART.md from its PART.md; in another language the
/// same from handout.ja.md and PART.ja.md. Each begins with a link to the same text in the others,
/// and a part's ends with one to its quiz.
void writeTexts(const Assignment& assignment, const fs::path& solutions, const json& figures,
                const Written& written, const fs::path& into) {
  const Translations translations = translationsFor(written.language, solutions);
  const auto stub = [&](const std::string& file) {
    return withFilled(translated(readFile(solutions / file), translations), file, {});
  };
  const auto measured = [&](const std::string& part) {
    return figures.empty() ? "" : tradeoff::handoutText(figures, part);
  };
  const auto write = [&](const std::string& from, const std::string& to, const Part* part) {
    const fs::path source = solutions / (from + written.ending);
    if (!fs::exists(source)) return;
    std::string links;
    for (const Written& other : kWritten)
      if (other.language != written.language && fs::exists(solutions / (from + other.ending)))
        links += fmt::format("[{}]({}{})\n\n", other.name, to, other.ending);
    report::writeFile(
        into / (to + written.ending),
        links + expandHandout(readFile(source), source.string(), assignment, stub, measured) +
            (part ? writeQuiz(*part, solutions, written, into) : ""));
  };
  write("handout", "README", assignment.isOnePart() ? &assignment.parts[0] : nullptr);
  for (const Part& part : assignment.parts) write(part.id, part.id, &part);
}

/// The charts that `tradeoff --adopt` kept, in the language that was chosen.
void writeCharts(const fs::path& adopted, const json& figures, const fs::path& into) {
  for (const json& sweep : figures.at("sweeps")) {
    const std::string part = sweep.at("part"), name = sweep.at("scene_name");
    report::writeFile(into / tradeoff::chartFile(part, name, gg::language()),
                      tradeoff::chartInWords(readFile(adopted / tradeoff::chartFile(part, name))));
  }
}

} // namespace

void deriveInto(const Assignment& assignment, const fs::path& solutions, gg::Language comments,
                const fs::path& into, const grading::Progress& pictures) {
  report::makeFolder(into / "handout");
  writeSources(assignment, solutions, {}, comments, into);
  const json figures = writeMeasured(solutions / "tradeoff", into);
  if (fs::exists(solutions / "handout.md")) {
    const gg::Language chosen = gg::language();
    for (const Written& written : kWritten) {
      if (!fs::exists(solutions / (std::string("handout") + written.ending))) continue;
      gg::setLanguage(written.language);
      addWords(solutions);
      if (!figures.empty()) writeCharts(solutions / "tradeoff", figures, into / "handout");
      writeTexts(Assignment::load(assignment.folder), solutions, figures, written, into);
    }
    gg::setLanguage(chosen);
    if (pictures) writePictures(assignment, solutions, into / "handout", pictures);
  }
}

} // namespace ggrade::authoring
