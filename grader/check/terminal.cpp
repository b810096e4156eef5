#include "check/terminal.hpp"

#include "report/text.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <sstream>

namespace ggrade::check {

using gg::say;
using gg::words;
using nlohmann::json;

namespace {

std::string paint(const std::string& text, const char* code, bool colour) {
  return colour ? fmt::format("\033[{}m{}\033[0m", code, text) : text;
}

/// Padded to `columns` of a terminal.
std::string padded(const std::string& text, std::size_t columns) {
  const std::size_t width = report::displayWidth(text);
  return text + std::string(columns > width ? columns - width : 0, ' ');
}

/// Two signs a TODO.
std::string bar(const Checked& checked) {
  const std::size_t done = doneRows(checked);
  return '[' + std::string(2 * done, '#') + std::string(2 * (checked.rows.size() - done), '-') +
         ']';
}

/// "Likely cause: ...", at its place if it has one.
std::string labelled(std::string_view label, const std::string& text) {
  auto problem = problemIn(text);
  if (!problem) return fmt::format("{}: {}\n", label, text);
  problem->text = fmt::format("{}: {}", label, problem->text);
  return lineOf(*problem) + '\n';
}

std::string ended(const std::string& text) {
  return text.empty() || text.ends_with('\n') ? text : text + '\n';
}

/// So much of the cause as is told, and how to be told more.
std::string causeOf(const Looked& looked, const std::string& ask) {
  const Checked& checked = looked.checked;
  if (checked.cause.empty()) return ended(unknownCause(checked));
  const std::string hint = ended(withPaths(checked.hint, looked.folder));
  const Level last = lastLevel(checked);
  if (last == Level::where)
    return labelled(words("Likely cause"), withPaths(checked.cause, looked.folder)) + hint;
  std::string out;
  if (looked.level >= Level::look)
    out += fmt::format("{}: {}\n", words("Likely cause"),
                       looked.level == Level::look ? lookOf(checked) : checked.cause);
  if (looked.level >= Level::why) out += hint;
  if (looked.canAsk)
    out += (looked.level == Level::where ? say("For a hint: {}", ask)
                                         : say("For one more hint, again: {}", ask)) +
           '\n';
  else if (looked.level == last)
    out += say("That was the last hint.") + '\n';
  return out;
}

/// Of the last step that is done, while nothing is wrong.
std::string purposeOfLast(const Looked& looked) {
  if (isTogether(*looked.expected)) return {};
  const Row* next = rowToLookAt(looked.checked);
  if (next && next->state != State::waits && next->state != State::notBegun) return {};
  const auto& rows = looked.checked.rows;
  const auto last = std::ranges::find(rows.rbegin(), rows.rend(), State::done, &Row::state);
  return last == rows.rend()
             ? std::string()
             : say("{} is done. What it is for: {}", last->todo, purposeOf(looked, *last)) + '\n';
}

} // namespace

std::string table(const std::vector<Looked>& all, bool colour, const std::string& ask) {
  static const char* const kColours[] = {"2", "32", "31;1", "33", "33", "33", "31"};
  std::string out;
  for (const Looked& looked : all) {
    const Checked& checked = looked.checked;
    out += fmt::format("{}: {}{} ({:.1f} s)\n", looked.part->id,
                       checked.drawn ? bar(checked) + ' ' : "", headline(checked), checked.seconds);
    std::size_t wide = 0;
    for (const State state : {State::notBegun, State::done, State::wrong, State::waits,
                              State::nearly, State::differs, State::maybe})
      wide = std::max(wide, report::displayWidth(nameOf(state)));
    for (const Row& row : checked.rows) {
      const std::string note = noteOf(checked, row);
      out += fmt::format("  {}  {}  {}{}\n", padded(row.todo, 16),
                         paint(padded(nameOf(row.state), wide), kColours[int(row.state)], colour),
                         words(todoOf(*looked.part, row.todo).title),
                         note.empty() ? "" : " (" + note + ")");
    }
    const bool isBuilt = checked.happened.outcome != results::Outcome::buildFailed;
    const std::string outcome = outcomeOf(checked);
    if (isBuilt && !outcome.empty()) // else the compiler's own lines follow
      out += ended(withPaths(outcome, looked.folder));
    for (const Problem& problem : todoProblems(looked)) out += lineOf(problem) + '\n';
    if (checked.firstWrong)
      out += fmt::format("{}: {}\n", pictureHeading(checked), pictureOf(looked));
    out += causeOf(looked, ask);
    for (const std::string& message : checked.messages) {
      if (message == outcome) continue;
      const std::string line = withPaths(message, looked.folder);
      out += (problemIn(line) ? "" : "  | ") + line + '\n';
    }
    if (!isBuilt) out += ended(withPaths(checked.happened.output, looked.folder));
    out += purposeOfLast(looked);
    if (const std::string step = stepToRead(looked, &looked == &all.back()); !step.empty())
      out += fmt::format("{}: {}\n", hasWrong(checked) ? words("Read again") : words("Next"), step);
  }
  return out;
}

namespace {

/// Everything that has a place.
json problemsOf(const Looked& looked) {
  const Checked& checked = looked.checked;
  std::string said = checked.cause + '\n' + checked.hint + '\n';
  for (const std::string& message : checked.messages) said += message + '\n';
  if (checked.happened.outcome == results::Outcome::buildFailed) said += checked.happened.output;
  std::vector<Problem> all;
  std::istringstream lines(withPaths(said, looked.folder));
  for (std::string line; std::getline(lines, line);)
    if (auto problem = problemIn(line)) all.push_back(std::move(*problem));
  for (Problem& problem : todoProblems(looked)) all.push_back(std::move(problem));
  json problems = json::array();
  for (const auto& [place, severity, text] : all)
    problems.push_back({{"file", place.file},
                        {"line", place.line},
                        {"column", place.column},
                        {"severity", severity},
                        {"text", text}});
  return problems;
}

} // namespace

json toJson(const std::vector<Looked>& all) {
  json parts = json::array();
  static const char* const kNames[] = {"not_begun", "done",    "wrong", "waits",
                                       "nearly",    "differs", "maybe"};
  for (const Looked& looked : all) {
    const Checked& checked = looked.checked;
    json rows = json::array();
    for (const Row& row : checked.rows)
      rows.push_back({{"id", row.todo}, {"state", kNames[int(row.state)]}, {"seen", row.seen}});
    json part = {{"part", looked.part->id},
                 {"outcome", results::name(checked.happened.outcome)},
                 {"detail", checked.happened.detail},
                 {"todos", rows},
                 {"cause", checked.cause},
                 {"hint", checked.hint},
                 {"problems", problemsOf(looked)},
                 {"messages", checked.messages},
                 {"seconds", checked.seconds}};
    if (checked.firstWrong)
      part["first_wrong"] = {{"picture", checked.firstWrong->name},
                             {"scene", looked.expected->scenes[checked.firstWrong->scene].name},
                             {"share", checked.firstWrong->share}};
    parts.push_back(part);
  }
  return parts;
}

} // namespace ggrade::check
