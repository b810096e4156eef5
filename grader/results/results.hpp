#pragma once
/// \file
/// What grading one submission produced: the one structure that every report is written from.

#include "image/image.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ggrade::results {

/// How grading a submission ended. Always told apart; only `notGradable` is our fault.
enum class Outcome {
  graded,
  buildFailed,
  shaderError,
  glError, ///< frames came and were scored, but OpenGL reported errors
  noFrame, ///< never swapped buffers
  timeout,
  crash,
  outOfMemory,
  badOutput,
  notGradable
};

/// `graded`, `build_failed`, ... as in the contract.
std::string_view name(Outcome outcome);
/// The other way; nothing for any other word.
std::optional<Outcome> parseOutcome(std::string_view word);
/// One sentence for a person.
std::string_view explanation(Outcome outcome);

enum class ItemKind { gain, keep, bonus };

/// `gain`, `keep` or `bonus`.
std::string_view name(ItemKind kind);
/// The other way; nothing for any other word.
std::optional<ItemKind> parseItemKind(std::string_view word);

/// For the grading process: where the passes that a failed item judges have left in one scene what
/// later ones build on.
struct PassOutputs {
  struct Pair {
    std::uint32_t pass, attachment; ///< in the submission's trace
    std::uint32_t referencePass, referenceAttachment;
  };
  std::size_t scene = 0; ///< index in the plan
  std::vector<Pair> pairs;
};

/// What an item has earned in one scene.
struct SceneCredit {
  std::string scene; ///< its name
  double credit = 0; ///< 0 to 1
  bool isPublic = false;

  bool operator==(const SceneCredit&) const = default;
};

/// What an item earns of its points by what it has in each scene: 0 to 1, and 1 without any. Gain
/// and bonus: the mean over the hidden scenes (the public one, which students have, counts where no
/// hidden one shows the item), but what is wrong in one scene costs at least half of what it would
/// if it were so in all: at most (1 + the worst) / 2. Keep: the worst of all scenes.
double creditOf(ItemKind kind, const std::vector<SceneCredit>& credits);

/// One rubric item. `points` come from assignment.json.
struct Item {
  std::string id; ///< "mirror.shading"
  std::string title;
  std::string looksAt; ///< what the item looks at, one sentence
  ItemKind kind = ItemKind::gain;
  double points = 0;   ///< most that it can give (gain, bonus) or take away (keep)
  double earned = 0;   ///< 0 to points (gain, bonus) or -points to 0 (keep)
  bool judged = false; ///< false: the judge never reached it
  std::string message; ///< what was seen, with numbers
  std::string where;   ///< scene and pixel of the worst place; hidden scenes: see Reveal
  std::string cause;   ///< what a failure most likely means; empty when all points were earned
  std::string step;    ///< heading of the handout to read again; empty when all points were earned
  bool beyondLecture = false;
  std::vector<SceneCredit> credits;
  std::vector<std::string> messages; ///< one to each of `credits`
  std::vector<PassOutputs> outputs;  ///< by scene; empty where nothing can be replaced
  /// What the reference's was put in place of ("reflection"), where the item earned more by that;
  /// else empty.
  std::vector<std::string> carried;
  std::vector<std::string> repaired; ///< likewise of proved causes ("the viewport")
};

/// One frame as a person compares it. Images are RGBA, 0 to 1, and may be empty (no frame came).
struct Frame {
  double time = 0; ///< seconds
  Image student, reference, difference;
  double wrongShare = 0; ///< of all pixels, tolerant comparison
  std::string hash{};    ///< of the student's bytes: equal hashes are bit-identical frames
  /// FLIP (image/flip.hpp), for people: 0 to 1; unless there was a pair to compare, not a number.
  double flip = std::numeric_limits<double>::quiet_NaN();
  Image flipPicture{};        ///< its map as a heat map
  std::string referencePng{}; ///< `reference` as a data URI, if somebody has encoded it before
  /// Of the pixels that a second run of the same program drew otherwise, in any bit: 0 to 1.
  double unsteadyShare = 0;
  Image unsteadyPicture{}; ///< where; empty if nowhere
};

