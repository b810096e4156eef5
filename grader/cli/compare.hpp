#pragma once
/// \file
/// `ggrade compare`: two image files, idiff's numbers and verdict, and the comparison that grades
/// use.

#include "image/compare.hpp"
#include "image/flip.hpp"

#include <filesystem>
#include <iosfwd>
#include <limits>
#include <optional>

namespace ggrade::cli {

/// Exit codes, as idiff's.
enum class CompareExit {
  same = 0,      ///< within the limits
  warning = 1,   ///< beyond the warning's limits only
  failure = 2,   ///< beyond the limits, or NaN or Inf in either image
  different = 3, ///< sizes or channels differ: nothing to compare
  fileError = 4  ///< a file cannot be read or written, or the command line is wrong
};

/// The command line; the limits mean what they mean to idiff.
struct CompareArguments {
  std::filesystem::path image, reference;
  float fail = 1e-6f;     ///< a pixel fails above this difference in any channel
  double failPercent = 0; ///< so many percent of the pixels may fail
  double hardFail = std::numeric_limits<double>::infinity(); ///< no pixel may differ by more
  /// Likewise for a warning. Not given: 1e-6, but nothing warns unless some pixel is over `fail`,
  /// as in idiff 2.4 (which goes on to ignore a warning's and the hard limits that are given; here
  /// they hold).
  std::optional<float> warn;
  double warnPercent = 0;
  double hardWarn = std::numeric_limits<double>::infinity();
  std::filesystem::path out; ///< difference image to write; empty: none
  float scale = 1;           ///< factor on the difference image
  bool absolute = false;     ///< difference image of absolute values
  bool quiet = false;
  bool json = false;
  bool flip = false; ///< FLIP too; `out` then is its heat map
  double pixelsPerDegree = kFlipPixelsPerDegree;
  CompareOptions tolerant; ///< the grade's comparison; channels 0: all but alpha
};

/// Compares, prints to `out` (what went wrong to `errors`), writes the difference or FLIP's image.
/// Never throws for what the files hold.
CompareExit runCompare(const CompareArguments& arguments, std::ostream& out, std::ostream& errors);

} // namespace ggrade::cli
