#include "capture/recorder/programs.hpp"

#include "capture/recorder/gl_calls.hpp"
#include "capture/recorder/images.hpp"
#include "replay/gl_state.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace ggrade::capture::recorder {
using ggrade::tape::elementName;
using ggrade::tape::targetOfSampler;

namespace {

// Elements of arrays count; more are left out.
constexpr std::size_t kMaxSamplers = 64;
constexpr std::size_t kMaxMatrices = 256;
constexpr std::size_t kMaxImages = 16;
constexpr GLint kMaxElements = 256;

bool isImage(GLenum type) {
  return type >= GL_IMAGE_1D && type <= GL_UNSIGNED_INT_IMAGE_2D_MULTISAMPLE_ARRAY;
}

UniformName cut(const std::string& name) {
  UniformName result{};
  std::copy_n(name.begin(), std::min(name.size(), result.size() - 1), result.begin());
  return result;
}

GLint ofUniform(GLuint program, GLuint uniform, GLenum name) {
  GLint value = 0;
  gl().getActiveUniformsiv(program, 1, &uniform, name, &value);
  return value;
}

void addMatrices(ProgramInfo& info, GLuint program, GLuint uniform, const std::string& name,
                 GLint elements) {
  const GLint block = ofUniform(program, uniform, GL_UNIFORM_BLOCK_INDEX);
  const bool inBlock = block >= 0;
  const GLint first = inBlock ? ofUniform(program, uniform, GL_UNIFORM_OFFSET) : 0;
  const GLint step = inBlock ? ofUniform(program, uniform, GL_UNIFORM_ARRAY_STRIDE) : 0;
  for (GLint i = 0; i < elements && info.matrices.size() < kMaxMatrices; ++i) {
    const std::string element = elementName(name, i);
    ProgramInfo::MatrixUniform matrix{};
    matrix.location = inBlock ? -1 : gl().getUniformLocation(program, element.c_str());
    matrix.name = cut(element);
    if (inBlock) {
      matrix.block = static_cast<GLuint>(block);
      matrix.offset = first + i * step;
      matrix.stride = ofUniform(program, uniform, GL_UNIFORM_MATRIX_STRIDE);
      matrix.rowMajor = ofUniform(program, uniform, GL_UNIFORM_IS_ROW_MAJOR) != 0;
    }
    info.matrices.push_back(matrix);
  }
}

ProgramInfo ask(GLuint program) {
  ProgramInfo info;
  info.outputs = outputsOf(program);
  GLint uniforms = 0;
  GLint longest = 0;
  gl().getProgramiv(program, GL_ACTIVE_UNIFORMS, &uniforms);
  gl().getProgramiv(program, GL_ACTIVE_UNIFORM_MAX_LENGTH, &longest);
  std::string name(static_cast<std::size_t>(std::max(longest, 1)), '\0');
  for (GLint i = 0; i < uniforms; ++i) {
    GLsizei length = 0;
    GLint size = 0;
    GLenum type = 0;
    const auto index = static_cast<GLuint>(i);
    gl().getActiveUniform(program, index, static_cast<GLsizei>(name.size()), &length, &size, &type,
                          name.data());
    const std::string text(name, 0, static_cast<std::size_t>(length));
    const GLint elements = std::min(size, kMaxElements);
    if (const GLenum target = targetOfSampler(type)) {
      for (GLint e = 0; e < elements && info.samplers.size() < kMaxSamplers; ++e) {
        const std::string element = elementName(text, e);
        info.samplers.push_back(
            {gl().getUniformLocation(program, element.c_str()), target, cut(element)});
      }
    } else if (type == GL_FLOAT_MAT4) {
      addMatrices(info, program, index, text, elements);
    } else if (isImage(type)) {
      for (GLint e = 0; e < elements && info.images.size() < kMaxImages; ++e)
        info.images.push_back(gl().getUniformLocation(program, elementName(text, e).c_str()));
    }
  }
  return info;
}

GLint64 indexed64(GLenum name, GLuint index) {
  GLint64 value = 0;
  gl().getInteger64i_v(name, index, &value);
  return value;
}

bool readFromBlock(GLuint program, const ProgramInfo::MatrixUniform& uniform, Matrix& value) {
  GLint binding = 0;
  gl().getActiveUniformBlockiv(program, uniform.block, GL_UNIFORM_BLOCK_BINDING, &binding);
  const auto unit = static_cast<GLuint>(binding);
  GLint buffer = 0;
  gl().getIntegeri_v(GL_UNIFORM_BUFFER_BINDING, unit, &buffer);
  if (!buffer || uniform.stride < 16) return false;
  const auto name = static_cast<GLuint>(buffer);
  GLint64 size = 0;
  gl().getNamedBufferParameteri64v(name, GL_BUFFER_SIZE, &size);
  const GLint64 start = indexed64(GL_UNIFORM_BUFFER_START, unit);
  const GLint64 range = indexed64(GL_UNIFORM_BUFFER_SIZE, unit); // 0: all of it
  const GLint64 end = range > 0 ? std::min(size, start + range) : size;
  const GLint64 bytes = 3 * GLint64{uniform.stride} + 16;
  const GLint64 offset = start + uniform.offset;
  if (offset < 0 || offset + bytes > end || bytes > 4096) return false;
  std::array<char, 4096> raw{};
  gl().getNamedBufferSubData(name, offset, bytes, raw.data());
  // As while the program has the buffer mapped.
  if (gl().getError() != GL_NO_ERROR) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<float, 4> vector{};
    std::memcpy(vector.data(), raw.data() + i * static_cast<std::size_t>(uniform.stride), 16);
    for (std::size_t j = 0; j < 4; ++j) value[uniform.rowMajor ? 4 * j + i : 4 * i + j] = vector[j];
  }
  return true;
}

