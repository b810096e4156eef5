#pragma once
/// \file
/// What late work loses, by a rule that the instructor states; points in time as people and tools
/// write them, without locale and time zone of the system.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

struct LateRule {
  double percentPerDay = 0; ///< of the maximum score, for every day that has started; above 0
  double atMostPercent = 100;
  std::int64_t graceSeconds = 0; ///< after the deadline, they don't count
};

/// "10% per day", "10% per day, at most 50%", "10% per day, at most 50%, 15 min grace": the parts
/// in any order, each once at most, the first one needed. Throws UsageError with these forms.
LateRule readLateRule(std::string_view text);

/// Points taken off, from 0 to `score`: what remains is never below 0.
double penalty(const LateRule& rule, double score, double maxScore, std::int64_t secondsLate);

/// The rule as the pages state it, one or two sentences.
std::string describe(const LateRule& rule);

/// `--due`. Throws UsageError with the accepted forms.
Time readDue(std::string_view text);

struct Submission {
  std::string student;          ///< as in the gradebook; compared by plainIdentifier
  std::string submitted;        ///< as in the file
  std::int64_t secondsLate = 0; ///< below 0: early
};
/// `--submitted`: a table with the columns student and submitted, and others that aren't looked at.
/// Throws UsageError as `file:line: ...` for a column, student or time that is missing, a time that
/// is none or has a zone where `due` has none (or the other way round), and a student who stands
/// there twice.
std::vector<Submission> readSubmitted(std::string_view bytes, const std::string& fileName,
                                      const Time& due);

} // namespace ggrade::gradebook
