// From any bytes to a tape, and what it and a right one differ in: what was read is written and
// read again as the same, and every patch can be made.
#include "require.hpp"
#include "sample_tape.hpp"

#include "repair/compare.hpp"

#include <cstdint>
#include <stdexcept>

using namespace ggrade;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tape::Tape tape;
  try {
    tape = tape::read(std::as_bytes(std::span(data, size)));
  } catch (const std::runtime_error&) {
    return 0;
  }
  require(tape::write(tape::read(tape::write(tape))) == tape::write(tape));
  repair::Comparison comparison;
  try {
    comparison = repair::compare(tape, sample::reference());
  } catch (const std::exception&) {
    return 0; // as whoever calls it does
  }
  for (const repair::Difference& one : comparison.differences) try {
      comparison.tape.commands.patch(one.patch);
    } catch (const nlohmann::json::exception&) {
      // Of a command that lacks what all have: the player refuses it.
    }
  return 0;
}
