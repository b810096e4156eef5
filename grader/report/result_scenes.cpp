#include "report/result_scenes.hpp"

#include "report/page.hpp"
#include "report/picture.hpp"
#include "report/summary.hpp"
#include "report/text.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace ggrade::report {

using gg::say;
using nlohmann::json;

std::string Audience::who() const {
  return instructor ? say("submission") : say("yours");
}

std::string sceneAnchor(const results::Result& result, const std::string& name) {
  for (std::size_t i = 0; i < result.scenes.size(); ++i)
    if (result.scenes[i].name == name) return fmt::format("scene-{}", i);
  return "";
}

std::string_view creditState(double credit) {
  return credit >= 1 ? "full" : credit > 0 ? "part" : "none";
}

std::string titleOf(const results::Item& item) {
  return sanitizeLine(item.title.empty() ? item.id : item.title);
}

namespace {

std::string percentWrong(double share) {
  return share <= 0 ? say("no pixel differs") : say("{} of the pixels differ", percent(share));
}

struct Loss {
  std::size_t item = 0;
  double credit = 0;
};

// Items that got less than full credit in the scene. A bonus isn't missed.
std::vector<Loss> lossesIn(const results::Result& result, const results::Scene& scene) {
  std::vector<Loss> losses;
  for (std::size_t i = 0; i < result.items.size(); ++i)
    for (const auto& [name, credit, isPublic] : result.items[i].credits)
      if (name == scene.name && result.items[i].kind != results::ItemKind::bonus && credit < 1)
        losses.push_back({i, credit});
  return losses;
}

struct SceneLook {
  std::string_view state;
  std::string word;
};

std::string wordsOf(const std::string& outcome) {
  switch (results::parseOutcome(outcome).value_or(results::Outcome::graded)) {
  case results::Outcome::graded:
    break;
  case results::Outcome::buildFailed:
    return say("build failed");
  case results::Outcome::shaderError:
    return say("shader error");
  case results::Outcome::glError:
    return say("gl error");
  case results::Outcome::noFrame:
    return say("no frame");
  case results::Outcome::timeout:
    return say("timeout");
  case results::Outcome::crash:
    return say("crash");
  case results::Outcome::outOfMemory:
    return say("out of memory");
  case results::Outcome::badOutput:
    return say("bad output");
  case results::Outcome::notGradable:
    return say("not gradable");
  }
  return spaced(outcome);
}

// A scene stands as its worst item does; without credits the outcome decides.
SceneLook lookOf(const results::Scene& scene, const std::vector<Loss>& losses) {
  const bool glError = scene.outcome == name(results::Outcome::glError);
  if (scene.outcome != name(results::Outcome::graded) && !glError)
    return {"none", wordsOf(scene.outcome)};
  if (losses.empty())
    return glError ? SceneLook{"part", wordsOf(scene.outcome)}
                   : SceneLook{"full", say("all right")};
  const double least = std::ranges::min_element(losses, {}, &Loss::credit)->credit;
  if (glError) return {creditState(least), wordsOf(scene.outcome)};
  return {creditState(least), losses.size() == 1 ? say("1 item lost points")
                                                 : say("{} items lost points", losses.size())};
}

json lossData(const results::Result& result, const std::vector<Loss>& losses) {
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

SceneKey keyOf(const results::Scene& scene) {
  return {scene.name, scene.isPublic};
}

bool comparable(const results::Frame& frame) {
  return !frame.student.empty() && sameSize(frame.student, frame.reference);
}

json frameOf(const results::Scene& scene, const results::Frame& frame, const FramePictures& uris,
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

json choicesOf(const results::Scene& scene, std::size_t sceneIndex, std::size_t chosen) {
  json choices = json::array();
  for (std::size_t i = 0; i < scene.frames.size(); ++i)
    choices.push_back({{"group", fmt::format("frame-{}", sceneIndex)},
                       {"label", fmt::format("{} s", number(scene.frames[i].time, 3))},
                       {"checked", i == chosen}});
  return choices;
}

} // namespace

Pictures encode(const results::Result& result, std::launch how) {
  const auto uris = [](const results::Scene& scene) {
    std::vector<FramePictures> frames;
    for (const results::Frame& frame : scene.frames) {
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
  for (const results::Scene& scene : result.scenes)
    pending.push_back(std::async(how, uris, std::cref(scene)));
  Pictures pictures;
  for (std::size_t i = 0; i < pending.size(); ++i)
    pictures.try_emplace(keyOf(result.scenes[i]), pending[i].get());
  return pictures;
}

json sceneOf(const results::Result& result, std::size_t index, const Pictures& pictures,
             const Audience& audience, bool open) {
  const results::Scene& scene = result.scenes[index];
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
      std::ranges::any_of(scene.frames, [](const results::Frame& f) { return !f.student.empty(); });
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

} // namespace ggrade::report
