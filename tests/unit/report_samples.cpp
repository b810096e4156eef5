#include "report_samples.hpp"

#include "image/difference.hpp"
#include "image/flip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace ggrade::report::samples {
namespace {

using Vec = std::array<double, 3>;
Vec operator+(Vec a, Vec b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vec operator-(Vec a, Vec b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vec operator*(Vec a, double s) {
  return {a[0] * s, a[1] * s, a[2] * s};
}
double dot(Vec a, Vec b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vec unit(Vec a) {
  return a * (1 / std::sqrt(dot(a, a)));
}

struct Ball {
  Vec centre, colour;
};

std::array<Ball, 6> balls(double time, double turn) {
  constexpr Vec kColours[] = {{.85, .3, .25}, {.9, .65, .2}, {.4, .7, .3},
                              {.25, .6, .75}, {.35, .4, .8}, {.7, .4, .7}};
  std::array<Ball, 6> ring;
  for (std::size_t i = 0; i < 6; ++i) {
    const double angle = double(i) * 1.0472 + turn + time * 0.3;
    const double hop = std::abs(std::sin(time * 2 + double(i)));
    ring[i] = {{1.5 * std::cos(angle), .42 + .5 * hop, 1.5 * std::sin(angle)}, kColours[i]};
  }
  return ring;
}

std::optional<Vec> shade(Vec from, Vec along, const std::array<Ball, 6>& ring, bool flat) {
  std::optional<Vec> colour;
  double nearest = 1e9;
  for (const Ball& ball : ring) {
    const Vec offset = from - ball.centre;
    const double b = dot(offset, along), c = dot(offset, offset) - .36 * .36, d = b * b - c;
    if (d < 0 || -b - std::sqrt(d) < 1e-4 || -b - std::sqrt(d) > nearest) continue;
    nearest = -b - std::sqrt(d);
    const Vec normal = unit(from + along * nearest - ball.centre), light = unit({.5, 1, .6});
    const double high = std::pow(std::max(0.0, dot(unit(light - along), normal)), 40);
    const double bright = flat ? .5 : .25 + .75 * std::max(0.0, dot(normal, light));
    colour = ball.colour * bright + Vec{1, 1, 1} * (flat ? 0 : .5 * high);
  }
  return colour;
}

Vec floorColour(Vec at, Vec along, const std::array<Ball, 6>& ring, Fault fault) {
  const bool dark = (int(std::floor(at[0] * 2)) + int(std::floor(at[2] * 2))) & 1;
  const Vec tile = dark ? Vec{.34, .36, .4} : Vec{.62, .63, .62};
  if (fault == Fault::noReflection) return tile;
  if (fault == Fault::shiftedReflection) at[0] += .25;
  const auto seen =
      shade(at, {along[0], -along[1], along[2]}, ring, fault == Fault::flatReflection);
  return seen ? tile * .45 + *seen * .55 : tile * .8 + Vec{.08, .1, .13};
}

results::Frame frame(Fault fault, double time, double turn, double wrong, int width, int height) {
  results::Frame made{time,
                      picture(fault, time, turn, width, height),
                      picture(Fault::none, time, turn, width, height),
                      {},
                      wrong};
  made.difference = differencePicture(made.student, made.reference);
  const Flip flip = ldrFlip(made.student, made.reference);
  made.flip = flip.mean;
  made.flipPicture = heatPicture(flip.map);
  return made;
}

results::Item item(const char* id, const char* title, const char* looksAt, results::ItemKind kind,
                   double points) {
  results::Item made;
  made.id = id, made.title = title, made.looksAt = looksAt, made.kind = kind, made.points = points;
  made.earned = kind == results::ItemKind::keep ? 0 : points;
  made.judged = true;
  made.credits = {{"public", 1, true}, {"hidden-low", 1}, {"hidden-many", 1}};
  made.message = "as good as the reference in 3 scenes";
  return made;
}

results::Result base() {
  results::Result result;
  result.assignment = "floor", result.part = "mirror";
  result.title = "Mirror reflection through a framebuffer object";
  result.outcome = results::Outcome::graded, result.maxScore = 100, result.seed = 8131,
  result.sandbox = "bwrap";
  result.timings = {
      {"build", .412}, {"public", .31}, {"hidden-low", .3}, {"hidden-many", .36}, {"judge", .12}};
  result.thresholds = {{"tolerance", 3.5 / 255}, {"radius", 1}};
  result.fingerprint = {{"renderer", "llvmpipe (LLVM 15.0.6, 256 bits)"},
                        {"version", "4.5 (Core Profile) Mesa 22.3.6"},
                        {"compiler", "g++ 12.2.0"},
                        {"ggrade", "0.1.0"}};
  result.items = {item("mirror.where", "The reflection is where it must be",
                       "the floor's pixels that see an object", results::ItemKind::gain, 35),
                  item("mirror.shading", "The reflection is lit from the right side",
                       "brightness over the reflected objects", results::ItemKind::gain, 30),
                  item("mirror.position", "The reflection touches its object",
                       "where object and reflection meet", results::ItemKind::gain, 20),
                  item("mirror.hidden", "Objects hide what is behind them",
                       "reflections behind objects", results::ItemKind::gain, 15),
                  item("mirror.keep", "Everything else stays",
                       "objects, floor and background away from reflections",
                       results::ItemKind::keep, 30),
                  item("mirror.blur", "The reflection is blurred",
                       "the width of edges in the reflection", results::ItemKind::bonus, 10)};
  result.items[3].beyondLecture = true;
  return result;
}

results::Result unjudged(results::Outcome outcome, const char* submission, const char* detail) {
  results::Result result = base();
  result.outcome = outcome, result.submission = submission, result.detail = detail;
  for (results::Item& one : result.items) {
    one.judged = false, one.earned = 0, one.message.clear(), one.credits.clear();
  }
  return result;
}

} // namespace

Image picture(Fault fault, double time, double turn, int width, int height) {
  Image image(width, height, 4, 1);
  const auto ring = balls(time, turn);
  const Vec eye{0, 2.4, 5.2}, forward = unit(Vec{0, -.42, -1}), right{1, 0, 0};
  const Vec up{0, -forward[2], forward[1]};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double u = (x + .5 - width / 2.0) / height, v = (height / 2.0 - y - .5) / height;
      const Vec along = unit(forward + right * u + up * v);
      Vec colour = Vec{.2, .26, .34} + Vec{.1, .12, .14} * (double(y) / height);
      const double reach = along[1] < 0 ? -eye[1] / along[1] : 1e9;
      const Vec hit = eye + along * reach;
      if (std::abs(hit[0]) < 3 && std::abs(hit[2]) < 3)
        colour = floorColour(hit, along, ring, fault);
      if (const auto seen = shade(eye, along, ring, false)) colour = *seen;
      for (int c = 0; c < 3; ++c) image.at(x, y, c) = float(std::min(1.0, colour[std::size_t(c)]));
    }
  return image;
}

results::Result perfect(int width, int height) {
  results::Result result = base();
  result.submission = "reference";
  result.score = 100, result.bonus = 10;
  const char* names[] = {"public", "hidden-low", "hidden-many"};
  for (int s = 0; s < 3; ++s) {
    results::Scene scene{names[s], s == 0, "graded", "", {}, {}, "", .3};
    for (const double time : {0.0, 2.5})
      scene.frames.push_back(frame(Fault::none, time, s * .4, 0, width, height));
    result.scenes.push_back(std::move(scene));
  }
  return result;
}

results::Result partial(int width, int height) {
  results::Result result = perfect(width, height);
  result.submission = "tanaka-42";
  result.score = 61.5, result.bonus = 0;
  const auto lose = [&](std::size_t i, double earned, const char* message, const char* cause,
                        const char* step) {
    results::Item& one = result.items[i];
    one.earned = earned, one.message = message, one.cause = cause, one.step = step;
    one.credits = {{"public", 1, true},
                   {"hidden-low", one.points > 0 ? std::max(0.0, earned) / one.points : 0},
                   {"hidden-many", .9}};
  };
  lose(1, 3,
       "In hidden-low 31.4% of the reflection's pixels differ by more than the tolerance, densest "
       "at (212, 340).",
       "The reflected objects are lit as if they stood above the floor: the normals or the light "
       "were not mirrored.",
       "Step 5: turn culling and normals");
  result.items[1].where = "hidden-low at 2.5 s, pixel (212, 340)";
  lose(3, 7.5, "7.9% of the pixels behind objects differ.",
       "What lies below the floor is not clipped.", "Step 6: clip at the floor");
  lose(4, -4, "0.8% of the pixels that must stay differ in the second frame.",
       "A state that the mirror pass changed is not restored.",
       "Step 2: draw into it and come back");
  lose(5, 0, "The reflection is sharp.", "", "Step 7: blur the reflection");
  for (std::size_t f = 0; f < 2; ++f) {
    const double time = f == 0 ? 0 : 2.5;
    result.scenes[1].frames[f] =
        frame(Fault::flatReflection, time, .4, .081 + .05 * double(f), width, height);
    result.scenes[2].frames[f] = frame(Fault::shiftedReflection, time, .8, .043, width, height);
  }
  result.scenes[1].messages = {
      "glDrawArrays: texture unit 1 is sampled while it is the render target (frame 2)"};
  result.scenes[1].output = "debug: camera at 1.25 0.9 3.75\n";
  result.scenes[1].detail = "Drawn with the camera at 1.25 0.9 3.75.";
  result.scenes[0].output = "warning: glossiness 0.0 is not used\n";
  result.unusedFiles = {"notes.txt: not among the files of this assignment",
                        "Makefile: not among the files of this assignment"};
  return result;
}

results::Result buildFailed() {
  results::Result result = unjudged(
      results::Outcome::buildFailed, "build-error",
      "Two errors in floor.cpp. Make it compile with the presets of the assignment first.");
  result.compilerOutput =
      "floor.cpp: In function 'void gg::run(gg::Window&, const gg::Scene&)':\n"
      "floor.cpp:42:5: error: 'mirrorFramebuffer' was not declared in this scope\n"
      "   42 |     mirrorFramebuffer.bind();\n      |     ^~~~~~~~~~~~~~~~~\n"
      "floor.cpp:57:19: error: expected ';' before '}' token\n"
      "   57 |   glEnable(GL_BLEND)\n      |                     ^\n      |                     ;\n"
      "floor.cpp:61:12: warning: unused variable 'size' [-Wunused-variable]\n";
  return result;
}

results::Result crashed() {
  results::Result result =
      unjudged(results::Outcome::crash, "crash",
               "Signal 11 (SIGSEGV) in the first frame of the scene public. A null "
               "pointer or an index out of range is likely.");
  result.scenes = {{"public",
                    true,
                    "crash",
                    "Signal 11 (SIGSEGV) in the first frame.",
                    {},
                    {},
                    "resources ready\n",
                    .2}};
  result.scenes[0].frames.push_back({0, {}, picture(Fault::none, 0), {}, 1});
  return result;
}

results::Result noFrame() {
  results::Result result =
      unjudged(results::Outcome::noFrame, "never-swaps",
               "The loop ran 400 times and drew 2400 times, but window.swapBuffers() "
               "is missing at its end.");
  result.scenes = {
      {"public", true, "no_frame", "", {{0, {}, picture(Fault::none, 0), {}, 1}}, {}, "", 5}};
  return result;
}

results::Result hostile() {
  const std::string evil =
      "<script>alert('x')</script>\"'&amp; \x1B[31mred\x1B[0m \x1B]0;title\a \xE2\x80\xAE"
      "gnp.exe \xFF\xC0\xAF \x01\x08 {{submission}} ]]>";
  std::string big;
  while (big.size() < (1 << 20)) big += evil + "\r\n";
  results::Result result = partial(64, 48);
  for (std::string* field : {&result.assignment, &result.part, &result.title, &result.submission,
                             &result.detail, &result.sandbox})
    *field = evil;
  for (results::Item& one : result.items) {
    for (std::string* field :
         {&one.id, &one.title, &one.looksAt, &one.message, &one.where, &one.cause, &one.step})
      *field = evil;
    one.credits = {{evil, .5}, {"public", .5, true}};
  }
  for (results::Scene& scene : result.scenes) {
    scene.outcome = scene.detail = evil;
    scene.messages = {evil};
    scene.output = big;
  }
  result.scenes[1].name = evil;
  result.compilerOutput = big;
  result.unusedFiles = {evil};
  result.timings = {{evil, .5}};
  result.thresholds = {{evil, .5}};
  result.fingerprint = {{evil, evil}};
  return result;
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

} // namespace ggrade::report::samples
