#include "cli/derive.hpp"

#include "authoring/handout.hpp"
#include "authoring/pass_picture.hpp"
#include "authoring/solution_blocks.hpp"
#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "grading/program.hpp"
#include "grading/references.hpp"
#include "image/png.hpp"
#include "report/write_file.hpp"
#include "tradeoff/adopted.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <set>

namespace ggrade::cli {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

struct Options {
  std::string id, out;
  int done = -1;
  bool noPictures = false;
};

std::set<std::string> firstTodos(const Part& part, int count) {
  std::set<std::string> filled;
  for (int i = 0; i < count; ++i) filled.insert(part.todos[std::size_t(i)].id);
  return filled;
}

} // namespace

void writeSources(const Assignment& assignment, const fs::path& solutions,
                  const std::set<std::string>& filled, const fs::path& into) {
  for (const std::string& file : assignment.files) {
    const fs::path from = solutions / file;
    report::writeFile(into / file, authoring::withFilled(readFile(from), from.string(), filled));
  }
}

Program::Program(const Assignment& assignment, const fs::path& solutions,
                 const std::set<std::string>& filled, const std::string& name)
    : assignment_(assignment.id), name_(name) {
  writeSources(assignment, solutions, filled, folder_.path());
  for (const std::string& file : assignment.dataFiles())
    fs::copy_file(assignment.folder / file, folder_.path() / file);
  const grading::Happened built =
      grading::buildProgram(assignment.id, folder_.path(), sandbox::Isolation::none);
  if (!built.ok()) throw UsageError(fmt::format("{} doesn't build:\n{}", name, built.output));
}

channel::Capture Program::draw(const json& scene, const std::vector<double>& times) const {
  grading::Rendering rendering =
      grading::renderScene(assignment_, folder_.path(), scene, times, {}, sandbox::Isolation::none,
                           grading::gradingRequest());
  if (rendering.happened.outcome != report::Outcome::graded)
    throw UsageError(fmt::format("{} doesn't render: {}\n{}", name_, rendering.happened.detail,
                                 rendering.happened.output));
  return std::move(rendering.capture);
}

Image window(const channel::Capture& capture) {
  return rubric::toImage(grading::rawFrames(capture).at(0));
}

