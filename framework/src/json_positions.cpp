#include "json_positions.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "words/words.hpp"
#include <fmt/format.h>
#include <gg/error.hpp>
#include <nlohmann/json.hpp>

namespace gg::detail {

namespace {

using nlohmann::json;

constexpr std::size_t kDeepest = 16; // a scene needs 3
constexpr std::size_t kLongestShown = 60;

std::string cut(std::string text) {
  if (text.size() <= kLongestShown) return text;
  std::size_t end = kLongestShown;
  while (end > 0 && (text[end] & 0xC0) == 0x80) --end; // not inside a UTF-8 character
  return text.substr(0, end) + "...";
}

// Counts lines while the parser reads. The parser looks one character past a number before it
// reports it, so the line of a value is that of the last character that is no white space.
struct LineCounter {
  int line = 1;
  int lineOfValue = 1;
  char last = 0;

  void count(char c) {
    if (c == '\n' && last == '\r') {
      // The second half of a line end that was counted already.
    } else if (c == '\n' || c == '\r') {
      ++line;
    } else if (c != ' ' && c != '\t') {
      lineOfValue = line;
    }
    last = c;
  }
};

class CountingIterator {
public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, LineCounter* lines) : at_(at), lines_(lines) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    lines_->count(*at_++);
    return *this;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

private:
  const char* at_;
  LineCounter* lines_;
};

// Receives the parser's events and writes the entries down.
class Reader : public json::json_sax_t {
public:
  Reader(const std::string& name, const LineCounter& lines) : name_(name), lines_(lines) {}

  std::vector<JsonEntry> entries;

  bool null() override { return add({.kind = JsonValue::Kind::null, .shown = "null"}); }
  bool boolean(bool value) override {
    return add(
        {.kind = JsonValue::Kind::boolean, .boolean = value, .shown = value ? "true" : "false"});
  }
  bool number_integer(json::number_integer_t value) override {
    return addNumber(static_cast<double>(value), std::to_string(value));
  }
  bool number_unsigned(json::number_unsigned_t value) override {
    return addNumber(static_cast<double>(value), std::to_string(value));
  }
  bool number_float(json::number_float_t value, const std::string& written) override {
    return addNumber(value, written);
  }
  bool string(std::string& value) override {
    return add({.kind = JsonValue::Kind::text, .text = value, .shown = inQuotes(value)});
  }
  bool binary(json::binary_t&) override { return false; }

  bool start_object(std::size_t) override {
    if (depth_ > 0) add({.kind = JsonValue::Kind::object, .shown = say("an object")});
    enter();
    return true;
  }
  bool end_object() override {
    leave();
    return true;
  }
  bool key(std::string& key) override {
    if (arrays_ > 0) return true;
    path_.back() = key;
    if (key.empty() || key.find('.') != key.npos)
      fail(say("{}: a key must be a name without a dot", inQuotes(key)));
    if (!seen_.insert(path()).second) fail(say("{}: stands here twice", path()));
    return true;
  }
  bool start_array(std::size_t) override {
    if (depth_ == 0) fail(std::string(words("must be an object: { ... }")));
    if (arrays_ > 0) {
      add({.kind = JsonValue::Kind::mixedArray, .shown = "[...]"});
    } else {
      array_ = {.kind = JsonValue::Kind::numbers, .shown = "["};
      arrayLine_ = lines_.lineOfValue;
    }
    ++arrays_;
    enter();
    return true;
  }
  bool end_array() override {
    leave();
    if (--arrays_ == 0) {
      array_.shown = cut(array_.shown) + (array_.shown.size() > kLongestShown ? "" : "]");
      entries.push_back({path(), arrayLine_, array_});
    }
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const json::exception& error) override {
    std::string what = error.what();
    for (const char* before : {"] ", ": ", " - "}) {
      const std::size_t found = what.find(before);
      if (found != what.npos && found < 90) what.erase(0, found + std::string_view(before).size());
    }
    for (char& c : what)
      if (static_cast<unsigned char>(c) >= 0x80) c = '?';
    if (what.find("UTF-8") != what.npos) what += words("; save the file as UTF-8");
    fail(say("is not valid JSON: {}", what));
  }

private:
  [[noreturn]] void fail(const std::string& what) const {
    throw SceneError(fmt::format("{}:{}: {}", name_, lines_.lineOfValue, what));
  }

  void enter() {
    if (++depth_ > kDeepest) fail(say("is nested too deeply"));
    if (arrays_ == 0) path_.emplace_back();
  }
  void leave() {
    --depth_;
    if (arrays_ == 0) path_.pop_back();
  }

  std::string path() const {
    std::string joined;
    for (const std::string& part : path_) joined += (joined.empty() ? "" : ".") + part;
    return joined;
  }

  bool addNumber(double value, const std::string& written) {
    return add({.kind = JsonValue::Kind::number, .number = value, .shown = cut(written)});
  }

  bool add(JsonValue value) {
    if (depth_ == 0) fail(std::string(words("must be an object: { ... }")));
    if (arrays_ == 0) {
      entries.push_back({path(), lines_.lineOfValue, std::move(value)});
      return true;
    }
    if (array_.shown.size() <= kLongestShown)
      array_.shown += (array_.shown == "[" ? "" : ", ") + value.shown;
    if (value.kind == JsonValue::Kind::number)
      array_.numbers.push_back(value.number);
    else
      array_.kind = JsonValue::Kind::mixedArray;
    return true;
  }

  const std::string& name_;
  const LineCounter& lines_;
  std::vector<std::string> path_; // one name for each open object
  std::size_t depth_ = 0;
  std::size_t arrays_ = 0; // open arrays; what objects in them hold is of no use
  JsonValue array_;
  int arrayLine_ = 0;
  std::set<std::string> seen_;
};

} // namespace

std::string inQuotes(std::string_view text) {
  return cut(json(text).dump(-1, ' ', false, json::error_handler_t::replace));
}

std::vector<JsonEntry> readJson(std::string_view text, const std::string& name) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    throw SceneError(say("{}:1: is UTF-16; save the file as UTF-8", name));
  // The parser would take it for the end.
  if (const std::size_t nul = text.find('\0'); nul != text.npos)
    throw SceneError(say("{}:{}: holds a NUL byte; save the file as text", name,
                         1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(nul), '\n')));
  LineCounter lines;
  Reader reader(name, lines);
  json::sax_parse(CountingIterator(text.data(), &lines),
                  CountingIterator(text.data() + text.size(), &lines), &reader);
  return std::move(reader.entries);
}

std::optional<SceneValue> convert(const KeyDeclaration& key, const JsonValue& value) {
  using Kind = JsonValue::Kind;
  const auto inRange = [&](double number) {
    return number >= key.lowest && number <= key.highest &&
           (key.type != KeyType::integer || number == std::floor(number));
  };
  switch (key.type) {
  case KeyType::boolean:
    if (value.kind == Kind::boolean) return value.boolean;
    return {};
  case KeyType::text:
    if (value.kind == Kind::text) return value.text;
    return {};
  case KeyType::integer:
  case KeyType::real:
    if (key.length > 1) {
      if (value.kind != Kind::numbers ||
          value.numbers.size() != static_cast<std::size_t>(key.length))
        return {};
      for (double number : value.numbers)
        if (!inRange(number)) return {};
      return value.numbers;
    }
    if (value.kind != Kind::number || !inRange(value.number)) return {};
    if (key.type == KeyType::integer) return static_cast<int>(value.number);
    return value.number;
  }
  return {};
}

} // namespace gg::detail