struct Scene {
  std::string name;
  bool isPublic = false;
  std::string outcome; ///< contract name of what happened in this scene
  std::string detail;  ///< one sentence with the evidence
  std::vector<Frame> frames;
  std::vector<std::string> messages; ///< GL errors and notices of the capture, UTF-8
  std::string output; ///< stdout and stderr of the run; of hidden scenes the instructor's page only
  double seconds = 0;
};

/// The likeliest fault of a submission, in words for its author. What is not known is empty: where
/// nothing known fits, `text` says so and `confidence` is 0.
struct Diagnosis {
  std::string part;                ///< of the assignment; empty: of all
  std::string text;                ///< what it is most likely, and what to look at
  std::string step;                ///< heading of the handout to read again
  double confidence = 0;           ///< 0 to 1; what shows the same shares it
  std::string picture;             ///< the first picture that is wrong: a pass's, or the window's
  std::string amount;              ///< how much of it
  std::string scene;               ///< where that was seen
  std::string place;               ///< and in which part of the picture, pixels from the top left
  std::vector<std::string> beside; ///< what else speaks for it, such as the compiler's warnings
  std::string id; ///< name in the catalogue, of the outcome or of the change; for the instructor
};

/// What stands in ProvedCause::own of a texture that isn't what another pass drew: none is read, or
/// the one that the same pass draws into.
inline constexpr const char *kNoTexture = "texture 0", *kDrawnInto = "GL_DRAW_FRAMEBUFFER";

/// What was wrong, proved by drawing it again with the reference's in its place.
struct ProvedCause {
  std::set<std::size_t> passes; ///< of the submission, counted within a frame from 0
  std::string role;             ///< of these passes, see repair::Unit
  std::string unit;             ///< "viewport", "uniform uLight", "function visibility in fragment"
  std::set<std::string> todos;  ///< whose work it is; none: it was right before, and was spoiled
  bool isUnseen = false;        ///< draws that lack: what else belongs to them can't be seen
  /// Of what is nobody's work: the TODOs with a statement that changes it or puts it back.
  std::set<std::string> changedBy{};
  std::set<std::string> notBegun{};  ///< of `todos` those of whose work nothing is there
  std::set<std::string> untouched{}; ///< of `todos` those that what is drawn shows nothing of
  std::string own{}; ///< what the submission has there: "0, 0, 640, 480"; empty: not said
};

struct Timing {
  std::string what;
  double seconds = 0;
};

struct Result {
  std::string assignment; ///< "floor"
  std::string part;       ///< "mirror", or the assignment's ID when all parts are graded
  std::string title;
  std::string submission; ///< display name
  Outcome outcome = Outcome::notGradable;
  std::string detail; ///< one or two sentences: what happened and what to do
  double score = 0;   ///< gain and keep, never below 0
  double bonus = 0;
  double maxScore = 0;
  std::vector<Item> items;
  std::vector<Item> asDrawn;       ///< before each fault was counted once; empty: as they are
  std::vector<ProvedCause> causes; ///< what each fault costs was counted by them
  std::string causesSought; ///< why there are none although points were lost, for the instructor
  std::vector<Diagnosis> diagnoses; ///< at most one a part; none where nothing was lost
  std::vector<Scene> scenes;
  std::string compilerOutput;           ///< valid UTF-8, the student's file names
  std::vector<std::string> unusedFiles; ///< what the upload held besides, with the reason
  std::vector<std::string> refused;     ///< of these what was refused; or the upload as a whole
  std::vector<Timing> timings; ///< one called "total" holds the sum; else they are added up
  std::vector<std::pair<std::string, double>>
      thresholds; ///< the comparison's tolerances, published
  std::uint64_t seed = 0;
  std::string quality; ///< how closely the grading looked: fast, balanced or thorough
  std::string sandbox; ///< "bwrap" or "none"
  std::vector<std::pair<std::string, std::string>>
      fingerprint; ///< renderer, compiler, tool version, pins
};

} // namespace ggrade::results
