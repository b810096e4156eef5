#pragma once
/// \file
/// What a student may see of the hidden scenes.

#include "results/results.hpp"

#include <optional>
#include <string_view>

namespace ggrade::report {

/// Each level shows what the one before it shows, and more.
enum class Reveal {
  none,   ///< titles and points of the items; nothing of a hidden scene
  names,  ///< names of hidden scenes and what happened there, credits, messages without the
          ///< positions in hidden scenes, cause, step, diagnosis
  details ///< pictures and positions, too
};

/// `none`, `names` or `details`.
std::string_view name(Reveal reveal);
/// The other way; nothing for any other word.
std::optional<Reveal> parseReveal(std::string_view word);

/// The part of `result` that a student may read at this level. Every text and picture for students
/// is made from this copy and from nothing else. Gone at every level: the seed (it makes the hidden
/// scenes), timings, the diagnosis' name in the catalogue, and what the program printed in hidden
/// scenes. Below `details` also gone: all text of a hidden run that the program can write into (GL
/// messages, evidence), because it can read the scene.
/// \param pictures false leaves out all frames: copying them takes most of the time
results::Result studentView(const results::Result& result, Reveal reveal, bool pictures = true);

/// Replaces bracketed coordinates, such as `(212, 340)` or `[0.1,2]`, by `(position withheld)`.
std::string withholdPositions(std::string_view message);

} // namespace ggrade::report
