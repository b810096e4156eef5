#pragma once
/// \file
/// What `derive` makes of a solution, for tests.

#include "tool.hpp"

#include "image/image.hpp"

#include <set>

namespace tool {

/// The IDs of all parts.
std::vector<std::string> partNames();

/// handout.json of an assignment's solution.
nlohmann::json readHandout(const ggrade::Assignment& assignment);
/// The TODOs that are done for one of its `pictures`: "shadow.5" are the first five of that part.
std::set<std::string> doneFor(const ggrade::Assignment& assignment, const nlohmann::json& picture);
/// The scene of one of them.
nlohmann::json pictureScene(const ggrade::Assignment& assignment, const nlohmann::json& settings,
                            const nlohmann::json& picture);

/// A picture in the folder `handout` of an assignment.
ggrade::Image readHandedOut(const ggrade::Assignment& assignment, const std::string& name);
/// Is it the one that is handed out?
void expectHandedOut(const ggrade::Assignment& assignment, const std::string& name,
                     const ggrade::Image& drawn);
/// Is what `derive` makes of an assignment's solution what is handed out? Without `pictures` it
/// draws none.
void expectInStep(const ggrade::Assignment& assignment, bool pictures);

} // namespace tool
