#include "handout.hpp"

#include "image/compare.hpp"
#include "image/png.hpp"

#include <gmock/gmock.h>

namespace tool {

using nlohmann::json;

std::vector<std::string> partNames() {
  std::vector<std::string> all;
  // The folder as it was compiled in: kSource may not be there yet.
  for (const auto& assignment :
       ggrade::loadAssignments(fs::path(GGRADE_SOURCE_DIR) / "assignments"))
    for (const ggrade::Part& part : assignment.parts) all.push_back(part.id);
  return all;
}

json readHandout(const ggrade::Assignment& assignment) {
  return json::parse(read(kSource / "solutions" / assignment.id / "handout.json"));
}

namespace {

std::string partOf(const json& todo) {
  return todo.get<std::string>().substr(0, todo.get<std::string>().find('.'));
}

} // namespace

std::set<std::string> doneFor(const ggrade::Assignment& assignment, const json& picture) {
  std::set<std::string> done;
  for (const json& last : picture.at("done"))
    for (const ggrade::Part& part : assignment.parts)
      if (part.id == partOf(last))
        for (const ggrade::Todo& todo : part.todos) {
          done.insert(todo.id);
          if (todo.id == last.get<std::string>()) break;
        }
  return done;
}

json pictureScene(const ggrade::Assignment& assignment, const json& settings, const json& picture) {
  std::vector<std::string> parts;
  for (const json& last : picture.at("done")) parts.push_back(partOf(last));
  json scene = ggrade::grading::partScene(assignment, parts);
  scene.merge_patch(settings.value("scene", json::object()));
  scene.merge_patch(picture.value("scene", json::object()));
  return scene;
}

ggrade::Image readHandedOut(const ggrade::Assignment& assignment, const std::string& name) {
  return ggrade::readPng(assignment.folder / "handout" / name);
}

void expectHandedOut(const ggrade::Assignment& assignment, const std::string& name,
                     const ggrade::Image& drawn) {
  const ggrade::Comparison comparison = ggrade::compare(drawn, readHandedOut(assignment, name));
  EXPECT_TRUE(comparison.compared()) << name << ": " << comparison.message;
  EXPECT_EQ(comparison.wrongPixels, 0u) << name << ": " << comparison.message;
}

void expectInStep(const ggrade::Assignment& assignment, bool pictures) {
  const TemporaryFolder made;
  Arguments arguments = {"derive", assignment.id, "--out", made.path()};
  if (!pictures) arguments.push_back("--no-pictures");
  const Ended ended = runTool(arguments, {}, 400); // a program is built for every picture
  ASSERT_EQ(ended.exitCode, 0) << ended.errors;
  for (const std::string& name : names(made.path()))
    if (name != "handout") {
      EXPECT_EQ(read(made.path() / name), read(assignment.folder / name)) << name;
    }
  EXPECT_TRUE(fs::exists(made.path() / "README.md"));
  for (const std::string& name : assignment.files)
    EXPECT_TRUE(fs::exists(made.path() / name)) << name;
  std::vector<std::string> handedOut = names(assignment.folder / "handout");
  if (!pictures) std::erase_if(handedOut, [](const auto& name) { return name.ends_with(".png"); });
  EXPECT_EQ(names(made.path() / "handout"), handedOut);
  for (const std::string& name : handedOut)
    if (name.ends_with(".svg")) {
      EXPECT_EQ(read(made.path() / "handout" / name), read(assignment.folder / "handout" / name));
    } else {
      expectHandedOut(assignment, name, ggrade::readPng(made.path() / "handout" / name));
    }
}

} // namespace tool