bool wantsMipmaps(std::uint32_t minFilter) {
  return minFilter != GL_NEAREST && minFilter != GL_LINEAR;
}

bool isInteger(std::uint32_t texture, std::uint32_t level) {
  const GLint type = levelParameter(texture, level, GL_TEXTURE_RED_TYPE);
  return type == GL_INT || type == GL_UNSIGNED_INT;
}

/// A texture without mipmaps, as some targets are always.
bool hasOneLevel(GLenum target) {
  return target == GL_TEXTURE_RECTANGLE || target == GL_TEXTURE_BUFFER ||
         target == GL_TEXTURE_2D_MULTISAMPLE || target == GL_TEXTURE_2D_MULTISAMPLE_ARRAY;
}

/// Level `lastLevel` of a chain that starts at the described base level, with GL's rule for sizes.
bool chainIsComplete(const trace::ImageRef& base, std::uint32_t lastLevel) {
  for (std::uint32_t level = base.level + 1; level <= lastLevel; ++level) {
    const std::uint32_t step = level - base.level;
    const auto is = [&](GLenum name, std::uint32_t wanted) {
      return static_cast<std::uint32_t>(levelParameter(base.name, level, name)) == wanted;
    };
    if (!is(GL_TEXTURE_WIDTH, std::max(base.width >> step, 1U)) ||
        !is(GL_TEXTURE_INTERNAL_FORMAT, base.format))
      return false;
    const bool rows = base.target != GL_TEXTURE_1D && base.target != GL_TEXTURE_1D_ARRAY;
    if (rows && !is(GL_TEXTURE_HEIGHT, std::max(base.height >> step, 1U))) return false;
  }
  return true;
}

/// Number of the last level that a full chain from the base would have.
std::uint32_t fullChainEnd(const trace::ImageRef& base) {
  std::uint32_t longest = base.width;
  if (base.target != GL_TEXTURE_1D_ARRAY) longest = std::max(longest, base.height);
  if (base.target == GL_TEXTURE_3D)
    longest = std::max(longest, static_cast<std::uint32_t>(
                                    levelParameter(base.name, base.level, GL_TEXTURE_DEPTH)));
  return base.level + static_cast<std::uint32_t>(std::bit_width(longest)) - 1;
}

/// The texture's own settings, or those of the sampler object at the active unit.
void readSettings(trace::SampleRecord& sample) {
  sample.sampler = number(GL_SAMPLER_BINDING);
  const auto ask = [&](GLenum name) {
    GLint value = 0;
    if (sample.sampler) {
      gl().getSamplerParameteriv(sample.sampler, name, &value);
    } else {
      value = textureParameter(sample.image.name, name);
    }
    return static_cast<std::uint32_t>(value);
  };
  sample.minFilter = ask(GL_TEXTURE_MIN_FILTER);
  sample.magFilter = ask(GL_TEXTURE_MAG_FILTER);
  sample.wrapS = ask(GL_TEXTURE_WRAP_S);
  sample.wrapT = ask(GL_TEXTURE_WRAP_T);
  sample.compareMode = ask(GL_TEXTURE_COMPARE_MODE);
  sample.compareFunc = ask(GL_TEXTURE_COMPARE_FUNC);
}

} // namespace

