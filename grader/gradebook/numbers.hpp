#pragma once
/// \file
/// Numbers in tables, read and written without any locale.

#include <optional>
#include <string>
#include <string_view>

namespace ggrade::gradebook {

/// A decimal number such as "12", "-0.5" or "87.25", and nothing else around it; none for all other
/// text, exponents, "inf" and "nan" included.
std::optional<double> readNumber(std::string_view text);

/// A number as a worksheet writes it, with the mark that its site takes.
struct MarkedNumber {
  double value = 0;
  char mark = '.'; ///< `.` or `,`
};
/// "100", "100.00" and "100,00", with blanks around it. A number without decimals leaves the mark
/// open: it is `mark` then. None for text with several marks ("1,000.00").
std::optional<MarkedNumber> readMarkedNumber(std::string_view text, char mark);

/// At most two decimals, no exponent, no trailing zeros: "87.5", or "87,5" for the mark `,`.
/// \param value finite
std::string writeNumber(double value, char mark = '.');

} // namespace ggrade::gradebook
