// Runs of equal draws within a pass, with what they sample and their matrices.

#include "capture/recorder/gl_calls.hpp"
#include "capture/recorder/session.hpp"
#include "capture/recorder/state.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace ggrade::capture::recorder {
namespace {

using trace::kNone;

bool sameState(const trace::StepRecord& a, const trace::StepRecord& b) {
  constexpr std::size_t kFirst = offsetof(trace::StepRecord, cullFace);
  constexpr std::size_t kEnd = offsetof(trace::StepRecord, firstMatrix);
  return std::memcmp(reinterpret_cast<const char*>(&a) + kFirst,
                     reinterpret_cast<const char*>(&b) + kFirst, kEnd - kFirst) == 0;
}

bool sameSamples(const std::vector<trace::SampleRecord>& a,
                 const std::vector<trace::SampleRecord>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0);
}

/// Whether a level that can be sampled is also drawn into.
bool isFeedback(const trace::ImageRef& sampled, std::uint32_t lastLevel, const OpenPass& pass,
                const trace::StepRecord& state) {
  for (std::uint32_t i = 0; i < trace::kAttachments; ++i) {
    const trace::ImageRef& image = pass.record.images[i];
    const bool used = i < trace::kColors   ? pass.record.drawBuffers >> i & 1
                      : i == trace::kDepth ? state.depthTest != 0
                                           : state.stencilTest != 0;
    if (used && image.kind == sampled.kind && image.name == sampled.name &&
        image.level >= sampled.level && image.level <= lastLevel)
      return true;
  }
  return false;
}

/// Room in the tables for a step and what it samples.
void keep(Session& session, OpenStep& step) {
  TableWriter& tables = session.shared().tables;
  step.kept = tables.keepStep();
  if (!step.kept) return;
  while (step.samplesKept < step.samples.size() && tables.keepSample()) ++step.samplesKept;
}

} // namespace

std::vector<trace::SampleRecord> currentSamples(Session& session, const OpenPass& pass,
                                                const std::vector<GLuint>& programs,
                                                const trace::StepRecord& state) {
  std::vector<trace::SampleRecord> samples;
  const GLuint unit = number(GL_ACTIVE_TEXTURE);
  for (const GLuint program : programs) {
    const ProgramInfo& info = session.shared().programs.info(session.state().shareGroup, program);
    for (const ProgramInfo::Sampler& sampler : info.samplers) {
      std::uint32_t lastLevel = 0;
      trace::SampleRecord sample = readSample(program, sampler, lastLevel);
      if (sample.image.name) {
        sample.writer = session.shared().writers.of(session.placeOf(sample.image),
                                                    sample.image.level, lastLevel);
        sample.feedback = isFeedback(sample.image, lastLevel, pass, state);
      }
      samples.push_back(sample);
    }
  }
  gl().activeTexture(unit);
  return samples;
}

void noteImageStores(Session& session, OpenPass& pass, const std::vector<GLuint>& programs) {
  for (const GLuint program : programs) {
    const ProgramInfo& info = session.shared().programs.info(session.state().shareGroup, program);
    for (const GLint location : info.images) {
      GLint unit = 0;
      gl().getUniformiv(program, location, &unit);
      const auto ask = [&](GLenum name) {
        GLint value = 0;
        gl().getIntegeri_v(name, static_cast<GLuint>(unit), &value);
        return static_cast<std::uint32_t>(value);
      };
      const GLuint texture = ask(GL_IMAGE_BINDING_NAME);
      if (!texture || ask(GL_IMAGE_BINDING_ACCESS) == GL_READ_ONLY) continue;
      const auto target = static_cast<GLenum>(textureParameter(texture, GL_TEXTURE_TARGET));
      const std::uint32_t layer =
          !hasLayers(target) || ask(GL_IMAGE_BINDING_LAYERED) ? kNone : ask(GL_IMAGE_BINDING_LAYER);
      const OtherWrite write{session.placeOf(texture), ask(GL_IMAGE_BINDING_LEVEL), layer};
      if (std::find(pass.otherWrites.begin(), pass.otherWrites.end(), write) ==
          pass.otherWrites.end())
        pass.otherWrites.push_back(write);
    }
  }
}

OpenStep* stepFor(Session& session, OpenPass& pass) {
  if (pass.index == kNone) return nullptr;
  OpenStep next;
  next.programs = currentPrograms();
  next.record = readState();
  next.record.program = next.programs.empty() ? 0 : next.programs.front();
  if (next.record.program)
    next.record.outputs =
        session.shared().programs.info(session.state().shareGroup, next.record.program).outputs;
  next.samples = currentSamples(session, pass, next.programs, next.record);
  if (!pass.steps.empty()) {
    OpenStep& open = pass.steps.back();
    if (open.programs == next.programs && sameState(open.record, next.record) &&
        sameSamples(open.samples, next.samples))
      return &open;
  }
  endStep(session, pass);
  keep(session, next);
  // Of steps that have no room only the open one is kept, to tell where the next one begins.
  if (!pass.steps.empty() && !pass.steps.back().kept) pass.steps.pop_back();
  pass.steps.push_back(std::move(next));
  return &pass.steps.back();
}

void recordMatrices(Session& session, OpenStep& step) {
  if (!step.kept) return;
  std::size_t index = 0;
  for (const GLuint program : step.programs) {
    const ProgramInfo& info = session.shared().programs.info(session.state().shareGroup, program);
    step.latest.resize(std::max(step.latest.size(), index + info.matrices.size()));
    for (const ProgramInfo::MatrixUniform& uniform : info.matrices) {
      if (step.matrices.size() >= trace::kMaxMatricesOfStep) return;
      std::optional<Matrix>& latest = step.latest[index++];
      Matrix value{};
      if (!readMatrix(program, uniform, value)) continue;
      if (latest && std::memcmp(latest->data(), value.data(), sizeof(value)) == 0) continue;
      latest = value;
      if (!session.shared().tables.keepMatrix()) continue;
      trace::MatrixRecord& record = step.matrices.emplace_back();
      record.draw = step.record.draws;
      std::copy(uniform.name.begin(), uniform.name.end(), record.name);
      std::copy(value.begin(), value.end(), record.values);
    }
  }
}

void addReadStep(Session& session, OpenPass& pass, std::vector<trace::SampleRecord> samples) {
  if (pass.index == kNone || samples.empty()) return;
  OpenStep step;
  step.samples = std::move(samples);
  keep(session, step);
  pass.steps.push_back(std::move(step));
}

void endStep(Session& session, OpenPass& pass) {
  if (!session.shared().request.stepCopies || pass.steps.empty() || !pass.steps.back().kept) return;
  OpenStep& step = pass.steps.back();
  copyAttachments(session, pass, step.written, static_cast<std::uint32_t>(pass.steps.size() - 1));
}

} // namespace ggrade::capture::recorder
