// What the submissions in these folders share; the test puts it into each upload. An attack says on
// standard output what it tried and how that went. "succeeded" stands for what must never happen.
#pragma once

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include <fcntl.h>
#include <unistd.h>

namespace attack {

// Where the grader keeps what is none of a submission's business. The test writes the places in:
// whoever attacks knows the machine.
constexpr char kSource[] = "@SOURCE@";   // the source tree, solutions included
constexpr char kCache[] = "@CACHE@";     // references, rendered hidden scenes
constexpr char kUploads[] = "@UPLOADS@"; // what others have handed in
constexpr char kResults[] = "@RESULTS@"; // what others have got

/// `worked`: it did what it must not; errno tells why it did not.
inline void say(const std::string& what, bool worked) {
  const int error = errno;
  std::printf("attack: %s: %s\n", what.c_str(), worked ? "succeeded" : std::strerror(error));
  std::fflush(stdout);
}

/// Something that harms nobody by itself.
inline void note(const std::string& what) {
  std::printf("attack: %s\n", what.c_str());
  std::fflush(stdout);
}

/// Opens a file and prints what it holds: what must not be read must not be opened, either.
inline void read(const std::string& path) {
  const int file = open(path.c_str(), O_RDONLY | O_NONBLOCK);
  say("read " + path, file >= 0);
  char text[4000];
  const ssize_t length = file >= 0 ? ::read(file, text, sizeof text) : 0;
  if (length > 0) std::fwrite(text, 1, static_cast<std::size_t>(length), stdout);
  if (file >= 0) close(file);
}

/// Makes a file, or empties the one that is there.
inline void write(const std::string& path) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NONBLOCK, 0666);
  say("write " + path, file >= 0);
  if (file >= 0) close(file);
}

} // namespace attack
