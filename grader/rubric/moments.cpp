#include "rubric/moments.hpp"

#include "assignment/usage_error.hpp"
#include "capture/channel.hpp"

#include <fmt/format.h>

#include <cmath>

namespace ggrade::rubric {

using nlohmann::json;

namespace {

bool isSeconds(const json& value) {
  return value.is_number() && std::isfinite(value.get<double>());
}

bool isSide(const json& value) {
  return value.is_number_integer() && value >= 1 && value <= channel::kMaxSide;
}

Moment readMoment(const json& declared, const std::string& where) {
  const auto fail = [&](const std::string& what, const json& value) {
    throw UsageError(fmt::format("{}{}, but is {}", where, what, value.dump()));
  };
  if (isSeconds(declared)) return {declared.get<double>()};
  if (!declared.is_object())
    fail(": must be seconds, or {\"seconds\": seconds, \"size\": [width, height]}", declared);
  for (const auto& [key, value] : declared.items())
    if (key != "seconds" && key != "size")
      throw UsageError(fmt::format("{}.{}: there are seconds and size only", where, key));
  if (!declared.contains("seconds") || !isSeconds(declared["seconds"]))
    fail(".seconds: must be a number", declared.value("seconds", json()));
  Moment moment{declared["seconds"].get<double>()};
  if (!declared.contains("size")) return moment;
  const json& size = declared["size"];
  if (!size.is_array() || size.size() != 2 || !isSide(size[0]) || !isSide(size[1]))
    fail(fmt::format(".size: must be two whole numbers of pixels, 1 to {}", channel::kMaxSide),
         size);
  moment.width = size[0];
  moment.height = size[1];
  return moment;
}

} // namespace

void to_json(json& to, const Moments& moments) {
  to = moments.shown;
  if (!moments.before.empty()) to = {{"before", toJson(moments.before)}, {"times", moments.shown}};
}

std::vector<Moment> readBefore(const json& declared, const std::string& where) {
  if (!declared.is_array())
    throw UsageError(
        fmt::format("{}: before: must be a list of frames, but is {}", where, declared.dump()));
  std::vector<Moment> before;
  for (const json& one : declared)
    before.push_back(readMoment(one, fmt::format("{}: before[{}]", where, before.size())));
  return before;
}

json toJson(const std::vector<Moment>& before) {
  json all = json::array();
  for (const Moment& one : before)
    if (one.width > 0)
      all.push_back({{"seconds", one.earlier}, {"size", {one.width, one.height}}});
    else
      all.push_back(one.earlier);
  return all;
}

void checkFrames(const Moments& moments, const std::string& where) {
  if (moments.shown.empty())
    throw UsageError(fmt::format("{}: times: there must be one frame at least", where));
  if (moments.frames() > channel::kMaxFrames)
    throw UsageError(fmt::format("{}: {} frames, {} of them before, are more than {}", where,
                                 moments.frames(), moments.before.size(), channel::kMaxFrames));
  for (const Moment& one : moments.before)
    if (moments.shown[0] - one.earlier < 0)
      throw UsageError(fmt::format("{}: a frame {} s before the one at {} s would be before the "
                                   "second 0",
                                   where, one.earlier, moments.shown[0]));
}

} // namespace ggrade::rubric
