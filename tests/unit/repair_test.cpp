// What two tapes differ in, and the patches that make one of them as the other.

#include "repair/align.hpp"
#include "repair/compare.hpp"
#include "repair/glsl.hpp"
#include "repair/own_value.hpp"
#include "results/results.hpp"

#include "../fuzz/sample_tape.hpp"

#include <GL/gl.h>
#include <GL/glext.h>
#include <gmock/gmock.h>

using namespace ggrade;
using namespace ggrade::repair;
using namespace sample;
using nlohmann::json;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Key;
using testing::UnorderedElementsAre;

namespace {

std::vector<std::string> names(const Comparison& comparison) {
  std::vector<std::string> all;
  for (const Difference& one : comparison.differences)
    all.push_back((one.passes.empty() ? "-" : std::to_string(*one.passes.begin())) + ' ' +
                  one.unit.name);
  return all;
}

/// As the reference, but its first pass is drawn with another shader.
tape::Tape withShader(const std::string& source) {
  tape::Tape other = reference();
  other.blobs.push_back(blob(source));
  other.commands[3]["program"]["stages"][0]["blob"] = 3;
  return other;
}

json sampled(int image, int filter = 9729) {
  return {{"unit", 0}, {"target", 3553}, {"image", image}, {"minFilter", filter}};
}

TEST(Repair, EqualTapesDifferInNothing) {
  EXPECT_THAT(names(compare(reference(), reference())), IsEmpty());
}

TEST(Repair, BlobsAreTheSameByWhatTheyHold) {
  tape::Tape other = reference();
  std::swap(other.blobs[1], other.blobs[2]);
  for (json& command : other.commands)
    if (command["op"] == "draw") {
      json& mesh = command["attributes"]["position"][0]["blob"];
      mesh = 3 - mesh.get<int>();
    }
  EXPECT_THAT(names(compare(other, reference())), IsEmpty());
}

TEST(Repair, NamesPassAndUnitAndPatchesThem) {
  tape::Tape submission = reference();
  for (const int i : {2, 3})
    submission.commands[std::size_t(i)]["state"]["viewport"] = {0, 0, 16, 16};
  submission.commands[5]["uniforms"]["uLight"]["values"] = {0.5};
  const Comparison comparison = compare(submission, reference());
  EXPECT_THAT(names(comparison), ElementsAre("0 viewport", "1 uniform uLight"));
  EXPECT_EQ(comparison.differences[0].own, "0, 0, 16, 16");
  EXPECT_EQ(comparison.differences[1].own, "0.5");
  json patched = comparison.tape.commands;
  for (const Difference& one : comparison.differences) patched = patched.patch(one.patch);
  // The reference's image stands before what the submission draws.
  EXPECT_EQ(patched[3]["state"]["viewport"], json({0, 0, 8, 8}));
  EXPECT_EQ(patched[4]["state"]["viewport"], json({0, 0, 8, 8}));
  EXPECT_EQ(patched[6]["uniforms"]["uLight"]["values"], json({1.0}));
}

/// Frames that nobody looks at are compared and patched like the others; only the passes that are
/// told are not theirs.
TEST(Repair, PassesAreThoseOfFramesThatAreLookedAt) {
  const auto twice = [](tape::Tape tape) {
    const json once = tape.commands;
    tape.commands.insert(tape.commands.end(), once.begin() + 2, once.end());
    return tape;
  };
  tape::Tape submission = twice(reference());
  const auto light = [&](std::size_t command) -> json& {
    return submission.commands[command]["uniforms"]["uLight"]["values"];
  };
  light(3) = {0.5}; // in the first frame alone
  EXPECT_THAT(names(compare(submission, twice(reference()))), ElementsAre("0 uniform uLight"));
  EXPECT_THAT(names(compare(submission, twice(reference()), 1)), ElementsAre("- uniform uLight"));
  light(9) = {0.25}; // and in the second
  const Comparison both = compare(submission, twice(reference()), 1);
  EXPECT_THAT(names(both), ElementsAre("0 uniform uLight"));
  EXPECT_EQ(both.differences[0].patch.size(), 2u);
}

TEST(Repair, AFunctionIsAUnitAndSoIsTheShader) {
  std::string source = kShader;
  source.replace(source.find("p.z < uBias"), 11, "p.z > uBias");
  const Comparison comparison = compare(withShader(source), reference());
  ASSERT_THAT(names(comparison),
              ElementsAre("0 function visibility in fragment", "0 shader fragment"));
  const json patched = comparison.tape.commands.patch(comparison.differences[0].patch);
  const std::size_t changed = patched[4]["program"]["stages"][0]["blob"];
  EXPECT_EQ(comparison.tape.blobs.at(changed), blob(kShader));
}

/// A shader whose main() has the work of two steps.
std::string twoSteps(const std::string& first, const std::string& second,
                     const std::string& mark = "TODO(a.2)") {
  return "out vec4 o;\nvoid main() {\n  float l = 0.5;\n  // TODO(a.1): add\n  " + first +
         "\n  // " + mark + ": twice\n  " + second + "\n  o = vec4(l);\n}\n";
}

TEST(Repair, AStepsLinesInAFunctionOfSeveralStepsAreAUnit) {
  // The second step is written in another way, the first is wrong.
  const Comparison comparison = compare(withShader(twoSteps("l += 3;", "l = l + l;")),
                                        withShader(twoSteps("l += 1;", "l *= 2;")));
  ASSERT_THAT(names(comparison),
              ElementsAre("0 lines a.1 of main in fragment", "0 lines a.2 of main in fragment",
                          "0 function main in fragment", "0 shader fragment"));
  const Difference& first = comparison.differences[0];
  EXPECT_THAT(first.lacks, ElementsAre("l+=1;"));
  EXPECT_TRUE(first.adds);
  EXPECT_EQ(functionOf(first.unit.name), comparison.differences[2].unit.name);
  EXPECT_EQ(shaderOf(first.unit.name), comparison.differences[3].unit.name);
  const auto drawnWith = [&](const json& commands) {
    return comparison.tape.blobs.at(commands[4]["program"]["stages"][0]["blob"]);
  };
  json patched = comparison.tape.commands.patch(first.patch);
  EXPECT_EQ(drawnWith(patched), blob(twoSteps("l += 1;", "l = l + l;")));
  // Both together are the function, which comes after them.
  patched = patched.patch(comparison.differences[1].patch);
  patched = patched.patch(comparison.differences[2].patch);
  EXPECT_EQ(drawnWith(patched), blob(twoSteps("l += 1;", "l *= 2;")));
}

TEST(Repair, WithoutTheCommentsOfItsStepsAFunctionIsOne) {
  EXPECT_THAT(names(compare(withShader(twoSteps("l += 3;", "l *= 2;", "twice")),
                            withShader(twoSteps("l += 1;", "l *= 2;")))),
              ElementsAre("0 function main in fragment", "0 shader fragment"));
}

TEST(Repair, CommentsAndSpacesAreNoDifference) {
  tape::Tape submission = reference();
  std::string source = kShader;
  source.replace(source.find("/* } */"), 7, "// nothing { more");
  source.insert(source.find("return 1.0"), "\n\n   ");
  submission.blobs[0] = blob(source);
  EXPECT_THAT(names(compare(submission, reference())), IsEmpty());
}

TEST(Repair, ADrawThatLacksIsPutBackAsAWhole) {
  tape::Tape submission = reference();
  submission.commands.erase(6);
  const Comparison comparison = compare(submission, reference());
  ASSERT_THAT(names(comparison), ElementsAre("1 draws"));
  const json patched = comparison.tape.commands.patch(comparison.differences[0].patch);
  EXPECT_EQ(patched[7]["op"], "swap");
  ASSERT_EQ(patched[7]["before"].size(), 1U);
  EXPECT_FALSE(comparison.differences[0].isUnseen) << "the pass draws another mesh";
  EXPECT_EQ(patched[7]["before"]["000006"]["op"], "draw");
}

TEST(Repair, ADrawTooManyIsSkipped) {
  tape::Tape submission = reference();
  submission.commands.insert(submission.commands.begin() + 4, draw(texture(0), 8, 2));
  const Comparison comparison = compare(submission, reference());
  ASSERT_THAT(names(comparison), ElementsAre("1 draws"));
  const json patched = comparison.tape.commands.patch(comparison.differences[0].patch);
  EXPECT_EQ(patched[5]["skip"], true);
  EXPECT_FALSE(patched[6].contains("skip"));
}

TEST(Repair, AClearThatLacksIsPutBeforeTheDraw) {
  tape::Tape submission = reference();
  submission.commands.erase(2);
  const Comparison comparison = compare(submission, reference());
  ASSERT_THAT(names(comparison), ElementsAre("0 clear"));
  const json patched = comparison.tape.commands.patch(comparison.differences[0].patch);
  EXPECT_EQ(patched[3]["before"]["000002"]["op"], "clear");
}

TEST(Repair, PassesOfOneRoleAreRepairedTogether) {
  tape::Tape right = reference();
  right.commands.insert(right.commands.begin() + 4,
                        {image(1, 32856), clear(texture(1), 8), draw(texture(1), 8, 1)});
  tape::Tape submission = right;
  for (const std::size_t i : {3U, 6U}) submission.commands[i]["state"]["depthTest"] = false;
  const Comparison comparison = compare(submission, right);
  ASSERT_THAT(names(comparison), ElementsAre("0 depth"));
  EXPECT_THAT(comparison.differences[0].passes, ElementsAre(0U, 1U));
  EXPECT_EQ(comparison.differences[0].patch.size(), 2U);
}

TEST(Repair, AClearThatLacksAMaskIsThatBuffersFault) {
  tape::Tape submission = reference();
  submission.commands[2]["depths"] = false;
  EXPECT_THAT(names(compare(submission, reference())), ElementsAre("0 clear depth"));
}

TEST(Repair, AnotherFormatIsTheStorage) {
  tape::Tape submission = reference();
  submission.commands[1] = image(0, 34842);
  const Comparison comparison = compare(submission, reference());
  ASSERT_THAT(names(comparison), ElementsAre("0 storage"));
  const json patched = comparison.tape.commands.patch(comparison.differences[0].patch);
  EXPECT_EQ(patched[2]["levels"][0]["format"], 32856);
  EXPECT_EQ(patched[2]["id"], 0);
}

TEST(Repair, APassInTheWrongPlaceIsTheRightPass) {
  tape::Tape submission = reference(), right = reference();
  right.commands[6]["textures"]["uReflection"] = {sampled(0)};
  submission.commands[6]["textures"]["uReflection"] = {sampled(0)};
  for (const std::size_t i : {2U, 3U}) submission.commands[i]["target"] = window();
  // It is first used, and so defined, where it is sampled.
  const json defined = submission.commands[1];
  submission.commands.erase(1);
  submission.commands.insert(submission.commands.begin() + 5, defined);
  const Comparison comparison = compare(submission, right);
  ASSERT_THAT(names(comparison), ElementsAre("0 framebuffer"));
  const json patched = comparison.tape.commands.patch(comparison.differences[0].patch);
  EXPECT_EQ(patched[2]["op"], "image");
  EXPECT_EQ(patched[2]["id"], 0);
  EXPECT_EQ(patched[3]["target"], texture(0));
  EXPECT_EQ(patched[4]["target"], texture(0));
}

TEST(Repair, APassThatLacksIsPutBeforeTheNext) {
  tape::Tape submission = reference();
  for (int i = 0; i < 3; ++i) submission.commands.erase(1);
  const Comparison comparison = compare(submission, reference());
  EXPECT_THAT(names(comparison), ElementsAre("- draws"));
  const json patched = comparison.tape.commands.patch(comparison.differences[0].patch);
  EXPECT_EQ(patched[2]["before"].size(), 2U);
  EXPECT_TRUE(comparison.differences[0].isUnseen);
  EXPECT_EQ(patched[2]["before"]["000003"]["op"], "draw");
  std::map<std::string, std::set<std::string>> compared; // units that both have, by role
  for (const auto& [unit, shaders] : comparison.compared)
    compared[unit.role].insert(unit.name.substr(0, unit.name.find(' ')));
  ASSERT_THAT(compared, testing::SizeIs(2));
  EXPECT_THAT(compared.begin()->second, UnorderedElementsAre("function", "shader"))
      << "the submission draws with them elsewhere";
}

/// Another program of which no line is that of the sample's.
const char* const kScreen = "void main() { gl_FragColor = vec4(1); }\n";

TEST(Repair, ADrawThatLacksIsPutInWithTheSubmissionsShader) {
  tape::Tape right = reference();
  right.blobs.push_back(blob(kScreen));
  for (const std::size_t i : {5U, 6U}) right.commands[i]["program"]["stages"][0]["blob"] = 3;
  tape::Tape submission = right;
  std::string source = kShader;
  source.replace(source.find("p.z < uBias"), 11, "p.z > uBias");
  submission.blobs[0] = blob(source);
  json linked = {{"op", "program"}, {"program", submission.commands[3]["program"]}};
  for (int i = 0; i < 3; ++i) submission.commands.erase(1);
  submission.commands.insert(submission.commands.end() - 1, linked);
  const Comparison comparison = compare(submission, right);
  ASSERT_THAT(names(comparison),
              ElementsAre("- function visibility in fragment", "- draws", "- shader fragment"));
  EXPECT_TRUE(comparison.differences[1].isUnseen);
  const auto shaderOf = [&](const json& commands) {
    const json& drawn = commands[2]["before"]["000003"];
    EXPECT_EQ(drawn["skip"], false);
    return comparison.tape.blobs.at(drawn["program"]["stages"][0]["blob"]);
  };
  json patched = comparison.tape.commands.patch(comparison.differences[1].patch);
  EXPECT_EQ(shaderOf(patched), blob(source));
  patched = patched.patch(comparison.differences[0].patch);
  EXPECT_EQ(shaderOf(patched), blob(kShader));
  EXPECT_EQ(comparison.tape.commands[2]["before"]["000003"]["skip"], true) << "as it was";
}

TEST(Repair, WhereNoProgramIsLikeItTheReferencesDraws) {
  tape::Tape right = reference();
  right.blobs.push_back(blob(kScreen));
  for (const std::size_t i : {5U, 6U}) right.commands[i]["program"]["stages"][0]["blob"] = 3;
  tape::Tape submission = right;
  for (int i = 0; i < 3; ++i) submission.commands.erase(1);
  const Comparison comparison = compare(submission, right);
  ASSERT_THAT(names(comparison), ElementsAre("- draws"));
  const json patched = comparison.tape.commands.patch(comparison.differences[0].patch);
  const json& drawn = patched[2]["before"]["000003"];
  EXPECT_EQ(comparison.tape.blobs.at(drawn["program"]["stages"][0]["blob"]), blob(kShader));
}

TEST(Repair, AnotherMeshIsNoOtherDraw) {
  tape::Tape submission = reference();
  submission.commands[3] = draw(texture(0), 8, 2, 0.5);
  const Comparison comparison = compare(submission, reference());
  ASSERT_THAT(names(comparison), ElementsAre("0 uniform uLight", "0 mesh"));
  const json patched = comparison.tape.commands.patch(comparison.differences[1].patch);
  EXPECT_EQ(comparison.tape.blobs.at(patched[4]["attributes"]["position"][0]["blob"]),
            blob("mesh"));
}

TEST(Repair, WhichTextureAndHowItIsSampledAreTwoThings) {
  tape::Tape right = reference();
  right.commands[6]["textures"]["uReflection"] = {sampled(0)};
  tape::Tape submission = right;
  submission.commands[6]["textures"]["uReflection"] = {sampled(0, 9987)};
  EXPECT_THAT(names(compare(submission, right)), ElementsAre("1 sampler uReflection"));
  submission.commands[6]["textures"]["uReflection"] = {{{"unit", 0}, {"target", 3553}}};
  EXPECT_THAT(names(compare(submission, right)),
              UnorderedElementsAre("1 texture uReflection", "1 sampler uReflection"));
}

TEST(Repair, OfATextureItIsSaidWhereNoneIsReadOrTheOneThatIsDrawnInto) {
  tape::Tape right = reference();
  right.commands[6]["textures"]["uReflection"] = {sampled(0)};
  tape::Tape submission = right;
  const auto own = [&] {
    for (const Difference& one : compare(submission, right).differences)
      if (one.unit.name == "texture uReflection") return one.own;
    return std::string("no difference");
  };
  submission.commands[6]["textures"]["uReflection"] = {{{"unit", 0}, {"target", 3553}}};
  EXPECT_EQ(own(), results::kNoTexture);
  for (tape::Tape* tape : {&right, &submission}) {
    *tape = reference();
    tape->commands.insert(tape->commands.begin() + 1, image(1, 32856));
  }
  right.commands[4]["textures"]["uReflection"] = {sampled(1)};
  submission.commands[4]["textures"]["uReflection"] = {sampled(0)}; // its target
  EXPECT_EQ(own(), results::kDrawnInto);
  std::swap(right, submission);
  EXPECT_EQ(own(), "") << "another image";
}

TEST(Repair, ImagesAreNotTakenForTwoOfTheReferences) {
  // Both passes draw into one texture.
  tape::Tape right = reference();
  right.commands.insert(right.commands.begin() + 4,
                        {image(1, 32856), clear(texture(1), 8), draw(texture(1), 8, 2)});
  tape::Tape submission = right;
  for (const std::size_t i : {5U, 6U}) submission.commands[i]["target"] = texture(0);
  const Comparison comparison = compare(submission, right);
  ASSERT_THAT(names(comparison), ElementsAre("1 attachments"));
  const json patched = comparison.tape.commands.patch(comparison.differences[0].patch);
  const auto drawnInto = [](const json& command) {
    return command["target"]["attachments"]["color0"]["image"].get<int>();
  };
  std::vector<int> images;
  for (const json& command : patched)
    if (command["op"] == "draw" && !command["target"].contains("window"))
      images.push_back(drawnInto(command));
  ASSERT_EQ(images.size(), 2U);
  EXPECT_NE(images[0], images[1]);
}

TEST(Repair, AMatrixThatTheReferenceHasElsewhereIsPassedToTheWrongPlace) {
  const auto matrix = [](double scale, double shift) {
    return json{{"type", 0x8b5c}, // GL_FLOAT_MAT4
                {"values", {scale, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, shift, 0, 0, 1}}};
  };
  tape::Tape right = reference();
  right.commands[3]["uniforms"]["uView"] = matrix(1, 2);
  right.commands[6]["uniforms"]["uView"] = matrix(1, 3);
  right.commands[6]["uniforms"]["uModel"] = matrix(1, 0);
  const auto isAnothers = [&](const json& view) {
    tape::Tape submission = right;
    submission.commands[3]["uniforms"]["uView"] = view;
    const Comparison comparison = compare(submission, right);
    EXPECT_THAT(names(comparison), ElementsAre("0 uniform uView"));
    return comparison.differences.at(0).isAnothers;
  };
  EXPECT_TRUE(isAnothers(matrix(1, 3)));
  EXPECT_FALSE(isAnothers(matrix(1, 4)));
  EXPECT_FALSE(isAnothers(matrix(1, 0))) << "a unit matrix may be one by chance";
}

TEST(Repair, AProgramForSomethingElseIsNamedAsSuch) {
  tape::Tape right = reference();
  right.blobs.push_back(blob(kScreen));
  right.commands[6]["program"]["stages"][0]["blob"] = 3;
  tape::Tape submission = right;
  submission.commands[3]["program"]["stages"][0]["blob"] = 3;
  EXPECT_THAT(names(compare(submission, right)), ElementsAre("0 program"));
}

TEST(Repair, WhatTheSubmissionHasIsSaidInAFewWordsOrNotAtAll) {
  EXPECT_EQ(ownValue("uniform uLight", "uLight", {{"values", {0.25, 1, 2}}}), "0.25, 1, 2");
  EXPECT_EQ(ownValue("uniform uView", "uView", {{"values", std::vector<double>(16, 1)}}), "");
  EXPECT_EQ(ownValue("uniform uLight", "uLight", {{"values", {nullptr}}}), "") << "not finite";
  EXPECT_EQ(ownValue("sampler uShadow", "wrapS", GL_REPEAT), "GL_REPEAT");
  EXPECT_EQ(ownValue("culling", "cull", false), "glDisable(GL_CULL_FACE)");
  EXPECT_EQ(ownValue("culling", "cullFace", GL_BACK), "GL_BACK");
  EXPECT_EQ(ownValue("depth", "depthMask", true), "glDepthMask(GL_TRUE)");
  EXPECT_EQ(ownValue("blend", "blend", json::array({false})), "");
  const json level = {{"width", 64}, {"height", 32}, {"format", GL_RGBA8}};
  EXPECT_EQ(ownValue("storage", "3", {{"levels", {level}}}), "64x32, GL_RGBA8");
  EXPECT_EQ(ownValue("storage", "3", level), "64x32, GL_RGBA8");
  EXPECT_EQ(ownValue("storage", "3", {{"levels", json::array()}}), "");
}

TEST(Repair, PassesThatHaveOtherValuesEachSayNone) {
  tape::Tape right = reference();
  right.commands.insert(right.commands.begin() + 4,
                        {image(1, 32856), clear(texture(1), 8), draw(texture(1), 8, 1)});
  tape::Tape submission = right;
  for (const int side : {3, 6})
    submission.commands[std::size_t(side)]["state"]["viewport"] = {0, 0, side, side};
  const Comparison comparison = compare(submission, right);
  ASSERT_THAT(names(comparison), ElementsAre("0 viewport"));
  EXPECT_EQ(comparison.differences[0].own, "");
}

TEST(Repair, WhatIsNoTapeIsAnError) {
  tape::Tape empty;
  EXPECT_THROW(compare(empty, reference()), json::exception);
  tape::Tape odd = reference();
  odd.commands[3].erase("uniforms");
  EXPECT_THROW(compare(odd, reference()), json::exception);
  tape::Tape beyond = reference();
  beyond.commands[3]["program"]["stages"][0]["blob"] = 99;
  EXPECT_THROW(compare(beyond, reference()), std::exception);
}

TEST(Repair, TooManyDrawsAreNotCompared) {
  tape::Tape many = reference();
  for (int i = 0; i < 2100; ++i)
    many.commands.insert(many.commands.end() - 1, draw(window(), 16, 1));
  EXPECT_THROW(compare(many, reference()), std::runtime_error);
}

TEST(Repair, FunctionsOfAShader) {
  const auto functions = functionsOf(kShader);
  EXPECT_THAT(functions, UnorderedElementsAre(Key("visibility"), Key("main")));
  const std::string source = kShader;
  const GlslText& one = functions.at("visibility");
  EXPECT_TRUE(source.substr(one.begin).starts_with("float visibility"));
  EXPECT_EQ(source[one.end - 1], '}');
  EXPECT_EQ(one.words, "float visibility(vec3 p){if(p.z<uBias){return 1.0;}return 0.0;}");
  EXPECT_EQ(restOf(source), "#version 410 core uniform float uBias;out vec4 oColor;");
}

TEST(Repair, StepsOfAFunction) {
  const auto of = [](const std::string& source) {
    return stepsOf(source, functionsOf(source).at("main"));
  };
  EXPECT_THAT(of(twoSteps("l += 1;", "l *= 2;")), UnorderedElementsAre(Key("a.1"), Key("a.2")));
  EXPECT_EQ(of(twoSteps("l += 1;", "l *= 2;")).at("a.2").words, "l*=2;o=vec4(l);}");
  EXPECT_THAT(of(twoSteps("", "", "TODO(a.1)")), IsEmpty()) << "one twice";
  EXPECT_THAT(of(twoSteps("", "", "more")), IsEmpty()) << "one alone";
  EXPECT_THAT(of("void main() { // TODO(\n}"), IsEmpty());
  EXPECT_THAT(of("void main() { f(TODO(a)); g(TODO(b)); }"), IsEmpty()) << "no comments";
}

TEST(Repair, OverloadedAndBrokenSources) {
  EXPECT_THAT(functionsOf("int f(int a) { return a; }\nint f(float a) { return 0; }"),
              UnorderedElementsAre(Key("f"), Key("f 2")));
  EXPECT_THAT(functionsOf("void main() { if (true) {"), UnorderedElementsAre(Key("main")));
  EXPECT_THAT(functionsOf("layout(location = 0) in vec3 p; struct S { int a; }; ((("), IsEmpty());
  EXPECT_THAT(functionsOf(""), IsEmpty());
}

} // namespace
