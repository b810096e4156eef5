#include "generated/mutants.hpp"

#include "authoring/solution_blocks.hpp"
#include "generated/chance.hpp"
#include "generated/operators.hpp"
#include "grading/workspace.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

namespace ggrade::generated {

namespace fs = std::filesystem;
using authoring::BlockLine;
using authoring::codeLength;
using authoring::isPlainStatement;

namespace {

/// Everything that could be drawn: by TODO, then by kind of change.
using Places = std::map<std::string, std::map<std::string, std::vector<Mutant>>>;

bool isStatement(const BlockLine& line) {
  return !line.marker && isPlainStatement(line.text);
}

/// The strings of a file's code.
std::set<std::string> namesIn(const std::vector<BlockLine>& lines) {
  static const std::regex kName(R"re("([A-Za-z]\w*)")re");
  std::set<std::string> names;
  for (const BlockLine& line : lines)
    for (std::sregex_iterator match(line.text.begin(), line.text.end(), kName), end; match != end;
         ++match)
      names.insert((*match)[1]);
  return names;
}

class Drawing {
public:
  Drawing(const Part& part) {
    for (const Todo& todo : part.todos) todos_.insert(todo.id);
  }

  void add(const std::string& file, const std::vector<BlockLine>& lines) {
    const std::set<std::string> names = namesIn(lines);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const BlockLine& line = lines[i];
      if (line.marker || !todos_.count(line.todo)) continue;
      const auto put = [&](const std::string& change, std::vector<std::string> before,
                           std::vector<std::string> after) {
        if (before != after)
          places_[line.todo][change].push_back(
              {line.todo, file, int(i) + 1, change, std::move(before), std::move(after)});
      };
      if (line.text.find_first_not_of(' ') == codeLength(line.text)) continue; // a comment
      for (const Operator& one : operators())
        for (std::string& after : one.apply(line.text))
          put(one.name, {line.text}, {std::move(after)});
      for (const std::string& name : names)
        for (const std::string& other : names)
          if (const auto at = line.text.find('"' + name + '"');
              at != line.text.npos && at < codeLength(line.text))
            put("another name", {line.text},
                {line.text.substr(0, at + 1) + other + line.text.substr(at + 1 + name.size())});
      if (!isStatement(line)) continue;
      if (i + 1 < lines.size() && isStatement(lines[i + 1]) && lines[i + 1].todo == line.todo)
        put("exchanges two statements", {line.text, lines[i + 1].text},
            {lines[i + 1].text, line.text});
      for (const BlockLine& other : lines)
        if (isStatement(other) && !other.todo.empty() && other.todo != line.todo)
          put("a statement of another step", {line.text}, {line.text, other.text});
    }
  }

  Mutant draw(Chance& chance) const {
    const auto& changes = anyOf(places_, chance);
    return chance.of(anyOf(changes, chance));
  }

  std::size_t count() const {
    std::size_t sum = 0;
    for (const auto& [todo, changes] : places_)
      for (const auto& [change, all] : changes) sum += all.size();
    return sum;
  }

private:
  template <class Map>
  static const typename Map::mapped_type& anyOf(const Map& map, Chance& chance) {
    return std::next(map.begin(), std::ptrdiff_t(chance.below(map.size())))->second;
  }

  std::set<std::string> todos_;
  Places places_;
};

} // namespace

std::vector<Mutant> drawMutants(const Assignment& assignment, const Part& part,
                                const fs::path& solutionFolder, std::size_t count,
                                std::uint64_t seed) {
  Drawing drawing(part);
  for (const std::string& file : assignment.files)
    if (const fs::path path = solutionFolder / file; fs::is_regular_file(path))
      drawing.add(file, authoring::blockLines(readFile(path), path.string()));
  Chance chance(seed, "wrong " + part.id);
  std::vector<Mutant> drawn;
  // The rare kinds are used up first; so many draws find the last of the others, or nearly.
  const std::size_t most = std::min(count, drawing.count());
  for (std::size_t tries = 0; drawn.size() < most && tries < 200 * count; ++tries)
    if (Mutant mutant = drawing.draw(chance); std::ranges::find(drawn, mutant) == drawn.end())
      drawn.push_back(std::move(mutant));
  return drawn;
}

std::string withChange(const std::string& text, const Mutant& mutant) {
  std::istringstream in(text);
  std::string out;
  std::size_t number = 0;
  const auto first = std::size_t(mutant.line), last = first + mutant.before.size();
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (number < first || number >= last) {
      out += line + '\n';
      continue;
    }
    if (line != mutant.before[number - first])
      throw std::invalid_argument(
          fmt::format("{}:{} isn't \"{}\"", mutant.file, number, mutant.before[number - first]));
    if (number + 1 == last)
      for (const std::string& other : mutant.after) out += other + '\n';
  }
  if (number + 1 < last)
    throw std::invalid_argument(fmt::format("{} has no line {}", mutant.file, last - 1));
  return out;
}

std::string describe(const Mutant& mutant) {
  const auto trimmed = [](const std::vector<std::string>& lines) {
    std::string out;
    for (const std::string& line : lines)
      out += (out.empty() ? "" : " ") +
             line.substr(std::min(line.find_first_not_of(' '), line.size()));
    return out;
  };
  return fmt::format("{}:{}: `{}` -> `{}`", mutant.file, mutant.line, trimmed(mutant.before),
                     trimmed(mutant.after));
}

} // namespace ggrade::generated
