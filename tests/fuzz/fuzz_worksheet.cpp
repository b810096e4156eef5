// Any bytes as a worksheet of Moodle or Canvas: filled in with nothing they are the same; filled in
// with grades, only the cells of grade and feedback differ, and filling in once more changes
// nothing. Only UsageError may be thrown.
#include "require.hpp"

#include "assignment/usage_error.hpp"
#include "gradebook/cells.hpp"
#include "gradebook/csv.hpp"
#include "gradebook/worksheet.hpp"

#include <algorithm>
#include <cstdint>

using namespace ggrade::gradebook;

namespace {

// So that most inputs get beyond the header. The cells that may change are called as in kMayChange.
constexpr std::string_view kMoodle[] = {
    "", "Identifier,Grade,Maximum grade,Grade can be changed,Feedback comments\n",
    "ID;評定;最大評点;フィードバックコメント\r\n"};
constexpr std::string_view kCanvas[] = {
    "", "Student,ID,SIS Login ID,Section,Floor (1)\n    Points Possible,,,,10\n",
    "LastName;FirstName;ID;SIS Login ID;Floor (1)\n    Points Possible;;;;10,0\n"};
const std::string kMayChange[] = {
    "grade",     "評定", "評点", "成績", "feedback comments", "フィードバックコメント",
    "floor (1)", "floor"};

bool mayChange(const Csv& csv, std::size_t column) {
  const std::string header = foldedHeader(csv.cell(0, column));
  return std::find(std::begin(kMayChange), std::end(kMayChange), header) != std::end(kMayChange);
}

void requireRestIsSame(const Csv& filled, const Csv& sheet, const std::string& feedback) {
  require(filled.rows() == sheet.rows() && filled.delimiter() == sheet.delimiter());
  for (std::size_t row = 0; row < sheet.rows(); ++row) {
    require(filled.columns(row) == sheet.columns(row));
    for (std::size_t column = 0; column < sheet.columns(row); ++column) {
      const std::string cell = filled.cell(row, column);
      if (cell == sheet.cell(row, column)) continue;
      require(row > 0 && column < sheet.columns(0) && mayChange(sheet, column));
      const bool isGrade =
          !cell.empty() && cell.find_first_not_of("0123456789.,") == std::string::npos;
      require(isGrade || cell == feedback);
      require(cell.starts_with('\'') || neutralized(cell) == cell);
    }
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // Three bytes choose the kind, the score and the length of the feedback; then that, then the
  // rows.
  if (size < 3) return 0;
  std::string_view rest(reinterpret_cast<const char*>(data) + 3, size - 3);
  const bool isCanvas = data[0] & 1;
  const std::string_view header = (isCanvas ? kCanvas : kMoodle)[data[0] / 2 % 3];
  const std::size_t length = std::min<std::size_t>(data[2] % 32, rest.size());
  const std::string feedback(rest.substr(0, length));
  const std::string bytes = std::string(header) + std::string(rest.substr(length));
  const std::vector<Entry> entries = {{"1", "Student One", data[1] / 2.0, 100, 1.5, feedback},
                                      {"2", "", {}, 100, 0, feedback},
                                      {"Participant 3", "", data[1] / 3.0, 90, 0, feedback},
                                      {"4", "", 1, 3}};
  const auto fill = [&](std::string_view sheet, const std::vector<Entry>& with) {
    return isCanvas ? fillCanvas(sheet, "sheet.csv", with, "Floor").bytes
                    : fillMoodle(sheet, "sheet.csv", with).bytes;
  };
  try {
    require(fill(bytes, {}) == bytes);
    const std::string filled = fill(bytes, entries);
    requireRestIsSame(Csv(filled, "sheet.csv"), Csv(bytes, "sheet.csv"), feedbackCell(feedback));
    require(fill(filled, entries) == filled);
  } catch (const ggrade::UsageError&) {
  }
  return 0;
}
