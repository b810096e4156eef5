// Programs: the sources that they were linked from, and what a draw gives them.

#include "capture/recorder/programs.hpp"
#include "capture/recorder/gl_calls.hpp"
#include "capture/tape/objects.hpp"
#include "capture/tape/writer.hpp"
#include "replay/gl_state.hpp"

#include <map>
#include <string>

namespace ggrade::capture::tape {

using nlohmann::json;
using recorder::gl;
using recorder::number;

namespace {

struct Uniform {
  std::string name;
  GLenum type;
  std::vector<GLint> locations; ///< of the elements
};

struct Attribute {
  std::string name;
  GLint location;
  int locations; ///< more than one of a matrix
};

/// What a linked program is asked once.
struct Linked {
  json definition; ///< null: its sources are not known
  bool isAsked = false;
  std::vector<Uniform> uniforms;
  std::vector<Attribute> attributes;
  std::vector<std::string> blocks;
};

std::map<GLuint, Linked>& programs() {
  static auto* const known = new std::map<GLuint, Linked>;
  return *known;
}

const char* stageOf(GLenum type) {
  switch (type) {
  case GL_VERTEX_SHADER:
    return "vertex";
  case GL_FRAGMENT_SHADER:
    return "fragment";
  case GL_GEOMETRY_SHADER:
    return "geometry";
  case GL_TESS_CONTROL_SHADER:
    return "tessControl";
  case GL_TESS_EVALUATION_SHADER:
    return "tessEvaluation";
  default:
    return "compute";
  }
}

std::string sourceOf(GLuint shader) {
  GLint length = 0;
  gl().getShaderiv(shader, GL_SHADER_SOURCE_LENGTH, &length);
  std::string source(static_cast<std::size_t>(std::max(length, 1)), '\0');
  GLsizei got = 0;
  gl().getShaderSource(shader, static_cast<GLsizei>(source.size()), &got, source.data());
  source.resize(static_cast<std::size_t>(got));
  return source;
}

GLint resources(GLuint program, GLenum interface) {
  GLint count = 0;
  gl().getProgramInterfaceiv(program, interface, GL_ACTIVE_RESOURCES, &count);
  return count;
}

std::string resourceName(GLuint program, GLenum interface, GLint index) {
  char name[256] = {};
  gl().getProgramResourceName(program, interface, static_cast<GLuint>(index), sizeof name, nullptr,
                              name);
  return name;
}

GLint resource(GLuint program, GLenum interface, GLint index, GLenum property) {
  GLint value = 0;
  gl().getProgramResourceiv(program, interface, static_cast<GLuint>(index), 1, &property, 1,
                            nullptr, &value);
  return value;
}

void askUniforms(GLuint program, Linked& linked) {
  for (GLint i = 0; i < resources(program, GL_UNIFORM); ++i) {
    if (resource(program, GL_UNIFORM, i, GL_BLOCK_INDEX) >= 0) continue;
    Uniform uniform;
    uniform.name = resourceName(program, GL_UNIFORM, i);
    uniform.type = static_cast<GLenum>(resource(program, GL_UNIFORM, i, GL_TYPE));
    if (ggrade::tape::shapeOf(uniform.type).columns == 0 &&
        !ggrade::tape::targetOfSampler(uniform.type))
      refuse("has uniforms of a kind that isn't recorded: " + uniform.name);
    const GLint elements = resource(program, GL_UNIFORM, i, GL_ARRAY_SIZE);
    for (GLint e = 0; e < elements; ++e)
      uniform.locations.push_back(
          gl().getUniformLocation(program, ggrade::tape::elementName(uniform.name, e).c_str()));
    linked.uniforms.push_back(std::move(uniform));
  }
}

int locationsOf(GLenum type) {
  const ggrade::tape::UniformShape shape = ggrade::tape::shapeOf(type);
  return shape.columns > 0 ? shape.columns : 1;
}

void askAttributes(GLuint program, Linked& linked) {
  for (GLint i = 0; i < resources(program, GL_PROGRAM_INPUT); ++i) {
    const std::string name = resourceName(program, GL_PROGRAM_INPUT, i);
    const GLint location = resource(program, GL_PROGRAM_INPUT, i, GL_LOCATION);
    if (location < 0) {
      if (name != "gl_VertexID" && name != "gl_InstanceID")
        refuse("takes vertices from " + name + ", as old OpenGL does");
      continue;
    }
    if (resource(program, GL_PROGRAM_INPUT, i, GL_ARRAY_SIZE) > 1)
      refuse("has arrays of vertex attributes");
    linked.attributes.push_back(
        {name, location,
         locationsOf(static_cast<GLenum>(resource(program, GL_PROGRAM_INPUT, i, GL_TYPE)))});
  }
}

/// Locations are given by name before a program is linked again.
json outputsOf(GLuint program) {
  json outputs = json::object();
  for (GLint i = 0; i < resources(program, GL_PROGRAM_OUTPUT); ++i) {
    const GLint location = resource(program, GL_PROGRAM_OUTPUT, i, GL_LOCATION);
    if (location < 0) continue; // gl_FragColor, gl_FragDepth
    if (resource(program, GL_PROGRAM_OUTPUT, i, GL_LOCATION_INDEX) > 0)
      refuse("blends with two colours of one output");
    outputs[resourceName(program, GL_PROGRAM_OUTPUT, i)] = location;
  }
  return outputs;
}

void ask(GLuint program, Linked& linked) {
  linked.isAsked = true;
  if (resources(program, GL_SHADER_STORAGE_BLOCK) > 0) refuse("has shader storage blocks");
  if (resources(program, GL_ATOMIC_COUNTER_BUFFER) > 0) refuse("has atomic counters");
  if (resources(program, GL_TRANSFORM_FEEDBACK_VARYING) > 0) refuse("has transform feedback");
  if (resources(program, GL_VERTEX_SUBROUTINE_UNIFORM) +
          resources(program, GL_FRAGMENT_SUBROUTINE_UNIFORM) >
      0)
    refuse("has shader subroutines");
  askUniforms(program, linked);
  askAttributes(program, linked);
  for (GLint i = 0; i < resources(program, GL_UNIFORM_BLOCK); ++i)
    linked.blocks.push_back(resourceName(program, GL_UNIFORM_BLOCK, i));
  json locations = json::object();
  for (const Attribute& attribute : linked.attributes)
    locations[attribute.name] = attribute.location;
  linked.definition["attributes"] = locations;
  linked.definition["outputs"] = outputsOf(program);
}

json valuesOf(GLuint program, const Uniform& uniform) {
  const ggrade::tape::UniformShape shape = ggrade::tape::shapeOf(uniform.type);
  const auto count = static_cast<std::size_t>(shape.columns * shape.rows);
  json values = json::array();
  for (const GLint location : uniform.locations) {
    GLfloat f[16] = {};
    GLint i[16] = {};
    GLuint u[16] = {};
    if (shape.base == 'f')
      gl().getUniformfv(program, location, f);
    else if (shape.base == 'u')
      gl().getUniformuiv(program, location, u);
    else
      gl().getUniformiv(program, location, i);
    for (std::size_t k = 0; k < count; ++k)
      values.push_back(shape.base == 'f'   ? json(f[k])
                       : shape.base == 'u' ? json(u[k])
                                           : json(i[k]));
  }
  return values;
}

json blockJson(GLuint program, GLint index) {
  const GLint binding = resource(program, GL_UNIFORM_BLOCK, index, GL_BUFFER_BINDING);
  const GLint bytes = resource(program, GL_UNIFORM_BLOCK, index, GL_BUFFER_DATA_SIZE);
  const auto unit = static_cast<GLuint>(binding);
  GLint buffer = 0;
  gl().getIntegeri_v(GL_UNIFORM_BUFFER_BINDING, unit, &buffer);
  if (!buffer) return nullptr;
  GLint64 start = 0, size = 0;
  gl().getInteger64i_v(GL_UNIFORM_BUFFER_START, unit, &start);
  gl().getInteger64i_v(GL_UNIFORM_BUFFER_SIZE, unit, &size);
  return {{"blob", bufferBlob(static_cast<GLuint>(buffer), start,
                              size > 0 ? std::min<GLint64>(size, bytes) : bytes)}};
}

json attributeJson(GLuint index) {
  const auto ask = [&](GLenum name) {
    GLint value = 0;
    gl().getVertexAttribiv(index, name, &value);
    return value;
  };
  if (!ask(GL_VERTEX_ATTRIB_ARRAY_ENABLED)) {
    GLfloat value[4] = {};
    gl().getVertexAttribfv(index, GL_CURRENT_VERTEX_ATTRIB, value);
    return {{"value", value}};
  }
  const auto binding = static_cast<GLuint>(ask(GL_VERTEX_ATTRIB_BINDING));
  GLint buffer = 0, stride = 0, divisor = 0;
  GLint64 offset = 0;
  gl().getIntegeri_v(GL_VERTEX_BINDING_BUFFER, binding, &buffer);
  gl().getIntegeri_v(GL_VERTEX_BINDING_STRIDE, binding, &stride);
  gl().getIntegeri_v(GL_VERTEX_BINDING_DIVISOR, binding, &divisor);
  gl().getInteger64i_v(GL_VERTEX_BINDING_OFFSET, binding, &offset);
  if (!buffer) {
    refuse("draws vertices that lie in no buffer object");
    return nullptr;
  }
  if (ask(GL_VERTEX_ATTRIB_ARRAY_LONG)) refuse("has vertex attributes of doubles");
  return {{"blob", bufferBlob(static_cast<GLuint>(buffer))},
          {"size", ask(GL_VERTEX_ATTRIB_ARRAY_SIZE)},
          {"type", ask(GL_VERTEX_ATTRIB_ARRAY_TYPE)},
          {"normalized", ask(GL_VERTEX_ATTRIB_ARRAY_NORMALIZED) != 0},
          {"integer", ask(GL_VERTEX_ATTRIB_ARRAY_INTEGER) != 0},
          {"stride", stride},
          {"offset", offset + ask(GL_VERTEX_ATTRIB_RELATIVE_OFFSET)},
          {"divisor", divisor}};
}

} // namespace

void linking(GLuint program) {
  Linked& linked = programs()[program] = {};
  GLuint shaders[16] = {};
  GLsizei count = 0;
  gl().getAttachedShaders(program, 16, &count, shaders);
  json stages = json::array();
  for (GLsizei i = 0; i < count; ++i) {
    GLint type = 0;
    gl().getShaderiv(shaders[i], GL_SHADER_TYPE, &type);
    stages.push_back(
        {{"stage", stageOf(static_cast<GLenum>(type))}, {"blob", blob(sourceOf(shaders[i]))}});
  }
  linked.definition = {{"stages", stages}};
}

void unknownProgram(GLuint program) {
  programs()[program] = {};
}

bool drawsNothing() {
  return !number(GL_CURRENT_PROGRAM) && !number(GL_PROGRAM_PIPELINE_BINDING) &&
         (number(GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_CORE_PROFILE_BIT);
}

void addUnusedPrograms() {
  for (auto& [program, linked] : programs()) {
    if (linked.definition.is_null() || linked.isAsked) continue;
    json definition = linked.definition;
    json& locations = definition["attributes"] = json::object();
    for (GLint i = 0; i < resources(program, GL_PROGRAM_INPUT); ++i)
      if (const GLint at = resource(program, GL_PROGRAM_INPUT, i, GL_LOCATION); at >= 0)
        locations[resourceName(program, GL_PROGRAM_INPUT, i)] = at;
    definition["outputs"] = outputsOf(program);
    command({{"op", "program"}, {"program", definition}});
  }
}

void addProgram(json& draw) {
  const GLuint program = number(GL_CURRENT_PROGRAM);
  if (!program) return refuse("draws without a program object, or with a pipeline of several");
  Linked& linked = programs()[program];
  if (linked.definition.is_null()) return refuse("draws with a program whose source isn't known");
  if (!linked.isAsked) ask(program, linked);
  draw["program"] = linked.definition;
  json &uniforms = draw["uniforms"] = json::object(), &textures = draw["textures"] = json::object(),
       &blocks = draw["blocks"] = json::object(), &attributes = draw["attributes"] = json::object();
  const GLuint active = number(GL_ACTIVE_TEXTURE);
  for (const Uniform& uniform : linked.uniforms) {
    if (const GLenum target = ggrade::tape::targetOfSampler(uniform.type)) {
      json& all = textures[uniform.name] = json::array();
      for (const GLint location : uniform.locations) {
        GLint unit = 0;
        gl().getUniformiv(program, location, &unit);
        all.push_back(textureJson(target, static_cast<GLuint>(unit)));
      }
    } else {
      uniforms[uniform.name] = {{"type", uniform.type}, {"values", valuesOf(program, uniform)}};
    }
  }
  gl().activeTexture(active);
  for (std::size_t i = 0; i < linked.blocks.size(); ++i)
    blocks[linked.blocks[i]] = blockJson(program, static_cast<GLint>(i));
  for (const Attribute& attribute : linked.attributes) {
    json& columns = attributes[attribute.name] = json::array();
    for (int i = 0; i < attribute.locations; ++i)
      columns.push_back(attributeJson(static_cast<GLuint>(attribute.location + i)));
  }
}

} // namespace ggrade::capture::tape
