#include "authoring/zip.hpp"

#include "assignment/assignment.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <memory>
#include <set>
#include <stdexcept>

namespace ggrade::authoring {

namespace fs = std::filesystem;

void writeZip(const fs::path& folder, const std::string& top, const fs::path& file) {
  std::set<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.insert(entry.path());
  const fs::path partial = file.string() + ".partial";
  const std::unique_ptr<archive, int (*)(archive*)> zip(archive_write_new(), archive_write_free);
  const auto check = [&](int code) {
    if (code >= ARCHIVE_OK) return;
    const std::string why = archive_error_string(zip.get()) ? archive_error_string(zip.get()) : "";
    fs::remove(partial);
    throw std::runtime_error(fmt::format("{}: {}", file.string(), why));
  };
  check(archive_write_set_format_zip(zip.get()));
  check(archive_write_open_filename(zip.get(), partial.c_str()));
  for (const fs::path& path : files) {
    const std::string content = readFile(path);
    const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(archive_entry_new(),
                                                                         archive_entry_free);
    const bool runs = (fs::status(path).permissions() & fs::perms::owner_exec) != fs::perms::none;
    archive_entry_set_pathname(entry.get(),
                               (fs::path(top) / path.lexically_relative(folder)).c_str());
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), runs ? 0755 : 0644);
    archive_entry_set_size(entry.get(), la_int64_t(content.size()));
    check(archive_write_header(zip.get(), entry.get()));
    check(int(
        std::min<la_ssize_t>(archive_write_data(zip.get(), content.data(), content.size()), 0)));
  }
  check(archive_write_close(zip.get()));
  fs::rename(partial, file);
}

} // namespace ggrade::authoring
