#include "trace/trace.hpp"

#include "assignment/usage_error.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

#include <fcntl.h>
#include <unistd.h>

namespace ggrade::trace {

namespace fs = std::filesystem;

namespace {

constexpr std::uint32_t kMagic = 0x31544747; // "GGT1"

/// How large records are and how many follow, table after table. A file of another layout than
/// this build's is refused.
struct FileHeader {
  std::uint32_t magic, layout;
  std::uint32_t sizes[6]; ///< of FrameTrace and the records, bytes
  std::uint64_t frames, passes, steps, matrices, samples, copies;
  std::uint32_t passesLost, stepsLost, matricesLost, samplesLost, copiesLost;
  std::uint32_t reserved;
  std::uint64_t pixelBytes; ///< of copies.bin
};

FileHeader headerOf(const Trace& trace, std::uint64_t pixelBytes) {
  return {kMagic,
          kLayoutVersion,
          {sizeof(FrameTrace), sizeof(PassRecord), sizeof(StepRecord), sizeof(MatrixRecord),
           sizeof(SampleRecord), sizeof(CopyRecord)},
          trace.frames.size(),
          trace.passes.size(),
          trace.steps.size(),
          trace.matrices.size(),
          trace.samples.size(),
          trace.copies.size(),
          trace.passesLost,
          trace.stepsLost,
          trace.matricesLost,
          trace.samplesLost,
          trace.copiesLost,
          0,
          pixelBytes};
}

/// Writes a whole file piece by piece. Throws UsageError.
class Out {
public:
  explicit Out(fs::path path)
      : path_(std::move(path)),
        descriptor_(open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600)) {
    if (descriptor_ < 0) fail();
  }
  ~Out() { close(descriptor_); }
  Out(const Out&) = delete;
  Out& operator=(const Out&) = delete;

  void write(const void* data, std::size_t size) {
    const char* at = static_cast<const char*>(data);
    while (size > 0) {
      const ssize_t done = ::write(descriptor_, at, size);
      if (done < 0 && errno == EINTR) continue;
      if (done <= 0) fail();
      at += done;
      size -= static_cast<std::size_t>(done);
    }
  }
  template <typename Record> void write(const std::vector<Record>& records) {
    write(records.data(), records.size() * sizeof(Record));
  }

private:
  [[noreturn]] void fail() const {
    throw UsageError("can't write " + path_.string() + ": " + std::strerror(errno));
  }
  fs::path path_;
  int descriptor_;
};

/// Reads a whole file piece by piece. Throws UsageError.
class In {
public:
  explicit In(fs::path path) : path_(std::move(path)), in_(path_, std::ios::binary) {
    std::error_code error;
    left_ = fs::file_size(path_, error);
    if (!in_ || error) throw UsageError("can't read " + path_.string());
  }
  void read(void* to, std::uint64_t size) {
    if (size > left_ || !in_.read(static_cast<char*>(to), static_cast<std::streamsize>(size)))
      throw UsageError(path_.string() + " is cut off");
    left_ -= size;
  }
  template <typename Record> void read(std::vector<Record>& to, std::uint64_t count) {
    if (count > left_ / sizeof(Record)) throw UsageError(path_.string() + " is cut off");
    to.resize(count);
    read(to.data(), count * sizeof(Record));
  }
  void requireEnd() const {
    if (left_ > 0) throw UsageError(path_.string() + " is longer than it says");
  }

private:
  fs::path path_;
  std::ifstream in_;
  std::uint64_t left_ = 0;
};

bool isWithin(std::uint64_t first, std::uint64_t count, std::uint64_t size) {
  return first <= size && count <= size - first;
}

/// Does every record name what is there? Who reads them relies on it.
bool holdsTogether(const Trace& trace, std::uint64_t pixelBytes) {
  const auto ends = [](const auto& name) { return std::memchr(name, 0, sizeof name) != nullptr; };
  return std::ranges::all_of(trace.frames,
                             [&](const FrameTrace& frame) {
                               return isWithin(frame.firstPass, frame.passCount,
                                               trace.passes.size());
                             }) &&
         std::ranges::all_of(trace.passes,
                             [&](const PassRecord& pass) {
                               return isWithin(pass.firstStep, pass.stepCount, trace.steps.size());
                             }) &&
         std::ranges::all_of(
             trace.steps,
             [&](const StepRecord& step) {
               return step.pass < trace.passes.size() &&
                      isWithin(step.firstMatrix, step.matrixCount, trace.matrices.size()) &&
                      isWithin(step.firstSample, step.sampleCount, trace.samples.size());
             }) &&
         std::ranges::all_of(trace.matrices,
                             [&](const MatrixRecord& matrix) { return ends(matrix.name); }) &&
         std::ranges::all_of(trace.samples,
                             [&](const SampleRecord& sample) {
                               return ends(sample.uniform) && (sample.writer == kNone ||
                                                               sample.writer < trace.passes.size());
                             }) &&
         std::ranges::all_of(trace.copies, [&](const CopyRecord& copy) {
           return copy.pass < trace.passes.size() && copy.attachment < kAttachments &&
                  copy.bytes > 0 && copy.width <= std::uint32_t(Image::kMaxSide) &&
                  copy.height <= std::uint32_t(Image::kMaxSide) &&
                  copy.bytes == std::uint64_t{copy.width} * copy.height *
                                    bytesPerPixel(static_cast<PixelType>(copy.type)) &&
                  isWithin(copy.offset, copy.bytes, pixelBytes);
         });
}

} // namespace

void save(const Trace& trace, const fs::path& folder) {
  std::error_code none;
  fs::create_directories(folder, none);
  Out(folder / "copies.bin").write(trace.pixels);
  const FileHeader header = headerOf(trace, trace.pixels.size());
  Out out(folder / "trace.bin");
  out.write(&header, sizeof header);
  out.write(trace.frames);
  out.write(trace.passes);
  out.write(trace.steps);
  out.write(trace.matrices);
  out.write(trace.samples);
  out.write(trace.copies);
}

Trace load(const fs::path& folder) {
  const fs::path path = folder / "trace.bin";
  Trace trace;
  if (!fs::exists(path)) return trace;
  In in(path);
  FileHeader header{};
  in.read(&header, sizeof header);
  const FileHeader own = headerOf(trace, 0);
  if (header.magic != kMagic || header.layout != own.layout ||
      std::memcmp(header.sizes, own.sizes, sizeof own.sizes) != 0)
    throw UsageError(path.string() + " was written by another version of this tool: remove it");
  in.read(trace.frames, header.frames);
  in.read(trace.passes, header.passes);
  in.read(trace.steps, header.steps);
  in.read(trace.matrices, header.matrices);
  in.read(trace.samples, header.samples);
  in.read(trace.copies, header.copies);
  in.requireEnd();
  trace.passesLost = header.passesLost;
  trace.stepsLost = header.stepsLost;
  trace.matricesLost = header.matricesLost;
  trace.samplesLost = header.samplesLost;
  trace.copiesLost = header.copiesLost;
  trace.pixelFile = folder / "copies.bin";
  std::error_code error;
  if (fs::file_size(trace.pixelFile, error) != header.pixelBytes || error)
    throw UsageError(trace.pixelFile.string() + " is cut off");
  if (!holdsTogether(trace, header.pixelBytes))
    throw UsageError(path.string() + " is damaged: remove it");
  return trace;
}

} // namespace ggrade::trace
