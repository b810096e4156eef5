// GIFT, read back by a small importer that goes about it as Moodle does: escaped characters are set
// aside first, then the text is cut at the ones that are left.

#include "quiz_files.hpp"

#include <gmock/gmock.h>

#include <sstream>

using namespace ggrade;
using authoring::Answer;
using authoring::Question;
using authoring::Quiz;
using quizzes::OfPart;
using testing::ElementsAre;

namespace {

struct Imported {
  std::string name, format, text;
  bool number = false;
  struct Choice {
    double weight = 0;
    std::string answer, feedback;
    bool operator==(const Choice&) const = default;
  };
  std::vector<Choice> answers;
};

constexpr std::string_view kSpecial = "~=#{}:";
constexpr char kFirstPlaceholder = 1; // \1 to \6 stand for them, \7 for a line break

std::string trimmed(const std::string& text) {
  const std::size_t from = text.find_first_not_of(" \t\n"), to = text.find_last_not_of(" \t\n");
  return from == text.npos ? "" : text.substr(from, to - from + 1);
}

std::string setAside(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char next = i + 1 < text.size() ? text[i + 1] : ' ';
    const std::size_t special = kSpecial.find(next);
    if (text[i] != '\\')
      out += text[i];
    else if (next == '\\')
      out += text[++i];
    else if (next == 'n')
      out += '\7', ++i;
    else if (special != std::string_view::npos)
      out += char(kFirstPlaceholder + special), ++i;
    else
      out += '\\';
  }
  return out;
}

std::string putBack(const std::string& text) {
  std::string out;
  for (const char c : trimmed(text))
    out += c == '\7' ? '\n'
           : c >= kFirstPlaceholder && c < '\7'
               ? kSpecial[static_cast<std::size_t>(c - kFirstPlaceholder)]
               : c;
  return out;
}

Imported::Choice importChoice(std::string text) {
  Imported::Choice choice;
  if (text.starts_with("=")) choice.weight = 100;
  text.erase(0, 1);
  if (text.starts_with("%")) {
    choice.weight = std::stod(text.substr(1));
    text.erase(0, text.find('%', 1) + 1);
  }
  const std::size_t comment = text.find('#');
  choice.answer = putBack(text.substr(0, comment));
  if (comment != text.npos) choice.feedback = putBack(text.substr(comment + 1));
  return choice;
}

Imported importQuestion(std::string text) {
  text = trimmed(setAside(text));
  Imported question;
  if (!text.starts_with("::")) throw std::runtime_error("no name: " + text);
  const std::size_t named = text.find("::", 2);
  question.name = putBack(text.substr(2, named - 2));
  text = trimmed(text.substr(named + 2));
  const std::size_t open = text.find('{'), close = text.find('}');
  if (close == text.npos || close + 1 != text.size()) throw std::runtime_error("braces: " + text);
  question.text = text.substr(0, open);
  if (question.text.starts_with("[")) {
    const std::size_t end = question.text.find(']');
    question.format = question.text.substr(1, end - 1);
    question.text.erase(0, end + 1);
  }
  question.text = putBack(question.text);
  std::string answers = trimmed(text.substr(open + 1, close - open - 1));
  question.number = answers.starts_with("#");
  if (question.number) answers = trimmed(answers.substr(1));
  for (std::size_t at = 0; at < answers.size();) {
    const std::size_t next = answers.find_first_of("~=", at + 1);
    question.answers.push_back(importChoice(trimmed(answers.substr(at, next - at))));
    at = std::min(next, answers.size());
  }
  return question;
}

/// An import of a file: empty lines end a question, lines that begin with // are comments.
std::vector<Imported> import(const std::string& gift, std::string* category = nullptr) {
  std::vector<Imported> all;
  std::string block;
  std::istringstream in(gift + "\n\n");
  for (std::string line; std::getline(in, line);) {
    if (trimmed(line).starts_with("//")) continue;
    if (!trimmed(line).empty()) {
      block += line + '\n';
      continue;
    }
    if (block.starts_with("$CATEGORY:")) {
      if (category) *category = trimmed(block.substr(10));
    } else if (!trimmed(block).empty()) {
      all.push_back(importQuestion(block));
    }
    block.clear();
  }
  return all;
}

