#pragma once
/// \file
/// A new assignment, made from the template `grader/authoring/new`: a small assignment that works,
/// called new_assignment.

#include <filesystem>
#include <string>

namespace ggrade::authoring {

/// Throws UsageError with the reason unless `id` can be the ID of another assignment of the tree
/// `root`: made of lower case letters, digits and _, at most 40 of them, of no assignment or part,
/// no folder on either side, and no target of the build (`buildFile`: its build.ninja, which may be
/// missing).
void requireFreeId(const std::string& id, const std::filesystem::path& root,
                   const std::filesystem::path& buildFile);

/// "Soft light" for "soft_light".
std::string titleOf(const std::string& id);

/// Throws UsageError with the reason unless `title` is one line of text that a handout can show.
void requireTitle(const std::string& title);

/// Writes one side of the template into `into` (made if missing): `templates` is its folder. In
/// names and texts, `new_assignment` becomes the ID and `A new assignment` the title.
void writeTemplate(const std::filesystem::path& templates, const std::string& id,
                   const std::string& title, const std::filesystem::path& into);

} // namespace ggrade::authoring
