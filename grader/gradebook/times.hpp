#pragma once
/// \file
/// Points in time as people and tools write them, without locale and time zone of the system.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ggrade::gradebook {

struct Time {
  std::int64_t seconds = 0; ///< since 1970-01-01T00:00 of its zone, or of a zone that isn't known
  bool hasZone = false;
};

/// ISO 8601 "2026-11-20T23:59", also with a blank for the T, seconds (a fraction is dropped) and a
/// zone: "Z", "+09:00", "+0900" or "+09"; or "2026/11/20 23:59" as spreadsheets write it, where
/// month, day and hour may have one digit. Blanks around it don't matter. None for all other text,
/// days that there are not included.
std::optional<Time> readTime(std::string_view text);

/// Forms that readTime takes, for messages.
inline constexpr std::string_view kTimeForms =
    "2026-11-20T23:59+09:00, 2026-11-20T23:59 or 2026/11/20 23:59";

/// Seconds from `due` to `submitted`; below 0: early. None where only one of them has a zone.
std::optional<std::int64_t> secondsLate(const Time& submitted, const Time& due);

} // namespace ggrade::gradebook
