#include "report/page_parts.hpp"

#include "report/picture.hpp"
#include "report/summary.hpp"
#include "report/text.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <future>

namespace ggrade::report {

using gg::say;

namespace {

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

Data lossData(const Result& result, const std::vector<Loss>& losses) {
  Data list = makeList();
  for (const Loss& loss : losses) {
    const Item& item = result.items[loss.item];
    Data entry;
    entry["lossState"] = Data(std::string(creditState(loss.credit)));
    entry["lossSign"] = Data(loss.credit > 0 ? "◐" : "✗");
    entry["itemAnchor"] = Data(fmt::format("item-{}", loss.item));
    entry["item"] = line(item.title.empty() ? item.id : item.title);
    entry["credit"] = Data(percent(loss.credit));
    list << entry;
  }
  return list;
}

Data pictureOf(const Image& image, const std::string& uri, const std::string& role,
               const std::string& label, const std::string& alt, const std::string& absent) {
  Data data;
  data["uri"] = optional(uri);
  data["role"] = Data(role);
  data["width"] = Data(std::to_string(image.width()));
  data["height"] = Data(std::to_string(image.height()));
  data["label"] = Data(label);
  data["alt"] = Data(alt);
  data["absent"] = Data(absent);
  return data;
}

SceneKey keyOf(const Scene& scene) {
  return {scene.name, scene.isPublic};
}

bool comparable(const Frame& frame) {
  return !frame.student.empty() && sameSize(frame.student, frame.reference);
}

Data frameOf(const Scene& scene, const Frame& frame, const FramePictures& uris,
             const Audience& audience) {
  const std::string moment = say("{} at {} s", sanitizeLine(scene.name), number(frame.time, 3));
  const std::string wrong = percentWrong(frame.wrongShare);
  const std::string mine = audience.instructor ? say("Submission") : say("Yours");
  const bool none = frame.student.empty();
  Data data, pictures = makeList();
  pictures << pictureOf(frame.student, uris[0], "student", mine,
                        say("{}, {}: {}.", mine, moment, wrong), say("no frame came"));
  pictures << pictureOf(frame.reference, uris[1], "reference", say("Reference"),
                        say("Reference, {}.", moment), say("no reference"));
  pictures << pictureOf(frame.difference, uris[2], "difference", say("Difference"),
                        say("Difference, {}: bright where the pictures differ.", moment),
                        none ? say("nothing to compare") : say("not compared"));
  if (!std::isnan(frame.flip))
    pictures << pictureOf(frame.flipPicture, uris[3], "flip",
                          fmt::format("FLIP {}", number(frame.flip, 4)),
                          say("FLIP, {}: bright where a person flipping between the pictures sees "
                              "a change.",
                              moment),
                          say("not compared"));
  if (!frame.unsteadyPicture.empty())
    pictures << pictureOf(frame.unsteadyPicture, uris[4], "unsteady",
                          say("{} unsteady", percent(frame.unsteadyShare)),
                          say("Between two runs, {}: bright where the same program drew something "
                              "else when it ran again.",
                              moment),
                          "");
  data["caption"] =
      Data(say("t = {} s, {}", number(frame.time, 3), none ? say("no frame came") : wrong));
  data["pictures"] = std::move(pictures);
  return data;
}

Data choicesOf(const Scene& scene, std::size_t sceneIndex, std::size_t chosen) {
  Data choices = makeList();
  for (std::size_t i = 0; i < scene.frames.size(); ++i) {
    Data choice;
    choice["group"] = Data(fmt::format("frame-{}", sceneIndex));
    choice["label"] = Data(fmt::format("{} s", number(scene.frames[i].time, 3)));
    choice["checked"] = Data(i == chosen);
    choices << choice;
  }
  return choices;
}

} // namespace

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

Data sceneOf(const Result& result, std::size_t index, const Pictures& pictures,
             const Audience& audience, bool open) {
  const Scene& scene = result.scenes[index];
  const std::vector<Loss> losses = lossesIn(result, scene);
  const SceneLook look = lookOf(scene, losses);
  std::size_t worst = 0;
  for (std::size_t i = 0; i < scene.frames.size(); ++i)
    if (scene.frames[i].wrongShare > scene.frames[worst].wrongShare) worst = i;
  Data data, frames = makeList();
  for (std::size_t i = 0; i < scene.frames.size(); ++i)
    frames << frameOf(scene, scene.frames[i], pictures.at(keyOf(scene)).at(i), audience);
  const bool shown = !scene.frames.empty();
  const bool withheld = !audience.instructor && !scene.isPublic && !shown;
  data["anchor"] = Data(fmt::format("scene-{}", index));
  data["scene"] = line(scene.name.empty() ? say("(no name)") : scene.name);
  data["publicWord"] = scene.name == (scene.isPublic ? "public" : "hidden")
                           ? Data(false)
                           : Data(scene.isPublic ? say("public") : say("hidden"));
  data["state"] = Data(std::string(look.state));
  data["outcome"] = line(look.word);
  data["open"] = Data(open);
  const bool drawn =
      std::ranges::any_of(scene.frames, [](const Frame& f) { return !f.student.empty(); });
  data["wrong"] = !shown  ? Data(false)
                  : drawn ? Data(percentWrong(scene.frames[worst].wrongShare))
                          : Data(say("no frame came"));
  data["seconds"] = scene.seconds > 0 ? Data(number(scene.seconds) + " s") : Data(false);
  data["detail"] = text(scene.detail);
  data["withheld"] =
      withheld ? Data(say("The pictures of this scene are not shown.")) : Data(false);
  data["hasChoice"] = Data(scene.frames.size() > 1);
  data["choices"] = choicesOf(scene, index, worst);
  data["frames"] = std::move(frames);
  data["slider"] = Data(std::ranges::any_of(scene.frames, comparable));
  data["who"] = Data(audience.who());
  const int width = shown ? scene.frames[worst].student.width() : 0;
  data["width"] = Data(std::to_string(width));
  data["middle"] = Data(std::to_string(width / 2));
  data["hasLosses"] = Data(!losses.empty());
  data["allHolds"] = Data(look.state == "full" && shown);
  data["losses"] = lossData(result, losses);
  data["hasMessages"] = Data(!scene.messages.empty());
  data["messages"] = linesOf(scene.messages);
  data["output"] = text(capped(sanitize(scene.output), kOutputBytes));
  return data;
}

} // namespace ggrade::report
