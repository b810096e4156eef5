#include "report/page_parts.hpp"

#include "report/picture.hpp"
#include "report/summary.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace ggrade::report {
namespace {

std::string percentWrong(double share) {
  return share <= 0 ? "no pixel differs" : percent(share) + " of the pixels differ";
}

struct SceneLook {
  std::string_view state;
  std::string word;
};

// A scene stands as its worst item does; without credits the outcome decides.
SceneLook lookOf(const Result& result, const Scene& scene) {
  if (scene.outcome != name(Outcome::graded) && scene.outcome != name(Outcome::glError))
    return {"none", scene.outcome};
  double least = 1;
  int losing = 0;
  for (const Item& item : result.items)
    for (const auto& [name, credit] : item.credits)
      if (name == scene.name && item.kind != ItemKind::bonus && credit < 1) {
        least = std::min(least, credit);
        ++losing;
      }
  if (scene.outcome == name(Outcome::glError))
    return {losing > 0 ? creditState(least) : "part", scene.outcome};
  if (losing == 0) return {"full", "all right"};
  return {creditState(least), fmt::format("{} item{} lost points", losing, losing == 1 ? "" : "s")};
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

Data frameOf(const Scene& scene, const Frame& frame, const std::array<std::string, 3>& uris,
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
  data["caption"] =
      Data(fmt::format("t = {} s, {}", number(frame.time, 3), none ? "no frame came" : wrong));
  data["pictures"] = std::move(pictures);
  data["slider"] = Data(!none && sameSize(frame.student, frame.reference));
  data["who"] = Data(audience.who());
  data["width"] = Data(std::to_string(frame.student.width()));
  data["middle"] = Data(std::to_string(frame.student.width() / 2));
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

Pictures encode(const Result& result) {
  Pictures pictures;
  for (const Scene& scene : result.scenes)
    for (const Frame& frame : scene.frames)
      pictures[scene.name].push_back(
          {pngDataUri(frame.student), pngDataUri(frame.reference), pngDataUri(frame.difference)});
  return pictures;
}

Data sceneOf(const Result& result, std::size_t index, const Pictures& pictures,
             const Audience& audience, bool open) {
  const Scene& scene = result.scenes[index];
  const SceneLook look = lookOf(result, scene);
  std::size_t worst = 0;
  for (std::size_t i = 0; i < scene.frames.size(); ++i)
    if (scene.frames[i].wrongShare > scene.frames[worst].wrongShare) worst = i;
  Data data, frames = makeList();
  for (std::size_t i = 0; i < scene.frames.size(); ++i)
    frames << frameOf(scene, scene.frames[i], pictures.at(scene.name)[i], audience);
  const bool shown = !scene.frames.empty();
  const bool withheld = !audience.instructor && !scene.isPublic && !shown;
  data["anchor"] = Data(fmt::format("scene-{}", index));
  data["scene"] = line(scene.name.empty() ? "(no name)" : scene.name);
  data["publicWord"] = Data(scene.isPublic ? "public" : "hidden");
  data["state"] = Data(std::string(look.state));
  data["outcome"] = line(look.word);
  data["open"] = Data(open);
  data["wrong"] = shown ? Data(percentWrong(scene.frames[worst].wrongShare)) : Data(false);
  data["seconds"] = scene.seconds > 0 ? Data(number(scene.seconds) + " s") : Data(false);
  data["detail"] = text(scene.detail);
  data["withheld"] = withheld ? Data("The pictures of this scene are not shown.") : Data(false);
  data["hasChoice"] = Data(scene.frames.size() > 1);
  data["choices"] = choicesOf(scene, index, worst);
  data["frames"] = std::move(frames);
  data["hasMessages"] = Data(!scene.messages.empty());
  data["messages"] = linesOf(scene.messages);
  data["output"] = text(capped(sanitize(scene.output), kOutputBytes));
  return data;
}

} // namespace ggrade::report
