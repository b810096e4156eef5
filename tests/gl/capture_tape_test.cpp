// Tapes: what the recorder's test programs draw is drawn again from the tape alone, bit for bit;
// and what a tape can't hold is refused by name.

#include "capture_traces.hpp"

#include "replay/tape.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include <unistd.h>

namespace ggrade::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr int kFrames = 2;

trace::Request taping() {
  trace::Request request = everything();
  request.tapeFrames = kFrames;
  request.tapeBytes = std::uint64_t{64} << 20;
  return request;
}

/// A folder of its own for a test, with the tape and what is to be played of it.
class Player {
public:
  Player() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~Player() { fs::remove_all(folder_); }

  CaptureRun play(const tape::Tape& tape, const json& patch = json::array()) const {
    const std::vector<std::byte> bytes = tape::write(tape);
    std::ofstream(folder_ / "tape", std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    std::ofstream(folder_ / "scene.json") << json{{"patches", {patch}}, {"frames", kFrames}};
    const std::vector<channel::PlannedFrame> frames(kFrames, {0, 8, 8});
    return runCaptured(GGRADE_PLAYER, frames,
                       {{"--scene", (folder_ / "scene.json").string()}, {}, everything()});
  }

private:
  const fs::path folder_ =
      fs::temp_directory_path() / ("ggrade-tape-" + std::to_string(::getpid()));
};

/// What differs, copy by copy and frame by frame; empty: nothing.
std::string differenceOf(const channel::Capture& a, const channel::Capture& b) {
  if (a.trace.copies.size() != b.trace.copies.size()) return "another number of copies";
  for (std::size_t i = 0; i < a.trace.copies.size(); ++i) {
    const trace::CopyRecord &one = a.trace.copies[i], &other = b.trace.copies[i];
    if (one.pass != other.pass || one.attachment != other.attachment || one.type != other.type ||
        a.trace.bytesOf(one) != b.trace.bytesOf(other))
      return "copy " + std::to_string(i) + " of pass " + std::to_string(one.pass);
  }
  if (a.frames.size() != b.frames.size()) return "another number of frames";
  for (std::size_t i = 0; i < a.frames.size(); ++i)
    if (a.frames[i].pixels != b.frames[i].pixels) return "frame " + std::to_string(i);
  return {};
}

struct Scenario {
  const char *program, *scenario;
};

class TapeOf : public testing::TestWithParam<Scenario> {};

TEST_P(TapeOf, IsDrawnAgainBitForBit) {
  const auto [program, scenario] = GetParam();
  const CaptureRun drawn = record(program, scenario, kFrames, taping());
  ASSERT_THAT(drawn.capture.tapeRefused, IsEmpty());
  ASSERT_GT(drawn.capture.trace.copies.size(), 0U);
  const Player player;
  const CaptureRun played = player.play(tape::read(drawn.capture.tape));
  EXPECT_EQ(played.exitCode, 0) << played.errors;
  EXPECT_EQ(lines(played.capture.trace.passes).size(), lines(drawn.capture.trace.passes).size())
      << testing::PrintToString(lines(drawn.capture.trace.passes)) << '\n'
      << testing::PrintToString(lines(played.capture.trace.passes));
  EXPECT_EQ(differenceOf(drawn.capture, played.capture), "");
}

std::string nameOf(const testing::TestParamInfo<Scenario>& info) {
  return std::string(info.param.program) + '_' + info.param.scenario;
}

// Not "draw_buffers": its shader leaves an output unwritten, and what is drawn there is undefined.
INSTANTIATE_TEST_SUITE_P(
    Programs, TapeOf,
    testing::Values(Scenario{"passes", "attachments"}, Scenario{"passes", "same_images"},
                    Scenario{"passes", "clears"}, Scenario{"passes", "levels"},
                    Scenario{"passes", "blit"}, Scenario{"passes", "copies"},
                    Scenario{"passes", "mipmap"}, Scenario{"passes", "uploads"},
                    Scenario{"passes", "deleted"}, Scenario{"passes", "steps"},
                    Scenario{"samples", "ping_pong"}, Scenario{"samples", "added"},
                    Scenario{"samples", "settings"}, Scenario{"samples", "incomplete"},
                    Scenario{"samples", "matrices"}, Scenario{"replaced", "sampled"},
                    Scenario{"replaced", "level"}),
    nameOf);

TEST(Tape, APatchChangesWhatIsDrawn) {
  const CaptureRun drawn = record("samples", "ping_pong", kFrames, taping());
  const tape::Tape tape = tape::read(drawn.capture.tape);
  json patch = json::array();
  for (std::size_t i = 0; i < tape.commands.size(); ++i)
    if (tape.commands[i].at("op") == "draw")
      patch.push_back({{"op", "replace"},
                       {"path", "/" + std::to_string(i) + "/state/viewport"},
                       {"value", {0, 0, 2, 2}}});
  ASSERT_GT(patch.size(), 0U);
  const Player player;
  EXPECT_NE(differenceOf(drawn.capture, player.play(tape, patch).capture), "");
}

TEST(Tape, WhatItCannotHoldIsRefusedByName) {
  EXPECT_THAT(record("passes", "compute", 1, taping()).capture.tapeRefused, HasSubstr("calls gl"));
}

TEST(Tape, OneThatDoesNotFitIsRefused) {
  trace::Request request = taping();
  request.tapeBytes = 4096;
  const CaptureRun run = record("passes", "attachments", kFrames, request);
  EXPECT_THAT(run.capture.tapeRefused, HasSubstr("room for"));
  EXPECT_THAT(run.capture.tape, IsEmpty());
}

TEST(Tape, ThePlayerRefusesWhatMakesNoSense) {
  const CaptureRun drawn = record("samples", "ping_pong", kFrames, taping());
  const tape::Tape good = tape::read(drawn.capture.tape);
  const Player player;
  const auto expectError = [&](const char* op, const char* key, const json& value,
                               const char* why) {
    tape::Tape bad = good;
    for (json& command : bad.commands)
      if (command.at("op") == op) command[key] = value;
    const CaptureRun run = player.play(bad);
    EXPECT_EQ(run.exitCode, 1) << op << ' ' << key;
    EXPECT_THAT(run.errors, HasSubstr(why)) << op << ' ' << key;
  };
  expectError("draw", "op", "explode", "unknown kind: explode");
  expectError("draw", "target", json::object(), "attachments");
  expectError("image", "levels", {{{"level", 0}, {"format", 1}, {"width", -8}}}, "height");
  tape::Tape cut = good;
  cut.blobs.clear();
  EXPECT_THAT(player.play(cut).errors, HasSubstr("no such blob"));
}

} // namespace
} // namespace ggrade::test
