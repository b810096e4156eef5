#include "print_once.hpp"

#include "words/words.hpp"

#include <cstdio>
#include <set>
#include <string_view>

#include <gg/call_place.hpp>

namespace gg::detail {

namespace {
std::set<std::string> printed;
}

void forgetPrinted() {
  printed.clear();
}

void printOnce(const std::string& line) {
  constexpr std::size_t kMost = 100;
  if (printed.size() < kMost && printed.insert(line).second)
    std::fprintf(stderr, "%s\n", line.c_str());
}

std::string lastPlace() {
  if (lastCallPlace.file == nullptr) return "";
  const std::string_view file = lastCallPlace.file;
  const std::string place = std::string(file.substr(file.find_last_of("/\\") + 1)) + ":" +
                            std::to_string(lastCallPlace.line);
  return " (" + (lastCallPlace.isNow ? place : say("noticed after {}", place)) + ")";
}

} // namespace gg::detail
