#include "check/places.hpp"

#include "assignment/assignment.hpp"
#include "grading/overlay.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <sstream>

namespace ggrade::check {

namespace fs = std::filesystem;

namespace {

/// std::regex recurses once a character.
constexpr std::size_t kLongestLine = 2000;

/// Without the white space around them.
std::vector<std::string> trimmedLines(std::string_view text) {
  std::vector<std::string> lines;
  std::istringstream in{std::string(text)};
  for (std::string line; std::getline(in, line);) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    const std::size_t last = line.find_last_not_of(" \t\r");
    lines.push_back(first == line.npos ? "" : line.substr(first, last + 1 - first));
  }
  return lines;
}

/// Line and column of the comment that begins with a TODO.
std::optional<Place> commentIn(const std::string& text, const std::string& todo) {
  const std::string mark = "TODO(" + todo + "):";
  std::istringstream in(text);
  int number = 1;
  for (std::string line; std::getline(in, line); ++number)
    if (const std::size_t at = line.find(mark);
        at != line.npos && line.find_first_not_of(" \t/*") == at)
      return Place{"", number, int(at) + 1};
  return std::nullopt;
}

std::optional<Place> placeIn(const std::string& stub, const std::string& text,
                             const std::string& todo) {
  const auto handedOut = commentIn(stub, todo);
  if (!handedOut) return std::nullopt;
  if (const auto now = commentIn(text, todo)) return now;
  const auto line = lineNow(stub, text, handedOut->line);
  return line ? std::optional(Place{"", *line, 0}) : std::nullopt;
}

/// A line that begins with one of the folder's files, after GCC's words or a program's name if any;
/// else one that ends with such a place.
std::string lineWithPath(const std::string& line, const fs::path& folder) {
  if (line.size() > kLongestLine) return line;
  static const std::regex first(R"((In file included from |\s+from |\w+: |)([^\s:/][^:/]*)(:.*))");
  static const std::regex last(R"((.*) \(([^\s:/()]+):(\d+)\))");
  std::smatch match;
  const auto isOurs = [&](const std::string& name) {
    std::error_code none;
    return fs::is_regular_file(folder / name, none);
  };
  if (std::regex_match(line, match, first) && isOurs(match[2])) {
    const std::string before = match[1];
    return (before.ends_with(": ") ? "" : before) + shown(folder / match[2].str()) + match[3].str();
  }
  if (std::regex_match(line, match, last) && isOurs(match[2])) {
    const std::string error = gg::say("OpenGL: error: {}", "");
    std::string text = match[1];
    const bool isError = text.starts_with(error);
    if (isError) text = "OpenGL: " + text.substr(error.size());
    return fmt::format("{}:{}: {}: {}", shown(folder / match[2].str()), match[3].str(),
                       isError ? "error" : "warning", text);
  }
  return line;
}

} // namespace

std::string shown(const fs::path& file) {
  const fs::path near =
      fs::absolute(file).lexically_normal().lexically_relative(fs::current_path());
  return (near.empty() || *near.begin() == ".." ? file : near).string();
}

std::string lineOf(const Problem& problem) {
  const auto& [place, severity, text] = problem;
  const std::string column = place.column > 0 ? fmt::format(":{}", place.column) : "";
  return fmt::format("{}:{}{}: {}: {}", place.file, place.line, column, severity, text);
}

std::optional<Problem> problemIn(const std::string& line) {
  if (line.size() > kLongestLine) return std::nullopt;
  static const std::regex form(
      R"(([^\s:][^:]*):(\d{1,8}):(?:(\d{1,8}):)? (?:fatal )?(error|warning|note): (.*))");
  std::smatch match;
  if (!std::regex_match(line, match, form)) return std::nullopt;
  const int column = match[3].matched ? std::stoi(match[3]) : 0;
  return Problem{{match[1], std::stoi(match[2]), column}, match[4], match[5]};
}

