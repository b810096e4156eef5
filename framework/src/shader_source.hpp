#pragma once
/// \file
/// A shader's text with its includes put in, and the way back from line numbers to files.

#include <filesystem>
#include <string>
#include <vector>

namespace gg::detail {

/// One file that a stage's text was put together from.
struct ShaderFile {
  std::string name; ///< as the program or the #include named it
  std::vector<std::string> lines;
};

/// The text of one stage. Line n of files[k] has the number k * kLinesPerFile + n, which #line
/// tells the compiler, because drivers keep line numbers but not all keep the number of the file.
struct ShaderSource {
  static constexpr int kLinesPerFile = 10000;
  std::string text;
  std::vector<ShaderFile> files;
};

/// Reads a stage's file and what it includes, each once. Byte-order marks and CRLF are taken out.
///   folder: where names are looked up first; then the framework's own shaders are
/// Throws ShaderError for a file that isn't there, includes itself, is too long, or a stage whose
/// first line is not `#version 410 core` or later.
ShaderSource readShader(const std::string& name, const std::filesystem::path& folder);

} // namespace gg::detail
