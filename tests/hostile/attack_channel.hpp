// The memory that a captured program shares with the grader, for those who write lies into it. The
// test puts this and the grader's own description of that memory into uploads that ask for it.
#pragma once

#include "attack.hpp"
#include "channel.hpp"

#include <cstdlib>

#include <sys/mman.h>
#include <sys/stat.h>

namespace attack {

inline void* mapped = MAP_FAILED;

/// Before any library's constructor runs, the descriptor is still open, and the C library does not
/// know its environment yet.
inline void mapChannel(int, char**, char** environment) {
  int file = -1;
  for (; *environment; ++environment) std::sscanf(*environment, "GG_CAPTURE_FD=%d", &file);
  struct stat status {};
  if (fstat(file, &status) == 0)
    mapped =
        mmap(nullptr, std::size_t(status.st_size), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
}
[[gnu::section(".preinit_array"), gnu::used]] static void (*const mapHook)(int, char**,
                                                                           char**) = mapChannel;

inline ggrade::channel::Header* channel() {
  note(mapped != MAP_FAILED ? "found the channel" : "found no channel");
  if (mapped == MAP_FAILED) _exit(1);
  return static_cast<ggrade::channel::Header*>(mapped);
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
