#include "check/begun.hpp"

#include "assignment/assignment.hpp"

#include <algorithm>
#include <regex>

namespace ggrade::check {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> linesOf(std::string_view text) {
  std::vector<std::string> lines(1);
  for (const char c : text)
    if (c == '\n')
      lines.emplace_back();
    else if (c != ' ' && c != '\t' && c != '\r')
      lines.back() += c;
  return lines;
}

/// Without white space: neither a comment nor the head or end of a block.
bool isStatement(const std::string& line) {
  return line.ends_with(';') && !line.starts_with("//");
}

/// By line of the stub, whose place it is; empty: nobody's.
struct Places {
  std::vector<std::string> added;   ///< what is written after this line
  std::vector<std::string> changed; ///< what is written in place of it
};

Places places(const std::vector<std::string>& stub) {
  static const std::regex kTodo(R"((?:TODO|DONE)\(([a-z0-9_]+\.[0-9]+)\))");
  Places owners;
  std::string owner;
  for (const std::string& line : stub) {
    std::set<std::string> named;
    for (std::sregex_iterator i(line.begin(), line.end(), kTodo), end; i != end; ++i)
      named.insert((*i)[1]);
    if (named.size() == 1) owner = *named.begin();
    if (named.size() > 1) owner.clear();
    // "negate it" speaks of the statement right above.
    const std::size_t number = owners.added.size();
    if (number > 0 && named.size() == 1 && line.starts_with("//TODO(") &&
        isStatement(stub[number - 1]))
      owners.changed.back() = owner;
    owners.added.push_back(owner);
    owners.changed.push_back(owner);
  }
  return owners;
}

/// Lengths of the longest common subsequences of the ends of both, [from a][from b].
std::vector<std::vector<int>> commonEnds(const std::vector<std::string>& a,
                                         const std::vector<std::string>& b) {
  std::vector<std::vector<int>> length(a.size() + 1, std::vector<int>(b.size() + 1));
  for (std::size_t i = a.size(); i-- > 0;)
    for (std::size_t k = b.size(); k-- > 0;)
      length[i][k] =
          a[i] == b[k] ? length[i + 1][k + 1] + 1 : std::max(length[i + 1][k], length[i][k + 1]);
  return length;
}

} // namespace

std::set<std::string> begunIn(std::string_view stubText, std::string_view text) {
  const std::vector<std::string> stub = linesOf(stubText), now = linesOf(text);
  const Places owners = places(stub);
  const auto common = commonEnds(stub, now);
  std::set<std::string> begun;
  std::size_t i = 0;
  const std::vector<std::string>* written = &owners.added;
  for (std::size_t k = 0; k < now.size();) {
    if (i < stub.size() && stub[i] == now[k]) {
      ++i, ++k;
      written = &owners.added;
    } else if (i < stub.size() && common[i + 1][k] >= common[i][k + 1]) {
      ++i;
      written = &owners.changed;
    } else {
      if (!now[k].empty() && i > 0 && !(*written)[i - 1].empty()) begun.insert((*written)[i - 1]);
      ++k;
    }
  }
  return begun;
}

std::set<std::string> begun(const fs::path& stub, const fs::path& folder) {
  std::set<std::string> all;
  for (const fs::directory_entry& entry : fs::directory_iterator(stub)) {
    const fs::path now = folder / entry.path().filename();
    if (fs::is_regular_file(now)) all.merge(begunIn(readFile(entry.path()), readFile(now)));
  }
  return all;
}

} // namespace ggrade::check
