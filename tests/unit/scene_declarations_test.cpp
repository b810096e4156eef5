#include <gg/declarations.hpp>

#include "framework_throws.hpp"
#include "scene_samples.hpp"
#include <gg/error.hpp>
#include <gmock/gmock.h>

namespace {

using gg::Declarations;

std::string messageFor(const std::string& text) {
  return messageOf<gg::SceneError>([&] { Declarations::fromText(text, "assignment.json"); });
}

// The message for an assignment with one scene key declared so.
std::string messageForKey(const std::string& declaration, const std::string& key = "a.b") {
  return messageFor("{ \"scene\": { \"" + key + "\": " + declaration + " } }");
}

TEST(Declarations, HoldTheAssignmentsKeysAndThoseOfEveryScene) {
  const Declarations declarations = sampleDeclarations();
  const gg::KeyDeclaration& count = declarations.keys().at("ring.count");
  EXPECT_EQ(count.type, gg::KeyType::integer);
  EXPECT_EQ(count.lowest, 0);
  EXPECT_EQ(count.highest, 100);
  EXPECT_EQ(std::get<int>(count.defaultValue), 6);
  EXPECT_EQ(count.about, "how many");
  EXPECT_FALSE(declarations.keys().at("ring.radius").hasDefault);
  EXPECT_TRUE(declarations.keys().contains("camera.fov"));
  EXPECT_TRUE(declarations.keys().contains("materials.object.shininess"));
  EXPECT_THAT(declarations.materials(), testing::ElementsAre("object"));
}

TEST(Declarations, OtherPartsOfAnAssignmentAreNotTheirs) {
  EXPECT_NO_THROW(
      Declarations::fromText("{ \"id\": \"x\", \"parts\": [1, 2] }", "assignment.json"));
}

TEST(Declarations, WrongOnesAreNamed) {
  const std::string at = "assignment.json: scene: a.b: ";
  EXPECT_EQ(messageForKey("5"), at + "must be an object");
  EXPECT_EQ(messageForKey("{ \"type\": \"float\" }"),
            at + "type must be \"boolean\", \"integer\", \"real\" or \"text\"");
  EXPECT_EQ(messageForKey("{}"),
            at + "type must be \"boolean\", \"integer\", \"real\" or \"text\"");
  EXPECT_EQ(messageForKey("{ \"type\": \"real\" }"), at + "a number needs a range");
  EXPECT_EQ(messageForKey("{ \"type\": \"text\", \"range\": [0, 1] }"),
            at + "only a number has a range");
  EXPECT_EQ(messageForKey("{ \"type\": \"real\", \"range\": [1, 0] }"),
            at + "range must be [lowest, highest]");
  EXPECT_EQ(messageForKey("{ \"type\": \"real\", \"range\": [0, 1], \"default\": 2 }"),
            at + "default must be a number between 0 and 1, but is 2");
  EXPECT_EQ(messageForKey("{ \"type\": \"boolean\", \"default\": \"yes\" }"),
            at + "default must be true or false, but is \"yes\"");
  EXPECT_EQ(messageForKey("{ \"type\": \"integer\", \"range\": [0, 1e10] }"),
            at + "an integer's range must lie within 32 bits");
  EXPECT_EQ(messageForKey("{ \"type\": \"text\", \"defualt\": \"x\" }"),
            at + "unknown member \"defualt\"");
}

TEST(Declarations, MayNotClashWithOthers) {
  EXPECT_EQ(messageForKey("{ \"type\": \"text\" }", "camera.fov"),
            "assignment.json: scene: camera.fov: every scene has this key already");
  EXPECT_EQ(messageForKey("{ \"type\": \"text\" }", "camera.fov.x"),
            "assignment.json: scene: camera.fov.x: \"camera.fov\" is a value, so it can't hold "
            "others");
}

TEST(Declarations, MaterialsAreNames) {
  for (const char* materials : {"[1]", "[\"\"]", "[\"a.b\"]"})
    EXPECT_EQ(messageFor(std::string("{ \"materials\": ") + materials + " }"),
              "assignment.json: materials: must be names without a dot");
}

TEST(Declarations, APresetIsOfDeclaredQualityKeys) {
  const auto problem = [](const std::string& presets) {
    Declarations declarations = Declarations::fromText(
        "{ \"scene\": { \"quality.size\": { \"type\": \"integer\", \"range\": [1, 8] }, "
        "\"ring\": { \"type\": \"text\" } } }",
        "assignment.json");
    return messageOf<gg::SceneError>([&] { declarations.addPresets(presets, "presets.json"); });
  };
  EXPECT_EQ(problem("[]"), "presets.json: must be an object: { ... }");
  EXPECT_THAT(problem("{"), testing::StartsWith("presets.json: is not valid JSON: "));
  EXPECT_EQ(problem("{ \"fast\": 1 }"),
            "presets.json: fast: must be an object of quality keys and their values");
  EXPECT_EQ(problem("{ \"fast\": { \"sise\": 1 } }"),
            "presets.json: fast: \"sise\" is no declared key of quality");
  EXPECT_EQ(problem("{ \"fast\": { \"ring\": \"x\" } }"),
            "presets.json: fast: \"ring\" is no declared key of quality");
  EXPECT_EQ(problem("{ \"fast\": { \"size\": 9 } }"),
            "presets.json: fast: size must be a whole number between 1 and 8, but is 9");
}

TEST(Declarations, AFileThatIsNotJsonIsNamed) {
  EXPECT_THAT(messageFor("{"), testing::StartsWith("assignment.json: is not valid JSON: "));
  EXPECT_EQ(messageFor("[]"), "assignment.json: must be an object: { ... }");
  EXPECT_EQ(messageFor("{ \"scene\": 1 }"), "assignment.json: scene: must be an object");
  EXPECT_EQ(messageOf<gg::SceneError>([] { Declarations::fromFile("/no/assignment.json"); }),
            "/no/assignment.json: cannot be read: No such file or directory");
}

TEST(Declarations, NearestIsTheLikeliestMeant) {
  const Declarations declarations = sampleDeclarations();
  EXPECT_EQ(declarations.nearest("ring.cuont"), "ring.count");
  EXPECT_EQ(declarations.nearest("camra"), "camera");
  EXPECT_EQ(declarations.nearest("quite.another"), "");
}

} // namespace
