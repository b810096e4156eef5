#include "report/reports.hpp"

#include "report/page.hpp"
#include "report/picture.hpp"
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

constexpr std::size_t kOutputBytes = 64 << 10; // of compiler or program output on a page
constexpr std::size_t kFindings = 3;

// Student, reference, difference, FLIP, difference between two runs as data URIs.
using FramePictures = std::array<std::string, 5>;
// The frames of each scene. Public and hidden scenes never share an entry, whatever their names.
using SceneKey = std::pair<std::string, bool>;
using Pictures = std::map<SceneKey, std::vector<FramePictures>>;

// Who reads the page decides its words, not what it shows: that is in the Result it is given.
struct Audience {
  bool instructor = true;
  std::string who() const { return instructor ? say("submission") : say("yours"); }
};

// The ID of the scene's element; empty when `result` doesn't hold the scene.
std::string sceneAnchor(const Result& result, const std::string& name) {
  for (std::size_t i = 0; i < result.scenes.size(); ++i)
    if (result.scenes[i].name == name) return fmt::format("scene-{}", i);
  return "";
}

// The class that colours a credit of 0 to 1.
std::string_view creditState(double credit) {
  return credit >= 1 ? "full" : credit > 0 ? "part" : "none";
}

std::string titleOf(const Item& item) {
  return sanitizeLine(item.title.empty() ? item.id : item.title);
}

// The table of items.

struct ItemLook {
  std::string_view state, sign, word; // the word in the reader's language
};

