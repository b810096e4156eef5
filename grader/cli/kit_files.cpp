#include "cli/kit_files.hpp"

#include "report/write_file.hpp"

namespace ggrade::cli {

namespace fs = std::filesystem;

void copyTree(const fs::path& from, const fs::path& to) {
  report::makeFolder(to);
  for (const fs::directory_entry& entry : fs::directory_iterator(from)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(".")) continue;
    if (entry.is_directory())
      copyTree(entry.path(), to / name);
    else if (entry.is_regular_file())
      fs::copy_file(entry.path(), to / name);
  }
}

} // namespace ggrade::cli
