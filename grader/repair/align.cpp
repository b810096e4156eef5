#include "repair/align.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>

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

/// Pairs of 0 to a-1 and 0 to b-1 in order, so that the sum of `weight` (0: no pair) is largest.
std::vector<std::pair<std::size_t, std::size_t>>
common(std::size_t a, std::size_t b, const std::function<int(std::size_t, std::size_t)>& weight) {
  if (a > kLongest || b > kLongest) throw std::runtime_error("it draws too often to be compared");
  std::vector<std::vector<int>> sum(a + 1, std::vector<int>(b + 1, 0));
  std::vector<std::vector<std::uint8_t>> weights(a, std::vector<std::uint8_t>(b, 0));
  for (std::size_t i = a; i-- > 0;)
    for (std::size_t k = b; k-- > 0;) {
      const int one = weight(i, k);
      weights[i][k] = std::uint8_t(one);
      sum[i][k] = std::max({sum[i + 1][k], sum[i][k + 1], one > 0 ? sum[i + 1][k + 1] + one : 0});
    }
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0, k = 0; i < a && k < b;) {
    if (weights[i][k] > 0 && sum[i][k] == sum[i + 1][k + 1] + weights[i][k])
      pairs.emplace_back(i++, k++);
    else if (sum[i + 1][k] >= sum[i][k + 1])
      ++i;
    else
      ++k;
  }
  return pairs;
}

/// What a command draws into, in a few words.
std::string placeOf(const json& command) {
  if (!command.contains("target")) return "image";
  const json& target = command["target"];
  if (target.contains("window")) return "window";
  return std::ranges::any_of(target.at("drawBuffers"),
                             [](const json& buffer) { return !buffer.is_null(); })
             ? "color"
             : "depth";
}

/// A command as it is compared with others.
struct Seen {
  bool isDraw;
  json mesh;
  std::string place;
  json shaders;
  Seen(const json& command)
      : isDraw(command.at("op") == "draw"), mesh(meshOf(command)), place(placeOf(command)),
        shaders(command.contains("program") ? command["program"].at("stages") : json()) {}
};

bool shareShader(const Seen& a, const Seen& b) {
  return std::ranges::any_of(a.shaders, [&](const json& stage) {
    return std::ranges::find(b.shaders, stage) != b.shaders.end();
  });
}

/// 0: not the same. What is drawn counts first, then where, then with which shaders. What draws
/// another mesh there, in part with the same shaders, is the same if nothing else is.
int likeness(const Seen& a, const Seen& b) {
  if (a.mesh == b.mesh) return 16 + 2 * (a.place == b.place) + (a.shaders == b.shaders);
  return a.isDraw && b.isDraw && a.place == b.place && shareShader(a, b);
}

std::size_t draws(const json& commands, const Pass& pass) {
  return std::size_t(std::ranges::count_if(
      pass.commands, [&](std::size_t i) { return commands[i].at("op") == "draw"; }));
}

} // namespace

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

std::string shadersOf(const std::vector<std::vector<std::byte>>& blobs, const json& command) {
  std::string shaders;
  if (command.contains("program"))
    for (const json& stage : command["program"].at("stages")) {
      const auto& source = blobs.at(stage.at("blob").get<std::size_t>());
      shaders +=
          fmt::format(" {:x}", std::hash<std::string_view>()(
                                   {reinterpret_cast<const char*>(source.data()), source.size()}));
    }
  return shaders;
}

std::string roleOf(const std::vector<std::vector<std::byte>>& blobs, const json& commands,
                   const Pass& pass) {
  std::set<std::string> parts;
  for (const std::size_t i : pass.commands)
    parts.insert(commands[i].at("op").get<std::string>() + shadersOf(blobs, commands[i]));
  if (parts.size() > 1) parts.erase("clear"); // cleared by itself or with the rest
  return fmt::format("{}: {}", placeOf(commands[pass.commands.front()]), fmt::join(parts, ", "));
}

std::string drawRole(const std::vector<std::vector<std::byte>>& blobs, const json& draw) {
  return fmt::format("{}: draw{}", placeOf(draw), shadersOf(blobs, draw));
}

std::vector<PassPair> align(const json& one, const json& other) {
  const std::vector<Pass> a = passesOf(one), b = passesOf(other);
  std::vector<PassPair> pairs;
  for (const Pass& pass : b) pairs.push_back({pass, {}});
  std::vector<std::size_t> swaps;
  for (std::size_t i = 0; i < one.size(); ++i)
    if (one[i].at("op") == "swap") swaps.push_back(i);
  std::size_t frames = 0;
  for (const auto* passes : {&a, &b})
    for (const Pass& pass : *passes) frames = std::max(frames, pass.frame + 1);
  for (std::size_t frame = 0; frame < frames; ++frame) {
    std::vector<std::size_t> from, to, passOf; // passOf: index in `pairs`
    for (const Pass& pass : a)
      if (pass.frame == frame) from.insert(from.end(), pass.commands.begin(), pass.commands.end());
    for (std::size_t i = 0; i < b.size(); ++i)
      if (b[i].frame == frame)
        for (const std::size_t command : b[i].commands) {
          to.push_back(command);
          passOf.push_back(i);
        }
    if (to.empty()) continue;
    std::vector<Seen> drawn, wanted;
    for (const std::size_t i : from) drawn.emplace_back(one[i]);
    for (const std::size_t i : to) wanted.emplace_back(other[i]);
    std::size_t x = 0, y = 0;
    const auto alone = [&](std::size_t endX, std::size_t endY) {
      // What the first alone draws stands in the pass that it comes before.
      for (; x < endX; ++x)
        pairs[passOf[std::min(endY, to.size() - 1)]].commands.push_back({from[x], {}});
      std::optional<std::size_t> before;
      if (x < from.size())
        before = from[x];
      else if (frame < swaps.size())
        before = swaps[frame];
      for (; y < endY; ++y) pairs[passOf[y]].commands.push_back({{}, to[y], before});
    };
    for (const auto& [p, q] : common(from.size(), to.size(), [&](std::size_t p, std::size_t q) {
           return likeness(drawn[p], wanted[q]);
         })) {
      alone(p, q);
      pairs[passOf[y]].commands.push_back({from[x++], to[y]});
      ++y;
    }
    alone(from.size(), to.size());
  }
  return pairs;
}

} // namespace ggrade::repair