ItemLook lookOf(const Item& item) {
  const bool bonus = item.kind == ItemKind::bonus;
  switch (standing(item)) {
  case Standing::full:
    return {bonus ? "extra" : "full", "✓",
            item.kind == ItemKind::keep ? gg::words("kept") : gg::words("full points")};
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

json tagsOf(const Item& item) {
  json tags = json::array();
  const auto add = [&](const std::string& word, const char* state) {
    tags.push_back({{"tag", word}, {"tagState", state}});
  };
  if (item.kind == ItemKind::bonus) add(say("bonus"), "extra");
  if (item.kind == ItemKind::keep)
    add(say("must stay right, up to −{}", number(item.points)), "plain");
  if (item.beyondLecture) add(say("beyond the lecture"), "plain");
  return tags;
}

json creditsOf(const Result& result, const Item& item) {
  json credits = json::array();
  for (const auto& [scene, credit] : item.credits)
    credits.push_back({{"scene", sanitizeLine(scene)},
                       {"credit", percent(credit)},
                       {"creditState", creditState(credit)},
                       {"sceneAnchor", sceneAnchor(result, scene)}});
  return credits;
}

json itemOf(const Result& result, std::size_t index) {
  const Item& item = result.items[index];
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
          {"hasCredits", isLost && item.kind != ItemKind::bonus && !item.credits.empty()},
          {"credits", creditsOf(result, item)}};
}

// One of the losses named at the top.
json findingOf(const Result& result, const Item& item) {
  const Scene* scene = worstScene(result, item);
  return {{"loss", lost(item)},
          {"anchor", fmt::format("item-{}", &item - result.items.data())},
          {"title", titleOf(item)},
          {"message", sanitizeLine(item.message, 180)},
          {"scene", scene ? sanitizeLine(scene->name) : ""},
          {"sceneAnchor", scene ? sceneAnchor(result, scene->name) : ""},
          {"sceneState", "none"}};
}

// The scenes with their frames.

std::string percentWrong(double share) {
  return share <= 0 ? say("no pixel differs") : say("{} of the pixels differ", percent(share));
}

struct Loss {
  std::size_t item = 0;
  double credit = 0;
};

// Items that got less than full credit in the scene. A bonus isn't missed.
std::vector<Loss> lossesIn(const Result& result, const Scene& scene) {
  std::vector<Loss> losses;
  for (std::size_t i = 0; i < result.items.size(); ++i)
    for (const auto& [name, credit] : result.items[i].credits)
      if (name == scene.name && result.items[i].kind != ItemKind::bonus && credit < 1)
        losses.push_back({i, credit});
  return losses;
}

struct SceneLook {
  std::string_view state;
  std::string word;
};

std::string wordsOf(const std::string& outcome) {
  switch (parseOutcome(outcome).value_or(Outcome::graded)) {
  case Outcome::graded:
    break;
  case Outcome::buildFailed:
    return say("build failed");
  case Outcome::shaderError:
    return say("shader error");
  case Outcome::glError:
    return say("gl error");
  case Outcome::noFrame:
    return say("no frame");
  case Outcome::timeout:
    return say("timeout");
  case Outcome::crash:
    return say("crash");
  case Outcome::outOfMemory:
    return say("out of memory");
  case Outcome::badOutput:
    return say("bad output");
  case Outcome::notGradable:
    return say("not gradable");
  }
  return words(outcome);
}

// A scene stands as its worst item does; without credits the outcome decides.
SceneLook lookOf(const Scene& scene, const std::vector<Loss>& losses) {
  const bool glError = scene.outcome == name(Outcome::glError);
  if (scene.outcome != name(Outcome::graded) && !glError) return {"none", wordsOf(scene.outcome)};
  if (losses.empty())
    return glError ? SceneLook{"part", wordsOf(scene.outcome)}
                   : SceneLook{"full", say("all right")};
  const double least = std::ranges::min_element(losses, {}, &Loss::credit)->credit;
  if (glError) return {creditState(least), wordsOf(scene.outcome)};
  return {creditState(least), losses.size() == 1 ? say("1 item lost points")
                                                 : say("{} items lost points", losses.size())};
}

json lossData(const Result& result, const std::vector<Loss>& losses) {
  json list = json::array();
  for (const Loss& loss : losses)
    list.push_back({{"lossState", creditState(loss.credit)},
                    {"lossSign", loss.credit > 0 ? "◐" : "✗"},
                    {"itemAnchor", fmt::format("item-{}", loss.item)},
                    {"item", titleOf(result.items[loss.item])},
                    {"credit", percent(loss.credit)}});
  return list;
}

json pictureOf(const Image& image, const std::string& uri, const std::string& role,
               const std::string& label, const std::string& alt, const std::string& absent) {
  return {{"uri", uri},     {"role", role}, {"width", image.width()}, {"height", image.height()},
          {"label", label}, {"alt", alt},   {"absent", absent}};
}

SceneKey keyOf(const Scene& scene) {
  return {scene.name, scene.isPublic};
}

bool comparable(const Frame& frame) {
  return !frame.student.empty() && sameSize(frame.student, frame.reference);
}

json frameOf(const Scene& scene, const Frame& frame, const FramePictures& uris,
             const Audience& audience) {
  const std::string moment = say("{} at {} s", sanitizeLine(scene.name), number(frame.time, 3));
  const std::string wrong = percentWrong(frame.wrongShare);
  const std::string mine = audience.instructor ? say("Submission") : say("Yours");
  const bool none = frame.student.empty();
  json pictures = json::array();
  pictures.push_back(pictureOf(frame.student, uris[0], "student", mine,
                               say("{}, {}: {}.", mine, moment, wrong), say("no frame came")));
  pictures.push_back(pictureOf(frame.reference, uris[1], "reference", say("Reference"),
                               say("Reference, {}.", moment), say("no reference")));
  pictures.push_back(pictureOf(frame.difference, uris[2], "difference", say("Difference"),
                               say("Difference, {}: bright where the pictures differ.", moment),
                               none ? say("nothing to compare") : say("not compared")));
  if (!std::isnan(frame.flip))
    pictures.push_back(
        pictureOf(frame.flipPicture, uris[3], "flip", fmt::format("FLIP {}", number(frame.flip, 4)),
                  say("FLIP, {}: bright where a person flipping between the pictures sees "
                      "a change.",
                      moment),
                  say("not compared")));
  if (!frame.unsteadyPicture.empty())
    pictures.push_back(
        pictureOf(frame.unsteadyPicture, uris[4], "unsteady",
                  say("{} unsteady", percent(frame.unsteadyShare)),
                  say("Between two runs, {}: bright where the same program drew something "
                      "else when it ran again.",
                      moment),
                  ""));
  return {
      {"caption", say("t = {} s, {}", number(frame.time, 3), none ? say("no frame came") : wrong)},
      {"pictures", std::move(pictures)}};
}

json choicesOf(const Scene& scene, std::size_t sceneIndex, std::size_t chosen) {
  json choices = json::array();
  for (std::size_t i = 0; i < scene.frames.size(); ++i)
    choices.push_back({{"group", fmt::format("frame-{}", sceneIndex)},
                       {"label", fmt::format("{} s", number(scene.frames[i].time, 3))},
                       {"checked", i == chosen}});
  return choices;
}

Pictures encode(const Result& result, std::launch how) {
  const auto uris = [](const Scene& scene) {
    std::vector<FramePictures> frames;
    for (const Frame& frame : scene.frames) {
      const std::string reference =
          frame.referencePng.empty() ? pngDataUri(frame.reference) : frame.referencePng;
      const bool same = sameSize(frame.student, frame.reference) &&
                        std::ranges::equal(frame.student.values(), frame.reference.values());
      frames.push_back({same ? reference : pngDataUri(frame.student), reference,
                        pngDataUri(frame.difference), pngDataUri(frame.flipPicture),
                        pngDataUri(frame.unsteadyPicture)});
    }
    return frames;
  };
  // Compressing is most of the time that a report takes: a thread a scene, if there may be any.
  std::vector<std::future<std::vector<FramePictures>>> pending;
  for (const Scene& scene : result.scenes)
    pending.push_back(std::async(how, uris, std::cref(scene)));
  Pictures pictures;
  for (std::size_t i = 0; i < pending.size(); ++i)
    pictures.try_emplace(keyOf(result.scenes[i]), pending[i].get());
  return pictures;
}

json sceneOf(const Result& result, std::size_t index, const Pictures& pictures,
             const Audience& audience, bool open) {
  const Scene& scene = result.scenes[index];
  const std::vector<Loss> losses = lossesIn(result, scene);
  const SceneLook look = lookOf(scene, losses);
  std::size_t worst = 0;
  for (std::size_t i = 0; i < scene.frames.size(); ++i)
    if (scene.frames[i].wrongShare > scene.frames[worst].wrongShare) worst = i;
  json frames = json::array();
  for (std::size_t i = 0; i < scene.frames.size(); ++i)
    frames.push_back(frameOf(scene, scene.frames[i], pictures.at(keyOf(scene)).at(i), audience));
  const bool shown = !scene.frames.empty();
  const bool drawn =
      std::ranges::any_of(scene.frames, [](const Frame& f) { return !f.student.empty(); });
  const bool withheld = !audience.instructor && !scene.isPublic && !shown;
  const bool named = scene.name == (scene.isPublic ? "public" : "hidden");
  const int width = shown ? scene.frames[worst].student.width() : 0;
  return {{"anchor", fmt::format("scene-{}", index)},
          {"scene", sanitizeLine(scene.name.empty() ? say("(no name)") : scene.name)},
          {"publicWord", named            ? ""
                         : scene.isPublic ? say("public")
                                          : say("hidden")},
          {"state", look.state},
          {"outcome", sanitizeLine(look.word)},
          {"open", open},
          {"wrong", !shown  ? ""
                    : drawn ? percentWrong(scene.frames[worst].wrongShare)
                            : say("no frame came")},
          {"seconds", scene.seconds > 0 ? number(scene.seconds) + " s" : ""},
          {"detail", scene.detail},
          {"withheld", withheld ? say("The pictures of this scene are not shown.") : ""},
          {"hasChoice", scene.frames.size() > 1},
          {"choices", choicesOf(scene, index, worst)},
          {"frames", std::move(frames)},
          {"slider", std::ranges::any_of(scene.frames, comparable)},
          {"who", audience.who()},
          {"width", width},
          {"middle", width / 2},
          {"hasLosses", !losses.empty()},
          {"allHolds", look.state == "full" && shown},
          {"losses", lossData(result, losses)},
          {"hasMessages", !scene.messages.empty()},
          {"messages", linesOf(scene.messages)},
          {"output", capped(sanitize(scene.output), kOutputBytes)}};
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

std::string firstError(const Result& result) {
  if (result.outcome != Outcome::buildFailed) return "";
  const std::string clean = sanitize(result.compilerOutput);
  for (std::size_t at = 0; at < clean.size();) {
    const std::size_t end = std::min(clean.find('\n', at), clean.size());
    const std::string row = clean.substr(at, end - at);
    if (row.find("error") != std::string::npos) return sanitizeLine(row);
    at = end + 1;
  }
  return "";
}

json heroOf(const Result& result, const Audience& audience) {
  const FrameIndex worst = worstFrame(result);
  if (!worst.found) return false;
  const bool whole = perfect(result);
  const Scene& scene = result.scenes[whole ? 0 : worst.scene];
  const Frame& frame = whole && !scene.frames.empty()
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

json factsOf(const Result& result, const Audience& audience) {
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
  for (const Timing& timing : result.timings)
    times.emplace_back(timing.what, number(timing.seconds, 3) + " s");
  for (const auto& [key, value] : result.thresholds) tolerances.emplace_back(key, number(value, 5));
  add(gg::words("Run"), run);
  add(gg::words("Times"), times);
  add(gg::words("Tolerances"), tolerances);
  add(gg::words("Rendered with"), result.fingerprint);
  return facts;
}

json diagnosesOf(const Result& result) {
  json list = json::array();
  for (const Diagnosis& diagnosis : result.diagnoses) {
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
std::string proofOf(const Result& result) {
  if (!perfect(result)) return "";
  std::size_t frames = 0;
  double worst = 0;
  for (const Scene& scene : result.scenes)
    for (const Frame& frame : scene.frames) {
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

json verdictOf(const Result& result, const Audience& audience) {
  const Summary summary = summarize(result);
  const bool hasScore = result.outcome != Outcome::notGradable;
  const double share =
      result.maxScore > 0 ? std::clamp(result.score / result.maxScore, 0.0, 1.0) : 0;
  const std::string score = number(result.score, 1), most = number(result.maxScore);
  json findings = json::array();
  for (const Item* item : worstItems(result, kFindings))
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

std::string page(const Result& result, const Pictures& pictures, const Audience& audience,
                 bool scenesLeftOut) {
  json items = json::array(), scenes = json::array();
  for (std::size_t i = 0; i < result.items.size(); ++i) items.push_back(itemOf(result, i));
  const FrameIndex worst = worstFrame(result);
  for (std::size_t i = 0; i < result.scenes.size(); ++i)
    scenes.push_back(
        sceneOf(result, i, pictures, audience, i == 0 || (worst.found && i == worst.scene)));
  const std::size_t count = items.size();
  const bool noneJudged = std::ranges::none_of(result.items, &Item::judged);
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
  const std::string score = result.outcome == Outcome::notGradable
                                ? say("no score")
                                : number(result.score) + "/" + number(result.maxScore);
  return renderPage(
      {templates::k_result_mustache, templates::k_page_js, templates::k_page_js_sha256, "", true},
      std::move(data),
      fmt::format("{} · {} · {}", score, sanitizeLine(result.submission),
                  sanitizeLine(result.part)));
}

} // namespace

Pages resultPages(const Result& result, Reveal reveal, std::launch how) {
  const Pictures pictures = encode(result, how);
  const Result view = studentView(result, reveal);
  return {page(result, pictures, {true}, false),
          page(view, pictures, {false}, view.scenes.size() < result.scenes.size())};
}

} // namespace ggrade::report
