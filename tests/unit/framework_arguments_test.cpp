#include "arguments.hpp"

#include "framework_throws.hpp"
#include <gmock/gmock.h>

namespace {

using gg::detail::parseArguments;
using gg::detail::UsageError;

std::string messageFor(const std::vector<std::string>& words) {
  return messageOf<UsageError>([&] { parseArguments(words); });
}

TEST(Arguments, AreAllOptional) {
  const auto arguments = parseArguments({});
  EXPECT_FALSE(arguments.help);
  EXPECT_FALSE(arguments.scene);
  EXPECT_FALSE(arguments.mesh);
  EXPECT_FALSE(arguments.size);
}

TEST(Arguments, TakeTheirValueAfterASpaceOrAnEqualsSign) {
  const auto arguments =
      parseArguments({"--scene", "a b.json", "--mesh=x=y.obj", "--size", "64x48"});
  EXPECT_EQ(arguments.scene, "a b.json");
  EXPECT_EQ(arguments.mesh, "x=y.obj");
  EXPECT_EQ(arguments.size, glm::ivec2(64, 48));
}

TEST(Arguments, APartAndASceneExcludeEachOther) {
  EXPECT_EQ(parseArguments({"--part", "shadow"}).part, "shadow");
  EXPECT_EQ(messageFor({"--part", "shadow", "--scene", "a.json"}),
            "--part and --scene both choose the scene; give one of them");
}

TEST(Arguments, TheLanguageHoldsForWhatFollows) {
  EXPECT_EQ(messageFor({"--lang", "de"}), "--lang de: must be en or ja");
  EXPECT_EQ(messageFor({"--lang=ja", "--mesh"}), "--meshには値が要ります");
  EXPECT_THAT(gg::detail::usage("floor"), testing::StartsWith("使い方: floor [--part ID"));
  EXPECT_EQ(messageFor({"--lang", "en", "--mesh"}), "--mesh needs a value");
}

TEST(Arguments, HelpIsRecognised) {
  EXPECT_TRUE(parseArguments({"--help"}).help);
  EXPECT_TRUE(parseArguments({"-h"}).help);
  EXPECT_THAT(gg::detail::usage("floor"),
              testing::StartsWith("usage: floor [--part ID | --scene FILE]"));
}

TEST(Arguments, UnknownOnesAreNamed) {
  EXPECT_EQ(messageFor({"--seen", "x"}), "unknown argument \"--seen\"");
  EXPECT_EQ(messageFor({"scene.json"}), "unknown argument \"scene.json\"");
}

TEST(Arguments, AMissingValueIsNamed) {
  EXPECT_EQ(messageFor({"--mesh"}), "--mesh needs a value");
}

TEST(Arguments, ABadSizeSaysWhatIsAllowed) {
  for (const std::string size :
       {"640", "640x", "x480", "0x480", "640x480x2", "-1x5", "16385x1", ""})
    EXPECT_EQ(messageFor({"--size", size}),
              "--size " + size + ": must be like 640x480, each side 1 to 16384");
}

} // namespace
