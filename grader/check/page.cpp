#include "check/page.hpp"

#include "image/difference.hpp"
#include "image/png.hpp"
#include "report/page.hpp"
#include "report/picture.hpp"
#include "report/templates.hpp"
#include "report/text.hpp"
#include "words/words.hpp"

#include <algorithm>

namespace ggrade::check {

namespace fs = std::filesystem;
using gg::say;
using gg::words;
using nlohmann::json;
using report::sanitizeLine;

namespace {

const char* const kClasses[] = {"plain", "full", "none", "unjudged", "unjudged", "unjudged"};

const Todo& todoOf(const Part& part, const std::string& id) {
  return *std::ranges::find(part.todos, id, &Todo::id);
}

std::size_t done(const Checked& checked) {
  return std::size_t(std::ranges::count(checked.rows, State::done, &Row::state));
}

bool hasWrong(const Checked& checked) {
  return std::ranges::find(checked.rows, State::wrong, &Row::state) != checked.rows.end();
}

/// The TODOs right before one that were taken for done as nothing of them is seen.
std::string unseenBefore(const Checked& checked, const Row& row) {
  std::string names;
  for (auto k = std::size_t(&row - checked.rows.data()); k > 0 && !checked.rows[k - 1].seen; --k)
    if (checked.rows[k - 1].state == State::done)
      names = checked.rows[k - 1].todo + (names.empty() ? "" : ", " + names);
  return names;
}

std::string noteOf(const Checked& checked, const Row& row) {
  // What is seen of a later TODO stands on this one.
  const bool last = std::ranges::none_of(checked.rows, [&](const Row& later) {
    return &later > &row && later.state == State::done && later.seen;
  });
  if (row.state == State::done && !row.seen && last)
    return say("as far as this scene shows: nothing of it can be seen yet");
  if (row.state == State::nearly)
    return say("a little differs that no known mistake explains: a detail, or another right way");
  if (row.state == State::wrong || row.state == State::differs) {
    const std::string doubt =
        row.state == State::wrong
            ? std::string()
            : say("no known mistake, and the window doesn't show it yet: wrong, or another right "
                  "way");
    const std::string names = checked.cause.empty() ? unseenBefore(checked, row) : std::string();
    if (names.empty()) return doubt;
    const std::string unseen =
        say("it may lie in {}, too, of which nothing could be seen before", names);
    return doubt.empty() ? unseen : say("{}; {}", doubt, unseen);
  }
  if (row.state == State::waits)
    return checked.drawn ? say("begun; judged once what comes before it is right")
                         : say("begun; judged once the program draws");
  return {};
}

/// Passes may have any range; a page shows 0 to 1, and greys for one channel.
std::string uriOf(const Image& image) {
  if (image.empty()) return {};
  Image shown(image.width(), image.height(), 3);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      for (int c = 0; c < 3; ++c)
        shown.at(x, y, c) =
            std::clamp(image.at(x, y, std::min(c, image.channels() - 1)), 0.0f, 1.0f);
  return report::pngDataUri(shown);
}

json pictureOf(const std::string& caption, const Image& image) {
  return {{"caption", sanitizeLine(caption)},
          {"uri", uriOf(image)},
          {"none", words("there is no such picture")}};
}

std::string headline(const Looked& looked) {
  if (!looked.checked.drawn) return say("not judged: the program draws nothing");
  return say("{} of {} done", done(looked.checked), looked.checked.rows.size());
}

/// From here, unless it lies elsewhere.
std::string shown(const fs::path& file) {
  const fs::path near = fs::absolute(file).lexically_relative(fs::current_path());
  return (near.empty() || *near.begin() == ".." ? file : near).string();
}

/// Empty for the public scene.
std::string sceneOf(const Looked& looked, std::size_t scene) {
  const auto& [name, values, times, todo, another] = looked.expected->scenes[scene];
  if (another) return say("in another scene: {}", shown(sceneFile(looked.expected->folder, scene)));
  if (todo.empty()) return {};
  const auto& todos = looked.part->todos;
  return say("in the scene of the handout's step {}",
             std::ranges::find(todos, todo, &Todo::id) - todos.begin() + 1);
}

std::string placeOf(const Looked& looked) {
  const Wrong& wrong = *looked.checked.firstWrong;
  const std::string place = say("{}: {} of it differs from what should be there now", wrong.name,
                                report::percent(wrong.share));
  const std::string scene = sceneOf(looked, wrong.scene);
  return scene.empty() ? place : say("{} ({})", place, scene);
}

/// The heading of the first picture that isn't as it should be.
std::string differs(const Checked& checked) {
  return hasWrong(checked) ? say("First wrong picture") : say("First picture that differs");
}

/// What a person has to know of a run that showed nothing, or not all.
std::string outcomeOf(const Checked& checked) {
  return checked.happened.ok() && checked.happened.outcome == results::Outcome::graded
             ? std::string()
             : checked.happened.detail;
}

json partOf(const Looked& looked) {
  const Checked& checked = looked.checked;
  const results::Outcome outcome = checked.happened.outcome;
  json rows = json::array(), pictures = json::array(), wrong = json::array();
  for (const Row& row : checked.rows)
    rows.push_back({{"id", sanitizeLine(row.todo)},
                    {"title", sanitizeLine(words(todoOf(*looked.part, row.todo).title))},
                    {"state", nameOf(row.state)},
                    {"class", kClasses[int(row.state)]},
                    {"note", sanitizeLine(noteOf(checked, row))}});
  if (!checked.window.empty() || checked.happened.ok()) {
    const std::string scene = sceneOf(looked, checked.scene);
    const auto add = [&](const std::string& caption, const Image& image) {
      pictures.push_back(
          pictureOf(scene.empty() ? caption : say("{} ({})", caption, scene), image));
    };
    add(say("your window"), checked.window);
    add(say("to expect now"), checked.expectedWindow);
    add(say("with all steps done"), checked.finishedWindow);
  }
  if (const auto& first = checked.firstWrong) {
    wrong.push_back(pictureOf(say("yours: {}", first->name), first->ours));
    wrong.push_back(pictureOf(hasWrong(checked) ? say("as it should be now")
                                                : say("the reference's after this step"),
                              first->expected));
  }
  const bool hasOutput =
      outcome == results::Outcome::buildFailed || outcome == results::Outcome::shaderError;
  return {{"title", sanitizeLine(words(looked.part->title))},
          {"headline", headline(looked)},
          {"rows", std::move(rows)},
          {"outcome", sanitizeLine(outcomeOf(checked))},
          {"cause", sanitizeLine(checked.cause)},
          {"hint", checked.hint},
          {"step", sanitizeLine(stepToRead(looked))},
          {"wrongPlace", checked.firstWrong ? sanitizeLine(placeOf(looked)) : ""},
          {"messages", report::linesOf(checked.messages)},
          {"hasMessages", !checked.messages.empty()},
          {"compiler", hasOutput ? checked.happened.output : ""},
          {"pictures", std::move(pictures)},
          {"wrong", std::move(wrong)},
          {"hasWrong", checked.firstWrong.has_value()},
          {"wordCause", words("Likely cause")},
          {"wordRead", hasWrong(checked) ? words("Read again") : words("Next")},
          {"wordFirstWrong", differs(checked)},
          {"wordMessages", words("What the program and OpenGL said")}};
}

std::string paint(const std::string& text, const char* code, bool colour) {
  return colour ? fmt::format("\033[{}m{}\033[0m", code, text) : text;
}

/// Padded to `columns` of a terminal.
std::string padded(const std::string& text, std::size_t columns) {
  const std::size_t width = report::displayWidth(text);
  return text + std::string(columns > width ? columns - width : 0, ' ');
}

} // namespace

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
  case State::notBegun:
    break;
  }
  return say("not begun");
}

