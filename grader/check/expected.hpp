#pragma once
/// \file
/// What a program is held against where there is no solution: pictures of the reference, of the
/// program after each step, and of known mistakes, all of public scenes.

#include "assignment/assignment.hpp"
#include "check/frustum.hpp"
#include "diagnosis/match.hpp"
#include "diagnosis/outcome.hpp"
#include "rubric/moments.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace ggrade::check {

/// A scene in which a program is looked at.
struct Scene {
  std::string name;
  nlohmann::json scene; ///< a whole scene file
  rubric::Moments times;
  /// The TODO that only this scene shows, so that it is drawn once that is begun; empty: always.
  std::string todo;
  /// Neither the public scene nor one of the handout's: numbers typed in show in it.
  bool another = false;
  /// That a finished program may draw in the first frame; 0: any number.
  std::uint64_t mostVertices = 0;
  /// Of one that is there for a TODO, others whose mistakes show in it alone.
  std::set<std::string> also = {};
};

/// What a mistake spoils in one scene.
struct Spoiled {
  std::optional<diagnosis::Slot> first; ///< the first wrong picture: a pass's; nothing: the window
  bool window = false;                  ///< is that wrong, too?
};

/// A mistake that is known by what it shows in a program that has come to some step.
struct Fault {
  std::string title, hint;
  std::string experiment;            ///< that tells it from what looks like it; or empty
  std::string todo;                  ///< in which it is made
  std::set<std::string> also = {};   ///< in whose places it may be made, too
  std::size_t step = 0;              ///< TODOs that the program has done, this one included
  std::set<std::size_t> scenes = {}; ///< in which it is known what it shows
  /// What was read from a file has no pictures yet, see `viewsOf`.
  diagnosis::Signature signature = {};
  /// Of what was read from a file: by those of its scenes in which it spoils anything.
  std::map<std::size_t, Spoiled> spoils = {};
};

struct Expected {
  std::string assignment, part;      ///< IDs
  std::vector<std::string> todos;    ///< IDs of what is to be done, in order
  std::vector<Scene> scenes;         ///< the public one first
  diagnosis::Run reference;          ///< by scene
  std::vector<diagnosis::Run> steps; ///< by TODOs done: todos.size() + 1
  /// What samplers read in the public scene's first frame, by TODOs done.
  std::vector<std::map<std::string, diagnosis::Sampled>> samplers;
  Frustum frustum; ///< of the public scene
  /// Each in the finished program, and in the first unfinished one in which it shows.
  std::vector<Fault> faults;
  /// Of finished programs that are right and whose windows aren't the reference's, such as one with
  /// another filter.
  std::vector<diagnosis::Run> others;
  std::filesystem::path folder; ///< where it was read from
};

/// Has an assignment several parts whose effects one picture shows? Where only some are to be
/// done, the others come filled in.
inline bool hasTogether(const Assignment& assignment) {
  return assignment.parts.size() > 1 && assignment.drawsTogether;
}
/// All of these effects, as a part whose one TODO is begun once every part is done. Its ID, and its
/// TODO's, is the assignment's.
Part togetherOf(const Assignment& assignment);
inline bool isTogether(const Expected& expected) {
  return expected.part == expected.assignment && expected.todos.size() == 1 &&
         expected.todos.front() == expected.assignment;
}

/// Is a scene drawn of a program that should have done so many TODOs?
bool isDrawnAfter(const Expected& expected, std::size_t scene, std::size_t step);

/// Vertices that all draws of the first frame send, instances included.
std::uint64_t verticesOf(const trace::Trace& trace);

/// The files as they were handed out.
std::filesystem::path stubFolder(const std::filesystem::path& folder);
/// The reference's passes in the public scene, for people: PNG and raw floats.
std::filesystem::path referenceFolder(const std::filesystem::path& folder);
/// A scene's window after `step` TODOs, first frame; PNG. Of a TODO's own scene there is none from
/// before that TODO.
std::filesystem::path stepPicture(const std::filesystem::path& folder, std::size_t step,
                                  std::size_t scene);

/// A scene, as `run --scene` reads it; of those that are `another`.
std::filesystem::path sceneFile(const std::filesystem::path& folder, std::size_t scene);

/// Translations of the faults' texts; there may be none.
std::filesystem::path wordsFile(const std::filesystem::path& folder);

/// Writes all but what these hold. Throws UsageError when the disk is full.
void save(const Expected& expected, const std::filesystem::path& folder);
/// Throws UsageError for a file that is missing or cut off.
Expected load(const std::filesystem::path& folder);
/// What a fault, by its number, shows in a scene in which it is known. There are many, and few are
/// ever asked for. Throws UsageError likewise.
diagnosis::SceneViews viewsOf(const Expected& expected, std::size_t fault, std::size_t scene);

} // namespace ggrade::check
