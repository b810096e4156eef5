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
#include <utility>
#include <vector>

#include "print_once.hpp"
#include "reload.hpp"
#include "words/words.hpp"

#include <gg/call_place.hpp>
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
  std::string viewportPlace;
  std::optional<std::string> unclearedPlace; // of the first object drawn over old colours
};

// What is known of a program since it drew first.
struct DrawingProgram {
  std::optional<bool> writesClipDistance;
  ActiveUniforms uniforms;
};

// A feedback loop, and what to say of it.
struct Loop {
  GLuint framebuffer;
  std::string text;
};

struct Watch {
  bool on = false;
  bool fromStart = false;                         // from when the window was made
  std::set<std::pair<GLuint, GLint>> uniformsSet; // program, location
  std::map<GLuint, Target> targets;               // by framebuffer; 0: the window
  std::vector<GLuint> written;                    // framebuffer objects: drawn into or cleared
  TextureTargets textures;
  std::map<GLuint, std::string> storedAt; // a 2D texture, where it got its storage last
  std::map<GLuint, std::string> boundAt;  // a framebuffer, last
  std::string viewportPlace;              // of glViewport, or of what should come before it
  std::string boundPlace; // of the program's last call that bound a texture or a framebuffer
  std::map<std::string, std::string> calledAt; // a function, last
  std::map<GLuint, DrawingProgram> programs;
  std::set<GLuint> setSinceUse;             // programs: uniforms since glUseProgram or a draw
  std::map<GLuint, std::string> neverInUse; // programs, and what to say if they draw nothing
  std::map<std::pair<GLuint, std::string>, Loop> loops; // by program and sampler: the first
  bool clippingIsWrong = false, matrixIsWrong = false, programIsMissing = false;
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

void checkUniforms(GLuint program, const ActiveUniforms& uniforms) {
  std::vector<std::string> never;
  for (const auto& [name, location] : zeroUniforms(program, uniforms))
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

// What closes a feedback loop: the draw is often a helper's, which others call, too.
void noteBinding() {
  if (lastCallPlace.isNow) watch.boundPlace = lastPlace();
}

void checkFeedback(GLuint program, const ActiveUniforms& uniforms) {
  const auto loop = feedbackLoop(program, uniforms);
  if (!loop) return;
  const GLuint framebuffer = boundForDrawing();
  watch.loops.try_emplace(
      {program, loop->sampler},
      Loop{framebuffer,
           say("sampler {} of {} reads the texture that is being drawn into ({} of {}), a feedback "
               "loop, whose result is undefined: bind another texture to unit {} or another "
               "framebuffer before drawing; to read another mipmap level of it, set "
               "GL_TEXTURE_BASE_LEVEL and GL_TEXTURE_MAX_LEVEL",
               loop->sampler, labelOf(program), loop->attachment, nameOf(framebuffer), loop->unit) +
               (watch.boundPlace.empty() ? lastPlace() : watch.boundPlace)});
}

void checkMatrices(GLuint program, const ActiveUniforms& uniforms) {
  if (watch.matrixIsWrong) return;
  const std::vector<std::string> names = nonFiniteMatrices(program, uniforms);
  if (names.empty()) return;
  watch.matrixIsWrong = true; // one camera makes many programs' matrices
  find(say("a matrix of {} holds NaN or infinity ({}), so what is drawn with it gets lost: look "
           "for a division by zero, as by near == far or a field of view of 0 in a projection, by "
           "normalize() of a zero vector (in lookAt(), too: a target at the eye, an up along the "
           "view), or by inverse() of a singular matrix such as a scale of 0",
           labelOf(program), fmt::format("{}", fmt::join(names, ", "))) +
       lastPlace());
}

// Where use() is missing, the uniforms of one program are set, and the program before it draws on.
// A right program may set some that don't draw: of a pass that isn't written yet, or has nothing to
// draw in this frame. So only such a program counts that draws nothing up to the frame's end, and
// that is the only one whose uniforms are set between the last draw or glUseProgram and a draw with
// another program, which drew before.
void checkUse(GLuint program, bool isNew) {
  const std::set<GLuint> set = std::exchange(watch.setSinceUse, {});
  if (isNew || set.size() != 1 || set.contains(program)) return;
  const GLuint other = *set.begin();
  watch.neverInUse.try_emplace(
      other, say("{0} draws nothing in this frame: its uniforms are set, but what is drawn next is "
                 "drawn with {1}, which is still in use. set() doesn't change that: call use() of "
                 "{0} (or glUseProgram) before drawing",
                 labelOf(other), labelOf(program)) +
                 lastPlace());
}

// At the end of the frame or, before it, of the program.
void sayIfNeverInUse(GLuint program) {
  const auto found = watch.neverInUse.find(program);
  if (found != watch.neverInUse.end() && !watch.programs.contains(program)) find(found->second);
}

// A quad has no more; the smallest mesh has many more.
constexpr GLsizei kMostOfAScreen = 6;

void onDraw(GLsizei vertices) {
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
  target.viewportPlace = watch.viewportPlace;

  if (glad_glIsEnabled(GL_DEPTH_TEST) == GL_TRUE && hasDepth()) {
    const GLint comparison = ask(GL_DEPTH_FUNC);
    if (!target.depthCleared && (comparison == GL_LESS || comparison == GL_LEQUAL)) {
      const auto bound = watch.boundAt.find(framebuffer); // after that it is missing
      find(say("the depth test is on, but the depth of {} was not cleared in this frame before "
               "this is drawn: what was there hides it. glClear(GL_DEPTH_BUFFER_BIT)",
               nameOf(framebuffer)) +
           (framebuffer != 0 && bound != watch.boundAt.end() ? bound->second : lastPlace()));
    }
    if (!target.colorCleared && framebuffer == 0 && vertices > kMostOfAScreen &&
        !target.unclearedPlace)
      target.unclearedPlace = lastPlace();
  }
  const auto program = static_cast<GLuint>(ask(GL_CURRENT_PROGRAM));
  if (program == 0) {
    if (!watch.programIsMissing && ask(GL_PROGRAM_PIPELINE_BINDING) == 0)
      find(say("something is drawn while no program is in use, which draws nothing: call use() "
               "(or glUseProgram) before it") +
           lastPlace());
    watch.programIsMissing = true;
    return;
  }
  const auto [known, isNew] = watch.programs.try_emplace(program);
  DrawingProgram& drawing = known->second;
  if (isNew) drawing = {writesClipDistance(program), activeUniforms(program)};
  checkClipping(drawing.writesClipDistance);
  checkFeedback(program, drawing.uniforms);
  checkMatrices(program, drawing.uniforms);
  checkUse(program, isNew);
  if (isNew) {
    const SamplerFaults faults = samplerFaults(program, drawing.uniforms);
    for (const auto& [texture, text] : faults.certain) {
      const auto stored = watch.storedAt.find(texture);
      find(text + (stored != watch.storedAt.end() ? stored->second : lastPlace()));
    }
    for (const std::string& fault : faults.perhaps) watch.perhaps.insert(fault + lastPlace());
    if (watch.fromStart) checkUniforms(program, drawing.uniforms);
  }
}

void onUniform(GLuint program, GLint location) {
  watch.uniformsSet.insert({program, location});
  if (program != 0) watch.setSinceUse.insert(program);
}

// A program that is deleted or linked anew; its name may come back as another one's.
void forget(GLuint program) {
  watch.programs.erase(program);
  watch.setSinceUse.erase(program);
  watch.neverInUse.erase(program);
}

bool draws(std::string_view function) {
  return function.starts_with("glDrawArrays") || function.starts_with("glDrawElements") ||
         function.starts_with("glDrawRangeElements") || function.starts_with("glMultiDraw") ||
         function.starts_with("glDrawTransformFeedback");
}

// Before a call: what it will draw is judged by the state that it finds.
void before(const char* name, GLADapiproc function, int count, ...) {
  if (function == nullptr)
    tell(say("{} is not in this machine's OpenGL, and calling it ends the program", name) +
         lastPlace());
  if (!draws(name)) return;
  const std::string_view draw = name;
  GLsizei vertices = kMostOfAScreen + 1; // or more
  va_list arguments;
  va_start(arguments, count);
  if (draw == "glDrawArrays") {
    va_arg(arguments, GLenum);
    va_arg(arguments, GLint);
    vertices = va_arg(arguments, GLsizei);
  } else if (draw == "glDrawElements") {
    va_arg(arguments, GLenum);
    vertices = va_arg(arguments, GLsizei);
  }
  va_end(arguments);
  onDraw(vertices);
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
    noteBinding();
    const GLenum target = va_arg(arguments, GLenum);
    watch.textures.try_emplace(va_arg(arguments, GLuint), target);
  } else if (function == "glTexImage2D" || function == "glTexStorage2D") {
    if (va_arg(arguments, GLenum) == GL_TEXTURE_2D)
      watch.storedAt[GLuint(ask(GL_TEXTURE_BINDING_2D))] = lastPlace();
  } else if (function == "glBindFramebuffer") {
    noteBinding();
    va_arg(arguments, GLenum);
    watch.boundAt[va_arg(arguments, GLuint)] = lastPlace();
    watch.viewportPlace = lastPlace(); // where it is missing, unless it comes after this
  } else if (function.starts_with("glUniform") && function != "glUniformBlockBinding") {
    onUniform(GLuint(ask(GL_CURRENT_PROGRAM)), va_arg(arguments, GLint));
  } else if (function.starts_with("glProgramUniform")) {
    const GLuint program = va_arg(arguments, GLuint);
    onUniform(program, va_arg(arguments, GLint));
  } else if (function == "glUseProgram") {
    watch.setSinceUse.clear();
  } else if (function == "glDeleteProgram") {
    const GLuint program = va_arg(arguments, GLuint);
    sayIfNeverInUse(program);
    forget(program);
  } else if (function == "glLinkProgram") {
    forget(va_arg(arguments, GLuint));
  } else if (function == "glViewport") {
    watch.viewportPlace = lastPlace();
  } else if (function == "glCullFace" || function == "glColorMask") {
    watch.calledAt[name] = lastPlace();
  }
  va_end(arguments);
  // Where the driver tells of errors itself they stay for the program to ask.
  if (!hasDebugSink() && function != "glGetError")
    if (const GLenum error = glad_glGetError(); error != GL_NO_ERROR)
      find(say("{} in {}", errorName(error), name) + lastPlace());
  lastCallPlace.isNow = false;
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
    const bool isMoved = viewport[2] == size.x && viewport[3] == size.y;
    const bool isNothing = viewport[2] == 0 || viewport[3] == 0;
    find((isMoved
              ? say("the viewport of {} begins at ({}, {}). {}", nameOf(framebuffer), viewport[0],
                    viewport[1], words("It should begin at (0, 0)"))
              : say("the viewport is {} x {} pixels, but {} is {} x {}. {}", viewport[2],
                    viewport[3],
                    framebuffer == 0
                        ? nameOf(framebuffer)
                        : say("the first attachment of framebuffer object {}", framebuffer),
                    size.x, size.y,
                    isNothing ? words("Is the size that it is given ever set?")
                              : words("Is glViewport called after binding what is drawn into, and "
                                      "with its size? Or has that a wrong size?"))) +
         target.viewportPlace);
  }
}

