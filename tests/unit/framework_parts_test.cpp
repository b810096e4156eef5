#include "parts.hpp"

#include "framework_temporary_folder.hpp"
#include "framework_throws.hpp"
#include <gg/error.hpp>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace {

using gg::detail::sceneOfPart;
using nlohmann::json;
using testing::HasSubstr;

class Parts : public testing::Test {
protected:
  Parts() {
    files_.write("scene.json", R"({"effects": {"a": false, "b": false}, "size": [8, 6]})");
    files_.write("assignment.json", R"({"parts": [
      {"id": "first", "scene": {"effects": {"a": true}, "size": [4, 3]}},
      {"id": "second", "scene": {"effects": {"b": true}}},
      {"id": "third"}]})");
  }
  json of(const std::string& part) { return json::parse(sceneOfPart(files_.path(), part)); }
  TemporaryFolder files_;
};

TEST_F(Parts, MergeTheirSettingsOverTheScene) {
  EXPECT_EQ(of("first"), json::parse(R"({"effects": {"a": true, "b": false}, "size": [4, 3]})"));
  EXPECT_EQ(of("second"), json::parse(R"({"effects": {"a": false, "b": true}, "size": [8, 6]})"));
  EXPECT_EQ(of("third"), json::parse(R"({"effects": {"a": false, "b": false}, "size": [8, 6]})"));
}

TEST_F(Parts, AllTogetherAreTheDefault) {
  EXPECT_EQ(of(""), json::parse(R"({"effects": {"a": true, "b": true}, "size": [4, 3]})"));
}

TEST_F(Parts, AnUnknownOneListsWhatThereIs) {
  EXPECT_EQ(messageOf<std::invalid_argument>([&] { of("fourth"); }),
            "--part fourth: there are first, second, third");
}

TEST_F(Parts, AFileThatCannotBeReadIsNamed) {
  files_.write("assignment.json", "{\"parts\": [");
  EXPECT_THAT(messageOf<gg::SceneError>([&] { of("first"); }), HasSubstr("assignment.json: "));
}

} // namespace
