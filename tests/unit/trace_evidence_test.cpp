// Recorded passes on their way to a rubric's judge.

#include "rubric/rubric.hpp"

#include "framework_temporary_folder.hpp"
#include "framework_throws.hpp"
#include "trace_samples.hpp"

#include <gmock/gmock.h>

namespace ggrade::rubric {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A scene's files with a recording each of the student (3 draws), the reference (2) and the stub
/// (1).
class TraceEvidence : public testing::Test {
protected:
  TraceEvidence() {
    const std::pair<const char*, std::uint32_t> all[] = {
        {"student", 3}, {"reference", 2}, {"stub", 1}};
    for (const auto& [name, draws] : all) {
      trace::Trace trace = trace::samples::mirror();
      trace.passes[0].draws = draws;
      trace::save(trace, folder_.path() / name);
      writeFrames(folder_.path() / name, {{0, 1, 1, std::vector<std::uint8_t>(4)}});
    }
  }
  Evidence evidence() {
    SceneFolders scene;
    scene.name = "public";
    scene.tags = {"lecture"};
    scene.times = {0};
    scene.student = folder_.path() / "student";
    scene.reference = folder_.path() / "reference";
    scene.stub = folder_.path() / "stub";
    scene.probeFolders["plain"] = folder_.path() / "stub";
    writeEvidence(folder_.path() / "evidence.json", "/assignments/floor", "mirror", {scene});
    return readEvidence(folder_.path() / "evidence.json");
  }
  TemporaryFolder folder_;
};

TEST_F(TraceEvidence, ReachesTheJudge) {
  ItemDeclaration item;
  item.id = "mirror.texture";
  item.kind = results::ItemKind::gain;
  item.points = 10;
  item.scenes = {"lecture"};
  std::vector<std::uint32_t> draws;
  const Decision decision = decide(
      item, {item},
      [&](const View& view) {
        const trace::PassRecord& pass = view.trace.passesOf(0)[0];
        draws.push_back(pass.draws);
        EXPECT_EQ(view.scene.referenceTrace.passes.at(0).draws, 2U);
        const Image left = view.trace.image(*view.trace.copyOf(0, 0));
        return Verdict{pass.draws == 3 ? left.at(0, 0, 0) : 0.0, "the copy's first value"};
      },
      evidence());
  EXPECT_THAT(draws, ElementsAre(3U, 1U)) << "the student's, and the stub's for the scale";
  EXPECT_DOUBLE_EQ(decision.credit, 0.5);
  EXPECT_EQ(decision.message, "public: the copy's first value");
}

TEST_F(TraceEvidence, NothingRecordedIsAnEmptyTrace) {
  std::filesystem::remove(folder_.path() / "student/trace.bin");
  const Evidence read = evidence();
  EXPECT_TRUE(read.scenes.at(0).studentTrace.passes.empty());
  EXPECT_EQ(read.scenes.at(0).stubTrace.passes.size(), 2U);
  EXPECT_EQ(read.scenes.at(0).student.size(), 1U);
}

TEST_F(TraceEvidence, CopiesStayInTheirFileUntilTheyAreAskedFor) {
  const Evidence read = evidence();
  const trace::Trace& trace = read.scenes.at(0).studentTrace;
  EXPECT_TRUE(trace.pixels.empty());
  EXPECT_EQ(trace.pixelFile, folder_.path() / "student/copies.bin");
}

TEST_F(TraceEvidence, ACutOffRecordingIsNamed) {
  std::filesystem::resize_file(folder_.path() / "reference/trace.bin", 100);
  EXPECT_THAT(messageOf<UsageError>([&] { evidence(); }),
              HasSubstr("reference/trace.bin is cut off"));
}

} // namespace
} // namespace ggrade::rubric
