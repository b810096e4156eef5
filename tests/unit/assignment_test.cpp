#include "assignment/assignment.hpp"

#include "framework_temporary_folder.hpp"
#include "framework_throws.hpp"

#include <gmock/gmock.h>

#include <functional>

using namespace ggrade;
using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

const json kSample = json::parse(R"({
  "id": "cube", "title": "A cube", "files": ["cube.cpp"], "files_optional": ["*.vert"],
  "parts": [
    {"id": "turn", "title": "Turning", "scene": {"effects": {"turn": true}},
     "todos": [{"id": "turn.1", "title": "turn it"}, {"id": "turn.2", "title": "more", "bonus": true}],
     "items": [
       {"id": "turn.angle", "kind": "gain", "points": 60, "title": "t", "looks_at": "l", "cause": "c",
        "step": "turn.1", "scenes": ["lecture"]},
       {"id": "turn.keep", "kind": "keep", "points": 30, "title": "t", "looks_at": "l", "cause": "c",
        "step": "turn.1"},
       {"id": "turn.extra", "kind": "bonus", "points": 5, "title": "t", "looks_at": "l", "cause": "c",
        "step": "turn.2", "beyond_lecture": true}]},
    {"id": "light", "title": "Light", "todos": [],
     "items": [{"id": "light.a", "kind": "gain", "points": 40, "title": "t", "looks_at": "l",
                "cause": "c", "step": "light.1"}]}
  ]
})");

class AssignmentFile : public testing::Test {
protected:
  void write(const json& content) { files_.write("cube/assignment.json", content.dump(1)); }
  std::string problem() {
    return messageOf<UsageError>([&] { Assignment::load(files_.path() / "cube"); });
  }
  /// What is wrong when the value at `pointer` is `value`, or is not there.
  std::string problemWith(const std::string& pointer, const json& value) {
    json changed = kSample;
    changed[json::json_pointer(pointer)] = value;
    write(changed);
    return problem();
  }

  TemporaryFolder files_;
};

TEST_F(AssignmentFile, IsRead) {
  write(kSample);
  const Assignment assignment = Assignment::load(files_.path() / "cube");
  EXPECT_EQ(assignment.id, "cube");
  EXPECT_THAT(assignment.files, ElementsAre("cube.cpp"));
  EXPECT_THAT(assignment.optionalFiles, ElementsAre("*.vert"));
  ASSERT_EQ(assignment.parts.size(), 2u);
  EXPECT_TRUE(assignment.parts[0].todos[1].bonus);
  EXPECT_FALSE(assignment.parts[0].todos[0].bonus);
  EXPECT_EQ(assignment.parts[0].items[1].kind, results::ItemKind::keep);
  EXPECT_TRUE(assignment.parts[0].items[2].beyondLecture);
  EXPECT_THAT(assignment.parts[0].items[0].scenes, ElementsAre("lecture"));
}

TEST_F(AssignmentFile, TargetsAreAPartOrAll) {
  write(kSample);
  const Target part = findTarget(files_.path(), "turn");
  EXPECT_EQ(part.maxScore(), 60); // gain alone
  EXPECT_EQ(part.items().size(), 3u);
  EXPECT_TRUE(part.covers("turn"));
  EXPECT_FALSE(part.covers("light"));
  const Target all = findTarget(files_.path(), "cube");
  EXPECT_EQ(all.maxScore(), 100);
  EXPECT_EQ(all.items().size(), 4u);
  EXPECT_TRUE(all.covers("light"));
}

TEST_F(AssignmentFile, ASinglePartMayBeTheWholeAssignment) {
  json one = kSample;
  one["parts"].erase(1);
  EXPECT_FALSE((write(one), Assignment::load(files_.path() / "cube").isOnePart()));
  one["parts"][0]["id"] = "cube";
  write(one);
  const Target target = findTarget(files_.path(), "cube");
  EXPECT_TRUE(target.assignment.isOnePart());
  EXPECT_EQ(target.parts.size(), 1u);
  EXPECT_EQ(target.maxScore(), 60);
  EXPECT_EQ(messageOf<UsageError>([&] { findTarget(files_.path(), "ball"); }),
            "there is no assignment or part \"ball\"; there are: cube");
  json two = kSample;
  two["parts"][0]["id"] = "cube";
  write(two);
  EXPECT_THAT(problem(), HasSubstr("\"cube\" stands there twice"));
}

TEST_F(AssignmentFile, WeightsCountWherePartsAreGradedTogether) {
  json weighed = kSample;
  weighed["parts"][0]["weight"] = 0.75;
  weighed["parts"][1]["weight"] = 0.25;
  write(weighed);
  EXPECT_EQ(findTarget(files_.path(), "turn").maxScore(), 60);
  const Target all = findTarget(files_.path(), "cube");
  EXPECT_EQ(all.maxScore(), 55);
  EXPECT_EQ(all.items()[1].points, 22.5); // what may be taken away, too
  EXPECT_EQ(all.items()[3].points, 10);
  EXPECT_THAT(problemWith("/parts/0/weight", 0), HasSubstr("turn: weight must be above 0"));
  EXPECT_THAT(problemWith("/parts/1/weight", 1.5), HasSubstr("light: weight must be"));
}

TEST_F(AssignmentFile, AnUnknownTargetListsWhatThereIs) {
  write(kSample);
  EXPECT_EQ(messageOf<UsageError>([&] { findTarget(files_.path(), "cbue"); }),
            "there is no assignment or part \"cbue\"; there are: cube, turn, light");
  EXPECT_THAT(messageOf<UsageError>([&] { findTarget("/nowhere", "cube"); }),
              HasSubstr("/nowhere holds no assignment"));
}

