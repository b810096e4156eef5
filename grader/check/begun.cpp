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

/// For each line of `stub` whose place it is in; empty: nobody's.
std::vector<std::string> places(const std::vector<std::string>& stub) {
  static const std::regex kTodo(R"(TODO\(([a-z0-9_]+\.[0-9]+)\))");
  std::vector<std::string> owners;
  std::string owner;
  for (const std::string& line : stub) {
    std::set<std::string> named;
    for (std::sregex_iterator i(line.begin(), line.end(), kTodo), end; i != end; ++i)
      named.insert((*i)[1]);
    if (named.size() == 1) owner = *named.begin();
    if (named.size() > 1) owner.clear();
    owners.push_back(owner);
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
  const std::vector<std::string> owners = places(stub);
  const auto common = commonEnds(stub, now);
  std::set<std::string> begun;
  std::size_t i = 0;
  for (std::size_t k = 0; k < now.size();) {
    if (i < stub.size() && stub[i] == now[k]) {
      ++i, ++k;
    } else if (i < stub.size() && common[i + 1][k] >= common[i][k + 1]) {
      ++i;
    } else {
      if (!now[k].empty() && i > 0 && !owners[i - 1].empty()) begun.insert(owners[i - 1]);
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