// Textures are still there in the next one.
void forgetFrame() {
  TextureTargets textures = std::move(watch.textures);
  std::map<GLuint, std::string> storedAt = std::move(watch.storedAt);
  watch = {};
  watch.textures = std::move(textures);
  watch.storedAt = std::move(storedAt);
}

} // namespace

void watchFrame(bool fromStart) {
  if (!isOn()) return gladUninstallGLDebug();
  if (fromStart) forgetFrame(); // of a window that showed none
  watch.on = true;
  watch.fromStart = fromStart;
  gladSetGLPreCallback(before);
  gladSetGLPostCallback(after);
  gladInstallGLDebug();
}

std::vector<GLuint> frameEnds(const glm::ivec2& window) {
  if (!watch.on) return {};
  gladUninstallGLDebug();
  const GLuint bound = boundForDrawing();
  if (bound != 0)
    find(say("framebuffer object {} is still bound at the end of the frame; the window needs "
             "glBindFramebuffer(GL_FRAMEBUFFER, 0){}",
             bound, watch.boundAt[bound]));
  for (const auto& [reader, loop] : watch.loops)
    if (loop.framebuffer != bound) find(loop.text); // else it comes of that
  if (const Target& target = watch.targets[0]; target.unclearedPlace)
    find((target.colorCleared
              ? say("objects are drawn into the window, and its colours are cleared after that, "
                    "which wipes them out: should they go into a framebuffer object, and is one "
                    "bound for drawing (GL_FRAMEBUFFER)? Or does the clear come too late?")
              : say("the colours of the window are not cleared before objects are drawn, so that "
                    "what was there stays around them. glClear(GL_COLOR_BUFFER_BIT), or should "
                    "they go into a framebuffer object?")) +
         *target.unclearedPlace);
  checkViewports(window);
  for (const auto& [program, text] : watch.neverInUse) sayIfNeverInUse(program);
  if (glad_glIsEnabled(GL_CULL_FACE) == GL_TRUE && ask(GL_CULL_FACE_MODE) != GL_BACK)
    find(say("culling is left at {}: what faces the eye is not drawn from here on. "
             "glCullFace(GL_BACK)",
             ask(GL_CULL_FACE_MODE) == GL_FRONT ? "GL_FRONT" : "GL_FRONT_AND_BACK") +
         watch.calledAt["glCullFace"]);
  GLboolean mask[4] = {};
  glad_glGetBooleanv(GL_COLOR_WRITEMASK, mask);
  if (std::ranges::find(mask, GL_TRUE) == std::end(mask))
    find(say("colours are left masked: from here on none is written, and the next frame isn't "
             "cleared. glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE)") +
         watch.calledAt["glColorMask"]);
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
        "view * model * position), is culled or hidden, or has that one colour itself",
        words("all pixels of the window have one colour")));
    for (const std::string& text : watch.perhaps) tell(say("perhaps: {}", text));
  }
  std::vector<GLuint> written = std::move(watch.written);
  forgetFrame();
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
