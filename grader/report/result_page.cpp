#include "report/reports.hpp"

#include "report/page.hpp"
#include "report/picture.hpp"
#include "report/result_scenes.hpp"
#include "report/summary.hpp"
#include "report/templates.hpp"
#include "report/text.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <map>
#include <vector>

namespace ggrade::report {

using gg::say;
using nlohmann::json;

namespace {

constexpr std::size_t kFindings = 3;

// The table of items.

struct ItemLook {
  std::string_view state, sign, word; // the word in the reader's language
};

ItemLook lookOf(const results::Item& item) {
  const bool bonus = item.kind == results::ItemKind::bonus;
  switch (standing(item)) {
  case Standing::full:
    return {bonus ? "extra" : "full", "✓",
            item.kind == results::ItemKind::keep ? gg::words("kept") : gg::words("full points")};
  case Standing::part:
    return {bonus ? "extra" : "part", "◐", gg::words("some points")};
  case Standing::none:
    return bonus ? ItemLook{"unjudged", "○", gg::words("bonus not earned")}
                 : ItemLook{"none", "✗", gg::words("no points")};
  case Standing::unjudged:
    break;
  }
  return {"unjudged", "–", gg::words("not judged")};
}

json tagsOf(const results::Item& item) {
  json tags = json::array();
  const auto add = [&](const std::string& word, const char* state) {
    tags.push_back({{"tag", word}, {"tagState", state}});
  };
  if (item.kind == results::ItemKind::bonus) add(say("bonus"), "extra");
  if (item.kind == results::ItemKind::keep)
    add(say("must stay right, up to −{}", number(item.points)), "plain");
  if (item.beyondLecture) add(say("beyond the lecture"), "plain");
  return tags;
}

json creditsOf(const results::Result& result, const results::Item& item) {
  json credits = json::array();
  for (const auto& [scene, credit, isPublic] : item.credits)
    credits.push_back({{"scene", sanitizeLine(scene)},
                       {"credit", percent(credit)},
                       {"creditState", creditState(credit)},
                       {"sceneAnchor", sceneAnchor(result, scene)}});
  return credits;
}

json itemOf(const results::Result& result, std::size_t index) {
  const results::Item& item = result.items[index];
  const ItemLook look = lookOf(item);
  const double reached = item.points > 0 ? 1 - lost(item) / item.points : 0;
  const bool isLost = item.judged && lost(item) > 0;
  const json tags = tagsOf(item);
  return {{"anchor", fmt::format("item-{}", index)},
          {"state", look.state},
          {"sign", look.sign},
          {"stateWord", look.word},
          {"title", titleOf(item)},
          {"looksAt", sanitizeLine(item.looksAt)},
          {"hasTags", !tags.empty()},
          {"tags", tags},
          {"points", pointsText(item)},
          {"share", item.judged ? number(std::clamp(reached, 0.0, 1.0) * 100, 1) : ""},
          {"message", sanitizeLine(item.message)},
          {"carried", carriedText(item)},
          {"where", sanitizeLine(item.where)},
          {"cause", sanitizeLine(item.cause)},
          {"step", sanitizeLine(item.step)},
          {"hasCredits", isLost && item.kind != results::ItemKind::bonus && !item.credits.empty()},
          {"credits", creditsOf(result, item)}};
}

// One of the losses named at the top.
json findingOf(const results::Result& result, const results::Item& item) {
  const results::Scene* scene = worstScene(result, item);
  return {{"loss", lost(item)},
          {"anchor", fmt::format("item-{}", &item - result.items.data())},
          {"title", titleOf(item)},
          {"message", sanitizeLine(item.message, 180)},
          {"scene", scene ? sanitizeLine(scene->name) : ""},
          {"sceneAnchor", scene ? sceneAnchor(result, scene->name) : ""},
          {"sceneState", "none"}};
}

// The verdict at the top.

// Escaped here, not by the template, because lines that hold an error get a mark.
std::string compilerHtml(const std::string& output) {
  std::string html;
  const std::string clean = capped(sanitize(output), kOutputBytes);
  for (std::size_t at = 0; at < clean.size();) {
    const std::size_t end = std::min(clean.find('\n', at), clean.size());
    const std::string row = clean.substr(at, end - at);
    const char* mark = row.find("error") != std::string::npos      ? "err"
                       : row.find("warning:") != std::string::npos ? "warn"
                                                                   : nullptr;
    html += mark ? fmt::format("<span class=\"{}\">{}</span>\n", mark, escapeXml(row))
                 : escapeXml(row) + "\n";
    at = end + 1;
  }
  return html;
}

std::string firstError(const results::Result& result) {
  if (result.outcome != results::Outcome::buildFailed) return "";
  const std::string clean = sanitize(result.compilerOutput);
  for (std::size_t at = 0; at < clean.size();) {
    const std::size_t end = std::min(clean.find('\n', at), clean.size());
    const std::string row = clean.substr(at, end - at);
    if (row.find("error") != std::string::npos) return sanitizeLine(row);
    at = end + 1;
  }
  return "";
}

json heroOf(const results::Result& result, const Audience& audience) {
  const FrameIndex worst = worstFrame(result);
  if (!worst.found) return false;
  const bool whole = perfect(result);
  const results::Scene& scene = result.scenes[whole ? 0 : worst.scene];
  const results::Frame& frame = whole && !scene.frames.empty()
                                    ? scene.frames[0]
                                    : result.scenes[worst.scene].frames[worst.frame];
  json pictures = json::array();
  const auto add = [&](const Image& image, int width, const std::string& caption,
                       const std::string& alt) {
    if (!image.empty())
      pictures.push_back({{"uri", pngDataUri(thumbnail(image, width, width))},
                          {"caption", caption},
                          {"alt", alt},
                          {"sceneAnchor", sceneAnchor(result, scene.name)}});
  };
  const std::string moment =
      fmt::format("{}, {} s", sanitizeLine(scene.name, 40), number(frame.time, 3));
  add(frame.student, whole ? 360 : 180, moment, audience.who() + ":");
  if (!whole) add(frame.reference, 180, say("reference"), "");
  return {{"pictures", std::move(pictures)}};
}

json factsOf(const results::Result& result, const Audience& audience) {
  using Rows = std::vector<std::pair<std::string, std::string>>;
  json facts = json::array();
  const auto add = [&](std::string_view heading, const Rows& rows) {
    if (rows.empty()) return;
    json list = json::array();
    for (const auto& [key, value] : rows)
      list.push_back({{"key", sanitizeLine(key)}, {"text", sanitizeLine(value)}});
    facts.push_back({{"heading", heading}, {"rows", std::move(list)}});
  };
  Rows run = {{say("part"), result.part == result.assignment
                                ? result.part
                                : result.assignment + " / " + result.part},
              {say("outcome"), std::string(name(result.outcome))}};
  if (audience.instructor) {
    run.emplace_back(say("seed"), std::to_string(result.seed));
    if (!result.quality.empty()) run.emplace_back(say("quality"), result.quality);
  }
  run.emplace_back(say("sandbox"), result.sandbox);
  Rows times, tolerances;
  for (const results::Timing& timing : result.timings)
    times.emplace_back(timing.what, number(timing.seconds, 3) + " s");
  for (const auto& [key, value] : result.thresholds) tolerances.emplace_back(key, number(value, 5));
  add(gg::words("Run"), run);
  add(gg::words("Times"), times);
  add(gg::words("Tolerances"), tolerances);
  add(gg::words("Rendered with"), result.fingerprint);
  return facts;
}

json diagnosesOf(const results::Result& result) {
  json list = json::array();
  for (const results::Diagnosis& diagnosis : result.diagnoses) {
    const bool known = diagnosis.confidence > 0;
    list.push_back({{"part", result.diagnoses.size() > 1 ? sanitizeLine(diagnosis.part) : ""},
                    {"known", known},
                    {"confidence", known ? number(diagnosis.confidence * 100, 0) + "%" : ""},
                    {"diagnosis", sanitizeLine(diagnosis.text, 800)},
                    {"firstWrong", whatIsWrong(diagnosis)},
                    {"readAgain", sanitizeLine(diagnosis.step)},
                    {"hasBeside", !diagnosis.beside.empty()},
                    {"beside", linesOf(diagnosis.beside)},
                    {"catalogue", sanitizeLine(diagnosis.id)}});
  }
  return list;
}

// What stands behind a perfect score, in numbers.
std::string proofOf(const results::Result& result) {
  if (!perfect(result)) return "";
  std::size_t frames = 0;
  double worst = 0;
  for (const results::Scene& scene : result.scenes)
    for (const results::Frame& frame : scene.frames) {
      ++frames;
      worst = std::max(worst, frame.wrongShare);
    }
  if (frames == 0) return "";
  const std::size_t count = result.items.size(), sceneCount = result.scenes.size();
  const std::string items = count == 1 ? say("1 item") : say("{} items", count);
  const std::string drawn = frames == 1 ? say("1 frame") : say("{} frames", frames);
  const std::string scenes = sceneCount == 1 ? say("1 scene") : say("{} scenes", sceneCount);
  return worst <= 0 ? say("{} in {} of {}; no pixel differs.", items, drawn, scenes)
                    : say("{} in {} of {}; at most {} of a frame's pixels differ.", items, drawn,
                          scenes, percent(worst));
}

json verdictOf(const results::Result& result, const Audience& audience) {
  const Summary summary = summarize(result);
  const bool hasScore = result.outcome != results::Outcome::notGradable;
  const double share =
      result.maxScore > 0 ? std::clamp(result.score / result.maxScore, 0.0, 1.0) : 0;
  const std::string score = number(result.score, 1), most = number(result.maxScore);
  json findings = json::array();
  for (const results::Item* item : worstItems(result, kFindings))
    findings.push_back(findingOf(result, *item));
  return {{"state", stateOf(summary)},
          {"perfect", summary.perfect},
          {"outcome", name(result.outcome)},
          {"scoreText", hasScore ? score : "–"},
          {"ofText", hasScore ? say("of {}", most) : ""},
          {"scoreLabel", hasScore ? say("Score {} of {}", score, most) : say("No score")},
          {"arc", hasScore && share > 0 ? number(share * 100, 1) : ""},
          {"bonus", result.bonus > 0 ? number(result.bonus) : ""},
          {"eyebrow", sanitizeLine(result.title.empty() ? result.part : result.title)},
          {"submission",
           sanitizeLine(result.submission.empty() ? say("(no name)") : result.submission)},
          {"headline", summary.headline},
          {"detail", sanitizeLine(result.detail) == summary.headline ? "" : result.detail},
          {"proof", proofOf(result)},
          {"firstError", firstError(result)},
          {"diagnoses", diagnosesOf(result)},
          {"hasFindings", !findings.empty()},
          {"findings", findings},
          {"hero", heroOf(result, audience)},
          {"noSandbox", audience.instructor && result.sandbox == "none"}};
}

std::string page(const results::Result& result, const Pictures& pictures, const Audience& audience,
                 bool scenesLeftOut) {
  json items = json::array(), scenes = json::array();
  for (std::size_t i = 0; i < result.items.size(); ++i) items.push_back(itemOf(result, i));
  const FrameIndex worst = worstFrame(result);
  for (std::size_t i = 0; i < result.scenes.size(); ++i)
    scenes.push_back(
        sceneOf(result, i, pictures, audience, i == 0 || (worst.found && i == worst.scene)));
  const std::size_t count = items.size();
  const bool noneJudged = std::ranges::none_of(result.items, &results::Item::judged);
  json data = verdictOf(result, audience);
  data.update(
      {{"compiler", compilerHtml(result.compilerOutput)},
       {"hasItems", count > 0},
       {"unjudgedNote", !noneJudged  ? ""
                        : count == 1 ? say("1 item was not judged.")
                                     : say("{} items were not judged.", count)},
       {"items", std::move(items)},
       {"hasScenes", !result.scenes.empty() || scenesLeftOut},
       {"scenes", std::move(scenes)},
       {"leftOut", scenesLeftOut},
       {"hasUnused", !result.unusedFiles.empty()},
       {"unused", linesOf(result.unusedFiles)},
       {"facts", factsOf(result, audience)},
       {"footer",
        audience.instructor
            ? say("The instructor's page: it shows hidden scenes. Hand back student.html instead.")
            : say("Positions count pixels from the top left corner.")}});
  const std::string score = result.outcome == results::Outcome::notGradable
                                ? say("no score")
                                : number(result.score) + "/" + number(result.maxScore);
  return renderPage(
      {templates::k_result_mustache, templates::k_page_js, templates::k_page_js_sha256, "", true},
      std::move(data),
      fmt::format("{} · {} · {}", score, sanitizeLine(result.submission),
                  sanitizeLine(result.part)));
}

} // namespace

Pages resultPages(const results::Result& result, Reveal reveal, std::launch how) {
  const Pictures pictures = encode(result, how);
  const results::Result view = studentView(result, reveal);
  return {page(result, pictures, {true}, false),
          page(view, pictures, {false}, view.scenes.size() < result.scenes.size())};
}

} // namespace ggrade::report
