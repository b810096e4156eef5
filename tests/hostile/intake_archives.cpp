#include "intake_archives.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <zlib.h>

#include <cstdio>
#include <stdexcept>

namespace {

std::string number(std::uint64_t value, int bytes) {
  std::string text;
  for (; bytes > 0; --bytes, value >>= 8) text += static_cast<char>(value & 0xFF);
  return text;
}

std::string deflated(const std::string& bytes) {
  z_stream stream = {};
  deflateInit2(&stream, 9, Z_DEFLATED, -15, 9, Z_DEFAULT_STRATEGY);
  std::string result(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  deflate(&stream, Z_FINISH);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  return result;
}

/// A file as it stands in a zip.
struct Member {
  std::string data;
  std::string common; ///< what its header and the table of contents both say
  std::string extra;
};

Member memberOf(const ZipEntry& entry, std::string data) {
  Member member;
  member.data = std::move(data);
  const std::uint64_t size =
      entry.claimedSize >= 0 ? std::uint64_t(entry.claimedSize) : entry.bytes.size();
  const auto crc = static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(entry.bytes.data()), uInt(entry.bytes.size())));
  // Extended timestamp, as Info-ZIP has it: without time zones.
  member.extra = number(0x5455, 2) + number(5, 2) + '\1' + number(std::uint64_t(entry.modified), 4);
  member.common = number(entry.flags, 2) + number(entry.deflated ? 8 : 0, 2) + number(0, 2) +
                  number(0x5821, 2) + number(crc + entry.crcError, 4) +
                  number(member.data.size(), 4) + number(size, 4) + number(entry.name.size(), 2) +
                  number(member.extra.size(), 2);
  return member;
}

Member memberOf(const ZipEntry& entry) {
  return memberOf(entry, entry.deflated ? deflated(entry.bytes) : entry.bytes);
}

std::string headerOf(const ZipEntry& entry, const Member& member) {
  return "PK\3\4" + number(20, 2) + member.common + entry.name + member.extra;
}

struct ZipWriter {
  std::string file, table;

  /// Adds a line to the table of contents.
  void list(const ZipEntry& entry, const Member& member, std::size_t offset) {
    table += "PK\1\2" + number(20, 1) + number(entry.system, 1) + number(20, 2) + member.common +
             number(0, 6) + number(std::uint64_t(entry.system == 3 ? entry.mode : 0) << 16, 4) +
             number(offset, 4) + entry.name + member.extra;
  }
  std::string whole(std::size_t count) const {
    return file + table + "PK\5\6" + number(0, 4) + number(count, 2) + number(count, 2) +
           number(table.size(), 4) + number(file.size(), 4) + number(0, 2);
  }
};

std::string tarHeader(const TarEntry& entry) {
  std::string header(512, '\0');
  const auto put = [&](std::size_t at, const std::string& text) {
    header.replace(at, text.size(), text);
  };
  const auto octal = [](std::uint64_t value, int digits) {
    char text[32] = {};
    std::snprintf(text, sizeof text, "%0*llo", digits, static_cast<unsigned long long>(value));
    return std::string(text);
  };
  put(0, entry.name.substr(0, 100));
  put(100, octal(06777, 7));
  put(108, octal(0, 7));
  put(116, octal(0, 7));
  put(124,
      octal(entry.claimedSize >= 0 ? std::uint64_t(entry.claimedSize) : entry.bytes.size(), 11));
  put(136, octal(1700000000, 11));
  put(148, "        ");
  header[156] = entry.type;
  put(157, entry.target.substr(0, 100));
  put(257, std::string("ustar\00000", 8));
  unsigned sum = 0;
  for (const char c : header) sum += static_cast<unsigned char>(c);
  put(148, octal(sum, 6) + std::string("\0 ", 2));
  return header;
}

} // namespace

std::string zipOf(const std::vector<ZipEntry>& entries) {
  ZipWriter zip;
  for (const ZipEntry& entry : entries) {
    const Member member = memberOf(entry);
    zip.list(entry, member, zip.file.size());
    zip.file += headerOf(entry, member) + member.data;
  }
  return zip.whole(entries.size());
}

std::string overlappingZip(std::size_t count, std::size_t size) {
  // From the last to the first: what follows a file is known before its header is written.
  ZipEntry last{.name = "0", .bytes = std::string(size, '\0'), .deflated = true};
  Member member = memberOf(last);
  std::vector<std::pair<ZipEntry, Member>> members = {{last, member}};
  std::string behind = headerOf(last, member) + member.data;
  std::vector<std::size_t> lengths = {behind.size()};
  for (std::size_t n = 1; n < count; ++n) {
    const std::size_t quoted = behind.size() - member.data.size();
    ZipEntry entry{.name = std::to_string(n),
                   .bytes = behind.substr(0, quoted) + members.back().first.bytes,
                   .deflated = true};
    // A stored block that is not the last (RFC 1951, 3.2.4) holds the next header.
    const std::string block = '\0' + number(quoted, 2) + number(~quoted, 2);
    member = memberOf(entry, block + behind);
    behind = headerOf(entry, member) + member.data;
    members.emplace_back(entry, member);
    lengths.push_back(behind.size());
  }
  ZipWriter zip;
  zip.file = behind;
  for (std::size_t n = count; n-- > 0;)
    zip.list(members[n].first, members[n].second, behind.size() - lengths[n]);
  return zip.whole(count);
}

std::string tarOf(const std::vector<TarEntry>& entries) {
  std::string file;
  for (const TarEntry& entry : entries) {
    file += tarHeader(entry) + entry.bytes;
    file.append((512 - entry.bytes.size() % 512) % 512, '\0');
  }
  return file + std::string(1024, '\0');
}

std::string compressed(const std::string& bytes, Compression kind) {
  archive* writer = archive_write_new();
  archive_write_set_format_raw(writer);
  if (kind == Compression::gzip) archive_write_add_filter_gzip(writer);
  if (kind == Compression::bzip2) archive_write_add_filter_bzip2(writer);
  if (kind == Compression::xz) archive_write_add_filter_xz(writer);
  if (kind == Compression::zstd) archive_write_add_filter_zstd(writer);
  std::string result(bytes.size() + bytes.size() / 8 + 65536, '\0');
  std::size_t used = 0;
  archive_write_open_memory(writer, result.data(), result.size(), &used);
  archive_entry* entry = archive_entry_new();
  archive_entry_set_pathname(entry, "data");
  archive_entry_set_filetype(entry, AE_IFREG);
  archive_write_header(writer, entry);
  archive_write_data(writer, bytes.data(), bytes.size());
  archive_entry_free(entry);
  if (archive_write_close(writer) != ARCHIVE_OK)
    throw std::runtime_error(archive_error_string(writer));
  archive_write_free(writer);
  result.resize(used);
  return result;
}
