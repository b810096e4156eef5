#include "cli/commands.hpp"

#include "cli/help.hpp"
#include "cli/rendering.hpp"
#include "cli/terminal.hpp"
#include "grading/references.hpp"
#include "grading/workspace.hpp"
#include "image/png.hpp"
#include "report/pass_files.hpp"
#include "report/write_file.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <iostream>
#include <sstream>

#include <unistd.h>

namespace ggrade::cli {

namespace fs = std::filesystem;
using gg::say;
using nlohmann::json;

namespace {

struct RenderOptions {
  std::string target, folder, out, scene, size;
  std::vector<double> times = {0}, before;
  bool solution = false, json = false;
  bool passes = false, steps = false, passTimes = false, raw = false;
};

trace::Request requested(const RenderOptions& options) {
  trace::Request request{};
  if (!options.passes) return request;
  request.passes = 1;
  request.copies = request.windowCopies = request.renderbufferCopies = trace::kAllAttachments;
  request.stepCopies = options.steps;
  request.copyFrames = std::uint32_t(options.times.size());
  request.times = options.passTimes;
  request.copyBytes = std::uint64_t{1} << 30;
  return request;
}

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
  throw UsageError(say("there is no program {}: name one that can be run", name));
}

json trace(const grading::Rendering& rendering, const std::vector<trace::CopyFiles>& files) {
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
  json all = {{"version", 1},
              {"rows", "top first"},
              {"values", "as stored in the window, 8 bits a channel"},
              {"outcome", results::name(rendering.happened.outcome)},
              {"context", grading::drawing().context},
              {"gl_version", capture.glVersion},
              {"gl_renderer", capture.glRenderer},
              {"context_seconds", capture.contextSeconds},
              {"shader_seconds", capture.shaderSeconds},
              {"frames", frames},
              {"messages", messages}};
  if (capture.trace.frames.empty() && capture.trace.passes.empty()) return all;
  for (std::size_t i = 0; i < capture.trace.frames.size(); ++i) {
    const trace::FrameTrace& frame = capture.trace.frames[i];
    all["frames"][i].update({{"first_pass", frame.firstPass},
                             {"pass_count", frame.passCount},
                             {"image_bytes", frame.imageBytes},
                             {"buffer_bytes", frame.bufferBytes}});
  }
  for (std::size_t i = 0; i < capture.messages.size(); ++i)
    if (capture.messages[i].pass != trace::kNone)
      all["messages"][i]["pass"] = capture.messages[i].pass;
  all["pass_values"] = "as stored, an sRGB attachment's decoded to linear";
  all.update(trace::toJson(capture.trace, files));
  return all;
}

/// What there was no room for, in words; empty if nothing is missing.
std::string lostText(const trace::Trace& trace) {
  const std::pair<std::string_view, std::uint32_t> tables[] = {
      {gg::tag("passes"), trace.passesLost},
      {gg::tag("steps"), trace.stepsLost},
      {gg::tag("matrix uniforms"), trace.matricesLost},
      {gg::tag("uses of textures"), trace.samplesLost},
      {gg::tag("pictures"), trace.copiesLost}};
  std::string text;
  for (const auto& [what, count] : tables)
    if (count > 0)
      text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", gg::words(what), count);
  return text;
}

void render(const RenderOptions& options) {
  const fs::path out = outputFolder(options.out);
  const grading::Moments moments = momentsOf(options.before, options.times, "--times");
  Progress progress("render");
  if (afterDashes.empty() == options.target.empty())
    throw UsageError(say("name either an assignment or folder, or a program after --; see ggrade "
                         "render --help"));
  const Size size = parseSize(options.size);
  if (!afterDashes.empty()) afterDashes[0] = findProgram(afterDashes[0]);
  const grading::Rendering rendering =
      afterDashes.empty() ? renderTarget({options.target, options.scene, size, moments,
                                          options.solution, requested(options), options.folder},
                                         progress)
                          : grading::renderProgram(afterDashes, moments, size.width, size.height,
                                                   requested(options));
  progress.clear();

  grading::TemporaryFolder work(fs::absolute(out).parent_path());
  const auto frames = grading::rawFrames(rendering.capture);
  for (std::size_t i = 0; i < frames.size(); ++i)
    writePng(work.path() / fmt::format("frame-{}.png", i), rubric::toImage(frames[i]));
  const trace::Trace& passes = rendering.capture.trace;
  const json trace =
      cli::trace(rendering, report::writePassFiles(passes, work.path(), options.raw));
  report::writeFile(work.path() / "trace.json", trace.dump(2) + '\n');
  work.publish(out);

  if (options.json) {
    std::cout << trace.dump(2) << '\n';
  } else {
    const results::Outcome outcome = rendering.happened.outcome;
    fmt::print("{}{}\n",
               outcome == results::Outcome::graded ? ""
                                                   : fmt::format("{}: ", results::name(outcome)),
               frames.size() == 1 ? say("1 frame in {}", out.string())
                                  : say("{} frames in {}", frames.size(), out.string()));
    if (options.passes)
      fmt::print("{}\n",
                 say("{} passes, {} pictures of them", passes.passes.size(), passes.copies.size()));
    if (const std::string lost = lostText(passes); !lost.empty())
      fmt::print("{}\n", say("not recorded, for lack of room: {}", lost));
    for (const channel::CapturedMessage& message : rendering.capture.messages)
      if (message.kind != channel::MessageKind::capture)
        fmt::print("  {}\n", say("frame {}: {}", message.frame, message.text));
  }
  if (rendering.happened.outcome != results::Outcome::graded) {
    std::fflush(stdout);
    fmt::print(stderr, "{}\n{}", rendering.happened.detail, rendering.happened.output);
  }
  if (!rendering.happened.ok()) exitCode = kNotGradable;
}

} // namespace

