#pragma once
/// \file
/// What the program that unpacks hands over: one file in a format that needs no parser to speak of.
///
/// `GGBUNDL1`, then the entries, little-endian: u32 length of the name, the name (bytes as the
/// archive has them), u8 Kind, i64 time of modification (seconds since 1970), u64 size, and for a
/// file that many bytes. The last entry is an `end`.

#include "intake/limits.hpp"

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace ggrade::intake {

enum class Kind : std::uint8_t {
  file,
  folder,
  tooLarge, ///< a file; `size` is what it says, or as far as it was read
  encrypted,
  damaged, ///< or compressed in a way that is not read
  symbolicLink,
  hardLink,
  device,
  fifo,
  socket,
  clutter, ///< the name is that of the clutter
  end
};

struct Entry {
  std::string_view name;
  Kind kind = Kind::file;
  std::int64_t modified = 0;
  std::uint64_t size = 0;
  std::string_view bytes = {}; ///< of a file, `size` of them
};

/// Starts a bundle.
void writeBundleMark(std::ostream& out);

/// Writes one entry, its name cut to kLongestPath. The bundle is complete after Kind::end.
void writeEntry(std::ostream& out, const Entry& entry);

/// The entries, without the end; they point into `bundle`. Every number is a claim: throws
/// std::runtime_error where one does not fit the bundle or goes beyond `limits`.
std::vector<Entry> readBundle(std::string_view bundle, const Limits& limits);

/// What computers leave in folders unasked is passed over and counted, never an error. The
/// component of `path` (parts divided by / or \) that makes it clutter: `__MACOSX`, `.vs`,
/// `.git`, `.DS_Store`, `Thumbs.db`, or `._*` for a name that starts so. Empty if there is none.
std::string_view clutterIn(std::string_view path);

} // namespace ggrade::intake
