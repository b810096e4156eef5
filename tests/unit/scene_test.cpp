#include <gg/scene.hpp>

#include "framework_temporary_folder.hpp"
#include "framework_throws.hpp"
#include "scene_samples.hpp"
#include <gg/error.hpp>
#include <gmock/gmock.h>

namespace {

using gg::Scene;
using testing::EndsWith;
using testing::StartsWith;

Scene read(const std::string& text) {
  return Scene::fromText(text, "scene.json", sampleDeclarations());
}

std::string messageFor(const std::string& text) {
  return messageOf<gg::SceneError>([&] { read(text); });
}

std::string messageWith(const std::string& from, const std::string& to) {
  return messageFor(sampleSceneWith(from, to));
}

TEST(Scene, HasWhatTheFileSays) {
  const Scene scene = read(kSampleScene);
  EXPECT_EQ(scene.camera.position, glm::vec3(0, 3, 8));
  EXPECT_EQ(scene.camera.target, glm::vec3(0, 1, 0));
  EXPECT_EQ(scene.camera.fov, 0.5f);
  EXPECT_EQ(scene.camera.near, 1);
  EXPECT_EQ(scene.camera.far, 15);
  EXPECT_EQ(scene.light.position, glm::vec4(1, 4, 2, 1));
  EXPECT_EQ(scene.material("object").diffuse, glm::vec4(0.4f, 0.5f, 0.6f, 1));
  EXPECT_EQ(scene.material("object").shininess, 40);
  EXPECT_EQ(scene.real("ring.radius"), 1.5f);
}

TEST(Scene, HasDefaultsForWhatTheFileOmits) {
  const Scene scene = read(kSampleScene);
  EXPECT_EQ(scene.size, glm::ivec2(640, 480));
  EXPECT_EQ(scene.background, glm::vec3(0));
  EXPECT_EQ(scene.camera.up, glm::vec3(0, 1, 0));
  EXPECT_EQ(scene.light.diffuse, glm::vec4(1));
  EXPECT_EQ(scene.light.ambient, glm::vec4(0.2f, 0.2f, 0.2f, 1));
  EXPECT_TRUE(scene.flag("effects.mirror"));
  EXPECT_EQ(scene.text("mesh"), "torus_knot");
  EXPECT_EQ(scene.integer("ring.count"), 6);
  EXPECT_EQ(scene.number("ring.count"), 6.0);
}

TEST(Scene, NumbersKeepDoublePrecision) {
  const Scene scene = read(sampleSceneWith("1.5", "0.1"));
  EXPECT_EQ(scene.number("ring.radius"), 0.1);
  EXPECT_EQ(scene.real("ring.radius"), 0.1f);
}

const std::string kWithQuality = R"({
  "materials": ["object"],
  "scene": {
    "quality.size": { "type": "integer", "range": [1, 4096], "default": 1024 },
    "quality.taps": { "type": "integer", "range": [1, 64], "default": 4 },
    "ring.radius": { "type": "real", "range": [0, 1e7] }
  }
})";

Scene readWithPresets(const std::string& quality) {
  auto declarations = gg::Declarations::fromText(kWithQuality, "assignment.json");
  declarations.addPresets(
      R"({ "fast": { "size": 256 }, "accurate": { "size": 2048, "taps": 16 } })", "presets.json");
  return Scene::fromText(
      sampleSceneWith("\"ring\": {", "\"quality\": " + quality + ",\n  \"ring\": {"), "scene.json",
      declarations);
}

TEST(Scene, APresetSetsQualityAndWhatStandsBesideItWins) {
  const auto sizeAndTaps = [](const std::string& quality) {
    const Scene scene = readWithPresets(quality);
    return std::pair(scene.integer("quality.size"), scene.integer("quality.taps"));
  };
  EXPECT_EQ(sizeAndTaps("{}"), std::pair(1024, 4));
  EXPECT_EQ(sizeAndTaps("\"fast\""), std::pair(256, 4)); // the rest has its default
  EXPECT_EQ(sizeAndTaps("\"accurate\""), std::pair(2048, 16));
  EXPECT_EQ(sizeAndTaps("{ \"preset\": \"accurate\", \"taps\": 2 }"), std::pair(2048, 2));
  EXPECT_EQ(sizeAndTaps("{ \"taps\": 2, \"preset\": \"accurate\" }"), std::pair(2048, 2));
}

