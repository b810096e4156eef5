#include "check/page.hpp"

#include "image/png.hpp"
#include "report/page.hpp"
#include "report/picture.hpp"
#include "report/templates.hpp"
#include "report/text.hpp"
#include "words/words.hpp"

#include <algorithm>

namespace ggrade::check {

using gg::say;
using gg::words;
using nlohmann::json;
using report::sanitizeLine;

namespace {

const char* const kClasses[] = {"plain",    "full",     "none", "unjudged",
                                "unjudged", "unjudged", "none"};

/// Of a fault's name in the page, by which its script knows it again.
constexpr std::size_t kLongestIdentity = 4000;

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

/// A picture of depth as all others show it: black is the nearest and white the farthest that
/// `range` shows, a picture of `trace::evenDepth`, and what is 1. Others stay.
Image between(Image image, const Image& range) {
  if (image.channels() != 1 || range.channels() != 1) return image;
  float nearest = 1, farthest = 0;
  for (const float depth : range.values())
    if (depth >= 0 && depth < 1)
      nearest = std::min(nearest, depth), farthest = std::max(farthest, depth);
  if (nearest >= farthest) return image;
  for (float& depth : image.values())
    if (depth < 1) depth = (depth - nearest) / (farthest - nearest);
  return image;
}

json figure(const std::string& caption, const Image& image) {
  return {{"caption", sanitizeLine(caption)}, {"uri", uriOf(image)}, {"none", words("not found")}};
}

/// Of what is done; nothing where that says no more than the row.
std::string purposeShown(const Looked& looked, const Row& row) {
  if (row.state != State::done) return {};
  const std::string purpose = purposeOf(looked, row);
  return purpose == words(todoOf(*looked.part, row.todo).title) ? std::string() : purpose;
}

json partOf(const Looked& looked, bool isLast) {
  const Checked& checked = looked.checked;
  const results::Outcome outcome = checked.happened.outcome;
  json rows = json::array(), pictures = json::array(), wrong = json::array();
  for (const Row& row : checked.rows)
    rows.push_back({{"id", sanitizeLine(row.todo)},
                    {"title", sanitizeLine(words(todoOf(*looked.part, row.todo).title))},
                    {"state", nameOf(row.state)},
                    {"class", kClasses[int(row.state)]},
                    {"note", sanitizeLine(noteOf(checked, row))},
                    {"purpose", sanitizeLine(purposeShown(looked, row))}});
  if (!checked.window.empty() || checked.happened.ok()) {
    const std::string scene = sceneOf(looked, checked.scene);
    const auto add = [&](const std::string& caption, const Image& image) {
      pictures.push_back(figure(scene.empty() ? caption : say("{} ({})", caption, scene), image));
    };
    add(say("your window"), checked.window);
    add(say("to expect now"), checked.expectedWindow);
    add(say("with all steps done"), checked.finishedWindow);
  }
  if (const auto& first = checked.firstWrong) {
    const Image& range = first->expected.empty() ? first->ours : first->expected;
    wrong.push_back(figure(say("yours: {}", first->name), between(first->ours, range)));
    wrong.push_back(figure(hasWrong(checked) ? say("as it should be now")
                                             : say("the reference's after this step"),
                           between(first->expected, range)));
  }
  const bool hasOutput =
      outcome == results::Outcome::buildFailed || outcome == results::Outcome::shaderError;
  std::vector<std::string> messages;
  for (const std::string& message : checked.messages)
    messages.push_back(withPaths(message, looked.folder));
  json places = json::array();
  for (const Place& place : looked.places)
    places.push_back(sanitizeLine(fmt::format("{}:{}", place.file, place.line)));
  const bool isPuzzle = lastLevel(checked) > Level::where;
  return {{"title", sanitizeLine(words(looked.part->title))},
          {"headline", headline(checked)},
          {"drawn", checked.drawn},
          {"percent", 100 * doneRows(checked) / std::max<std::size_t>(checked.rows.size(), 1)},
          {"rows", std::move(rows)},
          {"outcome", sanitizeLine(withPaths(outcomeOf(checked), looked.folder))},
          {"isTold", !isPuzzle && !checked.cause.empty()},
          {"isPuzzle", isPuzzle},
          {"fault", sanitizeLine(identityOf(checked), kLongestIdentity)},
          {"unknown", unknownCause(checked)},
          {"cause", withPaths(checked.cause, looked.folder)},
          {"look", lookOf(checked)},
          {"hint", withPaths(checked.hint, looked.folder)},
          {"step", sanitizeLine(stepToRead(looked, isLast))},
          {"places", std::move(places)},
          {"wrongPlace", checked.firstWrong ? sanitizeLine(pictureOf(looked)) : ""},
          {"messages", report::linesOf(messages)},
          {"hasMessages", !checked.messages.empty()},
          {"compiler", hasOutput ? withPaths(checked.happened.output, looked.folder) : ""},
          {"pictures", std::move(pictures)},
          {"wrong", std::move(wrong)},
          {"hasWrong", checked.firstWrong.has_value()},
          {"wordRead", hasWrong(checked) ? words("Read again") : words("Next")},
          {"wordFirstWrong", pictureHeading(checked)}};
}

} // namespace

std::string page(const std::string& title, const std::vector<Looked>& all, bool watched) {
  json parts = json::array();
  for (const Looked& looked : all) parts.push_back(partOf(looked, &looked == &all.back()));
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

} // namespace ggrade::check
