#include "check/begun.hpp"

#include "assignment/assignment.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <regex>

namespace ggrade::check {

namespace fs = std::filesystem;

namespace {

using Names = std::set<std::string>;

/// A statement, the head or end of a block, a directive; or a comment line that names TODOs.
struct Unit {
  std::string text;   ///< without white space; of a comment the TODOs alone
  Names todos;        ///< that a comment names
  bool opens = false; ///< does the comment begin with one?
  std::string words;  ///< all of the comment, and the lines of it that follow

  bool isComment() const { return !todos.empty(); }
};

Names todosIn(const std::string& comment) {
  static const std::regex kTodo(R"((?:TODO|DONE)\(([a-z0-9_]+\.[0-9]+)\))");
  Names names;
  for (std::sregex_iterator i(comment.begin(), comment.end(), kTodo), end; i != end; ++i)
    names.insert((*i)[1]);
  return names;
}

bool isOfName(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

class Reader {
public:
  explicit Reader(std::string_view text) : text_(text) {}

  std::vector<Unit> units() {
    for (bool startsLine = true; at_ < text_.size();) {
      const char c = text_[at_];
      if (std::isspace(static_cast<unsigned char>(c))) {
        startsLine = startsLine || c == '\n';
        ++at_;
        continue;
      }
      if (next("//"))
        comment(lineEnd());
      else if (next("/*"))
        comment(std::min(text_.size(), text_.find("*/", at_ + 2)) + 2);
      else if (c == '#' && startsLine)
        directive();
      else if (c == '"' || (c == '\'' && (at_ == 0 || !isOfName(text_[at_ - 1]))))
        literal(c);
      else
        code(c);
      startsLine = false;
    }
    flush();
    return std::move(units_);
  }

private:
  bool next(std::string_view what) const { return text_.substr(at_, what.size()) == what; }

  /// A backslash at its end goes on in the next line, as the compiler reads it.
  std::size_t lineEnd() const {
    std::size_t end = at_;
    std::string_view before;
    do {
      end = std::min(text_.size(), text_.find('\n', end + 1));
      before = text_.substr(0, end);
    } while (end < text_.size() && (before.ends_with('\\') || before.ends_with("\\\r")));
    return end;
  }

  void comment(std::size_t end) {
    const std::string words(text_.substr(at_, end - at_));
    at_ = std::min(end, text_.size());
    Unit unit{"@", todosIn(words), false, words};
    if (unit.isComment()) {
      for (const std::string& todo : unit.todos) unit.text += todo + ' ';
      const std::size_t first = words.find_first_not_of("/* \t");
      unit.opens = first != words.npos && words.compare(first, 5, "TODO(") == 0;
      units_.push_back(std::move(unit));
    } else if (pending_.empty() && !units_.empty() && units_.back().isComment()) {
      units_.back().words += words;
    }
  }

  void directive() {
    flush();
    const std::size_t end = lineEnd();
    for (; at_ < end; ++at_)
      if (!std::isspace(static_cast<unsigned char>(text_[at_]))) pending_ += text_[at_];
    flush();
  }

  void literal(char quote) {
    do {
      pending_ += text_[at_];
      if (text_[at_] == '\\' && at_ + 1 < text_.size()) pending_ += text_[++at_];
    } while (++at_ < text_.size() && text_[at_] != quote && text_[at_] != '\n');
    if (at_ < text_.size()) pending_ += text_[at_++];
  }

  void code(char c) {
    pending_ += c;
    ++at_;
    if (c == ';' || c == '{' || c == '}') flush();
  }

  void flush() {
    if (!pending_.empty()) units_.push_back({std::move(pending_), {}, false, {}});
    pending_.clear();
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::string pending_;
  std::vector<Unit> units_;
};

/// By unit of the stub, whose place it is; empty: nobody's.
struct Places {
  std::vector<std::string> added;   ///< what is written after this unit
  std::vector<std::string> changed; ///< what is written in place of it
  /// The comments around it without a statement between them, as numbers of units; of a statement
  /// itself, those before and after it.
  std::vector<std::vector<std::size_t>> comments;
};

Places placesIn(const std::vector<Unit>& stub) {
  Places places;
  std::string owner;
  for (std::size_t i = 0; i < stub.size(); ++i) {
    const Unit& unit = stub[i];
    if (unit.isComment()) owner = unit.todos.size() == 1 ? *unit.todos.begin() : "";
    // "negate it" speaks of the statement right above.
    if (i > 0 && unit.opens && !owner.empty() && !stub[i - 1].isComment() &&
        stub[i - 1].text.ends_with(';'))
      places.changed.back() = owner;
    places.added.push_back(owner);
    places.changed.push_back(owner);
    std::size_t first = i, end = i + 1;
    while (first > 0 && stub[first - 1].isComment()) --first;
    while (end < stub.size() && stub[end].isComment()) ++end;
    std::vector<std::size_t>& comments = places.comments.emplace_back();
    for (; first < end; ++first)
      if (stub[first].isComment()) comments.push_back(first);
  }
  return places;
}

/// Names in code, such as uPcfRadius or GL_BACK; not words of a language.
Names namesIn(const std::string& text) {
  Names names;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && isOfName(text[end])) ++end;
    const std::string name = text.substr(i, end - i);
    const bool isCode = std::any_of(name.begin() + (name.empty() ? 0 : 1), name.end(), [](char c) {
      return c == '_' || std::isupper(static_cast<unsigned char>(c));
    });
    if (isCode) names.insert(name);
    i = std::max(end, i + 1);
  }
  return names;
}

/// The TODOs whose comment alone, of all these, has one of the names that `written` has.
Names namedIn(const std::string& written, const std::vector<Unit>& stub,
              const std::vector<std::size_t>& comments) {
  std::map<std::string, Names> owners; // by name
  for (const std::size_t i : comments)
    for (const std::string& name : namesIn(stub[i].words))
      owners[name].insert(stub[i].todos.begin(), stub[i].todos.end());
  Names todos;
  for (const std::string& name : namesIn(written))
    if (const auto found = owners.find(name); found != owners.end() && found->second.size() == 1)
      todos.insert(*found->second.begin());
  return todos;
}

/// Lengths of the longest common subsequences of the ends of both, [from a][from b].
std::vector<std::vector<int>> commonEnds(const std::vector<Unit>& a, const std::vector<Unit>& b) {
  std::vector<std::vector<int>> length(a.size() + 1, std::vector<int>(b.size() + 1));
  for (std::size_t i = a.size(); i-- > 0;)
    for (std::size_t k = b.size(); k-- > 0;)
      length[i][k] = a[i].text == b[k].text ? length[i + 1][k + 1] + 1
                                            : std::max(length[i + 1][k], length[i][k + 1]);
  return length;
}

/// The statements of `stub` that `common` finds no place for in `now`: taken out, or moved.
std::multiset<std::string> leftOver(const std::vector<Unit>& stub, const std::vector<Unit>& now,
                                    const std::vector<std::vector<int>>& common) {
  std::multiset<std::string> texts;
  for (std::size_t i = 0, k = 0; i < stub.size();) {
    if (k < now.size() && stub[i].text == now[k].text) {
      ++i, ++k;
    } else if (k == now.size() || common[i + 1][k] >= common[i][k + 1]) {
      if (!stub[i].isComment()) texts.insert(stub[i].text);
      ++i;
    } else {
      ++k;
    }
  }
  return texts;
}

/// The TODOs in whose places, as the comments of `now` itself have them, stands what the stub
/// doesn't have anywhere.
Names byOwnComments(const std::vector<Unit>& now, const std::vector<Unit>& stub) {
  std::set<std::string> given;
  for (const Unit& unit : stub) given.insert(unit.text);
  const Places places = placesIn(now);
  Names todos;
  for (std::size_t k = 0; k < now.size(); ++k)
    if (!now[k].isComment() && !given.count(now[k].text)) todos.insert(places.added[k]);
  todos.erase("");
  return todos;
}

} // namespace

Begun begunIn(std::string_view stubText, std::string_view text) {
  const std::vector<Unit> stub = Reader(stubText).units(), now = Reader(text).units();
  const Places places = placesIn(stub);
  const auto common = commonEnds(stub, now);
  std::multiset<std::string> moved = leftOver(stub, now, common);
  Begun begun;
  std::set<std::size_t> takenOut;  // units of the stub
  std::set<std::size_t> writtenAt; // comments among which something is written
  std::size_t i = 0;
  bool inPlace = false; // of what was there, else after it
  for (std::size_t k = 0; k < now.size();) {
    if (i < stub.size() && stub[i].text == now[k].text) {
      ++i, ++k;
      inPlace = false;
    } else if (i < stub.size() && common[i + 1][k] >= common[i][k + 1]) {
      takenOut.insert(i++);
      inPlace = true;
    } else {
      const Unit& written = now[k++];
      if (written.isComment() || i == 0) continue;
      if (const auto given = moved.find(written.text); given != moved.end()) {
        moved.erase(given);
        continue;
      }
      std::vector<std::size_t> comments = places.comments[i - 1];
      if (!inPlace) // what stands before a statement is not asked of what is added after it
        std::erase_if(comments,
                      [&](std::size_t c) { return c < i - 1 && !stub[i - 1].isComment(); });
      Names all;
      for (const std::size_t comment : comments)
        all.insert(stub[comment].todos.begin(), stub[comment].todos.end());
      // Where one of several was taken out, nobody knows where the place of another ends.
      const bool isClear = all.size() < 2 || std::ranges::none_of(comments, [&](std::size_t c) {
                             return takenOut.count(c);
                           });
      const std::string& owner = (inPlace ? places.changed : places.added)[i - 1];
      if (isClear && !owner.empty()) begun.certain.insert(owner);
      begun.certain.merge(namedIn(written.text, stub, comments));
      writtenAt.insert(comments.begin(), comments.end());
    }
  }
  for (const std::size_t comment : writtenAt)
    if (takenOut.count(comment))
      for (const std::string& todo : stub[comment].todos)
        if (!begun.certain.count(todo)) begun.possible.insert(todo);
  begun.possible.merge(byOwnComments(now, stub));
  for (const std::string& todo : begun.certain) begun.possible.erase(todo);
  return begun;
}

Begun begun(const fs::path& stub, const fs::path& folder) {
  Begun all;
  for (const fs::directory_entry& entry : fs::directory_iterator(stub)) {
    const fs::path now = folder / entry.path().filename();
    if (!fs::is_regular_file(now)) continue;
    Begun one = begunIn(readFile(entry.path()), readFile(now));
    all.certain.merge(one.certain);
    all.possible.merge(one.possible);
  }
  for (const std::string& todo : all.certain) all.possible.erase(todo);
  return all;
}

} // namespace ggrade::check
