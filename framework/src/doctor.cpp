#include "doctor.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdarg>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "print_once.hpp"
#include "reload.hpp"
#include "words/words.hpp"
#include <gg/debug.hpp>

#include <fmt/ranges.h>

namespace gg::detail {

namespace {

void tell(const std::string& text) {
  printOnce(say("frame doctor: {}", text));
}

bool isOn() {
  const char* setting = std::getenv("GG_DOCTOR");
  return setting == nullptr || std::string_view(setting) != "0";
}

// What came to one framebuffer in the frame that is watched.
struct Target {
  int draws = 0;
  bool colorCleared = false, depthCleared = false;
  std::set<std::array<GLint, 4>> viewports;
  glm::ivec2 size{0}; // pixels; 0: unknown
};

struct Watch {
  bool on = false;
  bool fromStart = false;                         // from when the window was made
  std::set<std::pair<GLuint, GLint>> uniformsSet; // program, location
  std::map<GLuint, Target> targets;               // by framebuffer; 0: the window
  std::vector<GLuint> written;                    // framebuffer objects: drawn into or cleared
  TextureTargets textures;
  std::map<GLuint, std::string> boundAt;          // a framebuffer, last
  std::map<std::string, std::string> calledAt;    // a function, last
  std::map<GLuint, std::optional<bool>> programs; // looked at: is gl_ClipDistance written?
  bool clippingIsWrong = false;
  std::set<std::string> perhaps; // worth saying if nothing is to be seen
  bool foundSomething = false;
};
Watch watch;
std::atomic<int> windowClears = 0; // before the first frame

void find(const std::string& text) {
  watch.foundSomething = true;
  tell(text);
}

std::string nameOf(GLuint framebuffer) {
  return framebuffer == 0 ? std::string(words("the window"))
                          : say("framebuffer object {}", framebuffer);
}

GLuint boundForDrawing() {
  return static_cast<GLuint>(ask(GL_DRAW_FRAMEBUFFER_BINDING));
}

void listAsWritten(GLuint framebuffer) {
  if (framebuffer != 0 && std::ranges::find(watch.written, framebuffer) == watch.written.end())
    watch.written.push_back(framebuffer);
}

void onClear(GLbitfield what) {
  const GLuint framebuffer = boundForDrawing();
  listAsWritten(framebuffer);
  Target& target = watch.targets[framebuffer];
  if ((what & GL_COLOR_BUFFER_BIT) != 0) {
    if (framebuffer != 0 && !target.colorCleared && incompleteness().empty() && lacksColor())
      find(say("framebuffer object {} has no colour attachment, so its colours are neither cleared "
               "nor drawn: glFramebufferTexture2D attaches a texture, as GL_COLOR_ATTACHMENT0. "
               "Where depth is enough, glDrawBuffer(GL_NONE)",
               framebuffer) +
           lastPlace());
    target.colorCleared = true;
  }
  if (framebuffer == 0) ++windowClears;
  if ((what & GL_DEPTH_BUFFER_BIT) == 0) return;
  GLboolean written = GL_TRUE;
  glad_glGetBooleanv(GL_DEPTH_WRITEMASK, &written);
  if (written == GL_FALSE)
    find(say("the depth of {} is not cleared: glDepthMask(GL_FALSE) is still set, and holds for "
             "clearing, too",
             nameOf(framebuffer)) +
         lastPlace());
  else
    target.depthCleared = true;
}

// Wrong on a graphics card; software may clip by what is written and by nothing else.
void checkClipping(std::optional<bool> isWritten) {
  const bool clips = glad_glIsEnabled(GL_CLIP_DISTANCE0) == GL_TRUE;
  if (watch.clippingIsWrong || clips == isWritten.value_or(clips)) return;
  watch.clippingIsWrong = true; // said once is enough
  find(
      (clips
           ? say("GL_CLIP_DISTANCE0 is enabled, but a vertex shader that draws writes no "
                 "gl_ClipDistance: a graphics card may cut off anything. "
                 "Write it there, or glDisable(GL_CLIP_DISTANCE0) before it draws")
           : say("a vertex shader writes gl_ClipDistance, but GL_CLIP_DISTANCE0 is not enabled "
                 "while it draws: a graphics card cuts off nothing. glEnable(GL_CLIP_DISTANCE0)")) +
      lastPlace());
}

void checkUniforms(GLuint program) {
  std::vector<std::string> never;
  for (const auto& [name, location] : zeroUniforms(program))
    if (!watch.uniformsSet.contains({program, location})) never.push_back(name);
  if (never.size() == 1)
    find(say("uniform {0} of {1} is 0, as it was never set: set(\"{0}\", ...)", never.front(),
             labelOf(program)) +
         lastPlace());
  else if (!never.empty())
    find(say("the uniforms {} of {} are 0, as they were never set: set(...), and of this program",
             fmt::format("{}", fmt::join(never, ", ")), labelOf(program)) +
         lastPlace());
}

void onDraw() {
  const GLuint framebuffer = boundForDrawing();
  Target& target = watch.targets[framebuffer];
  ++target.draws;
  listAsWritten(framebuffer);
  if (framebuffer != 0 && target.draws == 1) {
    const std::string fault = incompleteness();
    if (!fault.empty())
      find(say("framebuffer object {} is not complete, so nothing is drawn into it: {}",
               framebuffer, fault) +
           lastPlace());
    target.size = framebufferSize(watch.textures);
  }
  std::array<GLint, 4> viewport{};
  glad_glGetIntegerv(GL_VIEWPORT, viewport.data());
  target.viewports.insert(viewport);

  if (glad_glIsEnabled(GL_DEPTH_TEST) == GL_TRUE && hasDepth()) {
    const GLint comparison = ask(GL_DEPTH_FUNC);
    if (!target.depthCleared && (comparison == GL_LESS || comparison == GL_LEQUAL))
      find(say("the depth test is on, but the depth of {} was not cleared in this frame: what was "
               "there hides what is drawn. glClear(GL_DEPTH_BUFFER_BIT)",
               nameOf(framebuffer)) +
           lastPlace());
    if (!target.colorCleared && framebuffer == 0)
      find(say("the colours of the window are not cleared before objects are drawn: the frame "
               "before shows through. glClear(GL_COLOR_BUFFER_BIT)") +
           lastPlace());
  }
  const auto program = static_cast<GLuint>(ask(GL_CURRENT_PROGRAM));
  const auto [known, isNew] = watch.programs.try_emplace(program);
  if (isNew) known->second = writesClipDistance(program);
  checkClipping(known->second);
  if (isNew) {
    const SamplerFaults faults = samplerFaults();
    for (const std::string& fault : faults.certain) find(fault + lastPlace());
    for (const std::string& fault : faults.perhaps) watch.perhaps.insert(fault + lastPlace());
    if (watch.fromStart) checkUniforms(program);
  }
}

bool draws(std::string_view function) {
  return function.starts_with("glDrawArrays") || function.starts_with("glDrawElements") ||
         function.starts_with("glDrawRangeElements") || function.starts_with("glMultiDraw") ||
         function.starts_with("glDrawTransformFeedback");
}

// Before a call: what it will draw is judged by the state that it finds.
void before(const char* name, GLADapiproc function, int, ...) {
  if (function == nullptr)
    tell(say("{} is not in this machine's OpenGL, and calling it ends the program", name) +
         lastPlace());
  if (draws(name)) onDraw();
}

void after(void*, const char* name, GLADapiproc, int count, ...) {
  const std::string_view function = name;
  va_list arguments;
  va_start(arguments, count);
  if (function == "glClear") {
    onClear(va_arg(arguments, GLbitfield));
  } else if (function.starts_with("glClearBuffer")) {
    const GLenum buffer = va_arg(arguments, GLenum);
    onClear(buffer == GL_COLOR           ? GL_COLOR_BUFFER_BIT
            : buffer == GL_DEPTH         ? GL_DEPTH_BUFFER_BIT
            : buffer == GL_DEPTH_STENCIL ? GL_DEPTH_BUFFER_BIT
                                         : 0);
  } else if (function == "glBlitFramebuffer") {
    Target& target = watch.targets[boundForDrawing()];
    ++target.draws;
    target.colorCleared = target.depthCleared = true;
  } else if (function == "glBindTexture") {
    const GLenum target = va_arg(arguments, GLenum);
    watch.textures.try_emplace(va_arg(arguments, GLuint), target);
  } else if (function == "glBindFramebuffer") {
    va_arg(arguments, GLenum);
    watch.boundAt[va_arg(arguments, GLuint)] = lastPlace();
  } else if (function.starts_with("glUniform") && function != "glUniformBlockBinding") {
    watch.uniformsSet.insert({GLuint(ask(GL_CURRENT_PROGRAM)), va_arg(arguments, GLint)});
  } else if (function.starts_with("glProgramUniform")) {
    const GLuint program = va_arg(arguments, GLuint);
    watch.uniformsSet.insert({program, va_arg(arguments, GLint)});
  } else if (function == "glCullFace") {
    watch.calledAt[name] = lastPlace();
  }
  va_end(arguments);
  // Where the driver tells of errors itself they stay for the program to ask.
  if (!hasDebugSink() && function != "glGetError")
    if (const GLenum error = glad_glGetError(); error != GL_NO_ERROR)
      find(say("{} in {}", errorName(error), name) + lastPlace());
}

bool isOneColor(const Image& picture) {
  const std::vector<std::uint8_t>& bytes = picture.rgba;
  for (std::size_t i = 4; i < bytes.size(); ++i)
    if (i % 4 != 3 && std::abs(int(bytes[i]) - int(bytes[i % 4])) > 1) return false;
  return !bytes.empty();
}

void checkViewports(const glm::ivec2& window) {
  for (auto& [framebuffer, target] : watch.targets) {
    const glm::ivec2 size = framebuffer == 0 ? window : target.size;
    if (target.viewports.size() != 1 || size.x == 0) continue; // several: it's meant so
    const std::array<GLint, 4>& viewport = *target.viewports.begin();
    if (viewport == std::array<GLint, 4>{0, 0, size.x, size.y}) continue;
    find(
        say("the viewport is {} x {} pixels, but {} is {} x {}. Call glViewport after binding what "
            "is drawn into",
            viewport[2], viewport[3], nameOf(framebuffer), size.x, size.y));
  }
}

} // namespace

void watchFrame(bool fromStart) {
  if (!isOn()) return gladUninstallGLDebug();
  watch.on = true;
  watch.fromStart = fromStart;
  gladSetGLPreCallback(before);
  gladSetGLPostCallback(after);
  gladInstallGLDebug();
}

std::vector<GLuint> frameEnds(const glm::ivec2& window) {
  if (!watch.on) return {};
  gladUninstallGLDebug();
  if (const GLuint bound = boundForDrawing(); bound != 0)
    find(say("framebuffer object {} is still bound at the end of the frame; the window needs "
             "glBindFramebuffer(GL_FRAMEBUFFER, 0). It was bound last{}",
             bound, watch.boundAt[bound]));
  checkViewports(window);
  if (glad_glIsEnabled(GL_CULL_FACE) == GL_TRUE && ask(GL_CULL_FACE_MODE) != GL_BACK)
    find(say("culling is left at {}: what faces the eye is not drawn from here on. "
             "glCullFace(GL_BACK)",
             ask(GL_CULL_FACE_MODE) == GL_FRONT ? "GL_FRONT" : "GL_FRONT_AND_BACK") +
         watch.calledAt["glCullFace"]);
  if (watch.targets[0].draws == 0) {
    const bool draws = std::ranges::any_of(
        watch.targets, [](const auto& target) { return target.second.draws > 0; });
    find(!draws
             ? say("nothing is drawn to the window: there is no draw call before the end of the "
                   "frame")
             : say("nothing is drawn to the window: all that this frame draws goes to framebuffer "
                   "objects"));
  } else if (!watch.foundSomething && isOneColor(windowPicture(window))) {
    find(say(
        "{}, though something was drawn there: it lies out of view (gl_Position is projection * "
        "view * model * position), is culled or hidden, or has the background's colour",
        words("all pixels of the window have one colour")));
    for (const std::string& text : watch.perhaps) tell(say("perhaps: {}", text));
  }
  std::vector<GLuint> written = std::move(watch.written);
  TextureTargets textures = std::move(watch.textures);
  watch = {};
  watch.textures = std::move(textures);
  return written;
}

const TextureTargets& knownTextures() {
  return watch.textures;
}

FirstFrameWatch::FirstFrameWatch() {
  windowClears = 0;
  if (isOn()) thread_ = std::thread([this] { wait(); });
}

FirstFrameWatch::~FirstFrameWatch() {
  shown();
  if (thread_.joinable()) thread_.join();
}

void FirstFrameWatch::shown() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  changed_.notify_all();
}

void FirstFrameWatch::wait() {
  constexpr int kLoops = 3; // a frame clears the window once
  std::unique_lock lock(mutex_);
  for (int second = 1; second <= 10; ++second) {
    if (changed_.wait_for(lock, std::chrono::seconds(1), [this] { return over_; })) return;
    if (second < 10 && (second < 3 || windowClears < kLoops)) continue;
    return tell(say("no frame was shown within {} seconds: does the loop call "
                    "window.swapBuffers()?",
                    second));
  }
}

} // namespace gg::detail
