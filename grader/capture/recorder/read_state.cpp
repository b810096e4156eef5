#include "capture/recorder/read_state.hpp"

#include "capture/recorder/gl_calls.hpp"

#include <iterator>

namespace ggrade::capture::recorder {
namespace {

struct Setting {
  GLenum name;
  GLint neutral;
};

constexpr GLenum kPackInvert = 0x8758; // GL_PACK_INVERT_MESA

constexpr Setting kPackSettings[] = {
    {GL_PACK_SWAP_BYTES, 0},   {GL_PACK_LSB_FIRST, 0}, {GL_PACK_ROW_LENGTH, 0},
    {GL_PACK_IMAGE_HEIGHT, 0}, {GL_PACK_SKIP_ROWS, 0}, {GL_PACK_SKIP_PIXELS, 0},
    {GL_PACK_SKIP_IMAGES, 0},  {GL_PACK_ALIGNMENT, 1}, {kPackInvert, 0},
};

// Of the compatibility profile.
constexpr Setting kTransferSettings[] = {
    {GL_MAP_COLOR, 0},   {GL_MAP_STENCIL, 0}, {GL_INDEX_SHIFT, 0}, {GL_INDEX_OFFSET, 0},
    {GL_RED_SCALE, 1},   {GL_RED_BIAS, 0},    {GL_GREEN_SCALE, 1}, {GL_GREEN_BIAS, 0},
    {GL_BLUE_SCALE, 1},  {GL_BLUE_BIAS, 0},   {GL_ALPHA_SCALE, 1}, {GL_ALPHA_BIAS, 0},
    {GL_DEPTH_SCALE, 1}, {GL_DEPTH_BIAS, 0},
};

static_assert(std::size(kPackSettings) == ReadState::kPacks);
static_assert(std::size(kTransferSettings) == ReadState::kTransfers);

} // namespace

ReadState::ReadState()
    : framebuffer_(number(GL_READ_FRAMEBUFFER_BINDING)),
      buffer_(number(GL_PIXEL_PACK_BUFFER_BINDING)), clamp_(number(GL_CLAMP_READ_COLOR)),
      compatible_(integer(GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT) {
  for (std::size_t i = 0; i < kPacks; ++i) {
    const Setting& setting = kPackSettings[i];
    pack_[i] = integer(setting.name);
    if (pack_[i] != setting.neutral) gl().pixelStorei(setting.name, setting.neutral);
  }
  if (buffer_) gl().bindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  if (clamp_ != GL_FALSE) gl().clampColor(GL_CLAMP_READ_COLOR, GL_FALSE);
  for (std::size_t i = 0; compatible_ && i < kTransfers; ++i) {
    const Setting& setting = kTransferSettings[i];
    gl().getFloatv(setting.name, &transfer_[i]);
    gl().pixelTransferf(setting.name, static_cast<GLfloat>(setting.neutral));
  }
}

ReadState::~ReadState() {
  for (std::size_t i = 0; i < kPacks; ++i) {
    const Setting& setting = kPackSettings[i];
    if (pack_[i] != setting.neutral) gl().pixelStorei(setting.name, pack_[i]);
  }
  if (buffer_) gl().bindBuffer(GL_PIXEL_PACK_BUFFER, buffer_);
  if (clamp_ != GL_FALSE) gl().clampColor(GL_CLAMP_READ_COLOR, clamp_);
  for (std::size_t i = 0; compatible_ && i < kTransfers; ++i)
    gl().pixelTransferf(kTransferSettings[i].name, transfer_[i]);
  gl().bindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
}

} // namespace ggrade::capture::recorder
