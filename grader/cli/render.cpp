#include "cli/commands.hpp"

#include "cli/rendering.hpp"
#include "cli/terminal.hpp"
#include "grading/references.hpp"
#include "grading/workspace.hpp"
#include "image/png.hpp"
#include "report/write_file.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <iostream>
#include <sstream>

#include <unistd.h>

namespace ggrade::cli {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

struct Options {
  std::string target, out, scene, size;
  std::vector<double> times = {0};
  bool solution = false, json = false;
};

/// The program that a shell would start. Throws UsageError if there is none.
std::string findProgram(const std::string& name) {
  const auto runs = [](const fs::path& path) {
    std::error_code none;
    return fs::is_regular_file(path, none) && access(path.c_str(), X_OK) == 0;
  };
  std::string searched = ".";
  if (const char* path = std::getenv("PATH"); path && name.find('/') == name.npos) searched = path;
  std::istringstream folders(searched);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (const fs::path path = fs::absolute(fs::path(folder) / name); runs(path)) return path;
  throw UsageError(fmt::format("there is no program {}: name one that can be run", name));
}

json trace(const grading::Rendering& rendering) {
  const channel::Capture& capture = rendering.capture;
  json frames = json::array(), messages = json::array();
  for (std::size_t i = 0; i < capture.frames.size(); ++i) {
    const channel::CapturedFrame& frame = capture.frames[i];
    frames.push_back({{"image", fmt::format("frame-{}.png", i)},
                      {"time", frame.time},
                      {"width", frame.width},
                      {"height", frame.height},
                      {"seconds", frame.seconds},
                      {"window_draws", frame.windowDraws},
                      {"window_clears", frame.windowClears},
                      {"framebuffer_at_swap", frame.boundFramebuffer},
                      {"window_srgb", frame.windowSrgb}});
  }
  for (const channel::CapturedMessage& message : capture.messages)
    messages.push_back(
        {{"frame", message.frame}, {"count", message.count}, {"text", message.text}});
  return {{"version", 1},
          {"rows", "top first"},
          {"values", "as stored in the window, 8 bits a channel"},
          {"outcome", report::name(rendering.happened.outcome)},
          {"gl_version", capture.glVersion},
          {"gl_renderer", capture.glRenderer},
          {"context_seconds", capture.contextSeconds},
          {"shader_seconds", capture.shaderSeconds},
          {"frames", frames},
          {"messages", messages}};
}

void render(const Options& options) {
  const fs::path out = outputFolder(options.out);
  checkTimes(options.times, "--times");
  Progress progress("render");
  if (afterDashes.empty() == options.target.empty())
    throw UsageError("name either an assignment or folder, or a program after --; see ggrade "
                     "render --help");
  const Size size = parseSize(options.size);
  if (!afterDashes.empty()) afterDashes[0] = findProgram(afterDashes[0]);
  const grading::Rendering rendering =
      afterDashes.empty()
          ? renderTarget({options.target, options.scene, size, options.times, options.solution},
                         progress)
          : grading::renderProgram(afterDashes, options.times, size.width, size.height);
  progress.clear();

  grading::TemporaryFolder work(fs::absolute(out).parent_path());
  const auto frames = grading::rawFrames(rendering.capture);
  for (std::size_t i = 0; i < frames.size(); ++i)
    writePng(work.path() / fmt::format("frame-{}.png", i), rubric::toImage(frames[i]));
  const json trace = cli::trace(rendering);
  report::writeFile(work.path() / "trace.json", trace.dump(2) + '\n');
  work.publish(out);

  if (options.json) {
    std::cout << trace.dump(2) << '\n';
  } else {
    fmt::print("{}: {} frames in {}\n", report::name(rendering.happened.outcome), frames.size(),
               out.string());
    for (const channel::CapturedMessage& message : rendering.capture.messages)
      if (message.kind != channel::MessageKind::capture)
        fmt::print("  frame {}: {}\n", message.frame, message.text);
  }
  if (rendering.happened.outcome != report::Outcome::graded) {
    std::fflush(stdout);
    fmt::print(stderr, "{}\n{}", rendering.happened.detail, rendering.happened.output);
  }
  if (!rendering.happened.ok()) exitCode = kNotGradable;
}

} // namespace

void addRender(CLI::App& app) {
  auto* command = app.add_subcommand("render", "Renders frames offscreen: images and trace.json");
  auto options = std::make_shared<Options>();
  command->add_option("TARGET", options->target,
                      "An assignment or part (its files in assignments/), or a folder of files");
  command->add_option("--out", options->out, "Where frame-N.png and trace.json go")->required();
  command->add_option("--scene", options->scene, "Another scene than the assignment's scene.json");
  command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels");
  command->add_option("--times", options->times, "Seconds, separated by commas")
      ->delimiter(',')
      ->capture_default_str();
  command->add_flag("--solution", options->solution,
                    "The reference instead of the assignment's own files");
  command->add_flag("--json", options->json, "Print trace.json on stdout");
  command->footer("After -- stands any GLFW program with its arguments, run as it is.\n"
                  "Exit codes: 0 all frames came, 1 not, 2 usage, 3 no sandbox.\n\n"
                  "Examples:\n"
                  "  ggrade render mirror --solution --out out/mirror\n"
                  "  ggrade render uploads/ada --times 0,0.5,1 --out out/ada\n"
                  "  ggrade render --out out/homework --size 640x480 -- ./homework --fast");
  command->callback([options] { render(*options); });
}

} // namespace ggrade::cli