TEST(Scene, AnUnknownPresetIsNamedWithThoseThereAre) {
  const auto problem = [](const std::string& quality) {
    return messageOf<gg::SceneError>([&] { readWithPresets(quality); });
  };
  EXPECT_EQ(problem("\"quick\""),
            "scene.json:18: quality: must be a preset (accurate, fast), but is \"quick\"");
  EXPECT_EQ(problem("{ \"preset\": 3 }"),
            "scene.json:18: quality.preset: must be a preset (accurate, fast), but is 3");
  EXPECT_EQ(messageWith("\"ring\": {", "\"quality\": \"fast\",\n  \"ring\": {"),
            "scene.json:18: quality: this assignment has no presets");
}

TEST(Scene, AValueOfAnotherTypeIsNamedWithLineKeyAndWhatIsAllowed) {
  EXPECT_EQ(messageWith("\"fov\": 0.5", "\"fov\": \"wide\""),
            "scene.json:5: camera.fov: must be a number between 0.01 and 3.1, but is \"wide\"");
  EXPECT_EQ(messageWith("[0, 3, 8]", "[0, 3]"),
            "scene.json:3: camera.position: must be an array of 3 numbers between -1000000000 and "
            "1000000000, but is [0, 3]");
  EXPECT_EQ(messageWith("[0, 3, 8]", "[0, \"3\", 8]"),
            "scene.json:3: camera.position: must be an array of 3 numbers between -1000000000 and "
            "1000000000, but is [0, \"3\", 8]");
  EXPECT_EQ(messageWith("[0, 3, 8]", "8"),
            "scene.json:3: camera.position: must be an array of 3 numbers between -1000000000 and "
            "1000000000, but is 8");
  EXPECT_EQ(messageWith("\"radius\": 1.5", "\"radius\": 1.5, \"count\": 2.5"),
            "scene.json:19: ring.count: must be a whole number between 0 and 100, but is 2.5");
  EXPECT_EQ(messageWith("\"radius\": 1.5", "\"radius\": null"),
            "scene.json:19: ring.radius: must be a number between 0 and 10000000, but is null");
  EXPECT_EQ(
      messageWith("\"radius\": 1.5", "\"radius\": { \"x\": 1 }"),
      "scene.json:19: ring.radius: must be a number between 0 and 10000000, but is an object");
  EXPECT_THAT(messageWith("\"ring\": {", "\"effects\": { \"mirror\": 1 }, \"ring\": {"),
              EndsWith("effects.mirror: must be true or false, but is 1"));
  EXPECT_THAT(messageWith("\"ring\": {", "\"mesh\": true, \"ring\": {"),
              EndsWith("mesh: must be a text in quotes, but is true"));
}

TEST(Scene, AValueOutOfRangeIsAnError) {
  EXPECT_EQ(messageWith("\"radius\": 1.5", "\"radius\": -0.001"),
            "scene.json:19: ring.radius: must be a number between 0 and 10000000, but is -0.001");
  EXPECT_EQ(messageWith("\"radius\": 1.5", "\"radius\": 1, \"count\": 101"),
            "scene.json:19: ring.count: must be a whole number between 0 and 100, but is 101");
  EXPECT_EQ(messageWith("\"radius\": 1.5", "\"radius\": 1, \"count\": 99999999999999999999999"),
            "scene.json:19: ring.count: must be a whole number between 0 and 100, but is "
            "99999999999999999999999");
  EXPECT_EQ(messageWith("0.1, 0.2, 0.3", "0.1, 0.2, -3"),
            "scene.json:12: materials.object.ambient: must be an array of 3 numbers between 0 and "
            "65504, but is [0.1, 0.2, -3]");
}

TEST(Scene, TheEndsOfARangeAreAllowed) {
  EXPECT_EQ(read(sampleSceneWith("1.5", "0, \"count\": 100")).integer("ring.count"), 100);
  EXPECT_EQ(read(sampleSceneWith("1.5", "1e7, \"count\": 0.0")).integer("ring.count"), 0);
}

