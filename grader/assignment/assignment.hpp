#pragma once
/// \file
/// What an assignment declares in its assignment.json: files, parts, TODOs, rubric items and
/// points.

#include "assignment/usage_error.hpp"
#include "results/results.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace ggrade {

/// One place that a student fills in.
struct Todo {
  std::string id; ///< "mirror.3"
  std::string title;
  bool bonus = false;
  bool beyondLecture = false;
};

/// One rubric item as declared; what it measures is code in `solutions/<id>/rubric.cpp`.
struct ItemDeclaration {
  std::string id; ///< "mirror.shading"
  std::string title;
  std::string looksAt;
  results::ItemKind kind = results::ItemKind::gain;
  double points = 0;
  std::string cause; ///< what a failure most likely means
  std::string step;  ///< the TODO whose step in the handout helps, "mirror.5"
  bool beyondLecture = false;
  std::vector<std::string>
      scenes; ///< tags of the scenes that it looks at; empty: all but bonus scenes
  /// The item that judges the pass which this one builds on; empty: none. Where that one failed,
  /// this one is judged once more with the reference's output of the pass, and the better counts.
  std::string after;
  /// What its work is, where that is not all of its step's: units as repair names them ("culling",
  /// "block Light"). What an item names is nobody else's.
  std::vector<std::string> work;
  /// What the item's pass leaves, in a word or two ("shadow map"); not empty where another item is
  /// after this one.
  std::string output;
};

/// What is handed out, graded and given points together.
struct Part {
  std::string id; ///< "mirror"
  std::string title;
  double weight = 0;    ///< share of the whole assignment, 0 to 1
  nlohmann::json scene; ///< merged over scene.json where this part is shown
  std::vector<Todo> todos;
  std::vector<ItemDeclaration> items;
};

struct Assignment {
  std::string id; ///< "floor"
  std::string title;
  std::vector<std::string> files;         ///< what a student edits
  std::vector<std::string> optionalFiles; ///< patterns such as "*.vert" that an upload may add
  std::vector<Part> parts;                ///< a single one may have the assignment's own ID
  bool drawsTogether = true;              ///< may one picture show the effects of all parts?
  std::filesystem::path folder;           ///< where it was read from

  /// Has it one part alone, under its own ID? Its handout is then README.md.
  bool isOnePart() const { return parts.size() == 1 && parts[0].id == id; }

  /// What the program reads beside its own files: assignment.json, scene.json, and presets.json if
  /// there is one.
  std::vector<std::string> dataFiles() const;

  /// Reads `folder/assignment.json`. What a student reads is in the language that was chosen, where
  /// `folder/words.ja.json` has it. Throws UsageError.
  static Assignment load(const std::filesystem::path& folder);
};

/// What is graded: some parts of one assignment.
struct Target {
  Assignment assignment;
  std::vector<Part> parts; ///< one, or all of the assignment
  std::string id;          ///< as it was named: "mirror" or "floor"

  /// The part's, or where several are graded together the assignment's.
  const std::string& title() const { return parts.size() == 1 ? parts[0].title : assignment.title; }

  double maxScore() const; ///< sum of the points of the gain items
  /// With the points as declared, or where several parts are graded together, times the part's
  /// weight.
  std::vector<ItemDeclaration> items() const;
  /// Is this part graded?
  bool covers(const std::string& partId) const;
};

/// All assignments under `root/assignments`, by ID. Throws UsageError, also where two have an ID
/// of an assignment or part in common.
std::vector<Assignment> loadAssignments(const std::filesystem::path& folder);

/// Finds the assignment or part `id` under `folder`. Throws UsageError that lists what there is.
Target findTarget(const std::filesystem::path& folder, const std::string& id);

/// Adds what `folder/words.ja.json`, an assignment's or a solution's, says in the chosen language.
/// Throws UsageError if it is no object of texts.
void addWords(const std::filesystem::path& folder);

/// Reads a whole file. Throws UsageError naming it.
std::string readFile(const std::filesystem::path& path);

/// Parses JSON. Throws UsageError with `path:line`.
nlohmann::json readJson(const std::filesystem::path& path);

} // namespace ggrade