namespace {

/// The window after each step of each part, as `part-k.png`; where handout.json names a pass for a
/// step, what it drew as `part-k-pass.png`; and further pictures by their names there.
void writePictures(const Assignment& assignment, const fs::path& solutions, const fs::path& into) {
  const fs::path file = solutions / "handout.json";
  const json settings = readJson(file);
  const auto times = settings.at("times").get<std::vector<double>>();
  const json passes = settings.value("passes", json::object());
  Progress progress("handout pictures of " + assignment.id);
  for (const Part& part : assignment.parts) {
    for (std::size_t k = 0; k <= part.todos.size(); ++k) {
      progress(part.id, k, part.todos.size());
      const std::string name = fmt::format("{}-{}", part.id, k);
      const channel::Capture capture =
          Program(assignment, solutions, firstTodos(part, int(k)), name)
              .draw(grading::handoutScene(assignment, part, settings, k), times);
      writePng(into / (name + ".png"), window(capture));
      const std::string step = k > 0 ? part.todos[k - 1].id : "";
      if (passes.contains(step))
        writePng(into / (name + "-pass.png"),
                 authoring::passPicture(capture.trace, passes.at(step),
                                        fmt::format("{}: passes: {}", file.string(), step)));
    }
  }
  const json pictures = settings.value("pictures", json::object());
  for (const auto& [name, picture] : pictures.items()) {
    progress(name, 0, 1);
    std::set<std::string> filled;
    std::vector<std::string> parts;
    for (const json& done : picture.at("done")) {
      // "shadow.5": the first five TODOs of that part.
      const std::string id = done.get<std::string>().substr(0, done.get<std::string>().find('.'));
      const Target target = findTarget(assignment.folder.parent_path(), id);
      parts.push_back(id);
      for (const Todo& todo : target.parts.at(0).todos) {
        filled.insert(todo.id);
        if (todo.id == done) break;
      }
    }
    json scene = grading::partScene(assignment, parts);
    scene.merge_patch(settings.value("scene", json::object()));
    scene.merge_patch(picture.value("scene", json::object()));
    writePng(into / (name + ".png"),
             window(Program(assignment, solutions, filled, name).draw(scene, times)));
  }
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

/// How a text's file is named, and what a text in the other language says of this one.
struct Written {
  gg::Language language;
  const char *ending, *name;
};
constexpr Written kWritten[] = {{gg::Language::english, ".md", "English"},
                                {gg::Language::japanese, ".ja.md", "日本語"}};

/// README.md from the solution's handout.md, and PART.md from its PART.md; in another language the
/// same from handout.ja.md and PART.ja.md. Each begins with a link to the same text in the others.
void writeTexts(const Assignment& assignment, const fs::path& solutions, const json& figures,
                const Written& written, const fs::path& into) {
  const auto stub = [&](const std::string& file) {
    return authoring::withFilled(readFile(solutions / file), file, {});
  };
  const auto measured = [&](const std::string& part) {
    return figures.empty() ? "" : tradeoff::handoutText(figures, part);
  };
  const auto write = [&](const std::string& from, const std::string& to) {
    const fs::path source = solutions / (from + written.ending);
    if (!fs::exists(source)) return;
    std::string links;
    for (const Written& other : kWritten)
      if (other.language != written.language && fs::exists(solutions / (from + other.ending)))
        links += fmt::format("[{}]({}{})\n\n", other.name, to, other.ending);
    report::writeFile(into / (to + written.ending),
                      links + authoring::expandHandout(readFile(source), source.string(),
                                                       assignment, stub, measured));
  };
  write("handout", "README");
  for (const Part& part : assignment.parts) write(part.id, part.id);
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

void deriveInto(const Assignment& assignment, const fs::path& solutions, const fs::path& into,
                bool pictures) {
  report::makeFolder(into / "handout");
  writeSources(assignment, solutions, {}, into);
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
    if (pictures) writePictures(assignment, solutions, into / "handout");
  }
}

namespace {

void derive(const Options& options) {
  const Target target = findTarget(assignmentsFolder(), options.id);
  const Assignment& assignment = target.assignment;
  const fs::path solutions = solutionFolder(assignment.id);
  if (options.done >= 0) {
    if (target.parts.size() != 1)
      throw UsageError(fmt::format(
          "--done counts the TODOs of one part, and {} has several: name the part", options.id));
    const Part& part = target.parts[0];
    if (std::size_t(options.done) > part.todos.size())
      throw UsageError(
          fmt::format("--done {}: {} has {} TODOs", options.done, part.id, part.todos.size()));
    if (options.out.empty()) throw UsageError("--done needs --out: name the folder for the files");
    report::makeFolder(options.out);
    writeSources(assignment, solutions, firstTodos(part, options.done), options.out);
    return;
  }
  const fs::path into = options.out.empty() ? assignment.folder : fs::path(options.out);
  deriveInto(assignment, solutions, into, !options.noPictures);
  fmt::print("{}: stub and handout are in step with {}\n", into.string(), solutions.string());
}

} // namespace

void addDerive(CLI::App& app) {
  auto* command = app.add_subcommand(
      "derive", "Makes an assignment's stub, handout and pictures from its solution");
  auto options = std::make_shared<Options>();
  command->add_option("ID", options->id, "Assignment, or with --done a part")->required();
  command
      ->add_option("--done", options->done,
                   "The program with the first N TODOs of the part filled in")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--out", options->out, "Where the files go (default: assignments/ID)");
  command->add_flag("--no-pictures", options->noPictures,
                    "Leave the handout's pictures as they are");
  command->footer(
      "Examples:\n"
      "  ggrade derive floor                          after every change of solutions/floor\n"
      "  ggrade derive mirror --done 3 --out out/step3");
  command->callback([options] { derive(*options); });
}

} // namespace ggrade::cli
