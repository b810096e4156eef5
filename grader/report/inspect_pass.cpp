#include "report/inspect_parts.hpp"

#include "report/inspect_words.hpp"
#include "trace/pixels.hpp"
#include "words/words.hpp"

#include <GL/glcorearb.h>
#include <fmt/format.h>

#include <algorithm>

namespace ggrade::report {

using namespace trace;
using gg::say;

namespace {

bool isThere(const ImageRef& image) {
  return image.kind != std::uint32_t(ImageKind::none);
}

std::string clearedTo(const PassRecord& pass, std::uint32_t attachment) {
  if (!(pass.cleared >> attachment & 1)) return "";
  if (attachment == kDepth) return shortest(pass.clearDepth);
  if (attachment == kStencil) return std::to_string(pass.clearStencil);
  const float* c = pass.clearColor;
  return fmt::format("({}, {}, {}, {})", shortest(c[0]), shortest(c[1]), shortest(c[2]),
                     shortest(c[3]));
}

Data attachmentsOf(const FrameGraph& graph, std::uint32_t index) {
  const PassRecord& pass = graph.pass(index);
  Data list = makeList();
  for (std::uint32_t i = 0; i < kAttachments; ++i) {
    if (!isThere(pass.images[i])) continue;
    Data row(Data::type::object);
    row["name"] = Data(attachmentWords(pass, i));
    row["image"] = Data(imageWords(pass.images[i]));
    row["size"] = Data(sizeWords(pass.images[i]));
    row["format"] = pass.images[i].format ? Data(glName(pass.images[i].format)) : Data(false);
    row["cleared"] = line(clearedTo(pass, i));
    const std::uint32_t before = pass.cleared >> i & 1 ? kNone : graph.writerBefore(index, i);
    row["holds"] = before == kNone
                       ? Data(false)
                       : passLink(graph, before, say("pass {}'s", graph.number(before)));
    const bool isOff = i < kColors && !(pass.drawBuffers >> i & 1);
    row["use"] = isOff                   ? Data(say("no draw buffer"))
                 : pass.written >> i & 1 ? Data(false)
                                         : Data(say("unchanged"));
    list.push_back(row);
  }
  return list;
}

std::string drawBuffers(const PassRecord& pass) {
  std::string text;
  for (std::uint32_t i = 0; i < kColors; ++i)
    if (pass.drawBuffers >> i & 1) text += (text.empty() ? "" : ", ") + attachmentWords(pass, i);
  return text.empty() ? say("none") : text;
}

std::string scaleWords(const PagePixels& pixels) {
  const std::string limits = say("black {:.4g}, white {:.4g}", pixels.low, pixels.high);
  if (pixels.scale == "as stored") return "";
  if (pixels.scale == "divided by the greatest value")
    return say("darkened: white is {:.4g}", pixels.high);
  if (pixels.depth)
    return say("distance from the eye, {} (found in {})", limits, pixels.depth->matrix);
  if (pixels.scale == "stretched depth") return say("depth, {}", limits);
  return say("a colour a value");
}

Data pictureOf(const FilmParts& parts, const PagePixels& pixels) {
  const CopyRecord& copy = *pixels.copy;
  const PassRecord& pass = parts.graph.pass(copy.pass);
  std::string name = attachmentWords(pass, copy.attachment);
  if (copy.step != kNone) name += say(" after step {}", copy.step - pass.firstStep + 1);
  Data data(Data::type::object);
  data["name"] = Data(name);
  data["picture"] = pixels.picture.empty() ? Data(false) : Data(pixels.picture);
  data["type"] = Data(trace::pixelTypeName(static_cast<PixelType>(copy.type)));
  data["width"] = Data(std::to_string(copy.width));
  data["height"] = Data(std::to_string(copy.height));
  data["values"] = pixels.values.empty()
                       ? Data(false)
                       : Data(fmt::format("values-{}", &pixels - parts.pixels.copies.data()));
  data["low"] = Data(fmt::format("{:.9g}", pixels.low));
  data["high"] = Data(fmt::format("{:.9g}", pixels.high));
  data["linear"] =
      pixels.depth
          ? Data(fmt::format("{:.17g} {:.17g}", pixels.depth->numerator, pixels.depth->offset))
          : Data(false);
  data["range"] = Data(pixels.range);
  data["scale"] = line(scaleWords(pixels));
  data["notANumber"] = line(pixels.notANumber);
  data["passNumber"] = Data(std::to_string(parts.graph.number(copy.pass)));
  return data;
}

std::string statusText(const PassRecord& pass) {
  return glName(pass.status);
}

} // namespace

Data passLink(const FrameGraph& graph, std::uint32_t pass, std::string_view words) {
  Data link(Data::type::object);
  link["to"] = Data(std::to_string(graph.number(pass)));
  link["words"] = line(words);
  return link;
}

Data notesData(const std::vector<Note>& notes) {
  Data list = makeList();
  for (const Note& note : notes) {
    const auto [state, sign] = note.kind == Note::Kind::wrong ? std::pair("none", "✗")
                               : note.kind == Note::Kind::odd ? std::pair("part", "!")
                                                              : std::pair("plain", "i");
    Data data(Data::type::object);
    data["note"] = line(note.text);
    data["state"] = Data(std::string(state));
    data["sign"] = Data(std::string(sign));
    list.push_back(data);
  }
  return list;
}

Data passOf(const FilmParts& parts, std::uint32_t index) {
  const FrameGraph& graph = parts.graph;
  const PassRecord& pass = graph.pass(index);
  Data data(Data::type::object);
  data["number"] = Data(std::to_string(graph.number(index)));
  data["title"] = line(passTitle(pass));
  data["notes"] = notesData(parts.notes[index - graph.first()]);

  Data pictures = makeList();
  for (const PagePixels* pixels : parts.pixelsOf(index))
    pictures.push_back(pictureOf(parts, *pixels));
  data["hasPictures"] = Data(!parts.pixelsOf(index).empty());
  data["pictures"] = std::move(pictures);

  data["framebuffer"] = pass.framebuffer == kNone ? Data(false)
                        : pass.framebuffer == 0   ? Data(say("0 (the window)"))
                                                  : Data(std::to_string(pass.framebuffer));
  data["incomplete"] = pass.framebuffer == kNone || pass.status == GL_FRAMEBUFFER_COMPLETE
                           ? Data(false)
                           : Data(statusText(pass));
  data["viewport"] = Data(rectangle(pass.viewport));
  data["drawBuffers"] = Data(drawBuffers(pass));
  data["draws"] = Data(say("{}, {} vertices", drawCount(pass.draws), grouped(pass.vertices)));
  data["milliseconds"] =
      pass.seconds > 0 ? Data(fmt::format("{:.2f} ms", pass.seconds * 1e3)) : Data(false);
  data["hasAttachments"] = Data(std::ranges::any_of(pass.images, isThere));
  data["attachments"] = attachmentsOf(graph, index);

  Data reads = makeList(), readers = makeList();
  for (const PassRead& read : graph.readsOf(index))
    reads.push_back(passLink(graph, read.writer, readWords(graph, read)));
  for (const PassRead& read : graph.readersOf(index))
    readers.push_back(passLink(graph, read.reader,
                               say("pass {} (its {})", graph.number(read.reader),
                                   attachmentWords(pass, read.attachment))));
  data["hasReads"] = Data(!graph.readsOf(index).empty());
  data["reads"] = std::move(reads);
  data["hasReaders"] = Data(!graph.readersOf(index).empty());
  data["readers"] = std::move(readers);

  Data messages = makeList();
  bool any = false;
  for (const InspectedMessage& message : parts.frame.messages) {
    if (message.pass != index) continue;
    Data entry(Data::type::object);
    entry["text"] = line(message.text);
    messages.push_back(entry);
    any = true;
  }
  data["hasMessages"] = Data(any);
  data["messages"] = std::move(messages);
  data["steps"] = stepsOf(parts, index);
  return data;
}

} // namespace ggrade::report
