#include "intake/clutter.hpp"

#include <algorithm>

namespace ggrade::intake {

std::string_view clutterIn(std::string_view path) {
  while (!path.empty()) {
    const std::string_view component = path.substr(0, path.find_first_of("/\\"));
    for (const std::string_view name : {"__MACOSX", ".vs", ".git", ".DS_Store", "Thumbs.db"})
      if (component == name) return name;
    if (component.starts_with("._")) return "._*";
    path.remove_prefix(std::min(path.size(), component.size() + 1));
  }
  return {};
}

} // namespace ggrade::intake
