#pragma once
/// \file
/// What the supervisor and its helper program tell each other. The helper starts the command:
/// its `outside` stage sheds root and descriptors and becomes bwrap, its `inside` stage is the
/// first process of the sandbox.

#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace ggrade::sandbox {

/// Folder where the `outside` stage, as root, makes the mounts' sources reachable for the worker's
/// uid: the source number n stands at `kStage`/n, in a mount namespace of its own.
inline constexpr char kStage[] = "/tmp";
/// Where the helper stands inside.
inline constexpr char kHelperInside[] = "/run/ggrade-helper";

/// The supervisor's orders to the helper. Descriptor numbers are -1 where there is none.
struct HelperPlan {
  // For the stage outside.
  std::int64_t parent = 0; ///< pid of the supervisor; another one by then means that it died
  std::int64_t uid = -1;   ///< uid and gid to become; -1 keeps the caller's
  std::vector<std::string> staged;  ///< host paths to put on the stage; as root only
  std::string bwrap;                ///< path of bwrap; empty for Isolation::none
  std::int64_t bwrapArguments = -1; ///< descriptor with bwrap's arguments
  std::vector<std::int64_t> kept;   ///< descriptors that bwrap and the stage inside need

  // For the stage inside.
  std::vector<std::string> arguments;
  std::vector<std::string> environment; ///< NAME=value
  std::string workingDirectory;
  std::vector<std::string> copies; ///< source, destination, source, ...
  std::int64_t report = -1;        ///< HelperReports go here
  std::int64_t lifeline = -1;  ///< its end of file means that the supervisor wants or met the end
  std::int64_t inherited = -1; ///< the one descriptor beyond 0, 1, 2 that the command keeps
  std::vector<std::string> collect; ///< files to hand back after a successful exit
  std::vector<std::int64_t> collectInto;
  std::uint64_t collectLimit = 0; ///< bytes
  std::uint64_t cpuSeconds = 0;
  std::uint64_t addressSpaceBytes = 0;
  std::uint64_t fileBytes = 0;
  std::uint64_t processes = 0; ///< RLIMIT_NPROC, the helper itself included; 0 sets none
};

/// One message of the helper to the supervisor, written to a pipe in one piece.
struct HelperReport {
  enum class Kind : std::uint32_t {
    started,     ///< the command's program runs
    failed,      ///< it could not be started through our fault; `text` says why
    unrunnable,  ///< the file is there, but the system cannot execute it; `text` says why
    exited,      ///< value is the exit code
    signalled,   ///< value is the signal
    collected,   ///< all of them; bit n of value is 1 if file n is executable
    notCollected ///< `text` says why; value is 1 if that is our fault: no room where it goes
  };
  Kind kind = Kind::failed;
  std::int32_t value = 0;
  double wallSeconds = 0; ///< since the start of the command
  char text[400] = {};
};

/// Writes or reads a HelperPlan as strings that end in NUL, in the order of `visit`.
/// `Field` is called with every member in turn.
template <class Plan, class Field> void visit(Plan& plan, Field&& field) {
  field(plan.parent), field(plan.uid), field(plan.staged), field(plan.bwrap);
  field(plan.bwrapArguments), field(plan.kept);
  field(plan.arguments), field(plan.environment), field(plan.workingDirectory), field(plan.copies);
  field(plan.report), field(plan.lifeline), field(plan.inherited);
  field(plan.collect), field(plan.collectInto), field(plan.collectLimit);
  field(plan.cpuSeconds), field(plan.addressSpaceBytes), field(plan.fileBytes),
      field(plan.processes);
}

class PlanWriter {
public:
  std::string bytes;
  void operator()(const std::string& text) { bytes.append(text).push_back('\0'); }
  void operator()(std::int64_t number) { (*this)(std::to_string(number)); }
  void operator()(std::uint64_t number) { (*this)(std::to_string(number)); }
  template <class T> void operator()(const std::vector<T>& list) {
    (*this)(std::uint64_t{list.size()});
    for (const T& item : list) (*this)(item);
  }
};

class PlanReader {
public:
  explicit PlanReader(const std::string& bytes) : bytes_(bytes) {}
  void operator()(std::string& text) {
    text = at_ < bytes_.size() ? bytes_.c_str() + at_ : "";
    at_ += text.size() + 1;
  }
  void operator()(std::int64_t& number) { number = std::strtoll(next().c_str(), nullptr, 10); }
  void operator()(std::uint64_t& number) { number = std::strtoull(next().c_str(), nullptr, 10); }
  template <class T> void operator()(std::vector<T>& list) {
    std::uint64_t size = 0;
    (*this)(size);
    for (; size > 0 && at_ < bytes_.size(); --size) (*this)(list.emplace_back());
  }

private:
  std::string next() {
    std::string text;
    (*this)(text);
    return text;
  }
  const std::string& bytes_;
  std::size_t at_ = 0;
};

/// The plan as bytes. Strings must not hold NUL.
inline std::string encode(const HelperPlan& plan) {
  PlanWriter writer;
  visit(plan, writer);
  return std::move(writer.bytes);
}

/// The plan that `encode` wrote.
inline HelperPlan decode(const std::string& bytes) {
  HelperPlan plan;
  visit(plan, PlanReader(bytes));
  return plan;
}

} // namespace ggrade::sandbox
