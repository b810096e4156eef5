// What a scene file can be besides wrong values: not JSON, not UTF-8, hostile.

#include <gg/scene.hpp>

#include "framework_throws.hpp"
#include "scene_samples.hpp"
#include <gg/error.hpp>
#include <gmock/gmock.h>

namespace {

using testing::HasSubstr;
using testing::StartsWith;

gg::Scene read(const std::string& text) {
  return gg::Scene::fromText(text, "scene.json", sampleDeclarations());
}

std::string messageFor(const std::string& text) {
  return messageOf<gg::SceneError>([&] { read(text); });
}

std::string withLineEnds(const std::string& text, const std::string& end) {
  std::string result;
  for (char c : text) result += c == '\n' ? end : std::string(1, c);
  return result;
}

TEST(SceneJson, ByteOrderMarkIsSkipped) {
  EXPECT_EQ(read("\xEF\xBB\xBF" + kSampleScene).camera.fov, 0.5f);
}

TEST(SceneJson, LinesAreCountedForEveryLineEnd) {
  const std::string text = sampleSceneWith("\"fov\": 0.5", "\"fov\": 9");
  for (const char* end : {"\n", "\r\n", "\r"})
    EXPECT_THAT(messageFor(withLineEnds(text, end)), StartsWith("scene.json:5: camera.fov: "));
}

TEST(SceneJson, ANumberAtTheEndOfItsLineHasThatLine) {
  EXPECT_EQ(messageFor("{\n\"camera\": { \"fov\": 9\n\n\n}}"),
            "scene.json:2: camera.fov: must be a number between 0.01 and 3.1, but is 9");
  EXPECT_THAT(messageFor("{\n\"camera\": { \"position\": [\n1,\n2\n]\n}}"),
              StartsWith("scene.json:2: camera.position: "));
}

TEST(SceneJson, AKeyThatStandsTwiceIsAnError) {
  EXPECT_EQ(messageFor(sampleSceneWith("\"near\": 1,", "\"near\": 1,\n\"near\": 1,")),
            "scene.json:7: camera.near: stands here twice");
  EXPECT_EQ(messageFor(sampleSceneWith("\"ring\": {", "\"camera\": {")),
            "scene.json:18: camera: stands here twice");
}

TEST(SceneJson, ADottedOrEmptyKeyIsAnError) {
  EXPECT_EQ(messageFor("{ \"camera.fov\": 1 }"),
            "scene.json:1: \"camera.fov\": a key must be a name without a dot");
  EXPECT_EQ(messageFor("{ \"\": 1 }"), "scene.json:1: \"\": a key must be a name without a dot");
}

TEST(SceneJson, WhatIsNoJsonHasALine) {
  EXPECT_THAT(messageFor(""),
              testing::MatchesRegex("scene.json:1: is not valid JSON: (unexpected end "
                                    "of input|attempting to parse an empty input).*"));
  EXPECT_EQ(messageFor("{\n  \"ring\": {\n    \"radius\": 1.5"),
            "scene.json:3: is not valid JSON: unexpected end of input; expected '}'");
  EXPECT_EQ(messageFor("{\n  \"size\": [640, 480],\n}"),
            "scene.json:3: is not valid JSON: unexpected '}'; expected string literal");
  EXPECT_EQ(messageFor("{\n  \"ring\": { \"radius\": NaN } }"),
            "scene.json:2: is not valid JSON: invalid literal; last read: '\"radius\": N'");
  EXPECT_THAT(messageFor("{\n // comment\n}"), StartsWith("scene.json:2: is not valid JSON: "));
  EXPECT_THAT(messageFor("{}\n\nx"), StartsWith("scene.json:3: is not valid JSON: "));
}

TEST(SceneJson, ANumberThatIsNotFiniteIsAnError) {
  EXPECT_EQ(messageFor("{\n\"ring\": { \"radius\": 1e999 } }"),
            "scene.json:2: is not valid JSON: number overflow parsing '1e999'");
}

TEST(SceneJson, ANulByteIsNoEnd) {
  using namespace std::string_literals;
  EXPECT_EQ(messageFor("{}\n\0"s), "scene.json:2: holds a NUL byte; save the file as text");
  EXPECT_EQ(messageFor("{}\0{\"ring\": 1}"s),
            "scene.json:1: holds a NUL byte; save the file as text");
}

TEST(SceneJson, OnlyAnObjectIsAScene) {
  for (const char* text : {"[]", "5", "\"x\"", "null", "[{}]"})
    EXPECT_EQ(messageFor(text), "scene.json:1: must be an object: { ... }") << text;
}

TEST(SceneJson, OtherEncodingsAreNamed) {
  using namespace std::string_literals;
  EXPECT_EQ(messageFor("\xFF\xFE{\0}\0"s), "scene.json:1: is UTF-16; save the file as UTF-8");
  EXPECT_EQ(messageFor("\xFE\xFF\0{\0}"s), "scene.json:1: is UTF-16; save the file as UTF-8");
  // Shift_JIS
  const std::string message = messageFor("{\n\"mesh\": \"\x83\x81\x83\x62\" }");
  EXPECT_THAT(message, StartsWith("scene.json:2: is not valid JSON: invalid string: ill-formed "
                                  "UTF-8 byte"));
  EXPECT_THAT(message, HasSubstr("save the file as UTF-8"));
  for (char c : message) EXPECT_GE(c, 0) << "the message itself must be UTF-8";
}

TEST(SceneJson, DeepNestingIsAnErrorAndNoCrash) {
  std::string arrays = "{ \"size\": ", objects;
  for (int i = 0; i < 100000; ++i) arrays += '[';
  for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
  EXPECT_EQ(messageFor(arrays), "scene.json:1: is nested too deeply");
  EXPECT_EQ(messageFor(objects), "scene.json:1: is nested too deeply");
}

TEST(SceneJson, LongValuesAreCutInMessages) {
  const std::string message = messageFor("{ \"mesh\": [\"" + std::string(100000, 'x') + "\"] }");
  EXPECT_LT(message.size(), 200u);
  std::string numbers = "{ \"size\": [1";
  for (int i = 0; i < 10000; ++i) numbers += ",1";
  EXPECT_LT(messageFor(numbers + "] }").size(), 250u);
}

TEST(SceneJson, CutsBetweenCharactersOnly) {
  std::string text = "{ \"camera\": { \"fov\": \"";
  for (int i = 0; i < 100; ++i) text += "\xE3\x81\x82";
  const std::string message = messageFor(text + "\" } }");
  const std::size_t dots = message.find("...");
  ASSERT_NE(dots, message.npos);
  EXPECT_EQ(message.substr(dots - 3, 3), "\xE3\x81\x82");
}

TEST(SceneJson, ArraysInArraysAreNoNumbers) {
  EXPECT_THAT(messageFor("{ \"camera\": { \"position\": [0, [1], {\"a.b\": 2, \"a.b\": 3}] } }"),
              testing::EndsWith("but is [0, [...], 1, an object, 2, 3]"));
}

} // namespace
