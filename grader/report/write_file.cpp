#include "report/write_file.hpp"

#include "image/temporary_file.hpp"
#include "report/text.hpp"

#include <fmt/format.h>
#include <span>
#include <stdexcept>
#include <system_error>

namespace ggrade::report {
namespace {

constexpr std::string_view kRemedy = "choose a folder that you may write to and that has room";

} // namespace

void writeFile(const std::filesystem::path& path, std::string_view text) {
  try {
    writeWholeFile(path,
                   std::span(reinterpret_cast<const unsigned char*>(text.data()), text.size()));
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}; {}", sanitizeLine(error.what(), 2000), kRemedy));
  }
}

void makeFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error && !std::filesystem::is_directory(folder, error))
    error = std::make_error_code(std::errc::not_a_directory);
  if (error)
    throw std::runtime_error(fmt::format("cannot make the folder '{}': {}; {}",
                                         sanitizeLine(folder.string(), 2000), error.message(),
                                         kRemedy));
}

} // namespace ggrade::report
