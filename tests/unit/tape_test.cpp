// A tape as bytes: what was written comes back, and what a stranger writes is refused by name.

#include "replay/tape.hpp"
#include "replay/tape_format.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <cstring>

using namespace ggrade;
using nlohmann::json;
using testing::HasSubstr;

namespace {

std::vector<std::byte> bytesOf(const std::string& text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

std::vector<std::byte> entry(std::uint32_t kind, const std::vector<std::uint8_t>& body,
                             std::uint64_t claimed) {
  const tape::EntryHead head{kind, 0, claimed};
  std::vector<std::byte> all(sizeof head);
  std::memcpy(all.data(), &head, sizeof head);
  for (const std::uint8_t one : body) all.push_back(std::byte(one));
  all.resize(sizeof head + tape::padded(body.size()));
  return all;
}

std::vector<std::byte> command(const json& one) {
  const std::vector<std::uint8_t> cbor = json::to_cbor(one);
  return entry(2, cbor, cbor.size());
}

void expectRefused(const std::vector<std::byte>& bytes, const char* why) {
  try {
    tape::read(bytes);
    ADD_FAILURE() << "was read: " << why;
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr(why));
  }
}

TEST(Tape, ComesBackAsItWasWritten) {
  tape::Tape tape;
  tape.blobs = {bytesOf("texels"), {}, bytesOf("12345678")};
  tape.commands = {{{"op", "clear"}, {"color", {0.1F, -0.0F, 1e-30F}}, {"mask", 16640}},
                   {{"op", "swap"}}};
  const tape::Tape again = tape::read(tape::write(tape));
  EXPECT_EQ(again.blobs, tape.blobs);
  EXPECT_EQ(again.commands, tape.commands);
  EXPECT_EQ(again.commands[0]["color"][0].get<float>(), 0.1F);
  EXPECT_TRUE(std::signbit(again.commands[0]["color"][1].get<float>()));
}

TEST(Tape, NotANumberStaysOne) {
  tape::Tape tape;
  tape.commands = {{{"op", "draw"}, {"values", {std::nan(""), HUGE_VAL}}}};
  const json values = tape::read(tape::write(tape)).commands[0]["values"];
  EXPECT_TRUE(std::isnan(values[0].get<float>()));
  EXPECT_TRUE(std::isinf(values[1].get<float>()));
}

TEST(Tape, RefusesWhatIsCutOff) {
  std::vector<std::byte> bytes = command({{"op", "swap"}});
  bytes.resize(bytes.size() - tape::kAlign);
  expectRefused(bytes, "larger than what is left");
  bytes.resize(5);
  expectRefused(bytes, "ends within an entry's head");
}

TEST(Tape, RefusesSizesThatWrapRound) {
  expectRefused(entry(1, {1, 2, 3}, ~std::uint64_t{0}), "larger than what is left");
  expectRefused(entry(1, {1, 2, 3}, ~std::uint64_t{0} - 6), "larger than what is left");
}

TEST(Tape, RefusesWhatIsNoCommand) {
  expectRefused(entry(3, {}, 0), "unknown kind");
  expectRefused(command(json::array({1, 2})), "without op");
  expectRefused(command({{"op", 7}}), "without op");
  expectRefused(entry(2, {0xff, 0xff}, 2), "no CBOR");
  expectRefused(command({{"op", "swap"}, {"b", json::binary({1, 2})}}), "no CBOR");
}

TEST(Tape, RefusesWhatIsNestedWithoutEnd) {
  // A megabyte of "array of one": read one in another it would be a million calls deep.
  expectRefused(entry(2, std::vector<std::uint8_t>(1 << 20, 0x81), 1 << 20), "no CBOR");
}

TEST(Tape, RefusesCountsThatNoMemoryHolds) {
  expectRefused(entry(2, {0xbb, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xf0}, 9), "no CBOR");
  expectRefused(entry(2, {0x9b, 0x7f, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff}, 9), "no CBOR");
}

TEST(Tape, RefusesMoreThanItsLimits) {
  std::vector<std::byte> bytes;
  for (std::uint32_t i = 0; i <= tape::kMaxBlobs; ++i) {
    const auto one = entry(1, {}, 0);
    bytes.insert(bytes.end(), one.begin(), one.end());
  }
  expectRefused(bytes, "more than 20000 blobs");
  const auto many = command({{"op", "draw"}, {"values", std::vector<int>(1'000'001, 0)}});
  expectRefused(many, "no CBOR");
}

} // namespace
