#include "report/html.hpp"

#include "report/page_parts.hpp"
#include "report/picture.hpp"
#include "report/templates.hpp"
#include "report/text.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <vector>

namespace ggrade::report {

using gg::say;

Data optional(const std::string& trusted) {
  return trusted.empty() ? Data(false) : Data(trusted);
}

Data linesOf(const std::vector<std::string>& lines) {
  Data list = makeList();
  for (const std::string& entry : lines) {
    Data data;
    data["text"] = Data(sanitizeLine(entry));
    list << data;
  }
  return list;
}

std::string sceneAnchor(const Result& result, const std::string& name) {
  for (std::size_t i = 0; i < result.scenes.size(); ++i)
    if (result.scenes[i].name == name) return fmt::format("scene-{}", i);
  return "";
}

std::string_view creditState(double credit) {
  return credit >= 1 ? "full" : credit > 0 ? "part" : "none";
}

namespace {

constexpr std::size_t kFindings = 3;

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

Data heroOf(const Result& result, const Audience& audience) {
  const FrameIndex worst = worstFrame(result);
  if (!worst.found) return Data(false);
  const bool whole = perfect(result);
  const Scene& scene = result.scenes[whole ? 0 : worst.scene];
  const Frame& frame = whole && !scene.frames.empty()
                           ? scene.frames[0]
                           : result.scenes[worst.scene].frames[worst.frame];
  Data hero, pictures = makeList();
  const auto add = [&](const Image& image, int width, const std::string& caption,
                       const std::string& alt) {
    if (image.empty()) return;
    Data picture;
    picture["uri"] = Data(pngDataUri(thumbnail(image, width, width)));
    picture["caption"] = Data(caption);
    picture["alt"] = Data(alt);
    picture["sceneAnchor"] = Data(sceneAnchor(result, scene.name));
    pictures << picture;
  };
  const std::string moment =
      fmt::format("{}, {} s", sanitizeLine(scene.name, 40), number(frame.time, 3));
  add(frame.student, whole ? 360 : 180, moment, audience.who() + ":");
  if (!whole) add(frame.reference, 180, say("reference"), "");
  hero["pictures"] = std::move(pictures);
  return hero;
}

Data factsOf(const Result& result, const Audience& audience) {
  Data facts = makeList();
  const auto add = [&](std::string_view heading,
                       const std::vector<std::pair<std::string, std::string>>& rows) {
    if (rows.empty()) return;
    Data group, list = makeList();
    for (const auto& [key, value] : rows) {
      Data row;
      row["key"] = Data(sanitizeLine(key));
      row["text"] = Data(sanitizeLine(value));
      list << row;
    }
    group["heading"] = Data(std::string(heading));
    group["rows"] = std::move(list);
    facts << group;
  };
  std::vector<std::pair<std::string, std::string>> run = {
      {say("part"),
       result.part == result.assignment ? result.part : result.assignment + " / " + result.part},
      {say("outcome"), std::string(name(result.outcome))}};
  if (audience.instructor) {
    run.emplace_back(say("seed"), std::to_string(result.seed));
    if (!result.quality.empty()) run.emplace_back(say("quality"), result.quality);
  }
  run.emplace_back(say("sandbox"), result.sandbox);
  std::vector<std::pair<std::string, std::string>> times, tolerances;
  for (const Timing& timing : result.timings)
    times.emplace_back(timing.what, number(timing.seconds, 3) + " s");
  for (const auto& [key, value] : result.thresholds) tolerances.emplace_back(key, number(value, 5));
  add(gg::words("Run"), run);
  add(gg::words("Times"), times);
  add(gg::words("Tolerances"), tolerances);
  add(gg::words("Rendered with"), result.fingerprint);
  return facts;
}

Data diagnosesOf(const Result& result) {
  Data list = makeList();
  for (const Diagnosis& diagnosis : result.diagnoses) {
    Data data;
    data["part"] = result.diagnoses.size() > 1 ? line(diagnosis.part) : Data(false);
    data["known"] = Data(diagnosis.confidence > 0);
    data["confidence"] =
        diagnosis.confidence > 0 ? Data(number(diagnosis.confidence * 100, 0) + "%") : Data(false);
    data["diagnosis"] = Data(sanitizeLine(diagnosis.text, 800));
    data["firstWrong"] = optional(whatIsWrong(diagnosis));
    data["readAgain"] = line(diagnosis.step);
    data["hasBeside"] = Data(!diagnosis.beside.empty());
    data["beside"] = linesOf(diagnosis.beside);
    data["catalogue"] = line(diagnosis.id);
    list << data;
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

void setVerdict(Data& data, const Result& result, const Audience& audience) {
  const Summary summary = summarize(result);
  const bool hasScore = result.outcome != Outcome::notGradable;
  const double share =
      result.maxScore > 0 ? std::clamp(result.score / result.maxScore, 0.0, 1.0) : 0;
  const std::string score = number(result.score, 1), most = number(result.maxScore);
  data["state"] = Data(std::string(stateOf(summary)));
  data["perfect"] = Data(summary.perfect);
  data["outcome"] = Data(std::string(name(result.outcome)));
  data["scoreText"] = Data(hasScore ? score : "–");
  data["ofText"] = hasScore ? Data(say("of {}", most)) : Data(false);
  data["scoreLabel"] = Data(hasScore ? say("Score {} of {}", score, most) : say("No score"));
  data["arc"] = hasScore && share > 0 ? Data(number(share * 100, 1)) : Data(false);
  data["bonus"] = result.bonus > 0 ? Data(number(result.bonus)) : Data(false);
  data["eyebrow"] = line(result.title.empty() ? result.part : result.title);
  data["submission"] = line(result.submission.empty() ? say("(no name)") : result.submission);
  data["headline"] = Data(summary.headline);
  data["detail"] =
      sanitizeLine(result.detail) == summary.headline ? Data(false) : text(result.detail);
  data["proof"] = optional(proofOf(result));
  data["firstError"] = optional(firstError(result));
  data["hasDiagnoses"] = Data(!result.diagnoses.empty());
  data["diagnoses"] = diagnosesOf(result);
  Data findings = makeList();
  for (const Item* item : worstItems(result, kFindings)) findings << findingOf(result, *item);
  data["hasFindings"] = Data(findings.is_non_empty_list());
  data["findings"] = std::move(findings);
  data["hero"] = heroOf(result, audience);
  data["noSandbox"] = Data(audience.instructor && result.sandbox == "none");
}

std::string page(const Result& result, const Pictures& pictures, const Audience& audience,
                 bool scenesLeftOut) {
  Data data, items = makeList(), scenes = makeList();
  setVerdict(data, result, audience);
  for (std::size_t i = 0; i < result.items.size(); ++i) items << itemOf(result, i);
  const FrameIndex worst = worstFrame(result);
  for (std::size_t i = 0; i < result.scenes.size(); ++i)
    scenes << sceneOf(result, i, pictures, audience, i == 0 || (worst.found && i == worst.scene));
  data["compiler"] = optional(compilerHtml(result.compilerOutput));
  data["hasItems"] = Data(!result.items.empty());
  const bool noneJudged = std::ranges::none_of(result.items, &Item::judged);
  data["unjudgedNote"] =
      noneJudged
          ? Data(result.items.size() == 1 ? say("1 item was not judged.")
                                          : say("{} items were not judged.", result.items.size()))
          : Data(false);
  data["items"] = std::move(items);
  data["hasScenes"] = Data(!result.scenes.empty() || scenesLeftOut);
  data["scenes"] = std::move(scenes);
  data["leftOut"] = Data(scenesLeftOut);
  data["hasUnused"] = Data(!result.unusedFiles.empty());
  data["unused"] = linesOf(result.unusedFiles);
  data["facts"] = factsOf(result, audience);
  data["footer"] =
      Data(audience.instructor
               ? say("The instructor's page: it shows hidden scenes. Hand back student.html "
                     "instead.")
               : say("Positions count pixels from the top left corner."));
  const std::string score = result.outcome == Outcome::notGradable
                                ? say("no score")
                                : number(result.score) + "/" + number(result.maxScore);
  addLanguage(data);
  return renderPage(templates::k_result_mustache, std::move(data),
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
