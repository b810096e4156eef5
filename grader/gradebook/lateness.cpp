#include "gradebook/lateness.hpp"

#include "assignment/usage_error.hpp"
#include "gradebook/cells.hpp"
#include "gradebook/csv.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <map>

namespace ggrade::gradebook {
namespace {

// Takes text from its front.
class Scanner {
public:
  explicit Scanner(std::string_view text) : rest_(text) {}

  bool atEnd() const { return rest_.empty(); }
  bool take(char c) {
    if (rest_.empty() || rest_[0] != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  // A number of `least` to `most` digits; -1 if there is none.
  int number(std::size_t least, std::size_t most) {
    int value = 0;
    std::size_t digits = 0;
    for (; digits < most && digits < rest_.size(); ++digits) {
      if (rest_[digits] < '0' || rest_[digits] > '9') break;
      value = value * 10 + (rest_[digits] - '0');
    }
    if (digits < least) return -1;
    rest_.remove_prefix(digits);
    return value;
  }

private:
  std::string_view rest_;
};

bool isWithin(int value, int most) {
  return value >= 0 && value <= most;
}

// Seconds east of Greenwich; none for no zone. False for what is none.
bool readZone(Scanner& in, std::optional<std::int64_t>& east) {
  if (in.take('Z') || in.take('z')) {
    east = 0;
    return true;
  }
  const bool isEast = in.take('+');
  if (!isEast && !in.take('-')) return true;
  const int hours = in.number(2, 2);
  const bool hasColon = in.take(':');
  const int minutes = in.atEnd() && !hasColon ? 0 : in.number(2, 2);
  if (!isWithin(hours, 14) || !isWithin(minutes, 59)) return false;
  east = (isEast ? 1 : -1) * (hours * 3600 + minutes * 60);
  return true;
}

} // namespace

std::optional<Time> readTime(std::string_view text) {
  Scanner in(trimmed(text));
  const int year = in.number(4, 4);
  const bool isSlashed = in.take('/');
  if (year < 1970 || (!isSlashed && !in.take('-'))) return {};
  const std::size_t least = isSlashed ? 1 : 2;
  const int month = in.number(least, 2);
  if (!in.take(isSlashed ? '/' : '-')) return {};
  const int day = in.number(least, 2);
  if (month < 0 || day < 0 || !(in.take(' ') || (!isSlashed && (in.take('T') || in.take('t')))))
    return {};
  const int hour = in.number(least, 2);
  if (!in.take(':')) return {};
  const int minute = in.number(2, 2);
  int second = 0;
  if (in.take(':')) {
    second = in.number(2, 2);
    if (in.take('.') && in.number(1, 9) < 0) return {};
  }
  if (!isWithin(hour, 23) || !isWithin(minute, 59) || !isWithin(second, 59)) return {};
  std::optional<std::int64_t> east;
  if (!readZone(in, east) || !in.atEnd()) return {};

  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(month),
                                         std::chrono::day(day)};
  if (!date.ok()) return {};
  const std::int64_t days = std::chrono::sys_days(date).time_since_epoch().count();
  return Time{days * 86400 + hour * 3600 + minute * 60 + second - east.value_or(0),
              east.has_value()};
}

std::optional<std::int64_t> secondsLate(const Time& submitted, const Time& due) {
  if (submitted.hasZone != due.hasZone) return {};
  return submitted.seconds - due.seconds;
}

namespace {

constexpr std::int64_t kSecondsPerDay = 86400;

// The number between `before` and `after`, if the text is made like that.
std::optional<double> numberIn(std::string_view text, std::string_view before,
                               std::string_view after) {
  if (text.size() < before.size() + after.size()) return {};
  if (!text.starts_with(before) || !text.ends_with(after)) return {};
  text.remove_prefix(before.size());
  text.remove_suffix(after.size());
  return readNumber(text);
}

// False if the part is none, or one that was there before.
bool readPart(std::string_view part, std::optional<double>& perDay, std::optional<double>& atMost,
              std::optional<double>& minutes) {
  const auto percent = [](double value) { return value > 0 && value <= 100; };
  if (const auto value = numberIn(part, "", "% per day"); value && !perDay) {
    perDay = value;
    return percent(*value);
  }
  if (const auto value = numberIn(part, "at most ", "%"); value && !atMost) {
    atMost = value;
    return percent(*value);
  }
  if (const auto value = numberIn(part, "", " min grace"); value && !minutes) {
    minutes = value;
    return *value >= 0 && *value <= 7 * 24 * 60 && *value == std::int64_t(*value);
  }
  return false;
}

} // namespace

LateRule readLateRule(std::string_view text) {
  const auto fault = [&](const std::string& what) {
    throw UsageError(fmt::format("--late \"{}\": {}; write \"10% per day\", and if need be \"at "
                                 "most 50%\" and \"15 min grace\", each once, with commas between "
                                 "(percentages above 0 and at most 100, whole minutes of 7 days "
                                 "at most)",
                                 text, what));
  };
  std::optional<double> perDay, atMost, minutes;
  for (std::string_view rest = text;;) {
    const std::string_view part = rest.substr(0, rest.find(','));
    if (!readPart(trimmed(part), perDay, atMost, minutes))
      fault(fmt::format("\"{}\" is no part of a rule", trimmed(part)));
    if (part.size() == rest.size()) break;
    rest.remove_prefix(part.size() + 1);
  }
  if (!perDay) fault("it doesn't say what a day costs");
  return {*perDay, atMost.value_or(100), std::int64_t(minutes.value_or(0) * 60)};
}

double penalty(const LateRule& rule, double score, double maxScore, std::int64_t secondsLate) {
  const std::int64_t counted = secondsLate - rule.graceSeconds;
  if (counted <= 0) return 0;
  const std::int64_t days = (counted + kSecondsPerDay - 1) / kSecondsPerDay;
  const double percent = std::min(rule.percentPerDay * double(days), rule.atMostPercent);
  return std::clamp(percent / 100 * maxScore, 0.0, std::max(score, 0.0));
}

std::string describe(const LateRule& rule) {
  std::string text = fmt::format("Late work loses {}% of the maximum score for every started day",
                                 writeNumber(rule.percentPerDay));
  if (rule.atMostPercent < 100)
    text += fmt::format(", {}% at most", writeNumber(rule.atMostPercent));
  text += '.';
  if (rule.graceSeconds > 0)
    text +=
        fmt::format(" The first {} min after the deadline don't count.", rule.graceSeconds / 60);
  return text;
}

Time readDue(std::string_view text) {
  const auto due = readTime(text);
  if (!due) throw UsageError(fmt::format("--due \"{}\": write {}", text, kTimeForms));
  return *due;
}

std::vector<Submission> readSubmitted(std::string_view bytes, const std::string& fileName,
                                      const Time& due) {
  const Csv csv(bytes, fileName);
  const std::vector<std::size_t> at =
      columnsNamed(csv, fileName, {"student", "submitted"}, OtherColumns::allowed);
  std::vector<Submission> all;
  std::map<std::string, std::size_t> lines;
  for (std::size_t row = 1; row < csv.rows(); ++row) {
    if (csv.isBlank(row)) continue;
    const auto fault = [&](const std::string& what) {
      throw UsageError(fmt::format("{}:{}: {}", fileName, csv.line(row), what));
    };
    const std::string student = cellOf(csv, row, at[0]), submitted = cellOf(csv, row, at[1]);
    if (student.empty()) fault("there is no student: write the identifier of the gradebook");
    const auto [first, isNew] = lines.emplace(plainIdentifier(student), csv.line(row));
    if (!isNew)
      fault(fmt::format("\"{}\" stands in line {}, too: keep the submission that counts",
                        report::sanitizeLine(student, 100), first->second));
    const auto time = readTime(narrow(submitted));
    if (!time)
      fault(fmt::format("submitted is \"{}\": write {}", report::sanitizeLine(submitted, 60),
                        kTimeForms));
    const auto late = secondsLate(*time, due);
    if (!late)
      fault(fmt::format("submitted is \"{}\" and has {} time zone, but --due has {}: write both "
                        "with a zone such as +09:00, or both without",
                        submitted, time->hasZone ? "a" : "no", due.hasZone ? "one" : "none"));
    all.push_back({student, submitted, *late});
  }
  return all;
}

} // namespace ggrade::gradebook
