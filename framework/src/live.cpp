#include "live.hpp"

#include <cstdio>
#include <filesystem>

#include "reload.hpp"
#include "words/words.hpp"
#include <fmt/format.h>
#include <gg/debug.hpp>
#include <gg/error.hpp>
#include <gg/text_file.hpp>

namespace gg::detail {

Live::Live(GLFWwindow* window, std::string title) : window_(window), title_(std::move(title)) {
  watchFrame(true);
}

void Live::keyPressed(int key) {
  constexpr double kStep = 0.1; // seconds
  switch (key) {
  case GLFW_KEY_T:
    tiles_ = !tiles_;
    if (tiles_) watchFrame(false);
    break;
  case GLFW_KEY_SPACE:
    stoppedAt_ = stoppedAt_ ? std::nullopt : std::optional(glfwGetTime());
    break;
  case GLFW_KEY_RIGHT:
  case GLFW_KEY_LEFT:
    stoppedAt_ = std::max(
        stoppedAt_.value_or(glfwGetTime()) + (key == GLFW_KEY_RIGHT ? kStep : -kStep), 0.0);
    break;
  case GLFW_KEY_F12:
    save_ = true;
    break;
  default:
    break;
  }
}

Overlay& Live::overlay() {
  if (!overlay_) overlay_ = std::make_unique<Overlay>();
  return *overlay_;
}

void Live::frameEnds(const glm::ivec2& size) {
  reportErrors(std::string(words("this frame")).c_str());
  firstFrame_.shown();
  const std::vector<GLuint> written = detail::frameEnds(size);
  if (tiles_) overlay().tiles(size, attachmentsOf(written, knownTextures()));
  const Reloaded reloaded = reloadPrograms();
  showErrors(reloaded.errors, size);
  if (save_) save(size);
  if (reloaded.any || tiles_) watchFrame(false);
}

void Live::frameBegins() {
  if (stoppedAt_) glfwSetTime(*stoppedAt_);
}

void Live::showErrors(const std::string& errors, const glm::ivec2& size) {
  if (!errors.empty()) overlay().text(size, errors, 2);
  if (errors == shownErrors_) return;
  shownErrors_ = errors;
  const std::string first = errors.substr(0, errors.find('\n'));
  glfwSetWindowTitle(window_, first.empty() ? title_.c_str() : first.c_str());
}

void Live::save(const glm::ivec2& size) {
  save_ = false;
  std::string file;
  for (int i = 1; file.empty() || std::filesystem::exists(fromUtf8(file)); ++i)
    file = fmt::format("{}-{}.png", title_, i);
  try {
    writePng(file, windowPicture(size));
    std::fprintf(stderr, "%s\n", say("saved {}", file).c_str());
  } catch (const FileError& error) {
    std::fprintf(stderr, "%s\n", error.what());
  }
}

} // namespace gg::detail
