// What every quiz of this repository must hold, and that students see no answer.

#include "quiz_files.hpp"

#include "in_japanese.hpp"

#include <gmock/gmock.h>

#include <set>

using namespace ggrade;
using authoring::Answer;
using authoring::Question;
using authoring::Quiz;
using quizzes::OfPart;
using testing::HasSubstr;
using testing::Not;

namespace {

bool hasJapanese(const std::string& text) {
  return std::ranges::any_of(text, [](char c) { return static_cast<unsigned char>(c) >= 0xE3; });
}

/// All texts that must be in the reader's language; a choice may be code or a number.
std::vector<std::string> sentencesOf(const Quiz& quiz) {
  std::vector<std::string> all = quiz.exercises;
  all.push_back(quiz.writeUp);
  for (const Question& question : quiz.questions) {
    all.push_back(question.text);
    for (const Answer& answer : question.answers) all.push_back(answer.reason);
  }
  return all;
}

std::string studentsPage(const OfPart& one) {
  return authoring::quizPage(one.quiz, one.part.title, false);
}

TEST(Quizzes, EveryPartHasSixQuestionsAWriteUpAndTwoExercises) {
  std::set<std::string> parts;
  for (const OfPart& one : quizzes::all()) {
    parts.insert(one.part.id);
    EXPECT_EQ(one.quiz.questions.size(), 6u) << one.part.id;
    EXPECT_EQ(one.quiz.exercises.size(), 2u) << one.part.id;
    EXPECT_THAT(one.quiz.writeUp, HasSubstr("3 to 5 sentences")) << one.part.id;
  }
  EXPECT_THAT(parts, testing::IsSupersetOf({"mirror", "shadow", "bloom", "targets", "figure",
                                            "shadow_volume", "ssao", "antialias", "motion_blur",
                                            "afterglow"}));
}

TEST(Quizzes, HaveOneRightAnswerAndAReasonForEach) {
  for (const OfPart& one : quizzes::all()) {
    int choices = 0, numbers = 0;
    std::set<std::ptrdiff_t> places;
    for (const Question& question : one.quiz.questions) {
      SCOPED_TRACE(one.part.id + '.' + question.id);
      ++(question.asksNumber ? numbers : choices);
      EXPECT_GE(question.answers.size(), 3u);
      EXPECT_EQ(std::ranges::count_if(question.answers, &Answer::right), 1);
      std::set<std::string> texts, reasons;
      for (const Answer& answer : question.answers) {
        texts.insert(answer.text);
        reasons.insert(answer.reason);
        EXPECT_GE(answer.reason.size(), 10u) << answer.text;
      }
      EXPECT_EQ(texts.size(), question.answers.size());
      EXPECT_EQ(reasons.size(), question.answers.size());
      if (!question.asksNumber)
        places.insert(std::ranges::find_if(question.answers, &Answer::right) -
                      question.answers.begin());
    }
    EXPECT_GE(choices, 2) << one.part.id;
    EXPECT_GE(numbers, 3) << one.part.id << ": something to reckon by hand";
    EXPECT_GE(places.size(), 2u) << one.part.id << ": the right one stands at the same place";
  }
}

/// Who knows nothing chooses the longest.
void expectLengthToTellNothing() {
  int questions = 0, longest = 0;
  for (const OfPart& one : quizzes::all())
    for (const Question& question : one.quiz.questions) {
      if (question.asksNumber) continue;
      const auto length = [](const Answer& answer) { return answer.text.size(); };
      longest += std::ranges::max_element(question.answers, {}, length)->right;
      ++questions;
    }
  EXPECT_LE(longest, questions / 3);
}

TEST(Quizzes, TheRightAnswerIsSeldomTheLongest) {
  expectLengthToTellNothing();
  const InJapanese inJapanese;
  expectLengthToTellNothing();
}

TEST(Quizzes, AreInBothLanguages) {
  const std::vector<OfPart> english = quizzes::all();
  const InJapanese inJapanese;
  const std::vector<OfPart> japanese = quizzes::all();
  ASSERT_EQ(japanese.size(), english.size());
  for (std::size_t i = 0; i < english.size(); ++i) {
    SCOPED_TRACE(english[i].part.id);
    for (const std::string& text : sentencesOf(english[i].quiz))
      EXPECT_FALSE(hasJapanese(text)) << text;
    for (const std::string& text : sentencesOf(japanese[i].quiz))
      EXPECT_TRUE(hasJapanese(text)) << text;
  }
}

/// The page itself is held against the quiz here; what else a kit has, in the tests of kits.
void expectHandedOut(const std::string& ending) {
  for (const OfPart& one : quizzes::all()) {
    const std::string name = one.part.id + ".quiz" + ending;
    SCOPED_TRACE(one.assignment.id + '/' + name);
    const std::string page = readFile(one.assignment.folder / name);
    EXPECT_TRUE(page.ends_with("\n\n" + studentsPage(one)))
        << "./ggrade derive " << one.assignment.id << " --no-pictures writes it anew";
    EXPECT_TRUE(page.starts_with("["));
    const std::string handout = one.assignment.isOnePart() ? "README" : one.part.id;
    EXPECT_THAT(readFile(one.assignment.folder / (handout + ending)), HasSubstr('(' + name + ')'));
  }
}

TEST(Quizzes, StudentsPagesAreInStepAndLinked) {
  expectHandedOut(".md");
  const InJapanese inJapanese;
  expectHandedOut(".ja.md");
}

TEST(Quizzes, StudentsSeeEveryQuestionAndNoAnswer) {
  for (const OfPart& one : quizzes::all()) {
    const std::string page = studentsPage(one);
    EXPECT_THAT(page, Not(HasSubstr("Right")));
    for (const Question& question : one.quiz.questions) {
      SCOPED_TRACE(one.part.id + '.' + question.id);
      EXPECT_THAT(page, HasSubstr(question.text));
      for (const Answer& answer : question.answers) {
        EXPECT_THAT(page, Not(HasSubstr(answer.reason)));
        if (question.asksNumber)
          EXPECT_THAT(page, Not(HasSubstr(": " + answer.text + '\n')));
        else
          EXPECT_THAT(page, HasSubstr(")** " + answer.text + '\n'));
      }
    }
  }
}

/// Questions that differ in nothing but what is right look the same to students.
TEST(Quizzes, NothingOnStudentsPagesDependsOnWhatIsRight) {
  for (OfPart one : quizzes::all()) {
    const std::string page = studentsPage(one);
    for (Question& question : one.quiz.questions) {
      if (question.asksNumber) question.answers.resize(1);
      for (Answer& answer : question.answers) {
        answer.right = !answer.right;
        answer.value += 1;
        answer.reason.clear();
      }
    }
    EXPECT_EQ(studentsPage(one), page) << one.part.id;
  }
}

TEST(Quizzes, InstructorsPagesHaveEveryReason) {
  for (const OfPart& one : quizzes::all()) {
    const std::string page = authoring::quizPage(one.quiz, one.part.title, true);
    for (const Question& question : one.quiz.questions)
      for (const Answer& answer : question.answers) {
        EXPECT_THAT(page, HasSubstr((answer.right ? "**Right**: " : "Wrong: ") + answer.reason))
            << one.part.id << '.' << question.id;
        EXPECT_THAT(page, HasSubstr((question.asksNumber ? "\n- " : ")** ") + answer.text));
      }
  }
}

} // namespace
