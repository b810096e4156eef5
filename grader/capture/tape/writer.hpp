#pragma once
/// \file
/// The tape (replay/tape_format.hpp) as it is written: blobs and commands, one after the other, as
/// far as there is room. Once something can't be recorded whole the tape is refused, with the
/// reason, and nothing more is written: half a tape says nothing.

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace ggrade::capture::tape {

/// Whether a tape is asked for. Set before `main`, and constant from then on.
extern bool isWanted;

/// The frame that is drawn is still to be recorded, and all before it could be.
bool isOpen();

/// The number of a blob with these bytes; equal ones are kept once.
std::uint64_t blob(std::span<const std::byte> bytes);
std::uint64_t blob(const std::string& text);

void command(const nlohmann::json& command);

/// What can't be recorded, in words that go on "the program ...".
void refuse(const std::string& what);

/// Frames that are complete.
void frameEnded();

} // namespace ggrade::capture::tape
