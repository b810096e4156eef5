#pragma once
// A headless Chromium that opens pages from file:// and reports what became of them.
#include "image/png.hpp"
#include "report/write_file.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>

namespace ggrade::report {

struct Visit {
  std::string dom;
  std::string
      console; // what chromium logged for the page, a line a message; empty when all is well
};

class Browser : public testing::Test {
protected:
  Browser() {
    std::string name = (std::filesystem::temp_directory_path() / "ggrade-browser-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~Browser() override { std::filesystem::remove_all(folder_); }

  static std::string read(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  // Runs chromium with a profile of its own; false when it fails or hangs.
  bool chromium(const std::string& flags, const std::string& html) {
    writeFile(folder_ / "page.html", html);
    const std::filesystem::path profile = folder_ / "profile";
    const std::string command =
        "timeout 60 chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run "
        "--disable-background-networking --disable-component-update --disable-sync "
        "--hide-scrollbars "
        "--disable-dev-shm-usage --enable-logging=stderr --user-data-dir=" +
        profile.string() + " " + flags + " file://" + (folder_ / "page.html").string() + " >" +
        (folder_ / "dom").string() + " 2>" + (folder_ / "log").string();
    const bool good = std::system(command.c_str()) == 0;
    std::filesystem::remove_all(profile);
    return good;
  }

  Visit visit(const std::string& html, const std::string& flags = "--window-size=1280,900") {
    EXPECT_TRUE(chromium("--dump-dom " + flags, html)) << read(folder_ / "log");
    Visit visit{read(folder_ / "dom"), ""};
    std::ifstream log(folder_ / "log");
    for (std::string line; std::getline(log, line);)
      if (line.find("CONSOLE") != std::string::npos) visit.console += line + "\n";
    return visit;
  }

  Image screenshot(const std::string& html, const std::string& flags) {
    const std::filesystem::path file = folder_ / "shot.png";
    std::filesystem::remove(file);
    EXPECT_TRUE(chromium("--screenshot=" + file.string() + " " + flags, html))
        << read(folder_ / "log");
    return readPng(file);
  }

  std::filesystem::path folder_;
};

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

// The page with its policy taken out and a script of the test's own behind the page's.
inline std::string driven(const std::string& page, const std::string& script) {
  const auto policy = page.find("<meta http-equiv");
  std::string open = page;
  open.erase(policy, page.find('\n', policy) - policy);
  return replaced(open, "</body>", "<script>" + script + "</script></body>");
}

} // namespace ggrade::report
