#pragma once
/// \file
/// The reference's frames as people compare them.

#include "rubric/evidence.hpp"

#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace ggrade::grading {

/// Reads and encodes the reference's frames once for all submissions that they are held against.
/// Several threads may ask.
class ReferencePictures {
public:
  struct Frame {
    rubric::RawFrame raw;
    Image image;     ///< RGBA, 0 to 1
    std::string png; ///< data URI
  };

  /// The frames in a folder of the reference's. Throws like `rubric::readFrames`.
  const std::vector<Frame>& of(const std::filesystem::path& folder);

private:
  std::mutex mutex_;
  std::map<std::filesystem::path, std::vector<Frame>> known_;
};

} // namespace ggrade::grading