TEST(Scene, AnUnknownKeySuggestsTheNearestOne) {
  EXPECT_EQ(messageWith("\"radius\"", "\"radios\""),
            "scene.json:19: ring.radios: is not a key of this scene; did you mean ring.radius?");
  EXPECT_EQ(messageWith("\"camera\"", "\"Camera\""),
            "scene.json:2: Camera: is not a key of this scene; did you mean camera?");
  EXPECT_EQ(messageWith("\"object\"", "\"objects\""),
            "scene.json:11: materials.objects: is not a key of this scene; did you mean "
            "materials.object?");
  EXPECT_EQ(messageWith("\"light\"", "\"zzzzzz\": 1, \"light\""),
            "scene.json:9: zzzzzz: is not a key of this scene");
}

TEST(Scene, AValueWhereKeysBelongIsAnError) {
  EXPECT_EQ(messageWith("\"light\": { \"position\": [1, 4, 2] }", "\"light\": 5"),
            "scene.json:9: light: must be an object { ... }, but is 5");
}

TEST(Scene, AMissingKeyIsNamedWithWhatItMustBe) {
  EXPECT_EQ(messageWith("\"fov\": 0.5,", ""),
            "scene.json: camera.fov: is missing; it must be a number between 0.01 and 3.1");
  EXPECT_THAT(messageFor("{}"), StartsWith("scene.json: camera.far: is missing; it must be "));
}

TEST(Scene, ACameraThatSeesNothingIsAnError) {
  EXPECT_EQ(messageWith("[0, 1, 0]", "[0, 3, 8]"),
            "scene.json:4: camera.target: is the same point as camera.position");
  EXPECT_EQ(messageWith("\"far\": 15", "\"far\": 1"),
            "scene.json:7: camera.far: must be more than camera.near");
  EXPECT_EQ(messageWith("\"fov\": 0.5", "\"fov\": 0.5, \"up\": [0, 0, 0]"),
            "scene.json:5: camera.up: must not be zero");
}

TEST(Scene, AskingForWhatIsNotDeclaredIsTheProgramsMistake) {
  const Scene scene = read(kSampleScene);
  EXPECT_EQ(messageOf<std::invalid_argument>([&] { scene.real("ring.radios"); }),
            "the assignment declares no scene key \"ring.radios\"");
  EXPECT_EQ(messageOf<std::invalid_argument>([&] { scene.integer("ring.radius"); }),
            "the scene key \"ring.radius\" is not an integer: integer() can't read it");
  EXPECT_EQ(messageOf<std::invalid_argument>([&] { scene.flag("mesh"); }),
            "the scene key \"mesh\" is not a boolean: flag() can't read it");
  EXPECT_EQ(messageOf<std::invalid_argument>([&] { scene.material("subject"); }),
            "the assignment has no material \"subject\"");
}

TEST(Scene, ATextCanBeReplaced) {
  Scene scene = read(kSampleScene);
  scene.setText("mesh", "box");
  EXPECT_EQ(scene.text("mesh"), "box");
  EXPECT_THROW(scene.setText("ring.count", "box"), std::invalid_argument);
}

TEST(Scene, AFileThatIsNotThereIsNamed) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "none.json").string();
  EXPECT_EQ(messageOf<gg::SceneError>([&] { Scene::fromFile(file, sampleDeclarations()); }),
            file + ": cannot be read: No such file or directory");
  const std::string here = folder.path().string();
  EXPECT_EQ(messageOf<gg::SceneError>([&] { Scene::fromFile(here, sampleDeclarations()); }),
            here + ": is a folder, not a file");
}

TEST(Scene, AFileIsReadWhateverItsName) {
  const TemporaryFolder folder;
  const std::string file = folder.write("\xE5\xA0\xB4\xE9\x9D\xA2.json", kSampleScene).string();
  EXPECT_EQ(Scene::fromFile(file, sampleDeclarations()).camera.fov, 0.5f);
}

TEST(Light, GoesToAnotherSpaceWithItsColours) {
  gg::Light light;
  light.position = {1, 2, 3, 1};
  light.diffuse = {0.1f, 0.2f, 0.3f, 1};
  glm::mat4 shift(1);
  shift[3] = {10, 20, 30, 1};
  EXPECT_EQ(light.in(shift).position, glm::vec4(11, 22, 33, 1));
  EXPECT_EQ(light.in(shift).diffuse, light.diffuse);
}

} // namespace
