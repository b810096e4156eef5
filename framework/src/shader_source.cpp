#include "shader_source.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

#include "builtin_shaders.hpp"
#include "words/words.hpp"
#include <fmt/format.h>
#include <gg/error.hpp>
#include <gg/text_file.hpp>

namespace gg::detail {

namespace {

std::vector<std::string> splitLines(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  std::vector<std::string> lines(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') continue;
    if (text[i] == '\n' || text[i] == '\r')
      lines.emplace_back();
    else
      lines.back() += text[i];
  }
  if (lines.back().empty()) lines.pop_back();
  return lines;
}

// The line without comments. `inComment` says whether it starts, and then ends, inside /* */.
std::string withoutComments(std::string_view line, bool& inComment) {
  std::string code;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const std::string_view two = line.substr(i, 2);
    if (inComment) {
      if (two != "*/") continue;
      inComment = false;
      ++i;
    } else if (two == "//") {
      break;
    } else if (two == "/*") {
      inComment = true;
      code += ' ';
      ++i;
    } else {
      code += line[i];
    }
  }
  return code;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

// If `code` is the preprocessor's directive of this name: what follows the name.
std::optional<std::string_view> directive(std::string_view code, std::string_view name) {
  code = trimmed(code);
  if (!code.starts_with('#')) return {};
  code = trimmed(code.substr(1));
  if (!code.starts_with(name)) return {};
  const std::string_view rest = code.substr(name.size());
  if (!rest.empty() && rest[0] != ' ' && rest[0] != '\t' && rest[0] != '"' && rest[0] != '<')
    return {};
  return trimmed(rest);
}

bool isSupportedVersion(std::string_view words) {
  int version = 0;
  const auto [end, error] = std::from_chars(words.data(), words.data() + words.size(), version);
  const std::string_view profile = trimmed(words.substr(end - words.data()));
  return error == std::errc() && version >= 410 && version <= 460 &&
         (profile.empty() || profile == "core");
}

class Assembler {
public:
  explicit Assembler(const std::filesystem::path& folder) : folder_(folder) {}

  ShaderSource assemble(const std::string& name) {
    const std::optional<std::string> text = find(name);
    if (!text) {
      throw ShaderError(say("{}: error: there is no such file in {}", name, toUtf8(folder_)));
    }
    add(name, *text);
    if (!versionSeen_) fail(name, 1, say("the first line must be \"#version 410 core\""));
    return std::move(source_);
  }

private:
  [[noreturn]] static void fail(const std::string& name, std::size_t line,
                                const std::string& what) {
    throw ShaderError(fmt::format("{}:{}: error: {}", name, line, what));
  }

  std::optional<std::string> find(const std::string& name) const {
    const std::filesystem::path file = folder_ / fromUtf8(name);
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored)) {
      try {
        return readFile(file);
      } catch (const FileError& error) {
        throw ShaderError(error.what());
      }
    }
    const auto builtin = builtinShaders().find(name);
    if (builtin != builtinShaders().end()) return builtin->second;
    return {};
  }

  void add(const std::string& name, const std::string& text) {
    const std::size_t index = source_.files.size();
    const std::vector<std::string> lines = splitLines(text);
    if (lines.size() >= ShaderSource::kLinesPerFile)
      fail(name, ShaderSource::kLinesPerFile, say("a shader file must be shorter than this"));
    source_.files.push_back({name, lines});
    open_.push_back(name);
    bool inComment = false;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const std::size_t number = i + 1;
      const std::string code = withoutComments(lines[i], inComment);
      if (const auto included = directive(code, "include")) {
        include(name, number, *included);
        source_.text += fmt::format("#line {}\n", index * ShaderSource::kLinesPerFile + number + 1);
        continue;
      }
      checkVersion(name, number, code, index == 0);
      source_.text += lines[i] + "\n";
    }
    open_.pop_back();
  }

  void include(const std::string& from, std::size_t line, std::string_view words) {
    const std::size_t length = words.size();
    const bool isQuoted = length > 2 && words.front() == '"' && words.back() == '"';
    const bool isAngled = length > 2 && words.front() == '<' && words.back() == '>';
    if (!isQuoted && !isAngled) fail(from, line, say("#include needs a name in quotes"));
    const std::string name(words.substr(1, length - 2));
    if (std::find(open_.begin(), open_.end(), name) != open_.end())
      fail(from, line, say("\"{}\" includes itself", name));
    for (const ShaderFile& file : source_.files)
      if (file.name == name) return;
    const std::optional<std::string> text = find(name);
    if (!text) {
      std::string builtins;
      for (const auto& [builtin, unused] : builtinShaders())
        builtins += (builtins.empty() ? "" : ", ") + builtin;
      fail(from, line,
           say("there is no file \"{}\" beside the program, and the framework has only {}", name,
               builtins));
    }
    source_.text +=
        fmt::format("#line {}\n", source_.files.size() * ShaderSource::kLinesPerFile + 1);
    add(name, *text);
  }

  // Nothing but comments may stand before #version; without it the language would be GLSL 1.10.
  void checkVersion(const std::string& name, std::size_t line, const std::string& code,
                    bool isStage) {
    if (trimmed(code).empty()) return;
    const auto version = directive(code, "version");
    if (version && !isStage) fail(name, line, say("an included file has no #version"));
    if (versionSeen_) return;
    if (!version || !isSupportedVersion(*version))
      fail(name, line, say("the first line must be \"#version 410 core\""));
    versionSeen_ = true;
  }

  const std::filesystem::path& folder_;
  ShaderSource source_;
  std::vector<std::string> open_; // files that are being read, outermost first
  bool versionSeen_ = false;
};

} // namespace

ShaderSource readShader(const std::string& name, const std::filesystem::path& folder) {
  return Assembler(folder).assemble(name);
}

} // namespace gg::detail
