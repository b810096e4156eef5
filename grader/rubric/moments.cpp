#include "rubric/moments.hpp"

#include "assignment/usage_error.hpp"
#include "capture/channel.hpp"

#include <fmt/format.h>

#include <cmath>

namespace ggrade::rubric {

using nlohmann::json;

namespace {

/// A number of seconds from 0.
bool isTime(const json& value) {
  return value.is_number() && std::isfinite(value.get<double>()) && value.get<double>() >= 0;
}

bool isSide(const json& value) {
  return value.is_number_integer() && value >= 1 && value <= channel::kMaxSide;
}

Moment readMoment(const json& declared, const std::string& where) {
  const auto fail = [&](const std::string& what, const json& value) {
    throw UsageError(fmt::format("{}{}, but is {}", where, what, value.dump()));
  };
  if (isTime(declared)) return {declared.get<double>()};
  if (!declared.is_object())
    fail(": must be seconds from 0, or {\"time\": seconds, \"size\": [width, height]}", declared);
  for (const auto& [key, value] : declared.items())
    if (key != "time" && key != "size")
      throw UsageError(fmt::format("{}.{}: there are time and size only", where, key));
  if (!declared.contains("time") || !isTime(declared["time"]))
    fail(".time: must be seconds from 0", declared.value("time", json()));
  Moment moment{declared["time"].get<double>()};
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
      all.push_back({{"time", one.time}, {"size", {one.width, one.height}}});
    else
      all.push_back(one.time);
  return all;
}

void checkFrames(const Moments& moments, const std::string& where) {
  if (moments.shown.empty())
    throw UsageError(fmt::format("{}: times: there must be one frame at least", where));
  if (moments.frames() > channel::kMaxFrames)
    throw UsageError(fmt::format("{}: {} frames, {} of them before, are more than {}", where,
                                 moments.frames(), moments.before.size(), channel::kMaxFrames));
}

} // namespace ggrade::rubric
