#pragma once
/// \file
/// Copies of attachments as a page holds them: pictures to look at, and the exact values.

#include "report/inspect.hpp"
#include "report/inspect_graph.hpp"
#include "trace/picture.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ggrade::report {

/// One copy inside the page.
struct PagePixels {
  const trace::CopyRecord* copy = nullptr;
  std::string picture;   ///< data URI of a PNG; empty: left out
  std::string thumbnail; ///< the same for a card; empty unless asked for
  std::string values;    ///< base64 of `packedValues`; empty: left out
  std::string scale;     ///< what the picture's values mean, see trace/picture.hpp
  double low = 0, high = 1;
  std::optional<trace::DepthScale> depth; ///< when `scale` is "stretched depth by ..."
  std::string range;      ///< "0 to 3.5": of all finite values, alpha apart; "0.25 everywhere"
  std::string notANumber; ///< "12 pixels hold NaN or Inf, the first ..."; empty: none
  bool uniform = false;   ///< every pixel holds the same values
};

struct PagePixelsOfFrame {
  std::vector<PagePixels> copies; ///< of this frame, whole passes first, in the order of the passes
  std::size_t withoutValues = 0, withoutPicture = 0; ///< left out for want of room
};

/// `mains` are the indices (in the trace) of the copies that a card shows.
PagePixelsOfFrame pagePixels(const FrameGraph& graph, const std::vector<std::uint32_t>& mains,
                             const InspectLimits& limits);

/// The bytes of a copy, zlib-compressed after they were put in order for that: byte k of every
/// pixel in one run, each as the difference (modulo 256) to the one before. Row 0 on top, little
/// endian.
std::vector<unsigned char> packedValues(std::span<const std::byte> bytes,
                                        std::size_t bytesPerPixel);

} // namespace ggrade::report
