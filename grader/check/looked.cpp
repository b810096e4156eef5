#include "check/looked.hpp"

#include "report/text.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ggrade::check {

namespace fs = std::filesystem;
using gg::say;
using gg::words;

namespace {

/// The TODOs right before one that were taken for done as nothing of them is seen.
std::string unseenBefore(const Checked& checked, const Row& row) {
  std::string names;
  for (auto k = std::size_t(&row - checked.rows.data()); k > 0 && !checked.rows[k - 1].seen; --k)
    if (checked.rows[k - 1].state == State::done)
      names = checked.rows[k - 1].todo + (names.empty() ? "" : ", " + names);
  return names;
}

/// Does a picture show what it has done, or what a later TODO has, which stands on this one?
bool isSeen(const Checked& checked, const Row& row) {
  return row.seen || std::ranges::any_of(checked.rows, [&](const Row& later) {
           return &later > &row && later.state == State::done && later.seen;
         });
}

/// Was a later step begun?
bool isBegunAfter(const Checked& checked, const Row& row) {
  return std::ranges::any_of(checked.rows, [&](const Row& later) {
    return &later > &row && later.state != State::notBegun;
  });
}

/// Those that may be wrong, else those that are nearly right, in the order of the steps.
std::vector<const Row*> inDoubt(const Checked& checked) {
  std::vector<const Row*> rows;
  for (const State state : {State::maybe, State::nearly})
    for (const Row& row : checked.rows)
      if (row.state == state && (rows.empty() || rows.front()->state == state))
        rows.push_back(&row);
  return rows;
}

} // namespace

const Row* rowToLookAt(const Checked& checked) {
  if (!checked.drawn) return nullptr;
  const auto first = [&](State state) {
    const auto row = std::ranges::find(checked.rows, state, &Row::state);
    return row == checked.rows.end() ? nullptr : &*row;
  };
  if (const Row* row = first(State::wrong)) return row;
  // Else, of those that may be, the likeliest; or the one that was written last: whoever looks
  // often has seen the others.
  if (const auto rows = inDoubt(checked); !rows.empty()) {
    const auto likely = std::ranges::find(rows, checked.likely, &Row::todo);
    if (likely != rows.end()) return *likely;
    const auto first = std::ranges::find_if(rows, &Row::isFirst);
    return first == rows.end() ? rows.back() : *first;
  }
  if (const Row* row = first(State::differs)) return row;
  const auto next =
      std::ranges::find_if(checked.rows, [](const Row& row) { return row.state != State::done; });
  return next == checked.rows.end() ? nullptr : &*next;
}

std::vector<const Row*> rowsToLookAt(const Checked& checked) {
  const Row* row = rowToLookAt(checked);
  if (!row) return {};
  const auto rows = inDoubt(checked);
  const bool isOneOfMany =
      row->todo != checked.likely && std::ranges::find(rows, row) != rows.end();
  return isOneOfMany ? rows : std::vector{row};
}

bool hasWrong(const Checked& checked) {
  return std::ranges::any_of(checked.rows, [](const Row& row) {
    return row.state == State::wrong || row.state == State::maybe;
  });
}

std::string unknownCause(const Checked& checked) {
  if (!checked.cause.empty() || !hasWrong(checked) || !checked.firstWrong) return {};
  return say("No mistake that is known at this point shows this picture. Put it beside the "
             "expected one: where do "
             "they differ, and since which line? Take that line out: what changes?");
}

const Todo& todoOf(const Part& part, const std::string& id) {
  return *std::ranges::find(part.todos, id, &Todo::id);
}

std::string nameOf(State state) {
  switch (state) {
  case State::done:
    return say("done");
  case State::wrong:
    return say("wrong");
  case State::waits:
    return say("waits");
  case State::nearly:
    return say("nearly");
  case State::differs:
    return say("differs");
  case State::maybe:
    return say("maybe wrong");
  case State::notBegun:
    break;
  }
  return say("not begun");
}

std::size_t doneRows(const Checked& checked) {
  return std::size_t(std::ranges::count(checked.rows, State::done, &Row::state));
}

std::string headline(const Checked& checked) {
  if (!checked.drawn) return say("not judged: the program draws nothing");
  return say("{} of {} done", doneRows(checked), checked.rows.size());
}

std::string noteOf(const Checked& checked, const Row& row) {
  if (row.state == State::done && !isSeen(checked, row))
    return say("as far as can be told: by itself it changes no picture");
  if (row.state == State::done && !row.showsWith.empty())
    return say("as far as can be told: known mistakes in it show later, the last of them with {}",
               row.showsWith);
  if (row.state == State::done &&
      std::ranges::find(checked.rows, State::nearly, &Row::state) != checked.rows.end())
    return say("as far as can be told: the little that differs may lie here, too");
  std::string notes;
  const auto add = [&](const std::string& note) {
    notes = notes.empty() ? note : say("{}; {}", notes, note);
  };
  if (row.state == State::nearly)
    add(say("little differs in the windows, as small as check compares them: something is wrong, "
            "here or in another step, or it is another right way"));
  if (row.state == State::differs)
    add(say("no known mistake, and the window doesn't show it yet: wrong, or another "
            "right way"));
  if (row.state == State::maybe)
    add(!row.seen ? say("by itself it changes no picture, and that of what stands on it is wrong")
        : std::ranges::count(checked.rows, State::maybe, &Row::state) > 1
            ? say("here, in another step that may be, or outside of the steps")
            : say("here, in another step, or outside of the steps"));
  if (row.state == State::wrong || row.state == State::differs) {
    const std::string unseen = checked.cause.empty() ? unseenBefore(checked, row) : std::string();
    if (!unseen.empty())
      add(say("it may lie in {}, too, of which nothing could be seen before", unseen));
    else if (!checked.firstWrong && !checked.happened.ok())
      add(say("the program ends in another scene; it may lie in another step, too"));
  }
  if (row.state == State::notBegun && isBegunAfter(checked, row))
    add(say("nothing stands in its place; if it stands elsewhere, it is known once the picture is "
            "right"));
  if (row.state == State::waits)
    add(checked.drawn ? say("begun; judged once what comes before it is right")
                      : say("begun; judged once the program draws"));
  return notes;
}

