#pragma once
/// \file
/// The capture channel as the captured process has it.

#include "capture/channel_reader.hpp"

#include <cstring>
#include <sys/mman.h>

namespace ggrade::channel {

/// All that can be recorded of the first two frames, with so many bytes for copies.
inline trace::Request everything(std::uint64_t copyBytes) {
  trace::Request request{};
  request.passes = 1;
  request.copies = request.windowCopies = request.renderbufferCopies = trace::kAllAttachments;
  request.stepCopies = 1;
  request.copyFrames = 2;
  request.copyBytes = copyBytes;
  return request;
}

class ChildView {
public:
  explicit ChildView(const Channel& channel) : bytes_(totalBytes(channel.plan())) {
    file_ = static_cast<unsigned char*>(
        mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_SHARED, channel.descriptor(), 0));
  }
  ~ChildView() { munmap(file_, bytes_); }
  ChildView(const ChildView&) = delete;
  ChildView& operator=(const ChildView&) = delete;

  Header& header() { return *reinterpret_cast<Header*>(file_); }
  /// Only there if the plan asks for passes.
  trace::Tables& tables() { return *reinterpret_cast<trace::Tables*>(file_ + tablesOffset()); }
  unsigned char* slot(const Plan& plan, std::uint32_t index) {
    return file_ + slotOffset(plan, index);
  }
  unsigned char* copies(const Plan& plan) { return file_ + copiesOffset(plan); }
  void fill(unsigned char value) { std::memset(file_, value, bytes_); }

private:
  std::size_t bytes_;
  unsigned char* file_;
};

} // namespace ggrade::channel
