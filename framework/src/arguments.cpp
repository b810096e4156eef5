#include "arguments.hpp"

#include <charconv>

#include "words/words.hpp"

namespace gg::detail {

namespace {

constexpr int kLargest = 16384; // pixels

int side(const std::string& word, std::string_view digits) {
  int value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || value < 1 || value > kLargest)
    throw UsageError(say("--size {}: must be like 640x480, each side 1 to {}", word, kLargest));
  return value;
}

glm::ivec2 parseSize(const std::string& word) {
  const std::size_t x = word.find('x');
  const std::string_view all = word;
  return {side(word, all.substr(0, x)),
          side(word, x == word.npos ? std::string_view() : all.substr(x + 1))};
}

// At once: what is wrong with later arguments is said in it.
void chooseLanguage(const std::string& word) {
  const auto language = parseLanguage(word);
  if (!language) throw UsageError(say("--lang {}: must be en or ja", word));
  setLanguage(*language);
}

} // namespace

Arguments parseArguments(const std::vector<std::string>& words) {
  Arguments result;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::size_t equals = words[i].find('=');
    const std::string option = words[i].substr(0, equals);
    if (option == "--help" || option == "-h") {
      result.help = true;
      continue;
    }
    if (option != "--scene" && option != "--part" && option != "--mesh" && option != "--size" &&
        option != "--lang")
      throw UsageError(say("unknown argument \"{}\"", words[i]));
    if (equals == std::string::npos && i + 1 == words.size())
      throw UsageError(say("{} needs a value", option));
    const std::string value =
        equals != std::string::npos ? words[i].substr(equals + 1) : words[++i];
    if (option == "--scene") result.scene = value;
    if (option == "--part") result.part = value;
    if (option == "--mesh") result.mesh = value;
    if (option == "--size") result.size = parseSize(value);
    if (option == "--lang") chooseLanguage(value);
  }
  if (result.part && result.scene)
    throw UsageError(say("--part and --scene both choose the scene; give one of them"));
  return result;
}

std::string usage(const std::string& program) {
  return say(
      "usage: {} [--part ID | --scene FILE] [--mesh NAME] [--size WIDTHxHEIGHT] [--lang en|ja]\n"
      "  --part ID      draw scene.json as this part of the assignment wants it (default: "
      "all parts)\n"
      "  --scene FILE   draw this scene\n"
      "  --mesh NAME    torus_knot, box, plane or an OBJ file\n"
      "  --size WxH     size of the window in pixels\n"
      "  --lang en|ja   language of what is printed (default: by GG_LANG, else the locale)\n"
      "  --help         print this\n"
      "Keys: Esc closes the window, T shows every texture of the frame, space stops the time,\n"
      "the arrow keys step it, F12 saves the picture.\n",
      program);
}

} // namespace gg::detail
