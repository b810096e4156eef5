#include "truth/truth.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace ggrade;

namespace {

/// The mean of the red channel.
truth::Judgement redness(const truth::Rendered& rendered) {
  double sum = 0;
  for (int y = 0; y < rendered.window.height(); ++y)
    for (int x = 0; x < rendered.window.width(); ++x) sum += rendered.window.at(x, y, 0);
  truth::Judgement answer;
  answer.errors = {{"redness", sum / double(rendered.window.pixelCount())}};
  return answer;
}

GGRADE_TRUTH("placeholder", redness);

TEST(Truth, AsksTheJudgeOfThePart) {
  truth::Rendered rendered;
  rendered.window = Image(4, 2, 4, 0.25f);
  const truth::Judgement answer = truth::judgeOf("placeholder")(rendered);
  ASSERT_EQ(answer.errors.size(), 1u);
  EXPECT_EQ(answer.errors[0].name, "redness");
  EXPECT_DOUBLE_EQ(answer.errors[0].value, 0.25);
}

TEST(Truth, NamesThePartsThereAre) {
  try {
    truth::judgeOf("fog");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "part fog has no truth; there are: placeholder");
  }
}

TEST(Truth, RefusesASecondJudge) {
  EXPECT_THROW(truth::add("placeholder", redness), std::logic_error);
}

} // namespace