std::string stepToRead(const Looked& looked) {
  if (!looked.checked.drawn) return {};
  for (const State state :
       {State::wrong, State::nearly, State::differs, State::waits, State::notBegun})
    for (const Row& row : looked.checked.rows)
      if (row.state == state)
        for (std::size_t k = 0; k < looked.part->todos.size(); ++k)
          if (looked.part->todos[k].id == row.todo)
            return say("{}, step {}: {}", looked.handout, k + 1,
                       words(looked.part->todos[k].title));
  return say("every step is done; hand in what you changed in {}",
             fs::path(looked.handout).parent_path().string());
}

std::string page(const std::string& title, const std::vector<Looked>& all, bool watched) {
  json parts = json::array();
  for (const Looked& looked : all) parts.push_back(partOf(looked));
  return report::renderPage(
      {report::templates::k_check_mustache, report::templates::k_check_js,
       report::templates::k_check_js_sha256, report::templates::k_check_css, true},
      {{"title", sanitizeLine(title)},
       {"watched", watched},
       {"watchWords", words("This page follows every save.")},
       {"footer", words("Compared with the public scene, the handout's and a few others: the "
                        "grader draws more.")},
       {"parts", std::move(parts)}},
      title);
}

std::string table(const std::vector<Looked>& all, bool colour) {
  static const char* const kColours[] = {"2", "32", "31;1", "33", "33", "33"};
  std::string out;
  for (const Looked& looked : all) {
    const Checked& checked = looked.checked;
    out += fmt::format("{}: {} ({:.1f} s)\n", looked.part->id, headline(looked), checked.seconds);
    std::size_t wide = 0;
    for (const State state :
         {State::notBegun, State::done, State::wrong, State::waits, State::nearly, State::differs})
      wide = std::max(wide, report::displayWidth(nameOf(state)));
    for (const Row& row : checked.rows) {
      const std::string note = noteOf(checked, row);
      out += fmt::format("  {}  {}  {}{}\n", padded(row.todo, 16),
                         paint(padded(nameOf(row.state), wide), kColours[int(row.state)], colour),
                         words(todoOf(*looked.part, row.todo).title),
                         note.empty() ? "" : " (" + note + ")");
    }
    if (const std::string outcome = outcomeOf(checked); !outcome.empty()) out += outcome + '\n';
    if (checked.firstWrong) out += fmt::format("{}: {}\n", differs(checked), placeOf(looked));
    if (!checked.cause.empty())
      out += fmt::format("{}: {}\n", words("Likely cause"), checked.cause);
    if (!checked.hint.empty()) out += checked.hint + (checked.hint.ends_with('\n') ? "" : "\n");
    for (const std::string& message : checked.messages) out += "  | " + message + '\n';
    if (checked.happened.outcome == results::Outcome::buildFailed) out += checked.happened.output;
    if (const std::string step = stepToRead(looked); !step.empty())
      out += fmt::format("{}: {}\n", hasWrong(checked) ? words("Read again") : words("Next"), step);
  }
  return out;
}

json toJson(const std::vector<Looked>& all) {
  json parts = json::array();
  static const char* const kNames[] = {"not_begun", "done", "wrong", "waits", "nearly", "differs"};
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
