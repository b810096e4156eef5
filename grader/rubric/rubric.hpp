#pragma once
/// \file
/// How a rubric is written: `solutions/<id>/rubric.cpp` gives every item that assignment.json
/// declares a function that says how right the frames of one scene are. Points, titles and texts
/// stand in assignment.json.
///
/// \code
/// GGRADE_ITEM("mirror.shading", [](const View& view) { ... return Verdict{quality, message}; })
/// \endcode
///
/// An item that judges what a pass leaves for others says where it lies, so that items after it
/// (`after` in assignment.json) can be judged with the reference's in its place:
///
/// \code
/// GGRADE_PASS("mirror.texture", [](const View& view) -> std::vector<PassOutput> { ... })
/// \endcode

#include "assignment/assignment.hpp"
#include "rubric/evidence.hpp"

#include <functional>
#include <map>
#include <string>

namespace ggrade::rubric {

/// What an item looks at: one scene, and the frames in question (the student's; for the scale also
/// the stub's and the reference's).
struct View {
  const SceneEvidence& scene;
  const Frames& frames;
  const trace::Trace& trace; ///< the passes that made them; with copies in the first frame
  /// The scene that this one is a change of; null if there is none, or its student's frames never
  /// came.
  const SceneEvidence* base = nullptr;
};

/// How right the frames are: 1 is as good as the reference, 0 has nothing of it. Must be finite.
struct Verdict {
  double quality = 0;
  std::string
      message; ///< with numbers: "31% of the reflection's pixels differ, densest at (212,340)"
};

using Judge = std::function<Verdict(const View&)>;

/// An attachment after a pass of the first frame.
struct PassOutput {
  std::uint32_t pass = 0; ///< index in the trace
  std::uint32_t attachment = 0;
};

/// Where the passes that an item judges have left their output, in an order that is the same for a
/// submission and the reference. Empty where there is none, or where the reference's output would
/// be of no use to the submission's later passes (as for a map that is read through another
/// matrix).
using Finder = std::function<std::vector<PassOutput>(const View&)>;

/// Registers the finder of one item, like `add`.
bool addFinder(const std::string& item, Finder finder);

/// Registers the judge of one item; returns true so that it can stand at namespace scope.
bool add(const std::string& item, Judge judge);

/// What the engine decides about one item over all scenes.
struct Decision {
  double credit = 0;   ///< 0 to 1, see results::creditOf
  std::string message; ///< of the worst scene
  std::vector<results::SceneCredit> credits;
  std::vector<std::string> messages; ///< one to each of `credits`
};

/// What the stub has of an item in a scene, for who asks for many submissions.
using Floors = std::map<std::pair<std::string, const SceneEvidence*>, double>;

/// Gain and bonus items: the student's quality on the scale from the stub's (0) to the reference's
/// (1). Keep items: the quality itself; what is missing from 1 is taken away. A missing frame has
/// credit 0; of keep items only in a scene in which nothing is gained.
///   items: all of the rubric
Decision decide(const ItemDeclaration& item, const std::vector<ItemDeclaration>& items,
                const Judge& judge, const Evidence& evidence, Floors* floors = nullptr);

/// Asks about the reference and the stub in every scene that the item looks at: `floors` then knows
/// the stub's qualities, and the rubric what it keeps of a scene.
void warm(const ItemDeclaration& item, const Judge& judge, const Evidence& evidence,
          Floors& floors);

/// Points earned, to a tenth: what a person can check by hand. Of a keep item: 0 or less.
double pointsOf(results::ItemKind kind, double points, double credit);

/// Where the passes of an item that failed have left their output, where another of `items` builds
/// on it: a list of `{"scene": index, "pairs": [[pass, attachment, the reference's pass, its
/// attachment], ...]}`, one entry for each scene that such an item looks at and where this one did
/// not earn nearly all. Only pairs of textures of equal size and format. Null if there is none.
nlohmann::json outputsOf(const ItemDeclaration& item, const std::vector<ItemDeclaration>& items,
                         const Decision& decision, const Evidence& evidence);

/// With less of its points an item has failed, and what is after it may be judged without it.
inline constexpr double kNearlyAll = 0.9;

/// The decision as a line of results: item, points earned, message, credits by scene.
nlohmann::json lineOf(const ItemDeclaration& item, const Decision& decision);

/// The judge of an item. Throws UsageError if no rubric has it.
const Judge& judgeOf(const std::string& item);

/// Judges the evidence by those of `items` that it wants judged, each a GoogleTest test named
/// `part.item`, once a process, and appends one JSON object a line to `results` after each.
/// `arguments` are GoogleTest's. Returns the exit code: 0 all items were judged, whatever the
/// points; 1 an item has no judge or threw.
int judgeItems(const Evidence& evidence, const std::vector<ItemDeclaration>& items, Floors* floors,
               const std::filesystem::path& results, const std::vector<std::string>& arguments);

/// Judges submissions in the same scenes. `evidence` names no student's folders; every line on
/// stdin is a request `{"students": [folder, ...], "arguments": [...], "again": [item, ...],
/// "results": file, "done": file}`. Each is answered by judgeItems in a process of its own; `done`
/// is then made: kJudged, or what went wrong; empty if not even that could be written. `many`, or a
/// line `{"warm": true}`: what only the reference decides is worked out before the next. Ends with
/// stdin.
inline constexpr char kJudged[] = "judged";
int serveJudge(const std::filesystem::path& evidence, bool many);

} // namespace ggrade::rubric

#define GGRADE_ITEM_JOIN_(a, b) a##b
#define GGRADE_ITEM_NAME_(line) GGRADE_ITEM_JOIN_(ggradeItem, line)
#define GGRADE_ITEM(item, ...)                                                                     \
  [[maybe_unused]] static const bool GGRADE_ITEM_NAME_(__LINE__) =                                 \
      ::ggrade::rubric::add(item, __VA_ARGS__)
#define GGRADE_PASS(item, ...)                                                                     \
  [[maybe_unused]] static const bool GGRADE_ITEM_NAME_(__LINE__) =                                 \
      ::ggrade::rubric::addFinder(item, __VA_ARGS__)