std::uint32_t outputsOf(GLuint program) {
  GLint count = 0;
  gl().getProgramInterfaceiv(program, GL_PROGRAM_OUTPUT, GL_ACTIVE_RESOURCES, &count);
  std::uint32_t outputs = 0;
  for (GLint i = 0; i < count; ++i) {
    const GLenum asked[] = {GL_LOCATION, GL_ARRAY_SIZE};
    GLint answers[2] = {-1, 1};
    gl().getProgramResourceiv(program, GL_PROGRAM_OUTPUT, static_cast<GLuint>(i), 2, asked, 2,
                              nullptr, answers);
    const auto [location, elements] = answers;
    if (location < 0) return ~0U; // gl_FragColor, gl_FragData
    for (GLint at = location; at < std::min(location + elements, 32); ++at) outputs |= 1U << at;
  }
  return outputs;
}

const ProgramInfo& Programs::info(std::uint32_t group, GLuint program) {
  const auto key = std::pair(group, program);
  const auto found = infos_.find(key);
  return found != infos_.end() ? found->second : infos_.emplace(key, ask(program)).first->second;
}

std::vector<GLuint> currentPrograms() {
  if (const GLuint program = number(GL_CURRENT_PROGRAM)) return {program};
  std::vector<GLuint> programs;
  const GLuint pipeline = number(GL_PROGRAM_PIPELINE_BINDING);
  if (!pipeline) return programs;
  for (const GLenum stage :
       {GL_FRAGMENT_SHADER, GL_VERTEX_SHADER, GL_GEOMETRY_SHADER, GL_TESS_CONTROL_SHADER,
        GL_TESS_EVALUATION_SHADER, GL_COMPUTE_SHADER}) {
    GLint program = 0;
    gl().getProgramPipelineiv(pipeline, stage, &program);
    const auto name = static_cast<GLuint>(program);
    if (name && std::find(programs.begin(), programs.end(), name) == programs.end())
      programs.push_back(name);
  }
  return programs;
}

bool readMatrix(GLuint program, const ProgramInfo::MatrixUniform& uniform, Matrix& value) {
  if (uniform.location < 0) return readFromBlock(program, uniform, value);
  gl().getUniformfv(program, uniform.location, value.data());
  return true;
}

trace::SampleRecord readSample(GLuint program, const ProgramInfo::Sampler& sampler,
                               std::uint32_t& lastLevel) {
  trace::SampleRecord sample{};
  sample.writer = trace::kNone;
  std::copy(sampler.name.begin(), sampler.name.end(), sample.uniform);
  GLint unit = 0;
  gl().getUniformiv(program, sampler.location, &unit);
  sample.unit = static_cast<std::uint32_t>(unit);
  gl().activeTexture(GL_TEXTURE0 + sample.unit);
  const GLuint texture = boundTexture(sampler.target);
  lastLevel = 0;
  if (!texture) {
    sample.image.layer = trace::kNone;
    sample.incomplete = 1;
    return sample;
  }
  sample.image = textureLevel(texture, 0);
  readSettings(sample);
  const bool oneLevel = hasOneLevel(sampler.target);
  if (!oneLevel)
    sample.image.level =
        static_cast<std::uint32_t>(textureParameter(texture, GL_TEXTURE_BASE_LEVEL));
  describe(sample.image, 0, {});
  if (!sample.image.target) sample.image.target = sampler.target;
  lastLevel = sample.image.level;
  if (sampler.target == GL_TEXTURE_BUFFER) return sample;
  if (sample.image.width == 0 || sample.image.height == 0) {
    sample.incomplete = 1;
    return sample;
  }
  if (oneLevel) return sample;
  if (wantsMipmaps(sample.minFilter)) {
    const auto maxLevel =
        static_cast<std::uint32_t>(textureParameter(texture, GL_TEXTURE_MAX_LEVEL));
    std::uint32_t end = std::min(fullChainEnd(sample.image), maxLevel);
    if (const GLint levels = textureParameter(texture, GL_TEXTURE_IMMUTABLE_LEVELS); levels > 0)
      end = std::min(end, static_cast<std::uint32_t>(levels) - 1);
    lastLevel = std::max(end, sample.image.level);
    if (maxLevel < sample.image.level || !chainIsComplete(sample.image, end)) sample.incomplete = 1;
  }
  if (isInteger(texture, sample.image.level) &&
      (sample.magFilter != GL_NEAREST ||
       (sample.minFilter != GL_NEAREST && sample.minFilter != GL_NEAREST_MIPMAP_NEAREST)))
    sample.incomplete = 1;
  return sample;
}

} // namespace ggrade::capture::recorder
