// Uploads made with the kit before floor's passes became functions of their own files: they build,
// score what they scored, and `check` knows what of them was begun.
//
// previous_kit/ has the files of that kit that have changed since, with the solution's blocks; its
// other files are today's.

#include "kit.hpp"

#include "authoring/solution_blocks.hpp"
#include "check/begun.hpp"

#include <gmock/gmock.h>

using namespace tool;

namespace {

const fs::path kKit = kSource / "tests/grading/previous_kit";

struct Upload {
  const char* name;
  std::string part;
  bool isFilled = true;
  /// Today's mistake of the same kind, and what makes it in that kit's files; empty: all is right.
  std::string mistake = {}, file = {}, from = {}, to = {};
  /// What was handed in, where it isn't all.
  std::vector<std::string> files = {};
};

const std::vector<Upload> kUploads{
    {.name = "MirrorDone", .part = "mirror"},
    {.name = "MirrorNotBegun", .part = "mirror", .isFilled = false},
    {.name = "MirrorsOwnFiles",
     .part = "mirror",
     .files = {"floor.cpp", "mirror.hpp", "mirror.vert", "tile.frag"}},
    {.name = "MirrorLightNotMirrored",
     .part = "mirror",
     .mistake = "mirror_light_not_mirrored",
     .file = "floor.cpp",
     .from = "scene.light.in(mirroredView)",
     .to = "scene.light.in(view)"},
    {.name = "ShadowDone", .part = "shadow"},
    {.name = "ShadowsOwnFiles",
     .part = "shadow",
     .files = {"floor.cpp", "shadow.hpp", "shadow.glsl"}},
    {.name = "ShadowNotCleared",
     .part = "shadow",
     .mistake = "shadow_not_cleared",
     .file = "floor.cpp",
     .from = "      glClear(GL_DEPTH_BUFFER_BIT);\n"},
    {.name = "BloomDone", .part = "bloom"},
    {.name = "BloomsOwnFiles",
     .part = "bloom",
     .files = {"floor.cpp", "bloom.hpp", "bright.frag", "composite.frag"}},
    {.name = "BloomBlendingOff",
     .part = "bloom",
     .mistake = "bloom_blending_off",
     .file = "bloom.hpp",
     .from = "  glEnable(GL_BLEND);\n"},
};

void PrintTo(const Upload& upload, std::ostream* out) {
  *out << upload.name;
}

Submission made(const Upload& upload) {
  Submission submission = upload.isFilled ? Submission::solution() : Submission::stub();
  for (const std::string& file : names(kKit)) {
    std::string text = read(kKit / file);
    if (!upload.isFilled) text = ggrade::authoring::withFilled(text, file, {});
    submission.write(file, text);
  }
  if (!upload.file.empty()) submission.replace(upload.file, upload.from, upload.to);
  if (!upload.files.empty())
    for (const std::string& file : names(submission.path()))
      if (std::ranges::find(upload.files, file) == upload.files.end())
        fs::remove(submission.path() / file);
  return submission;
}

/// What `check` says of a mirror's TODOs: of the mistake, which is one of step 4, that it's wrong.
void expectStates(const Upload& upload, const fs::path& folder) {
  std::string said;
  std::vector<std::string> states = statesOf("mirror", expectedOf("mirror"), folder, &said);
  ASSERT_EQ(states.size(), 7u) << said;
  if (!upload.mistake.empty()) {
    EXPECT_EQ(states[3], "wrong") << said;
    states.resize(3);
  }
  EXPECT_THAT(states, testing::Each(upload.isFilled ? "done" : "not_begun")) << said;
}

class PreviousKit : public testing::TestWithParam<Upload> {};

TEST_P(PreviousKit, LosesNothingAndIsKnownAsBegun) {
  const Upload& upload = GetParam();
  const Submission submission = made(upload);
  const Graded graded = gradePart(upload.part, submission);
  EXPECT_EQ(graded.outcome(), "graded") << graded.text();
  if (upload.mistake.empty()) {
    EXPECT_EQ(graded.score(), upload.isFilled ? 100 : 0);
  } else {
    const Graded today = gradePart(upload.part, Submission::mistake(upload.mistake));
    EXPECT_EQ(graded.score(), today.score());
    EXPECT_EQ(graded.lost(), today.lost());
    EXPECT_LT(graded.score(), 90);
  }

  // Who goes on in the present kit has copied what they had over its files.
  const Submission checked = Submission::stub();
  for (const std::string& file : names(submission.path()))
    fs::copy_file(submission.path() / file, checked.path() / file,
                  fs::copy_options::overwrite_existing);
  const ggrade::check::Begun begun =
      ggrade::check::begun(kSource / "assignments/floor", checked.path());
  std::set<std::string> all = begun.certain;
  all.insert(begun.possible.begin(), begun.possible.end());
  for (int i = 1; i <= (upload.part == "mirror" ? 7 : 6); ++i) {
    const std::string todo = upload.part + '.' + std::to_string(i);
    if (upload.isFilled)
      EXPECT_THAT(all, testing::Contains(todo));
    else
      EXPECT_THAT(begun.certain, testing::Not(testing::Contains(todo)));
  }
  // The other parts' pictures would take minutes to make.
  if (upload.part == "mirror") expectStates(upload, checked.path());
}

INSTANTIATE_TEST_SUITE_P(, PreviousKit, testing::ValuesIn(kUploads),
                         [](const auto& info) { return std::string(info.param.name); });

} // namespace