std::optional<int> lineNow(std::string_view stubText, std::string_view text, int number) {
  const std::vector<std::string> stub = trimmedLines(stubText), now = trimmedLines(text);
  for (std::size_t before = std::min(std::size_t(number - 1), stub.size()); before-- > 0;) {
    const std::string& line = stub[before];
    if (line.empty() || std::ranges::count(stub, line) != 1 || std::ranges::count(now, line) != 1)
      continue;
    auto at = std::size_t(std::ranges::find(now, line) - now.begin()) + 1;
    // Lines that stand more than once are right after it in both.
    for (std::size_t k = before + 1;
         k + 1 < std::size_t(number) && at < now.size() && stub[k] == now[at]; ++k)
      ++at;
    while (at < now.size() && now[at].empty()) ++at;
    return int(std::min(at, now.size() - 1)) + 1;
  }
  return std::nullopt;
}

std::vector<Place> placesOf(const std::string& todo, const std::vector<std::string>& files,
                            const fs::path& stub, const fs::path& folder) {
  std::vector<Place> places;
  for (const std::string& name : files) {
    if (!fs::is_regular_file(stub / name) || !fs::is_regular_file(folder / name)) continue;
    if (auto place = placeIn(readFile(stub / name), readFile(folder / name), todo)) {
      place->file = shown(folder / name);
      places.push_back(*place);
    }
  }
  return places;
}

void putReaderFirst(std::vector<Place>& places, const std::set<std::string>& samplers) {
  std::vector<std::ptrdiff_t> named;
  for (const Place& place : places) {
    // What is compiled sets what all of them read.
    const std::string text = grading::isCompiled(place.file) ? std::string() : readFile(place.file);
    named.push_back(std::ranges::count_if(samplers, [&](const std::string& sampler) {
      return std::regex_search(text, std::regex("\\b" + sampler + "\\b"));
    }));
  }
  const auto most = std::ranges::max_element(named);
  if (most == named.end() || *most == 0 || std::ranges::count(named, *most) > 1) return;
  const auto reader = places.begin() + (most - named.begin());
  std::rotate(places.begin(), reader, std::next(reader));
}

namespace {

/// Is this line one that was handed out, in a function below that of the TODO before it?
bool isHandedOut(const std::string& stub, const std::string& text, const std::string& todo,
                 int line) {
  const auto comment = commentIn(stub, todo);
  const std::vector<std::string> now = trimmedLines(text);
  if (!comment || std::size_t(line) > now.size() || now[std::size_t(line - 1)].empty())
    return false;
  std::istringstream in(stub);
  bool isBelow = false;
  int number = 1;
  for (std::string one; std::getline(in, one); ++number) {
    if (number <= comment->line) continue;
    if (one.find("TODO(") != one.npos && one.find("TODO(" + todo) == one.npos) return false;
    if (isBelow && !one.empty() && trimmedLines(one).front() == now[std::size_t(line - 1)])
      return true;
    isBelow = isBelow || one.starts_with('}');
  }
  return false;
}

} // namespace

std::string todoAt(const std::string& message, const std::vector<std::string>& todos,
                   const fs::path& stub, const fs::path& folder) {
  static const std::regex end(R"(.*\(([^\s:/()]+):(\d{1,8})\)[^()]*)");
  std::smatch match;
  if (message.size() > kLongestLine || !std::regex_match(message, match, end)) return {};
  const int line = std::stoi(match[2]);
  std::string found;
  int nearest = 0;
  for (const std::string& todo : todos)
    for (const Place& place : placesOf(todo, {match[1]}, stub, folder))
      if (place.line <= line && place.line > nearest) {
        nearest = place.line;
        found = todo;
      }
  if (!found.empty() &&
      isHandedOut(readFile(stub / match[1].str()), readFile(folder / match[1].str()), found, line))
    return {};
  return found;
}

std::string withPaths(const std::string& said, const fs::path& folder) {
  std::istringstream in(said);
  std::string all;
  for (std::string line; std::getline(in, line); all += '\n') all += lineWithPath(line, folder);
  if (!said.ends_with('\n') && !all.empty()) all.pop_back();
  return all;
}

} // namespace ggrade::check
