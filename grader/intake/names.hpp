#pragma once
/// \file
/// Names of people and files, as they come out of archives and folders of any system.

#include <optional>
#include <string>
#include <string_view>

namespace ggrade::intake {

/// Is it UTF-8 (shortest forms, no surrogates)?
bool isUtf8(std::string_view bytes);

/// Japanese Windows' encoding as UTF-8; nothing where the bytes are not valid CP932. Needs no
/// locale.
std::optional<std::string> fromCp932(std::string_view bytes);

/// A name as UTF-8 in Normalization Form C (Macs write NFD): UTF-8 is taken as such, else CP932.
/// Nothing where it is neither.
std::optional<std::string> decodeName(std::string_view bytes);

/// `decodeName`, with \xNN in place of every byte beyond ASCII where it is neither.
std::string decodeOrEscape(std::string_view bytes);

/// A name to show: one line without control characters and those that turn the direction of text,
/// at most 100 code points.
/// \param name valid UTF-8
std::string displayName(std::string_view name);

/// Does it hold a control character (category Cc)?
/// \param name valid UTF-8
bool hasControl(std::string_view name);

/// Equal for names that differ only in case.
/// \param name valid UTF-8
std::string caseFolded(std::string_view name);

/// A name for a folder on any system: letters and digits of any script, `-` and `_` inside, all
/// else as one `_`; at most 80 bytes, `id` whole at the end. No dot, so no result file has it.
/// \param name valid UTF-8
std::string folderName(std::string_view name, std::string_view id = {});

inline constexpr std::size_t kLongestFolderName = 80; ///< bytes

/// `text` cut between code points to at most `bytes`.
std::string_view cut(std::string_view text, std::size_t bytes);

} // namespace ggrade::intake
