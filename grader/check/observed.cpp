#include "check/observed.hpp"

#include "check/places.hpp"
#include "grading/overlay.hpp"
#include "report/text.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <regex>
#include <sstream>
#include <utility>

namespace ggrade::check {

namespace fs = std::filesystem;
using gg::say;

namespace {

/// Rounded sizes are as right.
bool sameSize(const diagnosis::Sampled& a, const diagnosis::Sampled& b) {
  const auto near = [](std::uint32_t m, std::uint32_t n) {
    return std::max(m, n) - std::min(m, n) <= 1;
  };
  return near(a.width, b.width) && near(a.height, b.height);
}

/// Is anything drawn into a texture of this size?
bool drawsInto(const trace::Trace& trace, const diagnosis::Sampled& size) {
  return std::ranges::any_of(trace.passes, [&](const trace::PassRecord& pass) {
    return std::ranges::any_of(pass.images, [&](const trace::ImageRef& image) {
      return image.kind == std::uint32_t(trace::ImageKind::texture) &&
             sameSize({false, image.width, image.height}, size);
    });
  });
}

/// What is sampled before this part begins may be another part's, which may not be done.
bool isOwn(const Expected& expected, const std::string& sampler) {
  return !expected.samplers[0].contains(sampler);
}

/// A sampler that doesn't read what it reads in the reference after as many TODOs.
struct SamplerFault {
  std::string sampler, text;
  bool isStorage = false; ///< no texture of the right size is there that could be read
};

/// The step since which a sampler should read what it should read after `step` TODOs.
std::size_t since(const Expected& expected, std::size_t step, const std::string& sampler) {
  const diagnosis::Sampled& wanted = expected.samplers[step].at(sampler);
  while (step > 1) {
    const auto before = expected.samplers[step - 1].find(sampler);
    if (before == expected.samplers[step - 1].end() || before->second != wanted) break;
    --step;
  }
  return step;
}
std::vector<SamplerFault> samplerFaults(const Expected& expected, std::size_t step,
                                        const trace::Trace& trace) {
  std::vector<SamplerFault> faults;
  const auto sampled = diagnosis::sampledTextures(trace);
  for (const auto& [sampler, wanted] : expected.samplers[step]) {
    if (!isOwn(expected, sampler)) continue;
    const auto found = sampled.find(sampler);
    if (found == sampled.end())
      faults.push_back({sampler, say("The sampler {} reads no texture: does its shader use it, is "
                                     "one bound to the texture unit that it is set to, and has "
                                     "that one storage (glTexImage2D)?",
                                     sampler)});
    else if (found->second.isDepth != wanted.isDepth)
      faults.push_back(
          {sampler,
           wanted.isDepth
               ? say("The sampler {} reads colours, not depths: another texture is bound to the "
                     "unit that it is set to. Was its unit made active (glActiveTexture) before "
                     "yours was bound, and unit 0 again after it?",
                     sampler)
               : say("The sampler {} reads depths, not colours: another texture is bound to the "
                     "unit that it is set to. Was its unit made active (glActiveTexture) before "
                     "yours was bound, and unit 0 again after it?",
                     sampler)});
    else if (found->second.width > 0 && !sameSize(found->second, wanted)) {
      const auto [width, height] = std::pair(found->second.width, found->second.height);
      const bool isStorage = !drawsInto(trace, wanted);
      faults.push_back(
          {sampler,
           isStorage ? say("The sampler {} reads a texture of {} x {} pixels, and should read one "
                           "of {} x {}: which size does its storage get?",
                           sampler, width, height, wanted.width, wanted.height)
                     : say("The sampler {} reads a texture of {} x {} pixels where it reads last, "
                           "and should read one of {} x {}: is another one bound to its unit, has "
                           "this one the "
                           "wrong size, or is a draw missing, too many, or in another place?",
                           sampler, width, height, wanted.width, wanted.height),
           isStorage});
    } else if (!found->second.isComplete && wanted.byObject && !found->second.byObject)
      faults.push_back(
          {sampler, say("The sampler {} reads black, as the texture's own filter wants "
                        "mipmaps: is the sampler object bound to its unit "
                        "(glBindSampler)?",
                        sampler)});
  }
  return faults;
}

constexpr std::string_view kViewport =
    "Is glViewport called after binding what is drawn into, and with its size? Or has that a wrong "
    "size?";

constexpr std::string_view kPlaced[] = {
    "It should begin at (0, 0)",
    "is incomplete: its filter wants mipmaps, and it has none. Set GL_TEXTURE_MIN_FILTER to "
    "GL_NEAREST or GL_LINEAR",
    "is incomplete: it holds whole numbers, which can't be filtered. Set both filters to "
    "GL_NEAREST",
    "colours are left masked: from here on none is written, and the next frame isn't cleared. "
    "glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE)"};

/// The first TODO in whose lines one of these lies.
std::string firstTodo(const std::vector<std::string>& texts, const std::vector<std::string>& todos,
                      const Expected& expected, const fs::path& folder) {
  for (const std::string& text : texts) {
    const std::string todo = todoAt(text, todos, stubFolder(expected.folder), folder);
    if (std::ranges::find(expected.todos, todo) != expected.todos.end()) return todo;
  }
  return {};
}

/// Some of what the doctor says has the place where it is to be mended, not where it shows.
/// \param knowsSizes of textures that are drawn into
void takePlaced(Observed& observed, const Expected& expected, bool knowsSizes,
                const std::vector<std::string>& todos, const fs::path& folder) {
  const auto has = [](const std::string& fault, std::string_view what) {
    return fault.find(gg::words(what)) != fault.npos;
  };
  for (const std::string& fault : observed.faults)
    if (observed.todo.empty() &&
        (std::ranges::any_of(kPlaced, [&](std::string_view what) { return has(fault, what); }) ||
         (has(fault, kViewport) && (knowsSizes || has(fault, "the window"))))) {
      observed.todo = firstTodo({fault}, todos, expected, folder);
      observed.isSure = !observed.todo.empty();
    }
}

/// Stands a name in a text, and not as a part of another? In Japanese no spaces are around it.
bool hasWord(const std::string& text, const std::string& name) {
  const auto isOfAName = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
  };
  for (std::size_t at = text.find(name); at != text.npos; at = text.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    if ((at == 0 || !isOfAName(text[at - 1])) && (end == text.size() || !isOfAName(text[end])))
      return true;
  }
  return false;
}

/// Says the doctor that distances are written and not clipped by, or not written?
bool isClippedOtherwise(const std::string& fault) {
  return fault.find("GL_CLIP_DISTANCE0") != fault.npos &&
         fault.find("gl_ClipDistance") != fault.npos;
}

/// The TODO that asks for distances, by its comment; empty: none does.
std::string clippingTodo(const fs::path& stub) {
  static const std::regex asks(R"(TODO\(([\w.]+)\):.*gl_ClipDistance)");
  for (const fs::directory_entry& file : fs::directory_iterator(stub)) {
    std::smatch match;
    if (file.path().extension() != ".vert") continue;
    const std::string text = readFile(file.path());
    if (std::regex_search(text, match, asks)) return match[1];
  }
  return {};
}

/// Where shaders write distances.
std::vector<std::string> clippingPlaces(const fs::path& folder) {
  std::vector<std::string> places;
  for (const fs::directory_entry& file : fs::directory_iterator(folder)) {
    if (file.path().extension() != ".vert") continue;
    std::istringstream lines(readFile(file.path()));
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number)
      if (line.substr(0, line.find("//")).find("gl_ClipDistance") != line.npos)
        places.push_back(fmt::format("({}:{})", file.path().filename().string(), number));
  }
  return places;
}

} // namespace

