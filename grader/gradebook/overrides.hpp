#pragma once
/// \file
/// Points that a person has given in place of the machine's.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ggrade::gradebook {

/// One line of overrides.csv, whose header is `student,item,points,reason,who`.
struct Override {
  std::string student; ///< as in the gradebook; compared by plainIdentifier
  std::string item;    ///< "mirror.shading"; empty: the total
  double points = 0;   ///< in place of what the item earned, or of the total
  std::string reason, who;
  std::size_t line = 0; ///< of the file
};

/// Throws UsageError as `file:line: ...` with the remedy for a column that is missing or unknown, a
/// student, reason or who that is missing, points that are no number or beyond kMostPoints, a total
/// below 0, and a student and item that stand there twice.
std::vector<Override> readOverrides(std::string_view bytes, const std::string& fileName);

/// More than any assignment gives or takes.
inline constexpr double kMostPoints = 1e6;

struct MachineItem {
  std::string id;
  double earned = 0;          ///< points given or, below 0, taken away
  double least = 0, most = 0; ///< that it can be
};

/// What the machine made of one submission: what is never altered.
struct MachineScore {
  std::string student;
  std::optional<double> score{};    ///< none: not gradable
  std::vector<MachineItem> items{}; ///< what counts in the score
  double most = kMostPoints;        ///< that the score can be, the bonus included
};

/// One override beside what it replaces.
struct Change {
  std::string item;              ///< empty: the total
  std::optional<double> machine; ///< points of the machine; none: not gradable
  double points = 0;
  std::string reason, who;
  /// Why the points can hardly be meant: beyond what the item, or all of them, can give. They count
  /// all the same. Empty: they are within.
  std::string beyond{};
};

struct Overridden {
  std::string student;
  std::optional<double> machine{}; ///< the machine's score
  /// The score that counts, never below 0: the machine's where nothing is changed, the overridden
  /// total, or the sum of the items to one decimal. None: not gradable.
  std::optional<double> score{};
  std::vector<Change> changes{};
};

struct Overrides {
  std::vector<Overridden> scores; ///< one to each of the machine's, in their order
  std::vector<std::string> remarks;
};

/// Applies what can be applied for certain and says in words what can't: students and items that
/// there are not, items of a submission that was not gradable (its total can be given), items
/// beside an overridden total, which stands whatever they are. Points beyond what an item can give
/// count, with a remark and marked in their Change: a sign or an item may be the wrong one.
Overrides applyOverrides(const std::vector<MachineScore>& scores,
                         const std::vector<Override>& overrides, const std::string& fileName);

} // namespace ggrade::gradebook
