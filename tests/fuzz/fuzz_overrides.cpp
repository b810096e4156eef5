// Any bytes as what an instructor decides: a table of overrides, one of times, a late rule. Only
// UsageError may be thrown; scores stay finite and not below 0, and whatever is given beyond what
// an item can give is marked.
#include "require.hpp"

#include "assignment/usage_error.hpp"
#include "gradebook/lateness.hpp"
#include "gradebook/overrides.hpp"
#include "gradebook/worksheet.hpp"

#include <cmath>
#include <cstdint>

using namespace ggrade::gradebook;

namespace {

const std::vector<MachineScore> kScores = {
    {"ada", 60, {{"gain", 60, 0, 100}, {"keep", 0, -50, 0}, {"bonus", 0, 0, 10}}, 110},
    {"bob", {}, {}, 110},
    {"Participant 3", 1, {{"gain", 1, 0, 100}}, 110}};

void decide(std::string_view bytes) {
  const Overrides applied =
      applyOverrides(kScores, readOverrides(bytes, "overrides.csv"), "overrides.csv");
  require(applied.scores.size() == kScores.size());
  for (std::size_t i = 0; i < kScores.size(); ++i) {
    const Overridden& one = applied.scores[i];
    require(one.machine == kScores[i].score);
    require(!one.score || (std::isfinite(*one.score) && *one.score >= 0));
    bool marked = false;
    for (const Change& change : one.changes) marked |= !change.beyond.empty();
    require(marked || !one.score || *one.score <= kScores[i].most);
  }
}

void takeTimes(std::string_view bytes) {
  const LateRule rule = readLateRule("10% per day, at most 50%, 15 min grace");
  for (const Submission& one :
       readSubmitted(bytes, "times.csv", readDue("2026-11-20T23:59+09:00"))) {
    const double off = penalty(rule, 60, 100, one.secondsLate);
    require(off >= 0 && off <= 60);
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // The first byte chooses what the rest is.
  if (size == 0) return 0;
  const std::string rest(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    switch (data[0] % 5) {
    case 0:
      decide(rest);
      break;
    case 1:
      decide("student,item,points,reason,who\n" + rest);
      break;
    case 2:
      takeTimes("student,submitted\n" + rest);
      break;
    case 3: {
      const LateRule rule = readLateRule(rest);
      require(std::isfinite(penalty(rule, 60, 100, 100'000)) && !describe(rule).empty());
      break;
    }
    default:
      readColumns(rest);
    }
  } catch (const ggrade::UsageError&) {
  }
  return 0;
}