std::string doctorsPrefix() {
  return say("frame doctor: {}", "");
}

std::vector<std::string> doctorsFindings(const std::vector<std::string>& messages) {
  const std::string doctor = doctorsPrefix(), perhaps = doctor + say("perhaps: {}", "");
  std::vector<std::string> found;
  for (const std::string& text : messages)
    if (text.starts_with(doctor) && !text.starts_with(perhaps))
      found.push_back(text.substr(doctor.size()));
  return found;
}

void dropPointless(std::vector<std::string>& messages, const Expected& expected, std::size_t step) {
  const std::string perhaps = doctorsPrefix() + say("perhaps: {}", "");
  std::erase_if(messages, [&](const std::string& text) {
    return text.starts_with(perhaps) &&
           std::ranges::none_of(expected.samplers[step], [&](const auto& sampler) {
             return isOwn(expected, sampler.first) && hasWord(text, sampler.first);
           });
  });
}

Observed observe(const Expected& expected, std::size_t step, const trace::Trace& trace,
                 const std::vector<std::string>& messages,
                 const std::vector<channel::CapturedMessage>& captured,
                 const std::vector<std::string>& todos, const fs::path& folder) {
  Observed observed;
  const std::string frustum = frustumFault(expected.frustum, trace);
  observed.isFrustum = !frustum.empty();
  if (observed.isFrustum) observed.faults.push_back(frustum);
  for (std::string& fault : diagnosis::stateFaults(trace))
    observed.faults.push_back(std::move(fault));
  const std::vector<SamplerFault> samplers = samplerFaults(expected, step, trace);
  if (!samplers.empty()) observed.misread = samplers[0].sampler;
  observed.isStorage = std::ranges::any_of(samplers, &SamplerFault::isStorage);
  const std::string doctor = doctorsPrefix();
  const auto said = std::ranges::find_if(messages, [&](const std::string& text) {
    // Of a texture that shouldn't be read at all it says nothing to the point.
    return text.starts_with(doctor) &&
           std::ranges::none_of(samplers, [&](const SamplerFault& fault) {
             return fault.isStorage || hasWord(text, fault.sampler);
           });
  });
  // What it says after that are guesses.
  if (said != messages.end()) {
    const std::string text = said->substr(doctor.size());
    const bool vague = text.starts_with(gg::words("all pixels of the window have one colour"));
    (vague ? observed.guess : observed.faults.emplace_back()) = text;
  }
  observed.isState = !observed.faults.empty();
  for (const SamplerFault& fault : samplers) observed.faults.push_back(fault.text);

  std::vector<std::string> errors;
  for (const channel::CapturedMessage& message : captured)
    // What is drawn into an incomplete framebuffer object fails where it is drawn.
    if (message.kind == channel::MessageKind::glError &&
        message.text.find("GL_INVALID_FRAMEBUFFER_OPERATION") == message.text.npos)
      errors.push_back(message.text);
  // The program's own words have the line, too, where the driver's haven't.
  const std::string error = say("OpenGL: error: {}", "");
  for (const std::string& message : messages)
    if (message.starts_with(error) &&
        message.find("GL_INVALID_FRAMEBUFFER_OPERATION") == message.npos)
      errors.push_back(message);
  observed.todo =
      frustum.empty() ? firstTodo(errors, todos, expected, folder) : expected.frustum.todo;
  observed.isSure = !observed.todo.empty() && frustum.empty(); // others may be drawn with
  // Where something is sampled, its size was looked at.
  const bool knowsSizes = std::ranges::any_of(
      expected.samplers[step], [&](const auto& sampler) { return isOwn(expected, sampler.first); });
  takePlaced(observed, expected, knowsSizes, todos, folder);
  std::size_t first = expected.todos.size() + 1;
  for (const SamplerFault& fault : samplers)
    if (!fault.isStorage) first = std::min(first, since(expected, step, fault.sampler));
  if (observed.todo.empty() && first <= expected.todos.size())
    observed.todo = expected.todos[first - 1];
  if (observed.todo.empty()) observed.todo = firstTodo(observed.faults, todos, expected, folder);
  if (std::ranges::any_of(observed.faults, isClippedOtherwise)) {
    observed.cardTodo = clippingTodo(stubFolder(expected.folder));
    if (observed.cardTodo.empty())
      observed.cardTodo = firstTodo(clippingPlaces(folder), todos, expected, folder);
  }
  return observed;
}

