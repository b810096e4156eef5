#include <gg/text_file.hpp>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "words/words.hpp"
#include <gg/error.hpp>

namespace gg {

std::string toUtf8(const std::filesystem::path& path) {
  const std::u8string text = path.u8string();
  return {reinterpret_cast<const char*>(text.data()), text.size()};
}

std::filesystem::path fromUtf8(std::string_view text) {
  return std::u8string(reinterpret_cast<const char8_t*>(text.data()), text.size());
}

std::string readFile(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored))
    throw FileError(say("{}: is a folder, not a file", toUtf8(file)));
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    const std::string reason = errno != 0 ? std::strerror(errno) : say("cannot be opened");
    throw FileError(say("{}: cannot be read: {}", toUtf8(file), reason));
  }
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (stream.bad()) throw FileError(say("{}: cannot be read to its end", toUtf8(file)));
  return text;
}

} // namespace gg
