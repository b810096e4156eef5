#include "report/inspect.hpp"

#include "assignment/assignment.hpp"
#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/rendering.hpp"
#include "report/write_file.hpp"

#include <fmt/format.h>

namespace ggrade::cli {

namespace fs = std::filesystem;
using gg::say;

namespace {

struct InspectOptions {
  std::string id, folder, out, scene, size;
  double time = 0;
  std::vector<double> before;
  bool solution = false, steps = false;
};

/// Everything of every frame, and pictures of the first.
trace::Request requested(bool steps) {
  trace::Request request{};
  request.passes = 1;
  request.copies = request.windowCopies = request.renderbufferCopies = trace::kAllAttachments;
  request.stepCopies = steps;
  request.copyFrames = 1;
  request.times = 1;
  request.copyBytes = std::uint64_t{512} << 20;
  return request;
}

bool isWhole(const trace::Trace& trace) {
  return trace.passesLost + trace.stepsLost + trace.matricesLost + trace.samplesLost == 0;
}

/// The frame that is shown, and the same moment again: shaders are ready by then, and nothing is
/// copied, so that its passes' times are those of drawing. Where there is no room or time for two,
/// one.
grading::Rendering rendered(const InspectOptions& options, Progress& progress) {
  RenderTarget what;
  what.target = options.id;
  what.folder = options.folder;
  what.scene = options.scene;
  what.size = parseSize(options.size);
  what.times = momentsOf(options.before, {options.time, options.time}, "--time");
  what.solution = options.solution;
  what.trace = requested(options.steps);
  grading::Rendering rendering = renderTarget(what, progress);
  const bool late =
      rendering.happened.outcome == results::Outcome::timeout && !rendering.capture.frames.empty();
  if (!late && isWhole(rendering.capture.trace)) return rendering;
  what.times.shown.pop_back();
  return renderTarget(what, progress);
}

/// Gives the first frame the times of the second; false if there is none with the same passes.
bool takeTimes(trace::Trace& trace) {
  if (trace.frames.size() < 2 || trace.frames[0].passCount != trace.frames[1].passCount)
    return false;
  for (std::uint32_t i = 0; i < trace.frames[0].passCount; ++i)
    trace.passes[trace.frames[0].firstPass + i].seconds =
        trace.passes[trace.frames[1].firstPass + i].seconds;
  return true;
}

report::InspectedFrame frameOf(const InspectOptions& options, grading::Rendering rendering) {
  channel::Capture& capture = rendering.capture;
  report::InspectedFrame frame;
  frame.name = options.id;
  if (!options.folder.empty())
    frame.name += ", " + options.folder;
  else if (options.solution)
    frame.name += say(", the reference");
  frame.trace = std::move(capture.trace);
  frame.shadersTimed = !takeTimes(frame.trace);
  frame.time = options.time;
  frame.framesBefore = !options.before.empty();
  if (!capture.frames.empty()) {
    const channel::CapturedFrame& first = capture.frames.front();
    frame.width = first.width;
    frame.height = first.height;
    frame.boundFramebuffer = first.boundFramebuffer;
    frame.windowSrgb = first.windowSrgb;
  }
  frame.renderer = capture.glRenderer;
  if (!rendering.happened.ok()) frame.problem = rendering.happened.detail;
  const auto frames = std::uint32_t(std::max<std::size_t>(1, capture.frames.size()));
  for (const channel::CapturedMessage& message : capture.messages)
    if (message.kind != channel::MessageKind::capture) // counted over both frames
      frame.messages.push_back({message.text, (message.count + frames - 1) / frames, message.pass});
  frame.messagesLost = capture.messagesLost;
  return frame;
}

void inspect(const InspectOptions& options) {
  findTarget(assignmentsFolder(), options.id); // before anything else: is there such an ID?
  momentsOf(options.before, {options.time, options.time}, "--time");
  const fs::path out = options.out.empty() ? "out/inspect-" + options.id + ".html" : options.out;
  if (fs::is_directory(out))
    throw UsageError(say("{} is a folder: --out names the page's file", out.string()));

  Progress progress("inspect");
  grading::Rendering rendering = rendered(options, progress);
  const grading::Happened happened = rendering.happened;
  const report::InspectedFrame frame = frameOf(options, std::move(rendering));
  const bool anything = !frame.trace.passes.empty();
  if (anything || happened.ok()) {
    progress(say("writing the page"), 0, 1);
    report::makeFolder(fs::absolute(out).parent_path());
    report::writeFile(out, report::inspectPage(frame));
  }
  progress.clear();
  if (anything || happened.ok()) fmt::print("{}{}\n", report::inspectTable(frame), out.string());
  if (happened.ok()) return;
  std::fflush(stdout);
  fmt::print(stderr, "{}\n{}", happened.detail, happened.output);
  exitCode = kNotGradable;
}

} // namespace

void addInspect(CLI::App& app) {
  auto* command = app.add_subcommand(
      "inspect", say("Shows a frame pass by pass: a page with pictures and state"));
  sayHelp(*command);
  auto options = std::make_shared<InspectOptions>();
  command->add_option("ID", options->id, say("Assignment or part (see ggrade list)"))->required();
  command->add_option(
      "DIR", options->folder,
      say("A folder of files that go over the assignment's own; runs in the sandbox"));
  command->add_option("--out", options->out, say("The page's file (default out/inspect-ID.html)"));
  command->add_option("--scene", options->scene,
                      say("Another scene than the assignment's scene.json"));
  command->add_option("--size", options->size, say("WIDTHxHEIGHT in pixels"));
  command->add_option("--time", options->time, say("Seconds on the program's clock"))
      ->capture_default_str();
  declareBefore(*command, options->before);
  command->add_flag("--solution", options->solution,
                    say("The reference instead of the assignment's own files"));
  declareContext(*command, true);
  command->add_flag("--steps", options->steps, say("Pictures after every step of a pass too"));
  command->footer(say("The page needs nothing else: open it in a browser.\n"
                      "Exit codes: 0 the frame came, 1 not, 2 usage, 3 no sandbox.\n\n"
                      "Examples:\n"
                      "  ggrade inspect mirror\n"
                      "  ggrade inspect shadow uploads/ada --out out/ada.html\n"
                      "  ggrade inspect floor --time 2.1 --before 0.2,0.1\n"
                      "  ggrade inspect floor --solution --steps"));
  command->callback([options] { inspect(*options); });
}

} // namespace ggrade::cli