void observeElsewhere(Observed& observed, const Expected& expected,
                      const std::vector<std::string>& findings,
                      const std::vector<std::string>& todos, const fs::path& folder) {
  for (const std::string& text : findings)
    if (!text.starts_with(gg::words("all pixels of the window have one colour")))
      observed.faults.push_back(text);
  observed.isState = !observed.faults.empty();
  takePlaced(observed, expected, false, todos, folder);
  if (observed.todo.empty() && std::ranges::any_of(observed.faults, [](const std::string& fault) {
        return fault.find("NaN") != fault.npos;
      })) {
    observed.todo = expected.frustum.todo;
    observed.isFrustum = !observed.todo.empty();
  }
}

std::string readerOf(const Expected& expected, const std::string& sampler) {
  if (!expected.samplers.back().contains(sampler) || !isOwn(expected, sampler)) return {};
  return expected.todos[since(expected, expected.todos.size(), sampler) - 1];
}

std::set<std::string> bindingForTheWindow(const Expected& expected, std::size_t step,
                                          const trace::Trace& trace) {
  std::set<std::string> todos;
  for (const trace::PassRecord& pass : trace.passesOf(0)) {
    if (pass.framebuffer != 0) continue;
    for (const trace::StepRecord& draw : trace.stepsOf(pass))
      for (const trace::SampleRecord& sample : trace.samplesOf(draw))
        if (expected.samplers[step].contains(sample.uniform))
          todos.insert(readerOf(expected, sample.uniform));
  }
  todos.erase(""); // another part's
  return todos;
}

std::string wrongEncoding(const Assignment& assignment, const fs::path& folder) {
  std::string message, separator = ": ";
  for (const std::string& name : grading::ownFiles(assignment, folder)) {
    const std::string text = readFile(folder / name);
    const std::size_t valid = report::validUtf8(text);
    if (valid == text.size()) continue;
    if (message.empty())
      message = say(
          "{}:{}: warning: this file is not UTF-8; it may be Shift_JIS, of which some characters "
          "swallow the next line when they end a comment. Save it as UTF-8 (in Visual Studio "
          "Code: the encoding at the bottom right, then \"Save with Encoding\")",
          name, 1 + std::ranges::count(text.substr(0, valid), '\n'));
    message += std::exchange(separator, ", ") + name;
  }
  return message;
}

} // namespace ggrade::check
