#include "intake/archive_reader.hpp"

#include "intake/bundle.hpp"

#include <archive.h>
#include <archive_entry.h>

#include <cerrno>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <system_error>

namespace ggrade::intake {
namespace {

using Archive = std::unique_ptr<archive, decltype(&archive_read_free)>;

std::string messageOf(archive* source) {
  const char* text = archive_error_string(source);
  return text ? text : "no reason given";
}

/// Throws std::system_error if it was the disk that failed.
void blameTheDisk(archive* source) {
  const int code = archive_errno(source);
  if (code == EIO || code == EMFILE || code == ENFILE)
    throw std::system_error(code, std::generic_category(), "can't read the archive");
}

[[noreturn]] void unreadable(archive* source) {
  blameTheDisk(source);
  throw std::runtime_error("can't be read as a zip or tar file (" + messageOf(source) +
                           "): damaged, cut short, or another kind of archive");
}

Archive makeReader() {
  Archive reader(archive_read_new(), archive_read_free);
  if (!reader) throw std::runtime_error("needs more memory than there is");
  // Only by the table of contents at a zip's end, as other tools do: no second way to read it.
  archive_read_support_format_zip_seekable(reader.get());
  archive_read_support_format_tar(reader.get());
  archive_read_support_filter_gzip(reader.get());
  archive_read_support_filter_bzip2(reader.get());
  archive_read_support_filter_xz(reader.get());
  archive_read_support_filter_zstd(reader.get());
  return reader;
}

Kind kindOf(archive_entry* entry) {
  if (archive_entry_hardlink(entry)) return Kind::hardLink;
  switch (archive_entry_filetype(entry)) {
  case AE_IFDIR:
    return Kind::folder;
  case AE_IFLNK:
    return Kind::symbolicLink;
  case AE_IFCHR:
  case AE_IFBLK:
    return Kind::device;
  case AE_IFIFO:
    return Kind::fifo;
  case AE_IFSOCK:
    return Kind::socket;
  default:
    return archive_entry_is_data_encrypted(entry) ? Kind::encrypted : Kind::file;
  }
}

class Bundler {
public:
  Bundler(Archive reader, const Limits& limits, std::ostream& out)
      : reader_(std::move(reader)), limits_(limits), out_(out) {}

  void run() {
    writeBundleMark(out_);
    archive_entry* entry = nullptr;
    for (;;) {
      const int status = archive_read_next_header(reader_.get(), &entry);
      if (status == ARCHIVE_EOF) break;
      if (status < ARCHIVE_WARN) unreadable(reader_.get());
      // One filter beside libarchive's own "none".
      if (archive_filter_count(reader_.get()) > 2)
        throw std::runtime_error("is compressed more than once");
      add(entry);
    }
    writeEntry(out_, {.name = "", .kind = Kind::end});
  }

private:
  void add(archive_entry* entry) {
    if (archive_entry_size_is_set(entry)) expand(archive_entry_size(entry));
    const char* text = archive_entry_pathname(entry);
    const std::string name = text ? text : "";
    if (const std::string_view clutter = clutterIn(name); !clutter.empty()) {
      if (++clutter_ > limits_.clutter) tooMany(limits_.clutter);
      return writeEntry(out_, {.name = clutter, .kind = Kind::clutter});
    }
    if (++entries_ > limits_.entries) tooMany(limits_.entries);
    Entry result{.name = name, .kind = kindOf(entry)};
    result.modified = archive_entry_mtime(entry);
    if (archive_entry_size_is_set(entry))
      result.size = static_cast<std::uint64_t>(archive_entry_size(entry));
    if (result.kind == Kind::file) read(result);
    writeEntry(out_, result);
  }

  /// Fills `content_`, which `file` then points to, unless the file is too large or damaged.
  void read(Entry& file) {
    content_.clear();
    if (file.size > limits_.fileBytes) {
      file.kind = Kind::tooLarge;
      return;
    }
    for (;;) {
      char block[1 << 16];
      const la_ssize_t count = archive_read_data(reader_.get(), block, sizeof block);
      if (count < 0) blameTheDisk(reader_.get());
      if (count == ARCHIVE_FATAL)
        throw std::runtime_error("is damaged (" + messageOf(reader_.get()) + ")");
      if (count < 0) {
        file.kind = Kind::damaged;
        return;
      }
      if (count == 0) break;
      content_.append(block, static_cast<std::size_t>(count));
      file.size = content_.size();
      if (file.size > limits_.fileBytes) {
        file.kind = Kind::tooLarge;
        return;
      }
    }
    file.size = content_.size();
    file.bytes = content_;
    bytes_ += file.size;
    if (bytes_ > limits_.bytes)
      throw std::runtime_error("holds more than " + std::to_string(limits_.bytes >> 20) +
                               " MiB of files");
  }

  /// A compressed tar is expanded even where its entries are passed over.
  void expand(std::int64_t bytes) {
    expanded_ += static_cast<std::uint64_t>(bytes);
    if (bytes < 0 || static_cast<std::uint64_t>(bytes) > limits_.expandedBytes ||
        expanded_ > limits_.expandedBytes)
      throw std::runtime_error("expands to more than " +
                               std::to_string(limits_.expandedBytes >> 20) + " MiB");
  }

  [[noreturn]] static void tooMany(std::size_t limit) {
    throw std::runtime_error("holds more than " + std::to_string(limit) + " files and folders");
  }

  Archive reader_;
  const Limits& limits_;
  std::ostream& out_;
  std::string content_;
  std::size_t entries_ = 0;
  std::size_t clutter_ = 0;
  std::uint64_t bytes_ = 0;
  std::uint64_t expanded_ = 0;
};

void bundle(Archive reader, int status, const Limits& limits, std::ostream& out) {
  if (status < ARCHIVE_WARN) unreadable(reader.get());
  Bundler(std::move(reader), limits, out).run();
}

} // namespace

void bundleFile(const char* path, const Limits& limits, std::ostream& out) {
  Archive reader = makeReader();
  const int status = archive_read_open_filename(reader.get(), path, 1 << 16);
  bundle(std::move(reader), status, limits, out);
}

void bundleMemory(std::string_view archive, const Limits& limits, std::ostream& out) {
  Archive reader = makeReader();
  const int status = archive_read_open_memory(reader.get(), archive.data(), archive.size());
  bundle(std::move(reader), status, limits, out);
}

} // namespace ggrade::intake
