#pragma once
/// \file
/// Ground truth: how far what a program has drawn is from what it should have drawn, told by
/// something that does not draw it in the same way (ray tracing, double precision).

#include "image/image.hpp"
#include "rubric/moments.hpp"
#include "trace/trace.hpp"

#include <nlohmann/json.hpp>

#include <functional>
#include <string>
#include <vector>

namespace ggrade::truth {

/// One frame of a program as it was captured.
struct Rendered {
  nlohmann::json scene;                 ///< the whole scene file
  double time = 0;                      ///< seconds
  Image window;                         ///< RGBA, 0 to 1, row 0 on top
  const trace::Trace* trace = nullptr;  ///< its passes with copies of every attachment, frame 0
  nlohmann::json truth = {};            ///< what the truth is told besides, see the part's judge
  std::vector<rubric::Moment> before{}; ///< frames that were drawn before it
};

/// How far a picture is from the truth.
struct Error {
  std::string name;
  double value = 0;
};

/// What a truth says of one frame.
struct Judgement {
  std::vector<Error> errors; ///< the first one is what settings are compared by; 0 is perfect
  Image truth, rendered, difference; ///< for people: RGB(A), 0 to 1; any may be empty
};

/// Of errors, one a pixel; 0 where there are none.
class Mean {
public:
  void add(double value) { sum_ += value, ++count_; }
  double value() const { return count_ > 0 ? sum_ / count_ : 0; }

private:
  double sum_ = 0, count_ = 0;
};

/// A difference as people can see it: four times as strong. Both RGB, of one size.
Image shownDifference(const Image& a, const Image& b);

using Judge = std::function<Judgement(const Rendered&)>;

/// The judge of a part; throws std::invalid_argument with the parts there are.
const Judge& judgeOf(const std::string& part);

/// What GGRADE_TRUTH calls. Throws std::logic_error for a part that has a judge.
bool add(const std::string& part, Judge judge);

} // namespace ggrade::truth

#define GGRADE_TRUTH_JOIN_(a, b) a##b
#define GGRADE_TRUTH_NAME_(line) GGRADE_TRUTH_JOIN_(ggradeTruth, line)
/// Registers how `part` is held against the truth; at file scope in solutions/<id>/truth.cpp.
#define GGRADE_TRUTH(part, ...)                                                                    \
  [[maybe_unused]] static const bool GGRADE_TRUTH_NAME_(__LINE__) =                                \
      ::ggrade::truth::add(part, __VA_ARGS__)
