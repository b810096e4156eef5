#include "report/page_parts.hpp"

#include "report/picture.hpp"
#include "report/summary.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <future>

namespace ggrade::report {
namespace {

std::string percentWrong(double share) {
  return share <= 0 ? "no pixel differs" : percent(share) + " of the pixels differ";
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

// A scene stands as its worst item does; without credits the outcome decides.
SceneLook lookOf(const Scene& scene, const std::vector<Loss>& losses) {
  const bool glError = scene.outcome == name(Outcome::glError);
  if (scene.outcome != name(Outcome::graded) && !glError) return {"none", words(scene.outcome)};
  if (losses.empty())
    return glError ? SceneLook{"part", words(scene.outcome)} : SceneLook{"full", "all right"};
  const double least = std::ranges::min_element(losses, {}, &Loss::credit)->credit;
  if (glError) return {creditState(least), words(scene.outcome)};
  return {creditState(least),
          fmt::format("{} item{} lost points", losses.size(), losses.size() == 1 ? "" : "s")};
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
  const std::string moment =
      fmt::format("{} at {} s", sanitizeLine(scene.name), number(frame.time, 3));
  const std::string wrong = percentWrong(frame.wrongShare);
  const std::string mine = audience.instructor ? "Submission" : "Yours";
  const bool none = frame.student.empty();
  Data data, pictures = makeList();
  pictures << pictureOf(frame.student, uris[0], "student", mine,
                        fmt::format("{}, {}: {}.", mine, moment, wrong), "no frame came");
  pictures << pictureOf(frame.reference, uris[1], "reference", "Reference",
                        fmt::format("Reference, {}.", moment), "no reference");
  pictures << pictureOf(frame.difference, uris[2], "difference", "Difference",
                        fmt::format("Difference, {}: bright where the pictures differ.", moment),
                        none ? "nothing to compare" : "not compared");
  if (!std::isnan(frame.flip))
    pictures << pictureOf(frame.flipPicture, uris[3], "flip",
                          fmt::format("FLIP {}", number(frame.flip, 4)),
                          fmt::format("FLIP, {}: bright where a person flipping between the "
                                      "pictures sees a change.",
                                      moment),
                          "not compared");
  if (!frame.unsteadyPicture.empty())
    pictures << pictureOf(frame.unsteadyPicture, uris[4], "unsteady",
                          percent(frame.unsteadyShare) + " unsteady",
                          fmt::format("Between two runs, {}: bright where the same program drew "
                                      "something else when it ran again.",
                                      moment),
                          "");
  data["caption"] =
      Data(fmt::format("t = {} s, {}", number(frame.time, 3), none ? "no frame came" : wrong));
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
  data["scene"] = line(scene.name.empty() ? "(no name)" : scene.name);
  const std::string publicWord = scene.isPublic ? "public" : "hidden";
  data["publicWord"] = scene.name == publicWord ? Data(false) : Data(publicWord);
  data["state"] = Data(std::string(look.state));
  data["outcome"] = line(look.word);
  data["open"] = Data(open);
  const bool drawn =
      std::ranges::any_of(scene.frames, [](const Frame& f) { return !f.student.empty(); });
  data["wrong"] = !shown  ? Data(false)
                  : drawn ? Data(percentWrong(scene.frames[worst].wrongShare))
                          : Data("no frame came");
  data["seconds"] = scene.seconds > 0 ? Data(number(scene.seconds) + " s") : Data(false);
  data["detail"] = text(scene.detail);
  data["withheld"] = withheld ? Data("The pictures of this scene are not shown.") : Data(false);
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
