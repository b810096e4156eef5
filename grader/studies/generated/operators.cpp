#include "generated/operators.hpp"

#include "authoring/solution_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <regex>

namespace ggrade::generated {

namespace {

using authoring::codeLength;
using authoring::isPlainStatement;
using authoring::stringsOf;
using Lines = std::vector<std::string>;

/// A name with its members and subscripts: `light.position`, `sizes[i]`.
constexpr const char* kSimple = R"([A-Za-z_][\w.]*(?:\[\w+\])?)";

/// The line once for each match of `pattern` in its code and each text that `others` gives for it.
/// \param overlapping may matches overlap?
Lines eachReplaced(const std::string& line, const std::regex& pattern,
                   const std::function<Lines(const std::smatch&)>& others,
                   bool overlapping = false) {
  Lines found;
  const auto strings = stringsOf(line);
  const std::string code = line.substr(0, codeLength(line));
  std::smatch match;
  for (auto start = code.begin();
       std::regex_search(start, code.end(), match, pattern,
                         start == code.begin() ? std::regex_constants::match_default
                                               : std::regex_constants::match_prev_avail);
       start = overlapping ? match[0].first + 1 : match[0].second) {
    const auto from = std::size_t(match[0].first - code.begin());
    const std::size_t to = from + std::size_t(match.length());
    const bool isInString = std::ranges::any_of(
        strings, [&](const auto& one) { return from <= one.second && one.first < to; });
    if (isInString) continue;
    for (const std::string& other : others(match))
      if (other != match.str()) found.push_back(line.substr(0, from) + other + line.substr(to));
  }
  return found;
}

Lines byTable(const std::string& line, const std::regex& pattern,
              const std::map<std::string, std::string>& table) {
  return eachReplaced(line, pattern, [&](const std::smatch& match) {
    const auto other = table.find(match[1]);
    return other == table.end() ? Lines{} : Lines{" " + other->second + " "};
  });
}

Lines comparisons(const std::string& line) {
  static const std::regex kPattern(" (<=|>=|<|>|==|!=) ");
  return byTable(line, kPattern,
                 {{"<", ">="}, {">=", "<"}, {">", "<="}, {"<=", ">"}, {"==", "!="}, {"!=", "=="}});
}

Lines bounds(const std::string& line) {
  static const std::regex kPattern(" (<=|>=|<|>) ");
  return byTable(line, kPattern, {{"<", "<="}, {"<=", "<"}, {">", ">="}, {">=", ">"}});
}

Lines junctions(const std::string& line) {
  static const std::regex kPattern(R"( (&&|\|\|) )");
  return byTable(line, kPattern, {{"&&", "||"}, {"||", "&&"}});
}

Lines sums(const std::string& line) {
  static const std::regex kPattern(" ([+-]) ");
  return byTable(line, kPattern, {{"+", "-"}, {"-", "+"}});
}

Lines products(const std::string& line) {
  static const std::regex kPattern(" ([*/]) ");
  return byTable(line, kPattern, {{"*", "/"}, {"/", "*"}});
}

Lines conditions(const std::string& line) {
  static const std::regex kPattern(R"(\bif \(((?:[^();]|\([^()]*\))+)\))");
  return eachReplaced(line, kPattern, [](const std::smatch& match) {
    return Lines{"if (!(" + match[1].str() + "))"};
  });
}

Lines numbers(const std::string& line) {
  static const std::regex kPattern(R"(\b(\d+\.\d+|\d+)(f?)\b(?!\.))");
  return eachReplaced(line, kPattern, [](const std::smatch& match) {
    const std::string text = match[1], suffix = match[2];
    if (text.find('.') == text.npos) {
      const long number = std::stol(text);
      return Lines{std::to_string(number + 1) + suffix, std::to_string(number / 2) + suffix};
    }
    const double number = std::stod(text);
    const auto written = [&](double value) {
      std::string out = fmt::format("{}", value);
      if (out.find_first_of(".e") == out.npos) out += ".0";
      return out + suffix;
    };
    return number == 0 ? Lines{written(1)}
                       : Lines{written(2 * number), written(number / 2), written(0)};
  });
}

Lines swapped(const std::string& line) {
  static const std::regex kPattern(fmt::format(R"(([(,{{] ?)({0}), ({0})(?=[,)}}]))", kSimple));
  return eachReplaced(
      line, kPattern,
      [](const std::smatch& match) {
        return Lines{match[1].str() + match[3].str() + ", " + match[2].str()};
      },
      true);
}

/// What is taken for one another, both ways.
Lines constantsOfOpenGL(const std::string& line) {
  static const std::vector<std::vector<std::string>> kKinds = {
      {"GL_LINEAR", "GL_NEAREST"},
      {"GL_CLAMP_TO_EDGE", "GL_REPEAT", "GL_CLAMP_TO_BORDER"},
      {"GL_BACK", "GL_FRONT", "GL_FRONT_AND_BACK"},
      {"GL_TEXTURE0", "GL_TEXTURE1", "GL_TEXTURE2"},
      {"GL_LESS", "GL_LEQUAL", "GL_GREATER", "GL_GEQUAL"},
      {"GL_ONE", "GL_ZERO", "GL_SRC_ALPHA", "GL_ONE_MINUS_SRC_ALPHA"},
      {"GL_INCR_WRAP", "GL_DECR_WRAP", "GL_INCR", "GL_DECR", "GL_KEEP"},
      {"GL_ALWAYS", "GL_NEVER"},
      {"GL_EQUAL", "GL_NOTEQUAL"},
      {"GL_COLOR_ATTACHMENT0", "GL_COLOR_ATTACHMENT1", "GL_COLOR_ATTACHMENT2"},
      {"GL_DEPTH_ATTACHMENT", "GL_STENCIL_ATTACHMENT"},
      {"GL_DEPTH_COMPONENT24", "GL_DEPTH_COMPONENT16", "GL_DEPTH_COMPONENT32F"},
      {"GL_RGBA16F", "GL_RGBA8", "GL_RGBA32F"},
      {"GL_FRAMEBUFFER", "GL_READ_FRAMEBUFFER", "GL_DRAW_FRAMEBUFFER"},
      {"GL_TRUE", "GL_FALSE"},
      {"GL_TEXTURE_MIN_FILTER", "GL_TEXTURE_MAG_FILTER"},
      {"GL_TEXTURE_WRAP_S", "GL_TEXTURE_WRAP_T"},
      {"GL_CW", "GL_CCW"},
      {"GL_DEPTH_TEST", "GL_CULL_FACE", "GL_STENCIL_TEST", "GL_BLEND"},
      {"GL_CLIP_DISTANCE0", "GL_CULL_FACE"}};
  static const std::regex kConstant(R"(\bGL_\w+\b)"), kMask(R"(GL_\w+_BIT \| | \| GL_\w+_BIT)");
  Lines found = eachReplaced(line, kConstant, [](const std::smatch& match) {
    Lines others;
    for (const auto& kind : kKinds)
      if (std::ranges::find(kind, match.str()) != kind.end())
        others.insert(others.end(), kind.begin(), kind.end());
    return others;
  });
  for (std::string& fewer : eachReplaced(
           line, kMask, [](const auto&) { return Lines{""}; }, true))
    found.push_back(std::move(fewer));
  return found;
}

Lines functions(const std::string& line) {
  static const std::map<std::string, Lines> kOthers = {{"sin", {"cos"}},
                                                       {"cos", {"sin"}},
                                                       {"min", {"max"}},
                                                       {"max", {"min"}},
                                                       {"floor", {"ceil"}},
                                                       {"ceil", {"floor"}},
                                                       {"inverse", {"", "transpose"}},
                                                       {"normalize", {""}},
                                                       {"abs", {""}},
                                                       {"transpose", {"inverse", ""}},
                                                       {"dot", {"distance"}},
                                                       {"reflect", {"refract"}},
                                                       {"glEnable", {"glDisable"}},
                                                       {"glDisable", {"glEnable"}},
                                                       {"sqrt", {""}},
                                                       {"fract", {"floor"}},
                                                       {"exp", {"exp2"}},
                                                       {"length", {"dot"}}};
  static const std::regex kPattern(R"(\b(?:glm::|std::)?([a-z]\w*)\()");
  return eachReplaced(line, kPattern, [](const std::smatch& match) {
    const auto others = kOthers.find(match[1]);
    Lines found;
    if (others == kOthers.end()) return found;
    const std::string space = match.str().substr(0, match.str().find(match[1].str()));
    for (const std::string& other : others->second)
      found.push_back(other.empty() ? "(" : space + other + "(");
    return found;
  });
}

Lines components(const std::string& line) {
  static const std::regex kPattern(R"(\.([xyzw]{1,4}|[rgba]{1,4})\b(?!\())");
  return eachReplaced(line, kPattern, [](const std::smatch& match) {
    const std::string from = "xyzwrgba", to = "yxwzgrab", names = match[1];
    std::string other;
    for (const char name : names) other += to[from.find(name)];
    return Lines{"." + std::string(names.rbegin(), names.rend()), "." + other};
  });
}

Lines factors(const std::string& line) {
  static const std::regex kPattern(fmt::format(R"(([ (])({0}) \* ({0})(?![\w(.]))", kSimple));
  return eachReplaced(line, kPattern, [](const std::smatch& match) {
    const std::string before = match[1], a = match[2], b = match[3];
    return Lines{before + b + " * " + a, before + a, before + b};
  });
}

Lines signsDropped(const std::string& line) {
  static const std::regex kPattern(R"(([(,=] ?|return )-(?=[\w(]))");
  return eachReplaced(line, kPattern,
                      [](const std::smatch& match) { return Lines{match[1].str()}; });
}

Lines signsAdded(const std::string& line) {
  static const std::regex kPattern(fmt::format(R"(([(,] ?|= |return )({0})(?=[,);]))", kSimple));
  return eachReplaced(line, kPattern, [](const std::smatch& match) {
    const std::string name = match[2];
    const bool isNumber = name.find("GL_") == name.npos && name != "true" && name != "false";
    return isNumber ? Lines{match[1].str() + '-' + name} : Lines{};
  });
}

Lines truths(const std::string& line) {
  static const std::regex kPattern(R"(\b(true|false)\b)");
  return eachReplaced(line, kPattern, [](const std::smatch& match) {
    return Lines{match[1] == "true" ? "false" : "true"};
  });
}

Lines leftOut(const std::string& line) {
  if (!isPlainStatement(line)) return {};
  return {line.substr(0, line.find_first_not_of(' ')) + ';'};
}

} // namespace

const std::vector<Operator>& operators() {
  static const std::vector<Operator> all = {{"flips a comparison", comparisons},
                                            {"moves a bound by one", bounds},
                                            {"and for or", junctions},
                                            {"negates a condition", conditions},
                                            {"plus for minus", sums},
                                            {"times for over", products},
                                            {"another number", numbers},
                                            {"swaps two arguments", swapped},
                                            {"another constant of OpenGL", constantsOfOpenGL},
                                            {"another function", functions},
                                            {"other components", components},
                                            {"other factors", factors},
                                            {"drops a sign", signsDropped},
                                            {"adds a sign", signsAdded},
                                            {"true for false", truths},
                                            {"leaves out a statement", leftOut}};
  return all;
}

} // namespace ggrade::generated
