// Debug output is always on and synchronous, with our callback, so that every GL error is known
// with its call. The program sees its own callback, its own switches and its own message log, as
// usual.

#include "capture/channel_writer.hpp"
#include "capture/context_state.hpp"
#include "capture/gl_hooks.hpp"

#include <algorithm>
#include <cstring>

namespace ggrade::capture {
namespace {

constexpr std::size_t kMaxLogged = 10; // GL_MAX_DEBUG_LOGGED_MESSAGES here
thread_local ContextState* currentContext = nullptr;

void APIENTRY receive(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                      const GLchar* text, const void* user) {
  auto& state = *static_cast<ContextState*>(const_cast<void*>(user));
  if (state.quiet) return;
  const bool ofProgram =
      source == GL_DEBUG_SOURCE_APPLICATION || source == GL_DEBUG_SOURCE_THIRD_PARTY;
  if (source == GL_DEBUG_SOURCE_API && type == GL_DEBUG_TYPE_ERROR) {
    state.errors.named = true;
    writeMessage(channel::MessageKind::glError, text);
  } else if (!ofProgram) {
    writeMessage(channel::MessageKind::glDebug, text);
  }
  DebugState& debug = state.debug;
  if (!debug.output) return;
  if (debug.callback) {
    debug.callback(source, type, id, severity, length, text, debug.userParam);
  } else if (debug.log.size() < kMaxLogged) {
    debug.log.push_back({source, type, id, severity, text});
  }
}

decltype(&glDebugMessageCallback) nextCallback, nextCallbackArb;

void setCallback(GLDEBUGPROC callback, const void* user, decltype(&glDebugMessageCallback) next) {
  if (!currentContext) return next(callback, user);
  currentContext->debug.callback = callback;
  currentContext->debug.userParam = user;
}
void APIENTRY hookCallback(GLDEBUGPROC callback, const void* user) {
  setCallback(callback, user, nextCallback);
}
void APIENTRY hookCallbackArb(GLDEBUGPROC callback, const void* user) {
  setCallback(callback, user, nextCallbackArb);
}

/// The program's copy of a switch that GL itself must keep on; null for all others.
bool* keptSwitch(GLenum name) {
  if (!currentContext) return nullptr;
  if (name == GL_DEBUG_OUTPUT) return &currentContext->debug.output;
  if (name == GL_DEBUG_OUTPUT_SYNCHRONOUS) return &currentContext->debug.synchronous;
  return nullptr;
}

decltype(&glEnable) nextEnable;
void APIENTRY hookEnable(GLenum name) {
  if (bool* const kept = keptSwitch(name)) {
    *kept = true;
  } else {
    nextEnable(name);
  }
}

decltype(&glDisable) nextDisable;
void APIENTRY hookDisable(GLenum name) {
  if (bool* const kept = keptSwitch(name)) {
    *kept = false;
  } else {
    nextDisable(name);
  }
}

decltype(&glIsEnabled) nextIsEnabled;
GLboolean APIENTRY hookIsEnabled(GLenum name) {
  const bool* const kept = keptSwitch(name);
  return kept ? *kept : nextIsEnabled(name);
}

decltype(&glGetPointerv) nextGetPointerv;
void APIENTRY hookGetPointerv(GLenum name, void** value) {
  if (currentContext && value && name == GL_DEBUG_CALLBACK_FUNCTION) {
    *value = reinterpret_cast<void*>(currentContext->debug.callback);
  } else if (currentContext && value && name == GL_DEBUG_CALLBACK_USER_PARAM) {
    *value = const_cast<void*>(currentContext->debug.userParam);
  } else {
    nextGetPointerv(name, value);
  }
}

/// As glGetDebugMessageLog: stops at the first message whose text doesn't fit; any array may be
/// null.
GLuint APIENTRY hookGetLog(GLuint count, GLsizei size, GLenum* sources, GLenum* types, GLuint* ids,
                           GLenum* severities, GLsizei* lengths, GLchar* texts) {
  if (!currentContext) return 0;
  std::deque<DebugState::Logged>& log = currentContext->debug.log;
  GLuint taken = 0;
  for (; taken < count && !log.empty(); ++taken) {
    const DebugState::Logged& message = log.front();
    const auto length = static_cast<GLsizei>(message.text.size() + 1);
    if (texts) {
      if (length > size) break;
      std::memcpy(texts, message.text.c_str(), static_cast<std::size_t>(length));
      texts += length;
      size -= length;
    }
    if (sources) sources[taken] = message.source;
    if (types) types[taken] = message.type;
    if (ids) ids[taken] = message.id;
    if (severities) severities[taken] = message.severity;
    if (lengths) lengths[taken] = length;
    log.pop_front();
  }
  return taken;
}

const Hook kDebugHooks[] = {
    GG_HOOK(glDebugMessageCallback, hookCallback, nextCallback),
    GG_HOOK(glDebugMessageCallbackARB, hookCallbackArb, nextCallbackArb),
    GG_HOOK(glEnable, hookEnable, nextEnable),
    GG_HOOK(glDisable, hookDisable, nextDisable),
    GG_HOOK(glIsEnabled, hookIsEnabled, nextIsEnabled),
    GG_HOOK(glGetPointerv, hookGetPointerv, nextGetPointerv),
    {"glGetDebugMessageLog", reinterpret_cast<GlFunction>(hookGetLog), nullptr},
    {"glGetDebugMessageLogARB", reinterpret_cast<GlFunction>(hookGetLog), nullptr},
};

} // namespace

std::span<const Hook> debugHooks() {
  return kDebugHooks;
}

bool debugInteger(const DebugState& debug, GLenum name, GLint& value) {
  switch (name) {
  case GL_DEBUG_OUTPUT:
    value = debug.output;
    return true;
  case GL_DEBUG_OUTPUT_SYNCHRONOUS:
    value = debug.synchronous;
    return true;
  case GL_DEBUG_LOGGED_MESSAGES:
    value = static_cast<GLint>(debug.log.size());
    return true;
  case GL_DEBUG_NEXT_LOGGED_MESSAGE_LENGTH:
    value = debug.log.empty() ? 0 : static_cast<GLint>(debug.log.front().text.size() + 1);
    return true;
  default:
    return false;
  }
}

ContextState* currentState() {
  return currentContext;
}
void setCurrentState(ContextState* state) {
  currentContext = state;
}

void installDebugCallback(ContextState& state) {
  real<decltype(&glDebugMessageCallback)>("glDebugMessageCallback")(receive, &state);
  const auto enable = real<decltype(&glEnable)>("glEnable");
  enable(GL_DEBUG_OUTPUT);
  enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
}

} // namespace ggrade::capture
