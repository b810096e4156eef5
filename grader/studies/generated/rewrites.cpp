#include "generated/rewrites.hpp"

#include "authoring/solution_blocks.hpp"
#include "generated/operators.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <regex>
#include <set>

namespace ggrade::generated {

using authoring::BlockLine;
using authoring::codeLength;
using authoring::isPlainStatement;

namespace {

using Lines = std::vector<std::string>;

/// Where a change may be made.
struct Site {
  const std::vector<BlockLine>& lines;
  std::size_t at; ///< the line
  bool isGlsl;
  std::string fresh; ///< a name that nothing has

  const std::string& line() const { return lines[at].text; }
  std::string code() const { return line().substr(0, codeLength(line())); }
  std::string indent() const { return line().substr(0, line().find_first_not_of(' ')); }
  /// Without what is before and behind it.
  std::string statement() const {
    const std::string text = code();
    const std::size_t from = text.find_first_not_of(' '), to = text.find_last_not_of(' ');
    return from == text.npos ? std::string() : text.substr(from, to + 1 - from);
  }
};

/// The lines that stand for the one at the site, or the two from there if `two`; nothing where it
/// can't be done there.
struct Change {
  std::string name;
  std::optional<Lines> (*apply)(const Site& site);
  bool two = false;
};

/// `float x = 2.0 * y;` in its pieces.
struct Declaration {
  std::string type, name, value;
};

std::optional<Declaration> declarationOf(const Site& site) {
  static const std::regex kPattern(
      R"((?:const )?((?:glm::)?(?:float|vec[234]|mat[34])) (\w+) = ([^;{}]+);)");
  std::smatch match;
  const std::string statement = site.statement();
  if (!std::regex_match(statement, match, kPattern)) return {};
  // Two declared at once.
  int depth = 0;
  for (const char c : match[3].str()) {
    depth += (c == '(' || c == '[') - (c == ')' || c == ']');
    if (c == ',' && depth == 0) return {};
  }
  return Declaration{match[1], match[2], match[3]};
}

bool isCall(const Site& site) {
  return isPlainStatement(site.line());
}

std::optional<Lines> loop(const Site& site) {
  if (!isCall(site)) return {};
  return Lines{fmt::format("{0}for (int {1} = 0; {1} < 1; ++{1}) {2}", site.indent(), site.fresh,
                           site.statement())};
}

std::optional<Lines> condition(const Site& site) {
  if (!isCall(site)) return {};
  return Lines{site.indent() + "if (1 < 2) {", "  " + site.line(), site.indent() + "}"};
}

std::optional<Lines> deadCode(const Site& site) {
  if (!isCall(site)) return {};
  return Lines{fmt::format("{}if (1 > 2) {}", site.indent(), site.statement()), site.line()};
}

std::optional<Lines> liveCode(const Site& site) {
  if (!isCall(site)) return {};
  return Lines{fmt::format("{0}float {1} = 0.25;", site.indent(), site.fresh),
               fmt::format("{0}{1} *= 3.0;", site.indent(), site.fresh), site.line()};
}

std::optional<Lines> lambda(const Site& site) {
  if (site.isGlsl || !isCall(site)) return {};
  return Lines{fmt::format("{}[&] {{ {} }}();", site.indent(), site.statement())};
}

/// Calls that do the same again.
std::optional<Lines> twice(const Site& site) {
  static const std::regex kPattern(
      R"(gl(Viewport|BindFramebuffer|BindTexture|ClearColor|Clear|Enable|Disable|CullFace|ActiveTexture|)"
      R"(TexParameter\w+|DepthMask|ColorMask|DepthFunc|StencilFunc\w*|StencilOp\w*|BlendFunc|DrawBuffer\w*|)"
      R"(ReadBuffer|PolygonOffset)\(.*\);)");
  if (site.isGlsl || !isCall(site) || !std::regex_match(site.statement(), kPattern)) return {};
  return Lines{site.line(), site.line()};
}

std::optional<Lines> named(const Site& site) {
  static const std::regex kPattern(R"((gl\w+)\((GL_\w+)(, [^{}]*)?\);)");
  std::smatch match;
  const std::string statement = site.statement();
  if (site.isGlsl || !isCall(site) || !std::regex_match(statement, match, kPattern)) return {};
  return Lines{
      fmt::format("{}const GLenum {} = {};", site.indent(), site.fresh, match[2].str()),
      fmt::format("{}{}({}{});", site.indent(), match[1].str(), site.fresh, match[3].str())};
}

std::optional<Lines> identity(const Site& site) {
  const auto declared = declarationOf(site);
  if (!declared || declared->type.find("mat") != std::string::npos) return {};
  const std::string one = site.isGlsl ? "1.0" : "1.0f";
  return Lines{fmt::format("{}{} {} = ({}) * {};", site.indent(), declared->type, declared->name,
                           declared->value, one)};
}

std::optional<Lines> through(const Site& site) {
  const auto declared = declarationOf(site);
  if (!declared) return {};
  return Lines{
      fmt::format("{}{} {} = {};", site.indent(), declared->type, site.fresh, declared->value),
      fmt::format("{}{} {} = {};", site.indent(), declared->type, declared->name, site.fresh)};
}

std::optional<Lines> packed(const Site& site) {
  static const std::vector<std::array<std::string, 3>> kKinds = {
      {"float", "vec2", "x"}, {"vec2", "vec3", "xy"}, {"vec3", "vec4", "xyz"}};
  const auto declared = declarationOf(site);
  if (!site.isGlsl || !declared) return {};
  const auto kind =
      std::ranges::find(kKinds, declared->type, [](const auto& one) { return one[0]; });
  if (kind == kKinds.end()) return {};
  return Lines{fmt::format("{}{} {} = {}({}, 0.0);", site.indent(), (*kind)[1], site.fresh,
                           (*kind)[1], declared->value),
               fmt::format("{}{} {} = {}.{};", site.indent(), declared->type, declared->name,
                           site.fresh, (*kind)[2])};
}

/// Parameters of one texture are set in any order.
std::optional<Lines> exchanged(const Site& site) {
  static const std::regex kPattern(R"(glTexParameteri\((\w+), (\w+), \w+\);)");
  if (site.isGlsl || site.at + 1 >= site.lines.size()) return {};
  const Site next{site.lines, site.at + 1, false, ""};
  if (next.lines[next.at].marker || !isCall(site) || !isCall(next)) return {};
  std::smatch a, b;
  const std::string first = site.statement(), second = next.statement();
  if (!std::regex_match(first, a, kPattern) || !std::regex_match(second, b, kPattern) ||
      a[1] != b[1] || a[2] == b[2])
    return {};
  return Lines{next.line(), site.line()};
}

std::optional<Lines> uncommented(const Site& site) {
  const std::size_t code = codeLength(site.line());
  if (code == site.line().size()) return {};
  if (site.line().find_first_not_of(' ') == code) return Lines{};
  return Lines{site.code()};
}

const std::vector<Change>& changes() {
  static const std::vector<Change> all = {{"runs once in a loop", loop},
                                          {"under a condition that holds", condition},
                                          {"dead code before it", deadCode},
                                          {"live code before it that nothing reads", liveCode},
                                          {"in a lambda that is called", lambda},
                                          {"the same call twice", twice},
                                          {"a constant by another name", named},
                                          {"times one", identity},
                                          {"through another variable", through},
                                          {"packed into a longer vector", packed},
                                          {"exchanged with the next call", exchanged, true},
                                          {"without its comment", uncommented}};
  return all;
}

/// Is each line a whole statement in a function's body?
std::vector<bool> inFunctions(const std::vector<BlockLine>& lines) {
  std::vector<bool> found;
  std::vector<bool> open; // braces: is it a body?
  std::string since;      // code since the last statement or brace
  int depth = 0;          // of parentheses
  for (const BlockLine& line : lines) {
    const std::string code = line.text.substr(0, codeLength(line.text));
    const bool isBegun = since.find_first_not_of(" \n") != since.npos || depth > 0;
    found.push_back(!line.marker && !isBegun && !open.empty() && open.back());
    for (const char c : code) {
      depth += (c == '(') - (c == ')');
      since += c;
      if (depth > 0) continue;
      if (c == '{') {
        const std::size_t last = since.find_last_not_of(" {");
        const bool isBody =
            last != since.npos &&
            (since[last] == ')' || since[last] == ']' || since.ends_with("else {") ||
             since.ends_with("const {") || since.ends_with("do {"));
        open.push_back(isBody);
      } else if (c == '}' && !open.empty()) {
        open.pop_back();
      }
      if (c == '{' || c == '}' || c == ';') since.clear();
    }
    since += ' ';
    if (code.empty() || code[0] == '#') since.clear();
  }
  return found;
}

} // namespace

Rewritten rewrite(std::string text, const std::string& file, std::size_t count, Chance& chance) {
  Rewritten done{std::move(text), {}};
  const bool isGlsl = !file.ends_with(".cpp") && !file.ends_with(".hpp");
  for (std::size_t n = 0; n < count; ++n) {
    const auto lines = authoring::blockLines(done.text, file);
    const std::vector<bool> inside = inFunctions(lines);
    // The kind of change first: some can be made nearly everywhere.
    std::vector<std::pair<const Change*, std::vector<std::pair<std::size_t, Lines>>>> all;
    std::string fresh;
    for (std::size_t i = 0; fresh.empty() || done.text.find(fresh) != done.text.npos; ++i)
      fresh = fmt::format("other{}", i);
    for (const Change& change : changes()) {
      std::vector<std::pair<std::size_t, Lines>> places;
      for (std::size_t i = 0; i < lines.size(); ++i)
        if (inside[i] && !lines[i].todo.empty() &&
            lines[i].text.find_first_not_of(' ') != std::string::npos)
          if (auto instead = change.apply({lines, i, isGlsl, fresh}))
            places.emplace_back(i, std::move(*instead));
      if (!places.empty()) all.emplace_back(&change, std::move(places));
    }
    if (all.empty()) return done;
    const auto& [change, places] = chance.of(all);
    const auto& [at, instead] = chance.of(places);
    std::string changed;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (i == at)
        for (const std::string& line : instead) changed += line + '\n';
      else if (!(change->two && i == at + 1))
        changed += lines[i].text + '\n';
    }
    done.text = std::move(changed);
    done.changes.push_back(fmt::format("{}:{}: {}", file, at + 1, change->name));
  }
  return done;
}

} // namespace ggrade::generated
