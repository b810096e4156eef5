#include "gradebook/numbers.hpp"

#include "gradebook/cells.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace ggrade::gradebook {

std::optional<double> readNumber(std::string_view text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value, std::chars_format::fixed);
  if (read.ec != std::errc() || read.ptr != end || !std::isfinite(value)) return {};
  return value;
}

std::optional<MarkedNumber> readMarkedNumber(std::string_view text, char mark) {
  std::string number = narrow(text);
  const std::size_t at = number.find_first_of(".,");
  if (at != number.npos) {
    mark = number[at];
    number[at] = '.';
  }
  const std::optional<double> value = readNumber(number);
  if (!value) return {};
  return MarkedNumber{*value, mark};
}

std::string writeNumber(double value, char mark) {
  std::string text = report::number(value, 2);
  std::replace(text.begin(), text.end(), '.', mark);
  return text;
}

} // namespace ggrade::gradebook
