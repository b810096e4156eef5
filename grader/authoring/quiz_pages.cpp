#include "authoring/quiz.hpp"

#include "words/words.hpp"

#include <fmt/format.h>

namespace ggrade::authoring {

namespace {

/// What may be chosen, or a line for a number; with `reasons` every answer and why.
std::string answersOf(const Question& question, bool reasons) {
  if (question.asksNumber && !reasons) return gg::say("Your answer, a number:") + " ________\n";
  std::string list;
  char letter = 'a';
  for (const Answer& answer : question.answers) {
    list += question.asksNumber ? fmt::format("- {} ± {}\n", answer.text, answer.tolerance)
                                : fmt::format("- **({})** {}\n", letter++, answer.text);
    if (reasons)
      list += fmt::format("  - {}: {}\n", answer.right ? gg::say("**Right**") : gg::say("Wrong"),
                          answer.reason);
  }
  return list;
}

/// As GIFT wants what stands for itself; a line break, too, because an empty line ends a question.
std::string escaped(const std::string& text) {
  std::string out;
  for (char c : text) {
    if (c == '\n') {
      out += "\\n";
    } else {
      if (std::string_view("\\~=#{}:").find(c) != std::string_view::npos) out += '\\';
      out += c;
    }
  }
  return out;
}

} // namespace

std::string quizPage(const Quiz& quiz, const std::string& title, bool answers) {
  std::string page = "# " + gg::say("Quiz: {}", title) + "\n\n";
  page += answers ? gg::say("With answers and reasons: not for students before the quiz is over.")
                  : gg::say("Answer first, with pencil and paper where there is something to "
                            "reckon; then look into the handout.");
  page += "\n";
  for (std::size_t i = 0; i < quiz.questions.size(); ++i) {
    const Question& question = quiz.questions[i];
    page += fmt::format("\n## {}\n\n{}\n\n{}", gg::say("Question {}", i + 1), question.text,
                        answersOf(question, answers));
  }
  page += fmt::format("\n## {}\n\n{}\n", gg::say("Write-up"), quiz.writeUp);
  page += fmt::format("\n## {}\n\n", gg::say("Exercises beyond"));
  for (std::size_t i = 0; i < quiz.exercises.size(); ++i)
    page += fmt::format("{}. {}\n", i + 1, quiz.exercises[i]);
  return page;
}

std::string quizGift(const Quiz& quiz, const std::string& name) {
  std::string gift = fmt::format("// Moodle: question bank, import, format GIFT\n"
                                 "$CATEGORY: ggrade/{}\n",
                                 name);
  for (const Question& question : quiz.questions) {
    gift += fmt::format("\n::{}::[markdown]{}{{{}\n", escaped(name + ' ' + question.id),
                        escaped(question.text), question.asksNumber ? "#" : "");
    for (const Answer& answer : question.answers) {
      gift += question.asksNumber ? fmt::format("\t=%{}%{}:{}", answer.right ? 100 : 0,
                                                answer.value, answer.tolerance)
                                  : (answer.right ? "\t=" : "\t~") + escaped(answer.text);
      gift += '#' + escaped(answer.reason) + '\n';
    }
    gift += "}\n";
  }
  return gift;
}

} // namespace ggrade::authoring
