// Shadow volumes against shadow maps: the two solutions draw the same torus knot over the same
// floor, under the same lamp, from the same eye. What does a shadow cost, how many pixels are
// wrong, as the mesh and the window grow? Prints Markdown.
//
// A time is what the shadow adds to a frame: the median of all passes, less that of the same scene
// without shadows. Errors are the truths' `wrong pixels`. Every program draws with OSMesa, one
// thread, and the pins of every grading; what counts are the ratios.

#include "../../solutions/shadow_volume/volume.hpp"

#include "grading/program.hpp"
#include "grading/scenes.hpp"
#include "grading/workspace.hpp"
#include "report/write_file.hpp"
#include "truth/truth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>

namespace fs = std::filesystem;
using namespace ggrade;
using nlohmann::json;

namespace {

constexpr int kTriangles[] = {1000, 10000, 100000};
constexpr int kSides[] = {256, 512, 1024}; ///< of the window, pixels
constexpr unsigned kRounds = 3, kFrames = 8, kWarmUp = 2;

// The room of solutions/shadow_volume, which has its origin at the middle of the floor's front
// edge; the floor of solutions/floor has it in the middle.
constexpr double kWidth = 5.528, kDepth = 5.592;
constexpr double kLift = 0.5; ///< of the knot

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

/// A torus knot of about so many triangles, 1 high.
gg::MeshData knot(int triangles) {
  const int around = std::max(3, int(std::sqrt(triangles / 20.0)));
  return gg::torusKnot(triangles / (2 * around), around);
}

std::string objOf(const gg::MeshData& mesh) {
  std::string text;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::vec3 &p = mesh.positions[i], &n = mesh.normals[i];
    text += fmt::format("v {} {} {}\nvn {} {} {}\n", p.x, p.y, p.z, n.x, n.y, n.z);
  }
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    text += fmt::format("f {0}//{0} {1}//{1} {2}//{2}\n", mesh.indices[i] + 1,
                        mesh.indices[i + 1] + 1, mesh.indices[i + 2] + 1);
  return text;
}

/// As large as solutions/shadow_volume makes a mesh that is 1 high.
double fitOf(const gg::MeshData& mesh) {
  glm::vec3 low = mesh.positions.front(), high = low;
  for (const glm::vec3& p : mesh.positions) low = glm::min(low, p), high = glm::max(high, p);
  return std::min(3.3, 3.6 / double(std::max(high.x - low.x, high.z - low.z)));
}

/// One way to draw shadows.
struct Way {
  std::string name, program, part;
  json quality;
};

std::vector<Way> ways() {
  std::vector<Way> all;
  for (const int method : {0, 1})
    for (const int edges : {0, 1})
      all.push_back(
          {fmt::format("{}{}", method == 0 ? "z-pass" : "z-fail", edges == 0 ? "" : ", silhouette"),
           "shadow_volume",
           "shadow_volume",
           {{"method", method}, {"edges", edges}}});
  for (const int size : {256, 512, 1024, 2048, 4096})
    all.push_back({fmt::format("map {}", size), "floor", "shadow", {{"shadow_size", size}}});
  return all;
}

/// The knot over the floor, from above, so that nothing else is seen.
json sceneOf(const Way& way, const std::string& mesh, double fit, int side) {
  const bool isRoom = way.program == "shadow_volume";
  const double middle = isRoom ? kDepth / 2 : 0; // of the floor, z
  json patch = {{"size", {side, side}},
                {"mesh", mesh},
                {"quality", way.quality},
                {"camera",
                 {{"position", {0, 11, middle - 3}},
                  {"target", {0, 0.6, middle}},
                  {"up", {0, 1, 0}},
                  {"fov", 0.42},
                  {"near", 1},
                  {"far", 20}}},
                {"light", {{"position", {0.9, 5.2, middle - 1.2}}}}};
  if (isRoom)
    patch.update({{"caster", {{"lift", kLift}, {"turn", 0}}}, {"orbit", {{"radius", 0}}}});
  else
    patch.update(
        {{"ring", {{"count", 1}, {"radius", 0}, {"hop", 0}, {"base", kLift}, {"scale", fit}}},
         {"floor", {{"width", kWidth}, {"depth", kDepth}}}});
  json scene = grading::partScene(
      Assignment::load(fs::path(GGRADE_SOURCE_DIR) / "assignments" / way.program), {way.part});
  scene.merge_patch(patch);
  return scene;
}

json unshadowed(json scene) {
  scene["effects"]["shadow"] = false;
  return scene;
}

/// Compiled shaders, kept between runs.
const fs::path& shaders() {
  static const grading::TemporaryFolder folder;
  return folder.path();
}

