#pragma once
/// \file
/// Parts of pages as data for the templates: of a result's page mostly.

#include "report/page.hpp"
#include "report/results.hpp"
#include "report/summary.hpp"
#include "words/words.hpp"

#include <array>
#include <cstddef>
#include <future>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ggrade::report {

inline constexpr std::size_t kOutputBytes = 64 << 10; ///< of compiler or program output on a page

/// Student, reference, difference, FLIP, difference between two runs as data URIs.
using FramePictures = std::array<std::string, 5>;
/// The frames of each scene. Public and hidden scenes never share an entry, whatever their names.
using SceneKey = std::pair<std::string, bool>;
using Pictures = std::map<SceneKey, std::vector<FramePictures>>;
Pictures encode(const Result& result, std::launch how);

/// Who reads the page decides its words, not what it shows: that is in the Result it is given.
struct Audience {
  bool instructor = true;
  std::string who() const { return instructor ? gg::say("submission") : gg::say("yours"); }
};

/// "2 complete", "3 lost points", "1 crash": what one wants to know of a class at once.
Data tallyOf(std::span<const Summary> results);
/// False when empty.
Data optional(const std::string& trusted);
/// A list of `{text}`.
Data linesOf(const std::vector<std::string>& lines);
/// The ID of the scene's element; empty when `result` doesn't hold the scene.
std::string sceneAnchor(const Result& result, const std::string& name);
/// The class that colours a credit of 0 to 1.
std::string_view creditState(double credit);

/// One row of the table of items.
Data itemOf(const Result& result, std::size_t index);
/// One of the losses named at the top.
Data findingOf(const Result& result, const Item& item);
/// One scene with its frames.
Data sceneOf(const Result& result, std::size_t index, const Pictures& pictures,
             const Audience& audience, bool open);

} // namespace ggrade::report