void addRender(CLI::App& app) {
  auto* command =
      app.add_subcommand("render", say("Renders frames offscreen: images and trace.json"));
  sayHelp(*command);
  auto options = std::make_shared<RenderOptions>();
  command->add_option(
      "TARGET", options->target,
      say("An assignment or part (its files in assignments/), or a folder of files"));
  command->add_option(
      "DIR", options->folder,
      say("A folder of files that go over the assignment's own; runs in the sandbox"));
  command->add_option("--out", options->out, say("Where frame-N.png and trace.json go"))
      ->required();
  command->add_option("--scene", options->scene,
                      say("Another scene than the assignment's scene.json"));
  command->add_option("--size", options->size, say("WIDTHxHEIGHT in pixels"));
  command->add_option("--times", options->times, say("Seconds, separated by commas"))
      ->delimiter(',')
      ->capture_default_str();
  declareBefore(*command, options->before);
  command->add_flag("--solution", options->solution,
                    say("The reference instead of the assignment's own files"));
  auto* passes =
      command->add_flag("--passes", options->passes,
                        say("Every pass too: in trace.json, and a picture of what it left in each "
                            "attachment, frame-N/pass-PP-color0.png"));
  command->add_flag("--steps", options->steps, say("A picture after every step of a pass too"))
      ->needs(passes);
  command
      ->add_flag("--pass-times", options->passTimes,
                 say("Measure every pass; the whole then takes longer"))
      ->needs(passes);
  command
      ->add_flag(
          "--raw", options->raw,
          say("The values of each picture too, as 4-byte floats: frame-N/pass-PP-color0.f32"))
      ->needs(passes);
  declareContext(*command, true);
  command->add_flag("--json", options->json, say("Print trace.json on stdout"));
  command->footer(say("After -- stands any GLFW program with its arguments, run as it is.\n"
                      "Exit codes: 0 all frames came, 1 not, 2 usage, 3 no sandbox.\n\n"
                      "Examples:\n"
                      "  ggrade render mirror --out out/mirror\n"
                      "  ggrade render floor --passes --out out/floor\n"
                      "  ggrade render uploads/ada --times 0,0.5,1 --out out/ada\n"
                      "  ggrade render floor --times 2.1 --before 0.2,0.1 --out out/later\n"
                      "  ggrade render --out out/homework --size 640x480 -- ./homework --fast"));
  command->callback([options] { render(*options); });
}

} // namespace ggrade::cli