grading::Rendering render(const Way& way, const json& scene, unsigned frames,
                          const trace::Request& request) {
  const fs::path program = fs::path(GGRADE_BUILD_DIR) / "solutions" / way.program;
  const auto run = [&] {
    return grading::renderScene(way.program, program, scene, std::vector<double>(frames, 0.0),
                                {shaders()}, sandbox::Isolation::none, request);
  };
  grading::Rendering rendering = run();
  // Neither solution hangs: the machine was busy for a while.
  if (rendering.happened.outcome == results::Outcome::timeout) rendering = run();
  if (!rendering.happened.ok())
    throw std::runtime_error(way.name + ": " + rendering.happened.detail + "\n" +
                             rendering.happened.output);
  return rendering;
}

/// Milliseconds of whole frames.
std::vector<double> frames(const Way& way, const json& scene) {
  trace::Request request{};
  request.passes = request.times = 1;
  const trace::Trace trace = render(way, scene, kWarmUp + kFrames, request).capture.trace;
  std::vector<double> all;
  for (std::size_t i = kWarmUp; i < trace.frames.size(); ++i) {
    double seconds = 0;
    for (const trace::PassRecord& pass : trace.passesOf(i)) seconds += pass.seconds;
    all.push_back(1000 * seconds);
  }
  return all;
}

double wrongPixels(const Way& way, const json& scene) {
  const grading::Rendering rendering = render(way, scene, 1, {});
  const channel::CapturedFrame& frame = rendering.capture.frames.at(0);
  const truth::Judgement answer = truth::judgeOf(way.part)(
      {scene, 0, Image::fromBytes(frame.pixels, int(frame.width), int(frame.height))});
  if (answer.errors.at(0).name != "wrong pixels") throw std::logic_error("another error is first");
  return answer.errors.at(0).value;
}

struct Figure {
  double ms = 0, wrong = 0;
};

/// All ways by turns.
std::vector<Figure> measure(const std::vector<Way>& all, const std::string& mesh, double fit,
                            int side) {
  std::vector<std::vector<double>> costs(all.size());
  for (unsigned round = 0; round < kRounds; ++round)
    for (std::size_t i = 0; i < all.size(); ++i) {
      const json scene = sceneOf(all[i], mesh, fit, side);
      const double without = median(frames(all[i], unshadowed(scene)));
      for (const double ms : frames(all[i], scene)) costs[i].push_back(ms - without);
    }
  std::vector<Figure> figures;
  for (std::size_t i = 0; i < all.size(); ++i)
    figures.push_back({median(costs[i]), wrongPixels(all[i], sceneOf(all[i], mesh, fit, side))});
  return figures;
}

/// Milliseconds to find the silhouette of a mesh; a lamp that moves costs so much a frame.
double silhouetteMs(gg::MeshData mesh) {
  std::vector<std::string> warnings;
  const ClosedMesh closed = closedMesh(mesh, warnings);
  std::vector<double> all;
  for (int i = 0; i < 5; ++i) {
    const auto start = std::chrono::steady_clock::now();
    if (silhouetteVolume(closed, {1, 2, 3}).indices.empty()) throw std::logic_error("no volume");
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    all.push_back(took.count());
  }
  return median(all);
}

/// The cheapest way of at most so many wrong pixels.
std::string cheapest(const std::vector<Way>& all, const std::vector<Figure>& figures,
                     double limit) {
  const Figure* best = nullptr;
  for (const Figure& figure : figures)
    if (figure.wrong <= limit && (!best || figure.ms < best->ms)) best = &figure;
  return best
             ? fmt::format("{} ({:.2f} ms)", all[std::size_t(best - figures.data())].name, best->ms)
             : "none";
}

} // namespace

int main() {
  const std::vector<Way> all = ways();
  const grading::TemporaryFolder work;
  std::string head = "| triangles | pixels |", line = "| --- | --- |", silhouettes,
              best = "| triangles | pixels | none wrong | at most 0.1% | at most 1% |\n"
                     "| --- | --- | --- | --- | --- |\n";
  for (const Way& way : all) head += " " + way.name + " |", line += " --- |";
  std::cout << "What a shadow adds to a frame, and the share of wrong pixels:\n\n"
            << head << '\n'
            << line << std::endl;
  for (const int wanted : kTriangles) {
    const gg::MeshData mesh = knot(wanted);
    const std::size_t triangles = mesh.indices.size() / 3;
    const fs::path file = work.path() / fmt::format("knot-{}.obj", triangles);
    report::writeFile(file, objOf(mesh));
    silhouettes += fmt::format("The silhouette of {} triangles is found in {:.2f} ms.\n", triangles,
                               silhouetteMs(mesh));
    for (const int side : kSides) {
      const std::vector<Figure> figures = measure(all, file.string(), fitOf(mesh), side);
      const std::string row = fmt::format("| {} | {} x {} |", triangles, side, side);
      std::cout << row;
      for (const Figure& figure : figures)
        std::cout << fmt::format(" {:.2f} ms, {:.3f}% |", figure.ms, 100 * figure.wrong);
      std::cout << std::endl;
      best += row;
      for (const double limit : {0.0, 0.001, 0.01})
        best += " " + cheapest(all, figures, limit) + " |";
      best += "\n";
    }
  }
  std::cout << "\nThe cheapest way:\n\n" << best << '\n' << silhouettes;
}
