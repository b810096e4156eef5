#pragma once
/// \file
/// Quizzes: a part's questions with the reason of every answer, from one file (`PART.quiz.json`),
/// as a page for students, a copy with the answers, and GIFT for Moodle's question bank.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ggrade::authoring {

/// One that may be chosen, or a number that somebody may find.
struct Answer {
  bool right = false;
  std::string text;                ///< a number's, too, as it is written
  double value = 0, tolerance = 0; ///< a number's
  std::string reason;              ///< why it is right, or what was misunderstood
};

struct Question {
  std::string id; ///< "clip"
  std::string text;
  bool asksNumber = false;     ///< the first answer is right, the others are mistakes to expect
  std::vector<Answer> answers; ///< exactly one of them is right
};

/// All texts are Markdown.
struct Quiz {
  std::vector<Question> questions;
  std::string writeUp;                ///< what to hand in
  std::vector<std::string> exercises; ///< beyond the part
  bool japanese = false;              ///< does any text have a translation?
};

/// Reads a quiz in the language that was chosen. A text is a string, the same in all languages, or
/// `{"en": "...", "ja": "..."}`:
///
///     { "questions": [
///         { "id": "order", "text": T, "answers": [{ "text": T, "right": true, "reason": T }, ...]
///         }, { "id": "clip", "text": T, "value": 0.75, "tolerance": 0.01, "reason": T,
///           "mistakes": [{ "value": 0.25, "tolerance": 0.01, "reason": T }, ...] }, ...],
///       "write_up": T, "exercises": [T, ...] }
///
/// Throws UsageError, as `file: questions[1].tolerance: must be ..., but is ...`, for what lacks,
/// is unknown or of another type, a question without exactly one right answer, and numbers that are
/// right and wrong at once.
Quiz readQuiz(const std::filesystem::path& file);

/// `solutions/PART.quiz.json`; nothing if there is no quiz in the language that was chosen.
std::optional<Quiz> quizOf(const std::filesystem::path& solutions, const std::string& part);

/// The quiz as Markdown in the language that was chosen; with `answers` the right ones are marked,
/// and all reasons are there.
std::string quizPage(const Quiz& quiz, const std::string& title, bool answers);

/// The quiz in Moodle's format GIFT, with the reasons as feedback, for the category `name` of the
/// question bank.
std::string quizGift(const Quiz& quiz, const std::string& name);

} // namespace ggrade::authoring
