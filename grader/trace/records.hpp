#pragma once
/// \file
/// What the recorder writes down of a run: passes, their steps, the matrices and textures that each
/// step used, and copies of what the passes drew.
///
/// A **pass** is a run of draws and clears into the same images. It ends when the attachments
/// (image, level, layer) or draw buffers change, at a clear after draws, at any blit, copy, mipmap
/// generation or compute shader, when one of its images is uploaded to or deleted, when its context
/// is no more current, and at a swap; blits, copies, mipmap generations and compute shaders are
/// passes of their own. Within a pass, a **step** is a run of draws with equal program, equal
/// sampled textures and settings of these, and equal state: all that StepRecord has but `mode`.
///
/// Plain data of fixed size: the records travel through shared memory, are checked by
/// channel_reader, and are used as they are afterwards. Names such as `format` hold OpenGL's own
/// numbers (GL_RGBA16F); `glName` (trace.hpp) prints them.

#include <cstdint>
#include <type_traits>

namespace ggrade::trace {

/// Of everything on this page: raise it with any change, so that recordings that were kept are made
/// again.
inline constexpr std::uint32_t kLayoutVersion = 3;

inline constexpr std::uint32_t kNone = 0xffffffff; ///< no such pass, layer, ...

/// Attachments are numbered: 0 to 7 colour, then depth and stencil. Bit masks use the same numbers.
inline constexpr std::uint32_t kColors = 8;
inline constexpr std::uint32_t kDepth = 8;
inline constexpr std::uint32_t kStencil = 9;
inline constexpr std::uint32_t kAttachments = 10;
inline constexpr std::uint32_t kAllAttachments = (1U << kAttachments) - 1;

// Most that is recorded of a run; what goes beyond is counted.
inline constexpr std::uint32_t kMaxPasses = 4096;
inline constexpr std::uint32_t kMaxSteps = 8192;
inline constexpr std::uint32_t kMaxMatrices = 32768;
inline constexpr std::uint32_t kMaxSamples = 16384;
inline constexpr std::uint32_t kMaxCopies = 8192;
inline constexpr std::uint32_t kMaxMatricesOfStep = 256; ///< the first draws' of a step

/// By which clock passes are timed.
enum class Times : std::uint32_t {
  none = 0,
  wall,
  processor ///< of the thread that draws: what else the machine does is not in it
};
enum class PassKind : std::uint32_t { draw = 1, blit, copy, mipmap, imageStore };
enum class ImageKind : std::uint32_t { none = 0, window, texture, renderbuffer };

/// How the pixels of a copy are stored: components and their type. Row 0 at the bottom in shared
/// memory, on top everywhere else.
enum class PixelType : std::uint32_t {
  u8x4 = 1, ///< RGBA, 0 to 255 stands for 0 to 1 (of an sRGB image: decoded to linear, then f32x4)
  f16x4,
  f32x4,
  f32x1, ///< depth, 0 to 1 as stored
  u8x1,  ///< stencil
  i32x4,
  u32x4,
};

/// A place that is drawn into or read from.
struct ImageRef {
  std::uint32_t kind;   ///< ImageKind
  std::uint32_t name;   ///< GL's name of the texture or renderbuffer; 0 for the window
  std::uint32_t target; ///< GL_TEXTURE_2D, ...; 0 unless a texture
  std::uint32_t level;
  std::uint32_t layer;  ///< or cube face; kNone: not layered, or all layers
  std::uint32_t format; ///< internal format, such as GL_RGBA16F
  std::uint32_t width;  ///< pixels of that level
  std::uint32_t height;
  std::uint32_t samples; ///< 0 or 1: not multisampled
};

/// Is it the same place that is drawn into: image, level and layer?
inline bool sameImage(const ImageRef& a, const ImageRef& b) {
  return a.kind == b.kind && a.name == b.name && a.level == b.level && a.layer == b.layer;
}

struct PassRecord {
  std::uint32_t frame;
  std::uint32_t kind;        ///< PassKind
  std::uint32_t framebuffer; ///< GL's name; 0 is the window. kNone where none takes part (mipmap)
  std::uint32_t status;      ///< GL_FRAMEBUFFER_COMPLETE, or why it isn't
  /// All that is attached, drawn into or not; the rest has kind none. Of a copy or mipmap
  /// generation (its first level): what is written, colour as color0. Of a compute shader: the
  /// images that it can write, as color0 and on.
  ImageRef images[kAttachments];
  std::uint32_t drawBuffers; ///< mask of the colour attachments that are draw buffers
  /// Of draws: the colour attachment that each of the fragment shader's outputs goes to, by
  /// location; kColors or more: none.
  std::uint8_t attachmentOfOutput[kColors];
  std::uint32_t cleared; ///< mask of attachments that a clear of this pass covered
  std::uint32_t written; ///< mask of attachments that clears or draws can have changed
  float clearColor[4];   ///< of the last clear of colour
  float clearDepth;
  std::uint32_t clearStencil;
  /// x, y, width, height at the first draw (clear, if there is none); of a blit: what it fills
  std::int32_t viewport[4];
  std::uint32_t draws;
  std::uint32_t firstStep; ///< index in the table of steps
  std::uint32_t stepCount;
  std::uint64_t vertices; ///< drawn, instances included; indirect draws are not counted
  /// Time from its first to its last call, and until GL has done it all, by the clock that was
  /// asked for; 0 without one.
  double seconds;
};

struct StencilFace {
  std::uint32_t func, ref, valueMask, writeMask, fail, depthFail, depthPass;
};

struct StepRecord {
  std::uint32_t pass;
  std::uint32_t program;
  std::uint32_t mode; ///< of the first draw: GL_TRIANGLES, ...
  std::uint32_t draws;
  std::uint64_t vertices;
  std::uint32_t cullFace;  ///< 0: off, else GL_BACK, GL_FRONT, GL_FRONT_AND_BACK
  std::uint32_t frontFace; ///< GL_CCW or GL_CW
  std::uint32_t depthTest; ///< 0: off, else the function (GL_LESS, ...)
  std::uint32_t depthWrite;
  std::uint32_t depthClamp;
  std::uint32_t blend; ///< 1: on for draw buffer 0
  std::uint32_t blendSource, blendDestination, blendEquation;
  std::uint32_t blendSourceAlpha, blendDestinationAlpha, blendEquationAlpha;
  float blendColor[4];
  std::uint32_t stencilTest;
  StencilFace stencil[2];  ///< front, back
  std::uint32_t colorMask; ///< bits 0 to 3: red, green, blue, alpha of draw buffer 0
  std::uint32_t scissorTest;
  std::int32_t scissor[4];
  std::int32_t viewport[4];
  std::uint32_t clipDistances; ///< mask of the enabled GL_CLIP_DISTANCEi
  std::uint32_t polygonOffset; ///< 1: on for filled polygons
  float polygonOffsetFactor, polygonOffsetUnits;
  std::uint32_t framebufferSrgb;
  std::uint32_t rasterizerDiscard;
  std::uint32_t
      outputs; ///< mask of the outputs that the fragment shader writes; the rest is undefined
  std::uint32_t firstMatrix, matrixCount; ///< in the table of matrices
  std::uint32_t firstSample, sampleCount; ///< in the table of samples
};

/// A mat4 uniform of the program at one draw, members of uniform blocks included. One that doesn't
/// change from draw to draw is recorded once, at the first.
struct MatrixRecord {
  std::uint32_t draw; ///< counted from 0 within the step
  char name[60];      ///< of the uniform, ends in 0
  float values[16];   ///< column by column, as OpenGL has it
};

/// A texture that a step's program can sample. A blit, copy or mipmap pass has one step, without
/// draws, whose samples are what it reads.
struct SampleRecord {
  std::uint32_t unit;
  ImageRef image; ///< of the base level
  /// The pass that drew it last, maybe of an earlier frame; kNone: uploaded, or drawn in a frame
  /// that nobody looks at.
  std::uint32_t writer;
  std::uint32_t feedback;   ///< 1: it is also drawn into by this pass
  std::uint32_t incomplete; ///< 1: not a complete texture; sampling gives (0,0,0,1)
  std::uint32_t sampler; ///< name of the sampler object whose settings count; 0: the texture's own
  std::uint32_t minFilter, magFilter, wrapS, wrapT;
  std::uint32_t compareMode, compareFunc;
  char uniform[60]; ///< name of the sampler in the shader, ends in 0
};

/// What an attachment held after a pass (or step). Multisamples are resolved; of an attachment with
/// all its layers the first is copied.
struct CopyRecord {
  std::uint32_t pass;
  std::uint32_t step;       ///< kNone: after the whole pass
  std::uint32_t attachment; ///< 0 to 7 colour, kDepth, kStencil
  std::uint32_t type;       ///< PixelType
  std::uint32_t width, height;
  std::uint64_t offset; ///< in bytes, from the start of all copies
  std::uint64_t bytes;
};

/// What the judging side wants recorded.
struct Request {
  std::uint32_t passes; ///< 1: record passes. 0: nothing at all is recorded.
  std::uint32_t copies; ///< mask of attachments to copy after every pass that can have changed them
  std::uint32_t windowCopies;       ///< mask of those of them that are copied of the window, too
  std::uint32_t renderbufferCopies; ///< mask of those that are copied of renderbuffers, too
  std::uint32_t stepCopies;         ///< 1: also after every step
  std::uint32_t copyFrames;         ///< copies are made in the first so many seen frames
  std::uint32_t times;              ///< Times: GL is waited for at both ends of every pass
  std::uint32_t tapeFrames;         ///< the first so many frames go on a tape (tape_format.hpp)
  std::uint64_t copyBytes;          ///< room for copies; what doesn't fit is counted
  std::uint64_t tapeBytes;          ///< room for the tape; one that doesn't fit is refused
};

/// How much of each table is filled, and how much was lost because a table was full.
struct Counts {
  std::uint32_t passes, steps, matrices, samples, copies;
  std::uint32_t passesLost, stepsLost, matricesLost, samplesLost, copiesLost;
  std::uint64_t copyBytes; ///< used
};

struct Tables {
  Counts counts;
  PassRecord passes[kMaxPasses];
  StepRecord steps[kMaxSteps];
  MatrixRecord matrices[kMaxMatrices];
  SampleRecord samples[kMaxSamples];
  CopyRecord copies[kMaxCopies];
};

static_assert(std::is_trivially_copyable_v<Tables>);

constexpr std::uint64_t bytesPerPixel(PixelType type) {
  switch (type) {
  case PixelType::u8x1:
    return 1;
  case PixelType::u8x4:
  case PixelType::f32x1:
    return 4;
  case PixelType::f16x4:
    return 8;
  case PixelType::f32x4:
  case PixelType::i32x4:
  case PixelType::u32x4:
    return 16;
  }
  return 0;
}

} // namespace ggrade::trace