std::string purposeOf(const Looked& looked, const Row& row) {
  std::string titles;
  for (const ItemDeclaration& item : looked.part->items)
    if (item.step == row.todo && item.kind == results::ItemKind::gain)
      titles += (titles.empty() ? "" : "; ") + std::string(words(item.title));
  if (titles.empty()) return std::string(words(todoOf(*looked.part, row.todo).title));
  if (!isSeen(looked.checked, row)) return say("{} (by itself it changes no picture)", titles);
  return row.showsWith.empty() ? titles : say("{} (as far as can be told so far)", titles);
}

namespace {

/// What one scene has otherwise than another: `size [300,400]`, `camera.near 0.6`.
std::vector<std::string> settingsThatDiffer(const nlohmann::json& from, const nlohmann::json& scene,
                                            const std::string& within = "") {
  std::vector<std::string> all;
  for (const auto& [key, value] : scene.items()) {
    const auto before = from.find(key);
    if (before != from.end() && *before == value) continue;
    if (before != from.end() && value.is_object() && before->is_object()) {
      const auto inner = settingsThatDiffer(*before, value, within + key + '.');
      all.insert(all.end(), inner.begin(), inner.end());
    } else {
      all.push_back(fmt::format("{}{} {}", within, key, value.dump()));
    }
  }
  return all;
}

} // namespace

std::string sceneOf(const Looked& looked, std::size_t scene) {
  const Scene& of = looked.expected->scenes[scene];
  if (of.another)
    return say("in another scene, with {}: {}",
               fmt::join(settingsThatDiffer(looked.expected->scenes[0].scene, of.scene), ", "),
               shown(sceneFile(looked.expected->folder, scene)));
  if (of.todo.empty()) return {};
  const auto& todos = looked.part->todos;
  return say("in the scene of the handout's step {}",
             std::ranges::find(todos, of.todo, &Todo::id) - todos.begin() + 1);
}

std::string pictureHeading(const Checked& checked) {
  return hasWrong(checked) ? say("First wrong picture") : say("First picture that differs");
}

std::string pictureOf(const Looked& looked) {
  const Wrong& wrong = *looked.checked.firstWrong;
  const std::string place = wrong.missing.empty()
                                ? say("{}: {} of it differs from what should be there now",
                                      wrong.name, report::percent(wrong.share))
                                : say("{}: {}", wrong.name, wrong.missing);
  const std::string scene = sceneOf(looked, wrong.scene);
  return scene.empty() ? place : say("{} ({})", place, scene);
}

std::string outcomeOf(const Checked& checked) {
  return checked.happened.ok() && checked.happened.outcome == results::Outcome::graded
             ? std::string()
             : checked.happened.detail;
}

std::string stepToRead(const Looked& looked, bool isLast) {
  if (!looked.checked.drawn) return {};
  const Row* row = rowToLookAt(looked.checked);
  if (!row)
    return isLast ? say("every step is done; hand in what you changed in {}", shown(looked.folder))
                  : std::string();
  const Todo& todo = todoOf(*looked.part, row->todo);
  if (isTogether(*looked.expected)) return looked.handout;
  const auto numberOf = [&](const std::string& id) {
    return &todoOf(*looked.part, id) - looked.part->todos.data() + 1;
  };
  const auto rows = rowsToLookAt(looked.checked);
  if (rows.size() == 1)
    return say("{}, step {}: {}", looked.handout, numberOf(row->todo), words(todo.title));
  std::vector<std::ptrdiff_t> numbers;
  for (const Row* each : rows) numbers.push_back(numberOf(each->todo));
  return say("{}, one of the steps {}", looked.handout, fmt::join(numbers, ", "));
}

std::vector<Problem> todoProblems(const Looked& looked) {
  const Row* row = rowToLookAt(looked.checked);
  if (!row) return {};
  const std::string_view title = words(todoOf(*looked.part, row->todo).title);
  const bool isWrong = row->state == State::wrong;
  const bool isNext = row->state == State::waits || row->state == State::notBegun;
  std::vector<Problem> problems;
  for (const Place& place : looked.places)
    problems.push_back({place, "note", say("{} goes on here", row->todo)});
  if (!problems.empty()) {
    problems[0].severity = isWrong ? "error" : isNext ? "note" : "warning";
    problems[0].text = isWrong  ? say("{} is wrong: {}", row->todo, title)
                       : isNext ? say("{} is next: {}", row->todo, title)
                                : say("{} may be wrong: {}", row->todo, title);
  }
  for (const auto& [todo, place] : looked.otherPlaces)
    problems.push_back({place, "warning",
                        say("{} may be wrong: {}", todo, words(todoOf(*looked.part, todo).title))});
  return problems;
}

} // namespace ggrade::check
