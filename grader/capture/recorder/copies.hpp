#pragma once
/// \file
/// Reads images back as they are stored, leaving the program's state as it was.

#include "capture/recorder/pixel_state.hpp"
#include "capture/recorder/table_writer.hpp"
#include "trace/records.hpp"

#include <GL/gl.h>

namespace ggrade::capture::recorder {

/// GL's words for pixels in memory.
struct PixelFormat {
  GLenum format, type;
};
PixelFormat pixelFormat(trace::PixelType type);

/// Reads images in one go. The context must be current, its errors collected and its messages
/// silenced.
class ImageReader {
public:
  /// `framebuffer` is a framebuffer object of ours in this context, made when it is 0.
  explicit ImageReader(GLuint& framebuffer);

  /// Copies the described image's colour, depth or stencil, whichever `record.attachment` says,
  /// into the tables. `record` has pass, step and attachment. Index of the copy; kNone, and counted
  /// as lost, when it can't be read or there is no room.
  std::uint32_t copy(const trace::ImageRef& image, trace::CopyRecord record, TableWriter& tables);

private:
  ReadState state_;
  GLuint framebuffer_;
};

} // namespace ggrade::capture::recorder
