// The memory that a captured program shares with the grader, for those who write lies into it. The
// test puts this and the grader's own description of that memory into uploads that ask for it.
#pragma once

#include "attack.hpp"
#include "channel.hpp"

#include <cinttypes>
#include <cstdlib>

namespace attack {

/// Null before the capture library has mapped it.
inline ggrade::channel::Header* channel() {
  std::FILE* const maps = std::fopen("/proc/self/maps", "r");
  char line[512];
  std::uintptr_t address = 0;
  while (maps && std::fgets(line, sizeof line, maps))
    if (std::strstr(line, "ggrade-capture")) std::sscanf(line, "%" SCNxPTR, &address);
  if (maps) std::fclose(maps);
  note(address ? "found the channel" : "found no channel");
  if (!address) _exit(1);
  return reinterpret_cast<ggrade::channel::Header*>(address);
}

inline ggrade::trace::Tables& tables(ggrade::channel::Header* header) {
  return *reinterpret_cast<ggrade::trace::Tables*>(reinterpret_cast<char*>(header) +
                                                   ggrade::channel::tablesOffset());
}

inline unsigned char* pixels(ggrade::channel::Header* header, std::uint32_t frame) {
  return reinterpret_cast<unsigned char*>(header) +
         ggrade::channel::slotOffset(header->plan, frame);
}

/// Ends the program before anything of the framework or the capture library can.
[[noreturn]] inline void end() {
  std::fflush(stdout);
  _exit(0);
}

} // namespace attack
