#include "truth/truth.hpp"

#include "truth/kept.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace ggrade::truth {

namespace {

std::map<std::string, Judge>& judges() {
  static std::map<std::string, Judge> all;
  return all;
}

} // namespace

bool add(const std::string& part, Judge judge) {
  if (!judges().emplace(part, std::move(judge)).second)
    throw std::logic_error("part " + part + " has two truths");
  return true;
}

const Judge& judgeOf(const std::string& part) {
  const auto found = judges().find(part);
  if (found != judges().end()) return found->second;
  std::string known;
  for (const auto& [name, judge] : judges()) known += (known.empty() ? "" : ", ") + name;
  throw std::invalid_argument("part " + part + " has no truth; there are: " +
                              (known.empty() ? std::string("none") : known));
}

std::string keyOf(const Rendered& rendered) {
  nlohmann::json scene = rendered.scene;
  scene.erase("quality");
  return nlohmann::json::array({scene, rendered.time, rendered.truth, rendered.window.width(),
                                rendered.window.height()})
      .dump();
}

Image shownDifference(const Image& a, const Image& b) {
  Image out(a.width(), a.height(), 3);
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      for (int c = 0; c < 3; ++c)
        out.at(x, y, c) = std::min(4 * std::abs(a.at(x, y, c) - b.at(x, y, c)), 1.0f);
  return out;
}

} // namespace ggrade::truth
