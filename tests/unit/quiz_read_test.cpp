// What a quiz's file may say, and what is said of one with a fault.

#include "authoring/quiz.hpp"

#include "assignment/usage_error.hpp"
#include "framework_temporary_folder.hpp"
#include "framework_throws.hpp"
#include "in_japanese.hpp"

#include <gmock/gmock.h>

using namespace ggrade;
using nlohmann::json;
using testing::ElementsAre;

namespace {

json choiceQuestion() {
  return json::parse(
      R"({"id": "side", "text": {"en": "Which side?", "ja": "どちら側？"}, "answers": [
    {"text": "left", "reason": "no"}, {"text": "right", "right": true, "reason": "yes"}]})");
}

json numberQuestion() {
  return json::parse(R"({"id": "clip", "text": "How much?", "value": 0.75, "tolerance": 0.01,
    "reason": "so", "mistakes": [{"value": 0.25, "tolerance": 0.01, "reason": "the sign"}]})");
}

json quizOfTwo() {
  return {{"questions", {choiceQuestion(), numberQuestion()}},
          {"write_up", "a picture"},
          {"exercises", {"one", "two"}}};
}

authoring::Quiz readText(const std::string& text) {
  const TemporaryFolder folder;
  return authoring::readQuiz(folder.write("mirror.quiz.json", text));
}

/// What is said of a quiz, after the path to its file.
std::string quizProblem(const std::string& text) {
  const std::string message = messageOf<UsageError>([&] { readText(text); });
  return message.substr(std::min(message.find("mirror.quiz.json"), message.size()));
}

/// What is said of a quiz in which the value at `pointer` is another.
std::string problemWith(const std::string& pointer, const json& value) {
  json quiz = quizOfTwo();
  quiz[json::json_pointer(pointer)] = value;
  return quizProblem(quiz.dump());
}

std::string problemWithout(const std::string& pointer, const char* member) {
  json quiz = quizOfTwo();
  quiz[json::json_pointer(pointer)].erase(member);
  return quizProblem(quiz.dump());
}

TEST(QuizFile, IsReadInTheChosenLanguage) {
  const authoring::Quiz quiz = readText(quizOfTwo().dump());
  EXPECT_TRUE(quiz.japanese);
  ASSERT_EQ(quiz.questions.size(), 2u);
  EXPECT_EQ(quiz.questions[0].text, "Which side?");
  EXPECT_FALSE(quiz.questions[0].asksNumber);
  EXPECT_TRUE(quiz.questions[0].answers.at(1).right);
  EXPECT_EQ(quiz.questions[0].answers.at(1).reason, "yes");
  EXPECT_TRUE(quiz.questions[1].asksNumber);
  EXPECT_TRUE(quiz.questions[1].answers.at(0).right);
  EXPECT_EQ(quiz.questions[1].answers.at(0).text, "0.75");
  EXPECT_EQ(quiz.questions[1].answers.at(1).value, 0.25);
  EXPECT_THAT(quiz.exercises, ElementsAre("one", "two"));
  const InJapanese inJapanese;
  EXPECT_EQ(readText(quizOfTwo().dump()).questions[0].text, "どちら側？");
}

TEST(QuizFile, WithoutTranslationsIsEnglishOnly) {
  const TemporaryFolder folder;
  json quiz = quizOfTwo();
  quiz["questions"][0]["text"] = "Which side?";
  folder.write("mirror.quiz.json", quiz.dump());
  EXPECT_FALSE(authoring::quizOf(folder.path(), "mirror").value().japanese);
  EXPECT_FALSE(authoring::quizOf(folder.path(), "shadow"));
  const InJapanese inJapanese;
  EXPECT_FALSE(authoring::quizOf(folder.path(), "mirror"));
}

TEST(QuizFile, FaultsNameFileKeyAndValue) {
  EXPECT_THAT(quizProblem("{\n\"questions\": [}"), testing::StartsWith("mirror.quiz.json:2: "));
  EXPECT_EQ(quizProblem("[]"), "mirror.quiz.json: must be an object, but is []");
  EXPECT_EQ(problemWith("/title", "x"), "mirror.quiz.json: unknown member \"title\" (\"x\")");
  EXPECT_EQ(problemWithout("", "write_up"), "mirror.quiz.json: lacks \"write_up\"");
  EXPECT_EQ(problemWith("/exercises", json::array()),
            "mirror.quiz.json: exercises: must be an array of one entry or more, but is []");
  EXPECT_EQ(problemWith("/exercises/1", 3),
            "mirror.quiz.json: exercises[1]: must be a text, but is 3");
  EXPECT_EQ(problemWith("/questions/0/text", {{"en", "a"}}),
            "mirror.quiz.json: questions[0].text: lacks \"ja\"");
  EXPECT_EQ(problemWith("/questions/0/text/ja", ""),
            "mirror.quiz.json: questions[0].text.ja: must be a text, but is \"\"");
  EXPECT_EQ(problemWith("/questions/0/text/fr", "a"),
            "mirror.quiz.json: questions[0].text: unknown member \"fr\" (\"a\")");
  EXPECT_EQ(problemWith("/questions/0/id", "A side"),
            "mirror.quiz.json: questions[0].id: must be a name of lower case letters, digits and "
            "_, but is \"A side\"");
  EXPECT_EQ(problemWith("/questions/1/id", "side"),
            "mirror.quiz.json: questions[1].id: \"side\" stands there twice");
}

TEST(QuizFile, ExactlyOneAnswerIsRight) {
  EXPECT_EQ(problemWithout("/questions/0/answers/1", "right"),
            "mirror.quiz.json: questions[0].answers: exactly one must be right, but 0 are");
  EXPECT_EQ(problemWith("/questions/0/answers/0/right", true),
            "mirror.quiz.json: questions[0].answers: exactly one must be right, but 2 are");
  EXPECT_EQ(problemWith("/questions/0/answers/0/right", "yes"),
            "mirror.quiz.json: questions[0].answers[0].right: must be true or false, but is "
            "\"yes\"");
  EXPECT_EQ(problemWithout("/questions/0/answers/0", "reason"),
            "mirror.quiz.json: questions[0].answers[0]: lacks \"reason\"");
  EXPECT_EQ(problemWith("/questions/0/answers",
                        {{{"text", "right"}, {"right", true}, {"reason", "yes"}}}),
            "mirror.quiz.json: questions[0].answers: must be two or more");
  EXPECT_EQ(problemWith("/questions/0/reason", "a"),
            "mirror.quiz.json: questions[0].reason: belongs to a question that has a \"value\"");
}

TEST(QuizFile, NumbersAreNumbersAndDontOverlap) {
  EXPECT_EQ(problemWith("/questions/1/value", "0.75"),
            "mirror.quiz.json: questions[1].value: must be a number, but is \"0.75\"");
  EXPECT_EQ(problemWith("/questions/1/tolerance", -1),
            "mirror.quiz.json: questions[1].tolerance: must be a number of 0 or more, but is -1");
  EXPECT_EQ(problemWith("/questions/1/mistakes/0/value", 0.735),
            "mirror.quiz.json: questions[1].mistakes[0]: 0.735 ± 0.01 overlaps 0.75 ± 0.01");
  EXPECT_EQ(problemWithout("/questions/1", "mistakes"),
            "mirror.quiz.json: questions[1]: lacks \"mistakes\"");
  EXPECT_EQ(problemWith("/questions/1/answers", json::array()),
            "mirror.quiz.json: questions[1].answers: a question has either answers or a value");
}

} // namespace
