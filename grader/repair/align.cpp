#include "repair/align.hpp"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>

namespace ggrade::repair {

using nlohmann::json;

namespace {

bool drawsOrClears(const json& command) {
  const json& op = command.at("op");
  return op == "draw" || op == "clear" || op == "clearBuffer";
}

bool movesPixels(const json& command) {
  const json& op = command.at("op");
  return op == "blit" || op == "copy" || op == "copyImage" || op == "mipmap";
}

/// Longer rows than this are not compared: the table has this many squared.
constexpr std::size_t kLongest = 2000;

/// The longest common subsequence of 0 to a-1 and 0 to b-1, as pairs.
std::vector<std::pair<std::size_t, std::size_t>>
common(std::size_t a, std::size_t b, const std::function<bool(std::size_t, std::size_t)>& alike) {
  if (a > kLongest || b > kLongest) throw std::runtime_error("it draws too often to be compared");
  std::vector<std::vector<std::size_t>> length(a + 1, std::vector<std::size_t>(b + 1, 0));
  for (std::size_t i = a; i-- > 0;)
    for (std::size_t k = b; k-- > 0;)
      length[i][k] =
          alike(i, k) ? length[i + 1][k + 1] + 1 : std::max(length[i + 1][k], length[i][k + 1]);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0, k = 0; i < a && k < b;) {
    if (alike(i, k) && length[i][k] == length[i + 1][k + 1] + 1)
      pairs.emplace_back(i++, k++);
    else if (length[i + 1][k] >= length[i][k + 1])
      ++i;
    else
      ++k;
  }
  return pairs;
}

/// What a draw draws, whatever it draws it with; of other commands what they are.
json meshOf(const json& draw) {
  if (draw.at("op") != "draw") return draw.at("op");
  json mesh = {draw.at("mode"), draw.at("calls"), draw.at("instances")};
  json blobs = json::array();
  for (const auto& [name, columns] : draw.at("attributes").items())
    for (const json& column : columns) blobs.push_back(column.value("blob", json()));
  std::sort(blobs.begin(), blobs.end());
  blobs.erase(std::unique(blobs.begin(), blobs.end()), blobs.end());
  mesh.push_back(blobs);
  if (draw.contains("indices")) mesh.push_back(draw["indices"]);
  return mesh;
}

std::vector<json> meshesOf(const json& commands, const Pass& pass) {
  std::vector<json> meshes;
  for (const std::size_t i : pass.commands) meshes.push_back(meshOf(commands[i]));
  return meshes;
}

/// Passes are alike that draw into the window, or into attachments of the same points.
bool alikePasses(const json& a, const json& b) {
  if (!drawsOrClears(a)) return a.at("op") == b.at("op");
  if (!drawsOrClears(b)) return false;
  const json &one = a.at("target"), &other = b.at("target");
  const bool window = one.contains("window");
  if (window != other.contains("window")) return false;
  if (window) return true;
  const auto hasColor = [](const json& target) {
    const json& buffers = target.at("drawBuffers");
    return std::ranges::any_of(buffers, [](const json& buffer) { return !buffer.is_null(); });
  };
  return hasColor(one) == hasColor(other);
}

std::size_t draws(const json& commands, const Pass& pass) {
  return std::size_t(std::ranges::count_if(
      pass.commands, [&](std::size_t i) { return commands[i].at("op") == "draw"; }));
}

} // namespace

std::vector<Pass> passesOf(const json& commands) {
  std::vector<Pass> passes;
  std::size_t frame = 0, ordinal = 0;
  const json* target = nullptr; ///< of the open pass
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const json& command = commands[i];
    if (command.at("op") == "swap") {
      ++frame;
      ordinal = 0;
      target = nullptr;
    } else if (drawsOrClears(command)) {
      const bool goesOn = target && *target == command.at("target") &&
                          (command.at("op") == "draw" || draws(commands, passes.back()) == 0);
      if (!goesOn) passes.push_back({frame, ordinal++, {}});
      passes.back().commands.push_back(i);
      target = &command.at("target");
    } else if (movesPixels(command)) {
      passes.push_back({frame, ordinal++, {i}});
      target = nullptr;
    }
  }
  return passes;
}

std::vector<PassPair> align(const json& one, const json& other) {
  const std::vector<Pass> a = passesOf(one), b = passesOf(other);
  const auto alike = [&](std::size_t i, std::size_t k) {
    return a[i].frame == b[k].frame && alikePasses(one[a[i].commands[0]], other[b[k].commands[0]]);
  };
  std::vector<PassPair> pairs;
  for (const auto& [i, k] : common(a.size(), b.size(), alike)) {
    PassPair pair{a[i], b[k], {}};
    const auto &from = a[i].commands, &to = b[k].commands;
    std::size_t x = 0, y = 0;
    const std::vector<json> meshes = meshesOf(one, a[i]), others = meshesOf(other, b[k]);
    const auto same = common(from.size(), to.size(),
                             [&](std::size_t p, std::size_t q) { return meshes[p] == others[q]; });
    const auto alone = [&](std::size_t endX, std::size_t endY) {
      for (; x < endX; ++x) pair.commands.push_back({from[x], {}});
      for (; y < endY; ++y) pair.commands.push_back({{}, to[y]});
    };
    for (const auto& [p, q] : same) {
      alone(p, q);
      pair.commands.push_back({from[x++], to[y++]});
    }
    alone(from.size(), to.size());
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

} // namespace ggrade::repair
