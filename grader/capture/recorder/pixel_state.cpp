#include "capture/recorder/pixel_state.hpp"

#include "capture/recorder/gl_calls.hpp"

#include <iterator>
#include <span>

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

constexpr Setting kUnpackSettings[] = {
    {GL_UNPACK_SWAP_BYTES, 0},   {GL_UNPACK_LSB_FIRST, 0}, {GL_UNPACK_ROW_LENGTH, 0},
    {GL_UNPACK_IMAGE_HEIGHT, 0}, {GL_UNPACK_SKIP_ROWS, 0}, {GL_UNPACK_SKIP_PIXELS, 0},
    {GL_UNPACK_SKIP_IMAGES, 0},  {GL_UNPACK_ALIGNMENT, 1},
};

// Of the compatibility profile.
constexpr Setting kTransferSettings[] = {
    {GL_MAP_COLOR, 0},   {GL_MAP_STENCIL, 0}, {GL_INDEX_SHIFT, 0}, {GL_INDEX_OFFSET, 0},
    {GL_RED_SCALE, 1},   {GL_RED_BIAS, 0},    {GL_GREEN_SCALE, 1}, {GL_GREEN_BIAS, 0},
    {GL_BLUE_SCALE, 1},  {GL_BLUE_BIAS, 0},   {GL_ALPHA_SCALE, 1}, {GL_ALPHA_BIAS, 0},
    {GL_DEPTH_SCALE, 1}, {GL_DEPTH_BIAS, 0},
};

static_assert(std::size(kPackSettings) == PixelState::kStores);
static_assert(std::size(kUnpackSettings) <= PixelState::kStores);
static_assert(std::size(kTransferSettings) == PixelState::kTransfers);

std::span<const Setting> settings(PixelDirection direction) {
  if (direction == PixelDirection::pack) return kPackSettings;
  return kUnpackSettings;
}

GLenum bufferTarget(PixelDirection direction) {
  return direction == PixelDirection::pack ? GL_PIXEL_PACK_BUFFER : GL_PIXEL_UNPACK_BUFFER;
}

} // namespace

PixelState::PixelState(PixelDirection direction)
    : direction_(direction),
      buffer_(number(direction == PixelDirection::pack ? GL_PIXEL_PACK_BUFFER_BINDING
                                                       : GL_PIXEL_UNPACK_BUFFER_BINDING)),
      compatible_(integer(GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT) {
  const auto stores = settings(direction);
  for (std::size_t i = 0; i < stores.size(); ++i) {
    store_[i] = integer(stores[i].name);
    if (store_[i] != stores[i].neutral) gl().pixelStorei(stores[i].name, stores[i].neutral);
  }
  if (buffer_) gl().bindBuffer(bufferTarget(direction), 0);
  for (std::size_t i = 0; compatible_ && i < kTransfers; ++i) {
    const Setting& setting = kTransferSettings[i];
    gl().getFloatv(setting.name, &transfer_[i]);
    gl().pixelTransferf(setting.name, static_cast<GLfloat>(setting.neutral));
  }
}

PixelState::~PixelState() {
  const auto stores = settings(direction_);
  for (std::size_t i = 0; i < stores.size(); ++i)
    if (store_[i] != stores[i].neutral) gl().pixelStorei(stores[i].name, store_[i]);
  if (buffer_) gl().bindBuffer(bufferTarget(direction_), buffer_);
  for (std::size_t i = 0; compatible_ && i < kTransfers; ++i)
    gl().pixelTransferf(kTransferSettings[i].name, transfer_[i]);
}

ReadState::ReadState()
    : framebuffer_(number(GL_READ_FRAMEBUFFER_BINDING)), clamp_(number(GL_CLAMP_READ_COLOR)),
      pack_(PixelDirection::pack) {
  if (clamp_ != GL_FALSE) gl().clampColor(GL_CLAMP_READ_COLOR, GL_FALSE);
}

ReadState::~ReadState() {
  if (clamp_ != GL_FALSE) gl().clampColor(GL_CLAMP_READ_COLOR, clamp_);
  gl().bindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
}

} // namespace ggrade::capture::recorder
