#pragma once
/// \file
/// A result's page: its scenes with their frames, and what the rest of the page shares with them.

#include "report/reports.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ggrade::report {

/// Bytes of a compiler's or a program's output on a page.
inline constexpr std::size_t kOutputBytes = 64 << 10;

/// Student, reference, difference, FLIP, difference between two runs as data URIs.
using FramePictures = std::array<std::string, 5>;
/// Public and hidden scenes never share an entry, whatever their names.
using SceneKey = std::pair<std::string, bool>;
/// The frames of each scene.
using Pictures = std::map<SceneKey, std::vector<FramePictures>>;
/// Compresses the pictures of all scenes once for both pages. `how`: see resultPages.
Pictures encode(const results::Result& result, std::launch how);

/// Who reads the page decides its words, not what it shows: that is in the Result it is given.
struct Audience {
  bool instructor = true;
  std::string who() const;
};

/// The ID of the scene's element; empty when `result` doesn't hold the scene.
std::string sceneAnchor(const results::Result& result, const std::string& name);
/// The class that colours a credit of 0 to 1.
std::string_view creditState(double credit);
std::string titleOf(const results::Item& item);

/// What the template shows of one scene.
nlohmann::json sceneOf(const results::Result& result, std::size_t index, const Pictures& pictures,
                       const Audience& audience, bool open);

} // namespace ggrade::report
