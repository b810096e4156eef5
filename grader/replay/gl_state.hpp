#pragma once
/// \file
/// The parts of OpenGL's state that are switched on and off, by the names that a tape gives them,
/// and the shapes of uniforms. What is recorded and what is played goes by the same lists.

#include <GL/gl.h>
#include <GL/glext.h>

#include <cstdint>
#include <string>

namespace ggrade::tape {

struct Switch {
  const char* name;
  GLenum capability;
};

inline constexpr Switch kSwitches[] = {
    {"cull", GL_CULL_FACE},
    {"depthTest", GL_DEPTH_TEST},
    {"depthClamp", GL_DEPTH_CLAMP},
    {"stencilTest", GL_STENCIL_TEST},
    {"scissorTest", GL_SCISSOR_TEST},
    {"polygonOffsetFill", GL_POLYGON_OFFSET_FILL},
    {"polygonOffsetLine", GL_POLYGON_OFFSET_LINE},
    {"polygonOffsetPoint", GL_POLYGON_OFFSET_POINT},
    {"framebufferSrgb", GL_FRAMEBUFFER_SRGB},
    {"rasterizerDiscard", GL_RASTERIZER_DISCARD},
    {"multisample", GL_MULTISAMPLE},
    {"sampleAlphaToCoverage", GL_SAMPLE_ALPHA_TO_COVERAGE},
    {"sampleAlphaToOne", GL_SAMPLE_ALPHA_TO_ONE},
    {"sampleCoverage", GL_SAMPLE_COVERAGE},
    {"sampleMask", GL_SAMPLE_MASK},
    {"sampleShading", GL_SAMPLE_SHADING},
    {"programPointSize", GL_PROGRAM_POINT_SIZE},
    {"primitiveRestart", GL_PRIMITIVE_RESTART},
    {"primitiveRestartFixedIndex", GL_PRIMITIVE_RESTART_FIXED_INDEX},
    {"colorLogicOp", GL_COLOR_LOGIC_OP},
    {"dither", GL_DITHER},
    {"lineSmooth", GL_LINE_SMOOTH},
    {"polygonSmooth", GL_POLYGON_SMOOTH},
    {"seamlessCubeMap", GL_TEXTURE_CUBE_MAP_SEAMLESS},
    {"clipDistance0", GL_CLIP_DISTANCE0},
    {"clipDistance1", GL_CLIP_DISTANCE1},
    {"clipDistance2", GL_CLIP_DISTANCE2},
    {"clipDistance3", GL_CLIP_DISTANCE3},
    {"clipDistance4", GL_CLIP_DISTANCE4},
    {"clipDistance5", GL_CLIP_DISTANCE5},
    {"clipDistance6", GL_CLIP_DISTANCE6},
    {"clipDistance7", GL_CLIP_DISTANCE7},
};

/// Parameters of how a texture is sampled, a sampler object's where one is bound.
inline constexpr Switch kSampling[] = {
    {"minFilter", GL_TEXTURE_MIN_FILTER},
    {"magFilter", GL_TEXTURE_MAG_FILTER},
    {"wrapS", GL_TEXTURE_WRAP_S},
    {"wrapT", GL_TEXTURE_WRAP_T},
    {"wrapR", GL_TEXTURE_WRAP_R},
    {"compareMode", GL_TEXTURE_COMPARE_MODE},
    {"compareFunc", GL_TEXTURE_COMPARE_FUNC},
};
inline constexpr Switch kSamplingFloats[] = {
    {"minLod", GL_TEXTURE_MIN_LOD},
    {"maxLod", GL_TEXTURE_MAX_LOD},
    {"lodBias", GL_TEXTURE_LOD_BIAS},
};
/// Parameters that are the texture's own in any case.
inline constexpr Switch kTextureOwn[] = {
    {"baseLevel", GL_TEXTURE_BASE_LEVEL}, {"maxLevel", GL_TEXTURE_MAX_LEVEL},
    {"swizzleR", GL_TEXTURE_SWIZZLE_R},   {"swizzleG", GL_TEXTURE_SWIZZLE_G},
    {"swizzleB", GL_TEXTURE_SWIZZLE_B},   {"swizzleA", GL_TEXTURE_SWIZZLE_A},
};

/// Of one element of a uniform. `columns` 0: a type that tapes don't hold.
struct UniformShape {
  char base = 'f'; ///< f float, i int and bool and sampler, u unsigned
  int columns = 0; ///< 1 but for matrices
  int rows = 1;
};

constexpr UniformShape shapeOf(GLenum type) {
  switch (type) {
  case GL_FLOAT:
    return {'f', 1, 1};
  case GL_FLOAT_VEC2:
    return {'f', 1, 2};
  case GL_FLOAT_VEC3:
    return {'f', 1, 3};
  case GL_FLOAT_VEC4:
    return {'f', 1, 4};
  case GL_INT:
  case GL_BOOL:
    return {'i', 1, 1};
  case GL_INT_VEC2:
  case GL_BOOL_VEC2:
    return {'i', 1, 2};
  case GL_INT_VEC3:
  case GL_BOOL_VEC3:
    return {'i', 1, 3};
  case GL_INT_VEC4:
  case GL_BOOL_VEC4:
    return {'i', 1, 4};
  case GL_UNSIGNED_INT:
    return {'u', 1, 1};
  case GL_UNSIGNED_INT_VEC2:
    return {'u', 1, 2};
  case GL_UNSIGNED_INT_VEC3:
    return {'u', 1, 3};
  case GL_UNSIGNED_INT_VEC4:
    return {'u', 1, 4};
  case GL_FLOAT_MAT2:
    return {'f', 2, 2};
  case GL_FLOAT_MAT3:
    return {'f', 3, 3};
  case GL_FLOAT_MAT4:
    return {'f', 4, 4};
  case GL_FLOAT_MAT2x3:
    return {'f', 2, 3};
  case GL_FLOAT_MAT2x4:
    return {'f', 2, 4};
  case GL_FLOAT_MAT3x2:
    return {'f', 3, 2};
  case GL_FLOAT_MAT3x4:
    return {'f', 3, 4};
  case GL_FLOAT_MAT4x2:
    return {'f', 4, 2};
  case GL_FLOAT_MAT4x3:
    return {'f', 4, 3};
  default:
    return {};
  }
}

/// The name of an element of a uniform: "bones[0]" and 3 give "bones[3]".
inline std::string elementName(const std::string& name, int element) {
  const std::size_t bracket = name.rfind('[');
  if (element == 0 || bracket == std::string::npos) return name;
  return name.substr(0, bracket + 1) + std::to_string(element) + "]";
}

/// The textures' target of a sampler's type; 0 for types that are no samplers.
constexpr GLenum targetOfSampler(GLenum type) {
  switch (type) {
  case GL_SAMPLER_1D:
  case GL_SAMPLER_1D_SHADOW:
  case GL_INT_SAMPLER_1D:
  case GL_UNSIGNED_INT_SAMPLER_1D:
    return GL_TEXTURE_1D;
  case GL_SAMPLER_2D:
  case GL_SAMPLER_2D_SHADOW:
  case GL_INT_SAMPLER_2D:
  case GL_UNSIGNED_INT_SAMPLER_2D:
    return GL_TEXTURE_2D;
  case GL_SAMPLER_3D:
  case GL_INT_SAMPLER_3D:
  case GL_UNSIGNED_INT_SAMPLER_3D:
    return GL_TEXTURE_3D;
  case GL_SAMPLER_CUBE:
  case GL_SAMPLER_CUBE_SHADOW:
  case GL_INT_SAMPLER_CUBE:
  case GL_UNSIGNED_INT_SAMPLER_CUBE:
    return GL_TEXTURE_CUBE_MAP;
  case GL_SAMPLER_2D_RECT:
  case GL_SAMPLER_2D_RECT_SHADOW:
  case GL_INT_SAMPLER_2D_RECT:
  case GL_UNSIGNED_INT_SAMPLER_2D_RECT:
    return GL_TEXTURE_RECTANGLE;
  case GL_SAMPLER_1D_ARRAY:
  case GL_SAMPLER_1D_ARRAY_SHADOW:
  case GL_INT_SAMPLER_1D_ARRAY:
  case GL_UNSIGNED_INT_SAMPLER_1D_ARRAY:
    return GL_TEXTURE_1D_ARRAY;
  case GL_SAMPLER_2D_ARRAY:
  case GL_SAMPLER_2D_ARRAY_SHADOW:
  case GL_INT_SAMPLER_2D_ARRAY:
  case GL_UNSIGNED_INT_SAMPLER_2D_ARRAY:
    return GL_TEXTURE_2D_ARRAY;
  case GL_SAMPLER_CUBE_MAP_ARRAY:
  case GL_SAMPLER_CUBE_MAP_ARRAY_SHADOW:
  case GL_INT_SAMPLER_CUBE_MAP_ARRAY:
  case GL_UNSIGNED_INT_SAMPLER_CUBE_MAP_ARRAY:
    return GL_TEXTURE_CUBE_MAP_ARRAY;
  case GL_SAMPLER_BUFFER:
  case GL_INT_SAMPLER_BUFFER:
  case GL_UNSIGNED_INT_SAMPLER_BUFFER:
    return GL_TEXTURE_BUFFER;
  case GL_SAMPLER_2D_MULTISAMPLE:
  case GL_INT_SAMPLER_2D_MULTISAMPLE:
  case GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE:
    return GL_TEXTURE_2D_MULTISAMPLE;
  case GL_SAMPLER_2D_MULTISAMPLE_ARRAY:
  case GL_INT_SAMPLER_2D_MULTISAMPLE_ARRAY:
  case GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE_ARRAY:
    return GL_TEXTURE_2D_MULTISAMPLE_ARRAY;
  default:
    return 0;
  }
}

} // namespace ggrade::tape
