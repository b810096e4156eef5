#include "gradebook/times.hpp"

#include "gradebook/cells.hpp"

#include <chrono>

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

} // namespace ggrade::gradebook
