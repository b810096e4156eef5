#include "capture/tape/writer.hpp"

#include "capture/channel_writer.hpp"
#include "replay/tape_format.hpp"

#include <algorithm>
#include <cstring>
#include <map>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace ggrade::capture::tape {
namespace {

/// One context's, on one thread: a program that draws with several is refused (calls.cpp).
class Writer {
public:
  Writer() : room_(plan()->trace.tapeBytes), to_(tapeRoom()) {}

  bool isOpen() const { return !refused_ && frames_ < plan()->trace.tapeFrames; }

  std::uint64_t blob(std::span<const std::byte> bytes) {
    const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
    const auto [at, isNew] = known_.try_emplace({hash.low64, hash.high64}, blobs_);
    if (!isNew) return at->second;
    if (blobs_ >= ggrade::tape::kMaxBlobs) refuse("uses more than 20000 different buffers");
    append(ggrade::tape::EntryKind::blob, bytes);
    return blobs_++;
  }

  void command(const nlohmann::json& command) {
    if (++commands_ > ggrade::tape::kMaxCommands) refuse("draws more than 20000 times");
    const std::vector<std::uint8_t> bytes = nlohmann::json::to_cbor(command);
    append(ggrade::tape::EntryKind::command, std::as_bytes(std::span(bytes)));
  }

  void refuse(const std::string& what) {
    if (refused_) return;
    refused_ = true;
    writeTapeRefused(what.c_str());
  }

  void frameEnded() { ++frames_; }

private:
  void append(ggrade::tape::EntryKind kind, std::span<const std::byte> bytes) {
    const ggrade::tape::EntryHead head{static_cast<std::uint32_t>(kind), 0, bytes.size()};
    const std::uint64_t all = sizeof head + ggrade::tape::padded(bytes.size());
    if (all > room_ - used_) refuse("draws with more data than a tape has room for");
    if (refused_) return;
    std::memcpy(to_ + used_, &head, sizeof head);
    if (!bytes.empty()) std::memcpy(to_ + used_ + sizeof head, bytes.data(), bytes.size());
    used_ += all;
    writeTapeBytes(used_);
  }

  const std::uint64_t room_;
  std::byte* const to_;
  std::uint64_t used_ = 0;
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::uint64_t> known_;
  std::uint64_t blobs_ = 0;
  std::uint64_t commands_ = 0;
  std::uint32_t frames_ = 0;
  bool refused_ = false;
};

/// Never destroyed: the program's own destructors may still call GL.
Writer& writer() {
  static Writer* const instance = new Writer;
  return *instance;
}

} // namespace

bool isWanted = false;

bool isOpen() {
  return isWanted && writer().isOpen();
}

std::uint64_t blob(std::span<const std::byte> bytes) {
  return writer().blob(bytes);
}

std::uint64_t blob(const std::string& text) {
  return blob(std::as_bytes(std::span(text)));
}

void command(const nlohmann::json& command) {
  writer().command(command);
}

void refuse(const std::string& what) {
  writer().refuse(what);
}

void frameEnded() {
  if (isWanted) writer().frameEnded();
}

} // namespace ggrade::capture::tape