Quiz withOneQuestion(const Question& question) {
  Quiz quiz;
  quiz.questions = {question};
  return quiz;
}

TEST(QuizGift, EverythingThatIsWrittenIsReadBack) {
  const std::string all = "~ = # { } : \\ ::x:: {=a ~b#c} \\n \\\\ \\= // %50% ####\n\nnew";
  const Question question{
      "odd", all, false, {{false, all + "1", 0, 0, all + "2"}, {true, all + "3", 0, 0, all + "4"}}};
  std::string category;
  const std::vector<Imported> read =
      import(authoring::quizGift(withOneQuestion(question), "mirror.ja"), &category);
  EXPECT_EQ(category, "ggrade/mirror.ja");
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].name, "mirror.ja odd");
  EXPECT_EQ(read[0].format, "markdown");
  EXPECT_EQ(read[0].text, all);
  EXPECT_FALSE(read[0].number);
  using Choice = Imported::Choice;
  EXPECT_THAT(read[0].answers,
              ElementsAre(Choice{0, all + "1", all + "2"}, Choice{100, all + "3", all + "4"}));
}

TEST(QuizGift, IsWrittenAsMoodleWantsIt) {
  Question choice{"one", "a: b?", false, {{false, "0", 0, 0, "x=1"}, {true, "1", 0, 0, "y"}}};
  Question number{"two", "c", true, {{true, "-5", -5, 0.01, "z"}, {false, "1", 1, 0, "no"}}};
  Quiz quiz;
  quiz.questions = {choice, number};
  EXPECT_EQ(authoring::quizGift(quiz, "mirror"), "// Moodle: question bank, import, format GIFT\n"
                                                 "$CATEGORY: ggrade/mirror\n"
                                                 "\n"
                                                 "::mirror one::[markdown]a\\: b?{\n"
                                                 "\t~0#x\\=1\n"
                                                 "\t=1#y\n"
                                                 "}\n"
                                                 "\n"
                                                 "::mirror two::[markdown]c{#\n"
                                                 "\t=%100%-5:0.01#z\n"
                                                 "\t=%0%1:0#no\n"
                                                 "}\n");
}

TEST(QuizGift, HoldsEveryQuizWhole) {
  int questions = 0;
  for (const OfPart& one : quizzes::all()) {
    const std::vector<Imported> read = import(authoring::quizGift(one.quiz, one.part.id));
    ASSERT_EQ(read.size(), one.quiz.questions.size()) << one.part.id;
    for (std::size_t i = 0; i < read.size(); ++i, ++questions) {
      const Question& question = one.quiz.questions[i];
      SCOPED_TRACE(one.part.id + '.' + question.id);
      EXPECT_EQ(read[i].text, question.text);
      EXPECT_EQ(read[i].number, question.asksNumber);
      ASSERT_EQ(read[i].answers.size(), question.answers.size());
      for (std::size_t k = 0; k < question.answers.size(); ++k) {
        const Answer& answer = question.answers[k];
        EXPECT_EQ(read[i].answers[k].weight, answer.right ? 100 : 0);
        EXPECT_EQ(read[i].answers[k].feedback, answer.reason);
        if (!question.asksNumber) {
          EXPECT_EQ(read[i].answers[k].answer, answer.text);
        } else {
          const std::string& range = read[i].answers[k].answer;
          EXPECT_EQ(std::stod(range), answer.value);
          EXPECT_EQ(std::stod(range.substr(range.find(':') + 1)), answer.tolerance);
        }
      }
    }
  }
  EXPECT_GE(questions, 42);
}

} // namespace
