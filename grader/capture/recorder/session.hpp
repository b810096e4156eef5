#pragma once
/// \file
/// The recorder's own state, and the right to use it.

#include "capture/context_state.hpp"
#include "capture/recorder/images.hpp"
#include "capture/recorder/programs.hpp"
#include "capture/recorder/table_writer.hpp"
#include "capture/recorder/writers.hpp"
#include "trace/records.hpp"

#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace ggrade::capture::recorder {

struct OpenStep {
  bool kept = false;          ///< there is room for it in the table
  trace::StepRecord record{}; ///< but for matrices, samples and pass
  std::uint32_t written = 0;  ///< mask of attachments
  std::vector<GLuint> programs;
  std::vector<trace::SampleRecord> samples;
  std::uint32_t samplesKept = 0; ///< so many of them have room in the table
  std::vector<trace::MatrixRecord> matrices;
  std::vector<std::optional<Matrix>> latest; ///< last recorded value of each of the programs' mat4
};

/// An image that a pass writes to beside its attachments (image stores).
struct OtherWrite {
  Place place;
  std::uint32_t level, layer;
  bool operator==(const OtherWrite&) const = default;
};

struct OpenPass {
  std::uint32_t index = trace::kNone; ///< kNone: the table of passes is full, or it is unseen
  bool isSeen = true;                 ///< began in a frame that is looked at
  trace::PassRecord record{};
  Target target;
  std::vector<OpenStep> steps; ///< the last one is open
  std::vector<OtherWrite> otherWrites;
  trace::ImageRef destination{}; ///< of a copy; the base level of a mipmap generation
  trace::ImageRef source{};      ///< of a copy between images; kind none: the read framebuffer
  struct StepCopy {
    std::uint32_t copy, step; ///< index in the table, index in `steps`
  };
  std::vector<StepCopy> stepCopies;
  std::chrono::nanoseconds start{};
  std::chrono::nanoseconds lastCall{}; ///< when the pass's latest draw or clear returned
};

/// What the recorder keeps for one context. Only the thread that it is current to uses it.
struct Context {
  std::uint32_t id = 0; ///< tells windows apart
  bool compatible = false;
  bool insideBegin = false;
  GLuint framebuffer = 0; ///< ours, to read images through
  std::optional<OpenPass> pass;
};

/// What all contexts share.
struct Shared {
  std::mutex mutex;
  trace::Request request;
  TableWriter tables;
  Writers writers;
  Programs programs;
  std::uint32_t contexts = 0;
  std::uint32_t frame = 0;      ///< the frame that is being drawn
  std::uint32_t seenFrames = 0; ///< before it, that are looked at
  std::uint32_t firstPassOfFrame = 0;
  Shared();
};

/// While it exists, this thread alone records, and the library may call GL: the program's pending
/// error has been put aside, messages are nobody's business, and errors of ours are dropped.
/// Converts to false when there is nothing to record: no context, a frame beyond the plan, inside
/// glBegin or a display list.
class Session {
public:
  Session();
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  explicit operator bool() const { return context_ != nullptr; }
  Context& context() const { return *context_; }
  /// Is the frame that is being drawn one that is looked at?
  bool isSeen() const;
  /// GL has refused a call since the session before.
  bool failed() const { return failed_; }
  Shared& shared() const { return shared_; }
  ContextState& state() const { return *state_; }
  /// Ends the frame: which passes began in it. Also when there is nothing to record now.
  void countFrame(std::uint32_t& firstPass, std::uint32_t& passCount);
  Place placeOf(const trace::ImageRef& image) const;
  Place placeOf(GLuint texture) const;

private:
  Shared& shared_;
  ContextState* state_;
  Context* context_ = nullptr;
  bool failed_ = false;
  std::unique_lock<std::mutex> lock_;
};

// passes.cpp

/// Now, by the clock that passes are timed by (trace::Times); its zero means nothing.
std::chrono::nanoseconds passClock();

/// The open pass that draws into this target; the one before is ended when it draws elsewhere, or
/// when this is a clear and it has drawn.
OpenPass& passFor(Session& session, const Target& target, bool isClear);

/// Begins a pass of its own kind. The caller fills in its images.
OpenPass& beginPass(Session& session, trace::PassKind kind);

/// Makes the copies, and writes everything down. Does nothing without an open pass.
void endPass(Session& session);

/// Makes copies of the attachments in `mask`, as far as they were asked for.
void copyAttachments(Session& session, OpenPass& pass, std::uint32_t mask, std::uint32_t step);

// steps.cpp

/// The open step of the pass for a draw with GL's state of now, or null if none can be recorded.
OpenStep* stepFor(Session& session, OpenPass& pass);

/// Records the mat4 uniforms that have changed since the step's last draw.
void recordMatrices(Session& session, OpenStep& step);

/// The textures that these programs sample now; those beyond what a record's table can hold are
/// counted when the step is written.
std::vector<trace::SampleRecord> currentSamples(Session& session, const OpenPass& pass,
                                                const std::vector<GLuint>& programs,
                                                const trace::StepRecord& state);

/// Adds a step that only says what is read.
void addReadStep(Session& session, OpenPass& pass, std::vector<trace::SampleRecord> samples);

/// The last step has had its last draw.
void endStep(Session& session, OpenPass& pass);

/// Marks images that the programs can write to by image stores as written by the pass.
void noteImageStores(Session& session, OpenPass& pass, const std::vector<GLuint>& programs);

// replacements.cpp

/// Makes the plan's replacements of this pass, which has ended, and answers to them. Leaves GL's
/// state as it was.
void replaceOutputs(const OpenPass& pass);

} // namespace ggrade::capture::recorder
