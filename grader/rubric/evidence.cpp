#include "rubric/evidence.hpp"

#include "assignment/assignment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <future>

namespace ggrade::rubric {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

void write(const fs::path& path, const void* data, std::size_t size) {
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  if (!out.write(static_cast<const char*>(data), std::streamsize(size)) || !out.flush())
    throw UsageError(fmt::format("can't write {}: is the disk full?", path.string()));
}

Frames readImages(const json& folder) {
  return toImages(readFrames(folder.get<std::string>()));
}

} // namespace

void readStudent(SceneEvidence& scene, const fs::path& folder) {
  scene.student = readImages(folder.string());
  scene.studentTrace = trace::load(folder);
}

namespace {

SceneEvidence readScene(const json& from) {
  SceneEvidence scene;
  scene.name = from.at("name");
  scene.isPublic = from.at("public");
  scene.tags = from.at("tags").get<std::vector<std::string>>();
  scene.scene = from.at("scene");
  scene.like = from.at("like");
  scene.frameCount = from.at("frames");
  if (from.at("student") != "") readStudent(scene, from.at("student").get<std::string>());
  scene.reference = readImages(from.at("reference"));
  scene.stub = readImages(from.at("stub"));
  scene.referenceTrace = trace::load(from.at("reference").get<std::string>());
  scene.stubTrace = trace::load(from.at("stub").get<std::string>());
  for (const auto& [name, folder] : from.at("probes").items())
    scene.probes[name] = readImages(folder);
  return scene;
}

} // namespace

void writeFrames(const fs::path& folder, const std::vector<RawFrame>& frames) {
  fs::create_directories(folder);
  json list = json::array();
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const RawFrame& frame = frames[i];
    write(folder / fmt::format("frame-{}.rgba", i), frame.pixels.data(), frame.pixels.size());
    list.push_back({{"time", frame.time}, {"width", frame.width}, {"height", frame.height}});
  }
  // Last, so that a folder with frames.json is whole.
  const std::string text = list.dump();
  write(folder / "frames.json", text.data(), text.size());
}

std::vector<RawFrame> readFrames(const fs::path& folder) {
  std::vector<RawFrame> frames;
  for (const json& one : readJson(folder / "frames.json")) {
    RawFrame frame{one.at("time"), one.at("width"), one.at("height"), {}};
    const fs::path path = folder / fmt::format("frame-{}.rgba", frames.size());
    std::error_code error;
    const auto size = fs::file_size(path, error);
    if (error || size != std::size_t(frame.width) * frame.height * 4)
      throw UsageError(fmt::format("{}: {} bytes are not {}x{}x4", path.string(), error ? 0 : size,
                                   frame.width, frame.height));
    frame.pixels.resize(size);
    if (!std::ifstream(path, std::ios::binary)
             .read(reinterpret_cast<char*>(frame.pixels.data()), std::streamsize(size)))
      throw UsageError(fmt::format("can't read {}", path.string()));
    frames.push_back(std::move(frame));
  }
  return frames;
}

std::vector<Image> toImages(const std::vector<RawFrame>& frames) {
  std::vector<Image> images;
  for (const RawFrame& frame : frames) images.push_back(toImage(frame));
  return images;
}

Image toImage(const RawFrame& frame) {
  static const auto kValues = [] {
    std::array<float, 256> values;
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = float(i) / 255.0f;
    return values;
  }();
  Image image(int(frame.width), int(frame.height), 3);
  float* to = image.values().data();
  for (std::size_t i = 0; i < frame.pixels.size(); i += 4)
    for (std::size_t c = 0; c < 3; ++c) *to++ = kValues[frame.pixels[i + c]];
  return image;
}

bool SceneEvidence::has(const std::string& tag) const {
  return std::find(tags.begin(), tags.end(), tag) != tags.end();
}

void writeEvidence(const fs::path& file, const fs::path& assignmentFolder,
                   const std::string& target, const std::vector<SceneFolders>& scenes) {
  json list = json::array();
  for (const SceneFolders& scene : scenes) {
    json probes = json::object();
    for (const auto& [name, folder] : scene.probeFolders) probes[name] = folder.string();
    list.push_back({{"name", scene.name},
                    {"public", scene.isPublic},
                    {"tags", scene.tags},
                    {"scene", scene.scene},
                    {"like", scene.like},
                    {"frames", scene.times.shown.size()},
                    {"student", scene.student.string()},
                    {"reference", scene.reference.string()},
                    {"stub", scene.stub.string()},
                    {"probes", probes}});
  }
  const std::string text =
      json{{"assignment", assignmentFolder.string()}, {"target", target}, {"scenes", list}}.dump(1);
  write(file, text.data(), text.size());
}

void keepFirstFrames(Evidence& evidence) {
  const auto cut = [](Frames& frames) { frames.resize(std::min<std::size_t>(frames.size(), 1)); };
  for (SceneEvidence& scene : evidence.scenes) {
    scene.frameCount = std::min<std::size_t>(scene.frameCount, 1);
    for (Frames* frames : {&scene.student, &scene.reference, &scene.stub}) cut(*frames);
    for (auto& [name, frames] : scene.probes) cut(frames);
  }
}

Evidence readEvidence(const fs::path& file) {
  const json from = readJson(file);
  Evidence evidence{from.at("assignment").get<std::string>(), from.at("target"), {}, {}};
  const json& scenes = from.at("scenes");
  std::vector<std::future<SceneEvidence>> loading;
  for (const json& scene : scenes)
    loading.push_back(std::async(std::launch::async, [&scene] { return readScene(scene); }));
  for (auto& scene : loading) evidence.scenes.push_back(scene.get());
  return evidence;
}

Target targetOf(const Evidence& evidence) {
  const fs::path assignments = evidence.assignmentFolder.parent_path();
  addWords(assignments.parent_path() / "solutions" / evidence.assignmentFolder.filename());
  return findTarget(assignments, evidence.target);
}

} // namespace ggrade::rubric
