#include "authoring/quiz.hpp"

#include "assignment/assignment.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace ggrade::authoring {

using nlohmann::json;

namespace {

std::string cut(std::string text) {
  constexpr std::size_t kLongest = 60;
  if (text.size() <= kLongest) return text;
  std::size_t end = kLongest;
  while (end > 0 && (text[end] & 0xC0) == 0x80) --end; // not inside a UTF-8 character
  return text.substr(0, end) + "...";
}

/// A value of the file and where it stands, for messages.
class Place {
public:
  /// `path`: dotted, empty for the whole file.
  Place(const json& value, std::string file, std::string path, bool* japanese)
      : value_(value), file_(std::move(file)), path_(std::move(path)), japanese_(japanese) {}

  [[noreturn]] void refuse(const std::string& what) const {
    throw UsageError(fmt::format("{}: {}{}{}", file_, path_, path_.empty() ? "" : ": ", what));
  }

  bool has(const char* key) const { return value_.contains(key); }
  Place at(const char* key) const {
    if (!has(key)) refuse(fmt::format("lacks \"{}\"", key));
    return {value_[key], file_, path_.empty() ? key : path_ + '.' + key, japanese_};
  }

  /// An object of these members and no others.
  const Place& of(const std::set<std::string>& members) const {
    if (!value_.is_object()) refuse("must be an object, but is " + shown());
    for (const auto& [key, value] : value_.items())
      if (!members.count(key))
        refuse(fmt::format("unknown member \"{}\" ({})", key, cut(value.dump())));
    return *this;
  }

  std::vector<Place> list() const {
    if (!value_.is_array() || value_.empty())
      refuse("must be an array of one entry or more, but is " + shown());
    std::vector<Place> all;
    for (std::size_t i = 0; i < value_.size(); ++i)
      all.emplace_back(value_[i], file_, fmt::format("{}[{}]", path_, i), japanese_);
    return all;
  }

  double number(bool negative = true) const {
    if (!value_.is_number() || (!negative && value_.get<double>() < 0))
      refuse(
          fmt::format("must be a number{}, but is {}", negative ? "" : " of 0 or more", shown()));
    return value_;
  }
  bool flag() const {
    if (!value_.is_boolean()) refuse("must be true or false, but is " + shown());
    return value_;
  }
  std::string id() const {
    const auto allowed = [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    };
    if (!value_.is_string() || value_ == "" || !std::ranges::all_of(string(), allowed))
      refuse("must be a name of lower case letters, digits and _, but is " + shown());
    return string();
  }
  std::string text() const {
    if (value_.is_object()) {
      of({"en", "ja"});
      *japanese_ = true;
      const std::string english = at("en").plainText(), translated = at("ja").plainText();
      return gg::language() == gg::Language::japanese ? translated : english;
    }
    return plainText();
  }

private:
  const std::string& string() const { return value_.get_ref<const std::string&>(); }
  std::string plainText() const {
    if (!value_.is_string() || value_ == "") refuse("must be a text, but is " + shown());
    return string();
  }
  std::string shown() const {
    return cut(value_.dump(-1, ' ', false, json::error_handler_t::replace));
  }

  const json& value_;
  std::string file_, path_;
  bool* japanese_;
};

Answer readNumber(const Place& from, bool right) {
  Answer answer{right, "", from.at("value").number(), from.at("tolerance").number(false),
                from.at("reason").text()};
  answer.text = fmt::format("{}", answer.value);
  return answer;
}

std::vector<Answer> readNumbers(const Place& from) {
  std::vector<Answer> all = {readNumber(from, true)};
  for (const Place& mistake : from.at("mistakes").list()) {
    const Answer answer = readNumber(mistake.of({"value", "tolerance", "reason"}), false);
    for (const Answer& other : all)
      if (std::abs(answer.value - other.value) <= answer.tolerance + other.tolerance)
        mistake.refuse(fmt::format("{} ± {} overlaps {} ± {}", answer.text, answer.tolerance,
                                   other.text, other.tolerance));
    all.push_back(answer);
  }
  return all;
}

std::vector<Answer> readChoices(const Place& from) {
  std::vector<Answer> all;
  for (const Place& one : from.list()) {
    one.of({"text", "right", "reason"});
    all.push_back({one.has("right") && one.at("right").flag(), one.at("text").text(), 0, 0,
                   one.at("reason").text()});
  }
  const auto right = std::ranges::count_if(all, [](const Answer& answer) { return answer.right; });
  if (right != 1) from.refuse(fmt::format("exactly one must be right, but {} are", right));
  if (all.size() < 2) from.refuse("must be two or more");
  return all;
}

Question readQuestion(const Place& from) {
  from.of({"id", "text", "answers", "value", "tolerance", "reason", "mistakes"});
  Question question{from.at("id").id(), from.at("text").text(), from.has("value"), {}};
  for (const char* key : {"tolerance", "reason", "mistakes"})
    if (!question.asksNumber && from.has(key))
      from.at(key).refuse("belongs to a question that has a \"value\"");
  if (question.asksNumber && from.has("answers"))
    from.at("answers").refuse("a question has either answers or a value");
  question.answers = question.asksNumber ? readNumbers(from) : readChoices(from.at("answers"));
  return question;
}

} // namespace

Quiz readQuiz(const std::filesystem::path& file) {
  const json source = readJson(file);
  Quiz quiz;
  const Place from(source, file.string(), "", &quiz.japanese);
  from.of({"questions", "write_up", "exercises"});
  std::set<std::string> ids;
  for (const Place& one : from.at("questions").list()) {
    quiz.questions.push_back(readQuestion(one));
    if (!ids.insert(quiz.questions.back().id).second)
      one.at("id").refuse(fmt::format("\"{}\" stands there twice", quiz.questions.back().id));
  }
  quiz.writeUp = from.at("write_up").text();
  for (const Place& one : from.at("exercises").list()) quiz.exercises.push_back(one.text());
  return quiz;
}

std::optional<Quiz> quizOf(const std::filesystem::path& solutions, const std::string& part) {
  const std::filesystem::path file = solutions / (part + ".quiz.json");
  if (!std::filesystem::exists(file)) return {};
  Quiz quiz = readQuiz(file);
  if (gg::language() == gg::Language::japanese && !quiz.japanese) return {};
  return quiz;
}

} // namespace ggrade::authoring
