#include "intake/bundle.hpp"

#include <algorithm>
#include <ostream>
#include <stdexcept>

namespace ggrade::intake {
namespace {

constexpr std::string_view kMark = "GGBUNDL1";

void writeNumber(std::ostream& out, std::uint64_t value, int bytes) {
  for (; bytes > 0; --bytes, value >>= 8) out.put(static_cast<char>(value & 0xFF));
}

class Cursor {
public:
  explicit Cursor(std::string_view rest) : rest_(rest) {}

  std::string_view take(std::uint64_t bytes, const char* what) {
    if (bytes > rest_.size())
      throw std::runtime_error(std::string(what) + " of " + std::to_string(bytes) +
                               " bytes where " + std::to_string(rest_.size()) + " are left");
    const std::string_view taken = rest_.substr(0, bytes);
    rest_.remove_prefix(bytes);
    return taken;
  }
  std::uint64_t number(unsigned bytes) {
    std::uint64_t value = 0;
    const std::string_view taken = take(bytes, "a number");
    for (unsigned n = bytes; n-- > 0;) value = value << 8 | static_cast<unsigned char>(taken[n]);
    return value;
  }
  bool atEnd() const { return rest_.empty(); }

private:
  std::string_view rest_;
};

Entry readEntry(Cursor& cursor, const Limits& limits) {
  const auto refuse = [](const char* what, std::uint64_t value) {
    throw std::runtime_error(std::string(what) + std::to_string(value));
  };
  Entry entry;
  const std::uint64_t nameLength = cursor.number(4);
  if (nameLength > kLongestPath) refuse("a name of bytes: ", nameLength);
  entry.name = cursor.take(nameLength, "a name");
  const std::uint64_t kind = cursor.number(1);
  if (kind > static_cast<std::uint64_t>(Kind::end)) refuse("unknown kind of entry: ", kind);
  entry.kind = static_cast<Kind>(kind);
  entry.modified = static_cast<std::int64_t>(cursor.number(8));
  entry.size = cursor.number(8);
  if (entry.kind != Kind::file) return entry;
  if (entry.size > limits.fileBytes) refuse("a file beyond the limit, of bytes: ", entry.size);
  entry.bytes = cursor.take(entry.size, "a file");
  return entry;
}

} // namespace

void writeBundleMark(std::ostream& out) {
  out << kMark;
}

void writeEntry(std::ostream& out, const Entry& entry) {
  const std::string_view name = entry.name.substr(0, kLongestPath);
  writeNumber(out, name.size(), 4);
  out << name;
  writeNumber(out, static_cast<std::uint64_t>(entry.kind), 1);
  writeNumber(out, static_cast<std::uint64_t>(entry.modified), 8);
  writeNumber(out, entry.size, 8);
  if (entry.kind == Kind::file) out << entry.bytes;
}

std::vector<Entry> readBundle(std::string_view bundle, const Limits& limits) {
  Cursor cursor(bundle);
  if (cursor.take(kMark.size(), "a mark") != kMark) throw std::runtime_error("it is no bundle");
  std::vector<Entry> entries;
  std::size_t clutter = 0;
  std::uint64_t bytes = 0;
  for (;;) {
    const Entry entry = readEntry(cursor, limits);
    if (entry.kind == Kind::end) break;
    if (entry.kind == Kind::clutter) ++clutter;
    bytes += entry.bytes.size();
    entries.push_back(entry);
    if (clutter > limits.clutter || entries.size() - clutter > limits.entries)
      throw std::runtime_error("it holds more entries than allowed");
    if (bytes > limits.bytes) throw std::runtime_error("it holds more bytes than allowed");
  }
  if (!cursor.atEnd()) throw std::runtime_error("something follows its end");
  return entries;
}

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
