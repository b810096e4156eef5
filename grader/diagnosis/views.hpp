#pragma once
/// \file
/// What a run showed in a scene, reduced to what tells one mistake from another: the window's
/// frames and the pictures that passes of the first frame drew into textures.

#include "trace/trace.hpp"

#include <compare>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace ggrade::diagnosis {

/// Pictures are compared with at most so many pixels on their longer side.
inline constexpr int kSide = 160;

/// Which of a frame's pictures one is, found by what it is and never by a name or a place in the
/// order of passes, so that the same pass has the same slot in any program.
struct Slot {
  bool depth = false;      ///< a depth texture
  bool mesh = false;       ///< a mesh was drawn into it, not a full-screen quad
  std::int32_t octave = 0; ///< of quads: how often its height was halved from the window's
  std::int32_t nth = 0;    ///< among the frame's with all else equal, from 0
  bool stencil = false;    ///< the stencil buffer at the frame's end, if it isn't all 0

  friend auto operator<=>(const Slot&, const Slot&) = default;
};

/// "the depth texture that objects are drawn into", "the texture without objects, at 1/4 of the
/// window's size".
std::string describe(const Slot& slot);

/// A pass's picture, see `reduced`. Depth is stretched as `stretchedDepth` says; of a stencil it
/// is 0.5 + n / 32 for a count n from -16, which is 240 in 8 bits that wrap, to 16.
struct PassView {
  Slot slot;
  std::int32_t width = 0, height = 0; ///< as it was drawn, pixels
  /// 3 channels, or 1 of depth. At a fraction of the window's size its mean is always the same.
  Image picture;
  /// Where it was drawn, in the trace that it was taken from; kNone: not known (any more).
  std::uint32_t pass = trace::kNone, attachment = 0;
};

/// One scene. Passes stand in the order in which they were made.
struct SceneViews {
  std::vector<PassView> passes;       ///< of the first frame
  std::vector<Image> windows;         ///< by frame, 3 channels
  std::int32_t width = 0, height = 0; ///< of the first frame, pixels

  const PassView* find(const Slot& slot) const;
};

/// By scene.
using Run = std::vector<SceneViews>;

/// The views of what a program showed. `frames` are RGB, as many as came. Every texture that a pass
/// of the first frame drew and that was copied becomes a PassView, sampled later or not: what a
/// program drew and forgot to use tells as much. With `stencil`, so does the stencil buffer. Throws
/// UsageError when the trace's copies can't be read.
SceneViews views(const std::vector<Image>& frames, const trace::Trace& trace, bool stencil = false);

/// The picture with its longer side at most `kSide`, each pixel the mean of those that it covers.
/// Values from 0 to 1 stay, larger ones are compressed (1 + log2 v, at most 17), negative ones end
/// at -1; NaN becomes -1. `channels` are kept.
Image reduced(const Image& image, int channels);
/// The mean colours at another size, for pictures that were made at different sizes.
Image resized(const Image& image, int width, int height);

/// `trace::evenDepth` of each value; -1 for one that is no number.
Image stretchedDepth(const Image& depth);

/// Writes views in 16 bits a value, compressed. A picture of `base` (same slot or frame) that looks
/// the same in these bits is not written again. Throws UsageError when the disk is full.
void save(const SceneViews& views, const SceneViews* base, const std::filesystem::path& file);
/// Reads them back. Throws UsageError for a file that is cut off.
SceneViews load(const std::filesystem::path& file, const SceneViews* base);

} // namespace ggrade::diagnosis