TEST_F(AssignmentFile, ThatIsNoJsonNamesTheLine) {
  files_.write("cube/assignment.json", "{\n  \"id\": \"cube\",\n  \"title\" \"A cube\"\n}\n");
  EXPECT_THAT(problem(), HasSubstr("cube/assignment.json:3: "));
  files_.write("cube/assignment.json", "");
  EXPECT_THAT(problem(), HasSubstr("cube/assignment.json:1: "));
}

TEST_F(AssignmentFile, ANumberBeyondAllNamesItsLine) {
  files_.write("cube/assignment.json", "{\n\"id\": \"cube\",\n\"points\": 1e999 }");
  EXPECT_THAT(problem(), HasSubstr("cube/assignment.json:3: "));
  EXPECT_THAT(problem(), HasSubstr("number overflow parsing '1e999'"));
}

TEST_F(AssignmentFile, WithANulByteIsNoText) {
  files_.write("cube/assignment.json", kSample.dump() + "\n" + std::string(1, '\0'));
  EXPECT_THAT(problem(), HasSubstr("cube/assignment.json:2: holds a NUL byte"));
}

TEST_F(AssignmentFile, WithAWrongValueNamesTheFileAndTheFault) {
  const auto names = [](const std::string& what) {
    return AllOf(HasSubstr("cube/assignment.json: "), HasSubstr(what));
  };
  EXPECT_THAT(problemWith("/id", "ball"), names("id is \"ball\" but the folder is \"cube\""));
  EXPECT_THAT(problemWith("/parts/0/items/0/kind", "win"),
              names("kind must be gain, keep or bonus, but is \"win\""));
  EXPECT_THAT(problemWith("/parts/0/items/0/points", -1),
              names("turn.angle: points must not be negative"));
  EXPECT_THAT(problemWith("/parts/0/items/0/points", 1e308),
              names("turn.angle: points must not be more than a million"));
  EXPECT_THAT(problemWith("/parts/0/items/0/points", "many"), names("must be number"));
  EXPECT_THAT(problemWith("/files", 7), names("must be array"));
  EXPECT_THAT(problemWith("/parts", json::array({json::object()})), names("'id' not found"));
}

TEST_F(AssignmentFile, ThatIsMissingIsNamed) {
  EXPECT_THAT(problem(), HasSubstr("can't read"));
  EXPECT_TRUE(loadAssignments(files_.path()).empty());
}

TEST_F(AssignmentFile, TheSameIdTwiceIsRefused) {
  json twice = kSample;
  twice["parts"][1]["id"] = "turn";
  write(twice);
  EXPECT_THAT(problem(), HasSubstr("\"turn\" stands there twice"));
  twice = kSample;
  twice["parts"][1]["items"][0]["id"] = "turn.angle";
  write(twice);
  EXPECT_THAT(problem(), HasSubstr("\"turn.angle\" stands there twice"));
}

TEST_F(AssignmentFile, TheSameIdInTwoAssignmentsIsRefused) {
  write(kSample);
  json other = kSample;
  other["id"] = "ball";
  other["parts"].erase(0);
  files_.write("ball/assignment.json", other.dump());
  EXPECT_THAT(messageOf<UsageError>([&] { findTarget(files_.path(), "turn"); }),
              AllOf(HasSubstr("\"light\" stands in "), HasSubstr("ball/assignment.json and in "),
                    HasSubstr("cube/assignment.json: give one of them another ID")));
}

/// The sample with an item "turn.after" in the part "turn", changed by `change`.
json chained(const std::function<void(json& angle, json& after)>& change) {
  json sample = kSample;
  json& items = sample["parts"][0]["items"];
  items[0]["output"] = "angle";
  items.push_back(items[0]);
  items[3]["id"] = "turn.after";
  items[3]["after"] = "turn.angle";
  change(items[0], items[3]);
  return sample;
}

TEST_F(AssignmentFile, ItemsCanBeAfterOneAnother) {
  write(chained([](json&, json&) {}));
  const Assignment assignment = Assignment::load(files_.path() / "cube");
  EXPECT_EQ(assignment.parts[0].items[0].after, "");
  EXPECT_EQ(assignment.parts[0].items[0].output, "angle");
  EXPECT_EQ(assignment.parts[0].items[3].after, "turn.angle");
}

TEST_F(AssignmentFile, WhatNoItemCanBeAfterIsRefused) {
  struct Case {
    const char* problem;
    void (*change)(json& angle, json& after);
  };
  const Case cases[] = {
      {"turn.after: after \"turn.angel\": there is no such item",
       [](json&, json& after) { after["after"] = "turn.angel"; }},
      {"turn.after: after \"light.a\": that is an item of another part, \"light\"",
       [](json&, json& after) { after["after"] = "light.a"; }},
      {"turn.after: after \"turn.angle\": that item doesn't say what its pass leaves (\"output\")",
       [](json& angle, json&) { angle.erase("output"); }},
      {"turn.after: after \"turn.angle\": only an item of kind gain comes after one",
       [](json&, json& after) { after["kind"] = "keep"; }},
      {"turn.after: after \"turn.after\": items go round in a circle",
       [](json&, json& after) { after["after"] = "turn.after"; }},
      {"turn.after: after \"turn.angle\": items go round in a circle",
       [](json& angle, json&) { angle["after"] = "turn.after"; }},
  };
  for (const Case& one : cases) {
    write(chained(one.change));
    EXPECT_THAT(problem(), testing::EndsWith(one.problem));
  }
}

} // namespace
