// The capture library stands in for four installed libraries, so it must export all that they
// export.

#include <gmock/gmock.h>

#include <cstdio>
#include <set>
#include <sstream>
#include <string>

namespace {

/// Names of all symbols that a shared library defines.
std::set<std::string> exportsOf(const std::string& library) {
  std::set<std::string> names;
  const std::string command = std::string(GGRADE_NM) + " -D --defined-only " + library;
  FILE* const pipe = popen(command.c_str(), "r");
  char line[512];
  while (pipe && std::fgets(line, sizeof(line), pipe)) {
    std::istringstream words(line);
    std::string address;
    std::string kind;
    std::string name;
    words >> address >> kind >> name;
    // The linker's own marks; every library has them or doesn't.
    if (name != "_edata" && name != "_end" && name != "__bss_start") names.insert(name);
  }
  EXPECT_TRUE(pipe && pclose(pipe) == 0) << command;
  return names;
}

TEST(CaptureExports, AreThoseOfTheInstalledLibraries) {
  std::istringstream libraries(GGRADE_INSTALLED_LIBRARIES);
  std::size_t total = 0;
  for (std::string library; std::getline(libraries, library, ',');) {
    const std::string name = library.substr(library.rfind('/') + 1);
    const std::set<std::string> ours = exportsOf(std::string(GGRADE_CAPTURE_FOLDER) + "/" + name);
    for (const std::string& symbol : exportsOf(library)) {
      EXPECT_TRUE(ours.count(symbol)) << name << " exports " << symbol;
      ++total;
    }
  }
  EXPECT_GT(total, 4500U);
}

} // namespace
