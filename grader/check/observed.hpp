#pragma once
/// \file
/// What a run tells without a look at its pictures: the state that OpenGL was in, what the frame
/// doctor found, what samplers read, where the frustum lies.

#include "capture/channel_reader.hpp"
#include "check/expected.hpp"

#include <set>
#include <string>
#include <vector>

namespace ggrade::check {

struct Observed {
  std::vector<std::string> faults;
  std::string guess; ///< vague: any known mistake says more
  /// In whose lines a fault lies; empty: that isn't known. One is sure of it, as a call that fails
  /// at a line is; a state is often left by another.
  std::string todo;
  bool isSure = false;
  /// In whose lines stands what software draws right and a graphics card doesn't; empty: nothing
  /// does.
  std::string cardTodo;
  /// Do `faults` hold more than what samplers read, of which known mistakes say more?
  bool isState = false;
  /// Is `todo` whose matrices they are? Others may be drawn with.
  bool isFrustum = false;
  std::string misread;    ///< a sampler that reads another texture than it should; may be empty
  bool isStorage = false; ///< a texture that is read has another size than in the reference
};

/// Before what the frame doctor says.
std::string doctorsPrefix();

/// What the frame doctor has found, without its prefix and its guesses.
std::vector<std::string> doctorsFindings(const std::vector<std::string>& messages);

/// Takes the doctor's guesses about samplers that have nothing to read after `step` TODOs, or
/// nothing of this part's, out of the program's messages.
void dropPointless(std::vector<std::string>& messages, const Expected& expected, std::size_t step);

/// Of the public scene.
///   step: TODOs that the program should have done;  messages: what it and OpenGL said
///   captured: with the lines of calls that failed;  todos: of all parts
///   folder: the student's files
Observed observe(const Expected& expected, std::size_t step, const trace::Trace& trace,
                 const std::vector<std::string>& messages,
                 const std::vector<channel::CapturedMessage>& captured,
                 const std::vector<std::string>& todos, const std::filesystem::path& folder);

/// What the doctor has found in a scene whose pictures are the first that are wrong, where the
/// public one tells nothing: a size that is typed in, for instance.
void observeElsewhere(Observed& observed, const Expected& expected,
                      const std::vector<std::string>& findings,
                      const std::vector<std::string>& todos, const std::filesystem::path& folder);

/// The TODO with which this sampler is read first; empty: it is none of this part's.
std::string readerOf(const Expected& expected, const std::string& sampler);

/// The TODOs with which what draws the window begins to read one of its samplers.
std::set<std::string> bindingForTheWindow(const Expected& expected, std::size_t step,
                                          const trace::Trace& trace);

/// Of files that a compiler may misread: the second byte of some characters of Shift_JIS is a
/// backslash, which joins two lines. Names all, after the place of the first; empty: there are
/// none.
std::string wrongEncoding(const Assignment& assignment, const std::filesystem::path& folder);

} // namespace ggrade::check
