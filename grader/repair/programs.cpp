#include "repair/programs.hpp"

#include "repair/glsl.hpp"

#include <algorithm>

namespace ggrade::repair {

using nlohmann::json;

namespace {

/// A program with so many of another's lines is a changed one of it.
constexpr double kAlike = 0.5;

std::set<std::string> linesIn(const std::vector<std::vector<std::byte>>& blobs, const json& stage) {
  const auto& bytes = blobs.at(stage.at("blob").get<std::size_t>());
  return linesOf({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

} // namespace

void Programs::addOwn(const json& commands) {
  for (const json& command : commands)
    if (command.contains("program")) own_.insert(command["program"]);
}

void Programs::addReferences(const json& commands) {
  for (const json& command : commands)
    if (command.at("op") == "draw")
      for (const json& stage : command.at("program").at("stages")) stages_.insert(stage);
}

bool Programs::isForSomethingElse(const json& program, const json& wanted) const {
  const json& right = wanted.at("stages");
  return std::ranges::any_of(program.at("stages"), [&](const json& stage) {
    return std::ranges::find(right, stage) == right.end() && stages_.contains(stage);
  });
}

const json* Programs::likest(const json& wanted) {
  const auto [known, isNew] = likest_.try_emplace(wanted.at("stages"), nullptr);
  if (!isNew) return known->second;
  double best = kAlike;
  for (const json& program : own_) {
    const double likeness = likenessOf(program, wanted);
    if (likeness < best || isForSomethingElse(program, wanted)) continue;
    best = likeness;
    known->second = &program;
  }
  return known->second;
}

double Programs::likenessOf(const json& program, const json& wanted) const {
  std::size_t all = 0, found = 0;
  for (const json& stage : wanted.at("stages")) {
    const auto lines = linesIn(blobs_, stage);
    all += lines.size();
    for (const json& own : program.at("stages")) {
      if (own.at("stage") != stage.at("stage")) continue;
      const auto ownLines = linesIn(blobs_, own);
      found += std::size_t(std::ranges::count_if(
          lines, [&](const std::string& line) { return ownLines.contains(line); }));
    }
  }
  return all == 0 ? 0 : double(found) / double(all);
}

} // namespace ggrade::repair
