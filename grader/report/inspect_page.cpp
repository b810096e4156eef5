#include "report/inspect.hpp"

#include "report/inspect_graph.hpp"
#include "report/inspect_pixels.hpp"
#include "report/inspect_words.hpp"
#include "report/page.hpp"
#include "report/templates.hpp"
#include "report/text.hpp"
#include "trace/trace.hpp"
#include "words/words.hpp"

#include <GL/glcorearb.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace ggrade::report {

using namespace trace;
using gg::say;
using nlohmann::json;

namespace {

/// Indices of the copies that the cards show: of each pass the first main attachment that was
/// copied, else whatever was.
std::vector<std::uint32_t> mainCopies(const FrameGraph& graph) {
  const Trace& trace = graph.trace();
  std::vector<std::uint32_t> best(graph.count(), kNone);
  const auto isMain = [&](const CopyRecord& copy) {
    const auto mains = mainAttachments(graph.pass(copy.pass));
    return std::ranges::find(mains, copy.attachment) != mains.end();
  };
  for (const CopyRecord& copy : trace.copies) {
    if (!graph.holds(copy.pass) || copy.step != kNone) continue;
    std::uint32_t& held = best[copy.pass - graph.first()];
    const auto rank = [&](const CopyRecord& c) { return std::pair(!isMain(c), c.attachment); };
    if (held == kNone || rank(copy) < rank(trace.copies[held]))
      held = std::uint32_t(&copy - trace.copies.data());
  }
  std::erase(best, kNone);
  std::ranges::sort(best);
  return best;
}

/// All that the page is made from.
struct Film {
  const InspectedFrame& frame;
  FrameGraph graph;
  PagePixelsOfFrame pixels;
  std::vector<std::vector<Note>> notes; ///< of each pass of the frame, in order

  Film(const InspectedFrame& inspected, const InspectLimits& limits);

  std::vector<const PagePixels*> pixelsOf(std::uint32_t pass) const {
    std::vector<const PagePixels*> found;
    for (const PagePixels& copy : pixels.copies)
      if (copy.copy->pass == pass) found.push_back(&copy);
    return found;
  }
  double totalSeconds() const {
    double sum = 0;
    for (std::uint32_t i = 0; i < graph.count(); ++i) sum += graph.pass(graph.first() + i).seconds;
    return sum;
  }
};

Film::Film(const InspectedFrame& inspected, const InspectLimits& limits)
    : frame(inspected), graph(inspected.trace, inspected.frame),
      pixels(pagePixels(graph, mainCopies(graph), limits)) {
  for (std::uint32_t i = 0; i < graph.count(); ++i) {
    const std::uint32_t index = graph.first() + i;
    notes.push_back(passNotes(graph, index));
    for (const PagePixels* copy : pixelsOf(index)) {
      const std::string name = attachmentWords(graph.pass(index), copy->copy->attachment);
      if (!copy->notANumber.empty())
        notes.back().push_back({Note::Kind::wrong, say("{}: {}.", name, copy->notANumber)});
      const bool drawn = graph.pass(index).draws > 0 && copy->copy->step == kNone;
      if (copy->uniform && drawn && copy->copy->attachment < kColors)
        notes.back().push_back(
            {Note::Kind::odd, say("{} is the same in every pixel: {}.", name, copy->range)});
    }
  }
}

bool isThere(const ImageRef& image) {
  return image.kind != std::uint32_t(ImageKind::none);
}

/// "12.50 ms"; empty where nothing was measured.
std::string millisecondsOf(const PassRecord& pass) {
  return pass.seconds > 0 ? fmt::format("{:.2f} ms", pass.seconds * 1e3) : "";
}

/// A pass that is linked to: its number and words such as "pass 1's depth".
json passLink(const FrameGraph& graph, std::uint32_t pass, std::string_view words) {
  return {{"to", graph.number(pass)}, {"words", sanitizeLine(words)}};
}

json notesOf(const std::vector<Note>& notes) {
  json list = json::array();
  for (const Note& note : notes) {
    const auto [state, sign] = note.kind == Note::Kind::wrong ? std::pair("none", "✗")
                               : note.kind == Note::Kind::odd ? std::pair("part", "!")
                                                              : std::pair("plain", "i");
    list.push_back({{"note", sanitizeLine(note.text)}, {"state", state}, {"sign", sign}});
  }
  return list;
}

// The strip: a card a pass, and who reads what as lines under the cards.

// As in templates/inspect.css.
constexpr int kCardWidth = 220, kCardGap = 16;
constexpr int kLaneHeight = 8, kLanes = 12;
constexpr int kRadius = 5;

/// One read as a line from under the writer's card to under the reader's.
struct Arc {
  std::uint32_t from, to; ///< cards, counted from 0
  int lane = 0;           ///< 0 is nearest to the cards
};

/// Short lines nearest to the cards; lines that share a stretch in different lanes.
std::vector<Arc> arcsOf(const FrameGraph& graph) {
  std::vector<Arc> arcs;
  for (const PassRead& read : graph.reads())
    if (read.writer < read.reader &&
        (arcs.empty() || arcs.back().from != read.writer - graph.first() ||
         arcs.back().to != read.reader - graph.first()))
      arcs.push_back({read.writer - graph.first(), read.reader - graph.first()});
  std::ranges::stable_sort(arcs, {}, [](const Arc& arc) { return arc.to - arc.from; });
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    unsigned taken = 0;
    for (std::size_t k = 0; k < i; ++k)
      if (arcs[k].from < arcs[i].to && arcs[i].from < arcs[k].to) taken |= 1U << arcs[k].lane;
    while (arcs[i].lane < kLanes - 1 && (taken >> arcs[i].lane & 1)) ++arcs[i].lane;
  }
  return arcs;
}

std::string pathOf(const Arc& arc) {
  constexpr int kStep = kCardWidth + kCardGap;
  // A line leaves right of the card's middle and arrives left of it.
  const int x0 = int(arc.from) * kStep + kCardWidth / 2 + 14;
  const int x1 = int(arc.to) * kStep + kCardWidth / 2 - 14;
  const int y = 14 + arc.lane * kLaneHeight;
  return fmt::format("M{0} 0V{2}q0 {4} {4} {4}H{3}q{4} 0 {4} -{4}V6", x0, x1, y - kRadius,
                     x1 - kRadius, kRadius);
}

json cardsOf(const Film& film) {
  json cards = json::array();
  for (std::uint32_t i = 0; i < film.graph.count(); ++i) {
    const std::uint32_t index = film.graph.first() + i;
    const PassRecord& pass = film.graph.pass(index);
    const auto pixels = film.pixelsOf(index);
    const auto shown =
        std::ranges::find_if(pixels, [](const PagePixels* p) { return !p->thumbnail.empty(); });
    const bool found = shown != pixels.end();
    const auto& notes = film.notes[i];
    const auto count = std::ranges::count_if(
        notes, [](const Note& note) { return note.kind != Note::Kind::fact; });
    const bool wrong =
        std::ranges::any_of(notes, [](const Note& note) { return note.kind == Note::Kind::wrong; });
    std::string reads;
    for (const PassRead& read : film.graph.readsOf(index))
      reads += (reads.empty() ? "" : ", ") + readWords(film.graph, read);
    cards.push_back({{"number", i + 1},
                     {"title", sanitizeLine(passTitle(pass))},
                     {"thumbnail", found ? (*shown)->thumbnail : ""},
                     {"small", found && (*shown)->copy->width < std::uint32_t(kCardWidth)},
                     {"draws", drawCount(pass.draws)},
                     {"milliseconds", millisecondsOf(pass)},
                     {"noteCount", count == 0   ? ""
                                   : count == 1 ? say("1 note")
                                                : say("{} notes", count)},
                     {"state", wrong ? "none" : "part"},
                     {"reads", reads.empty() ? "" : sanitizeLine(say("reads {}", reads))}});
  }
  return cards;
}

/// `arcs` and their drawing's size.
void setArcs(json& page, const FrameGraph& graph) {
  json& list = page["arcs"] = json::array();
  int lanes = 0;
  for (const Arc& arc : arcsOf(graph)) {
    list.push_back({{"from", arc.from + 1}, {"to", arc.to + 1}, {"path", pathOf(arc)}});
    lanes = std::max(lanes, arc.lane + 1);
  }
  page["arcsHeight"] = lanes == 0 ? 0 : 14 + lanes * kLaneHeight;
  page["stripWidth"] = int(graph.count()) * (kCardWidth + kCardGap) - kCardGap;
}

// Steps with state, textures and matrices.

constexpr std::size_t kMatricesShown = 24; ///< of a step; trace.json has all

json stateOf(const StepRecord& step, const StepRecord* before) {
  const std::vector<StateWord> words = stateWords(step);
  const std::vector<StateWord> old = before ? stateWords(*before) : words;
  json list = json::array();
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool changed = words[i].value != old[i].value;
    list.push_back({{"label", words[i].label},
                    {"value", words[i].value},
                    {"changed", changed},
                    {"was", changed ? old[i].value : ""},
                    {"quiet", !changed && words[i].isOff}});
  }
  return list;
}

/// The pass of this frame that drew the texture, as a link; false where none did.
json writerOf(const FrameGraph& graph, const SampleRecord& sample) {
  if (sample.writer == kNone || !graph.holds(sample.writer)) return false;
  std::uint32_t attachment = kNone;
  for (const PassRead& read : graph.readersOf(sample.writer))
    if (const ImageRef& image = graph.pass(sample.writer).images[std::min(read.attachment, 9U)];
        read.attachment != kNone && image.name == sample.image.name &&
        image.kind == sample.image.kind)
      attachment = read.attachment;
  return passLink(graph, sample.writer, readWords(graph, {sample.writer, 0, attachment}));
}

json textureOf(const FrameGraph& graph, const SampleRecord& sample) {
  const bool bound = isThere(sample.image), hasImage = bound && sample.image.width > 0;
  return {{"uniform", sanitizeLine(sample.uniform)},
          {"unit", sample.unit},
          {"texture", bound ? imageWords(sample.image) : say("nothing bound: reads black")},
          {"size", !bound     ? ""
                   : hasImage ? sizeWords(sample.image) + " " + glName(sample.image.format)
                              : say("no image: reads black")},
          {"sampler", hasImage && sample.magFilter ? samplerWords(sample) : ""},
          {"incomplete", hasImage && sample.incomplete != 0},
          {"feedback", sample.feedback != 0},
          {"writer", writerOf(graph, sample)},
          {"earlier", sample.writer < graph.first()},
          {"uploaded", sample.writer == kNone && hasImage}};
}

json matrixOf(const MatrixRecord& matrix) {
  json rows = json::array();
  for (int r = 0; r < 4; ++r) {
    json cells = json::array();
    for (int c = 0; c < 4; ++c) cells.push_back(fmt::format("{:.4g}", matrix.values[c * 4 + r]));
    rows.push_back({{"cells", std::move(cells)}});
  }
  return {{"name", sanitizeLine(matrix.name)}, {"draw", matrix.draw + 1}, {"rows", rows}};
}

bool sameTextures(std::span<const SampleRecord> a, std::span<const SampleRecord> b) {
  return std::ranges::equal(a, b, [](const SampleRecord& x, const SampleRecord& y) {
    return std::memcmp(&x, &y, sizeof x) == 0;
  });
}

json stepsOf(const FrameGraph& graph, std::uint32_t index) {
  const Trace& trace = graph.trace();
  const auto steps = trace.stepsOf(graph.pass(index));
  json list = json::array();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const StepRecord& step = steps[i];
    const StepRecord* before = i > 0 ? &steps[i - 1] : nullptr;
    const bool draws = step.draws > 0;
    const auto samples = trace.samplesOf(step);
    const auto matrices = trace.matricesOf(step);
    const bool same = before && !samples.empty() && sameTextures(samples, trace.samplesOf(*before));
    json textures = json::array(), shown = json::array();
    if (!same)
      for (const SampleRecord& sample : samples) textures.push_back(textureOf(graph, sample));
    for (const MatrixRecord& matrix : matrices.first(std::min(matrices.size(), kMatricesShown)))
      shown.push_back(matrixOf(matrix));
    const std::size_t left = matrices.size() - shown.size();
    list.push_back({{"step", i + 1},
                    {"work", draws ? say("{} of {}, {} vertices", drawCount(step.draws),
                                         modeName(step.mode), grouped(step.vertices))
                                   : ""},
                    {"words", draws ? stateOf(step, before) : json::array()},
                    {"hasState", draws},
                    {"hasTextures", !samples.empty() && !same},
                    {"sameTextures", same},
                    {"textures", std::move(textures)},
                    {"matrices", std::move(shown)},
                    {"matrixCount", matrices.empty() ? json(false) : json(matrices.size())},
                    {"matricesLeft", left == 0 ? json(false) : json(left)}});
  }
  return list;
}

// One pass in full.

std::string clearedTo(const PassRecord& pass, std::uint32_t attachment) {
  if (!(pass.cleared >> attachment & 1)) return "";
  if (attachment == kDepth) return shortest(pass.clearDepth);
  if (attachment == kStencil) return std::to_string(pass.clearStencil);
  const float* c = pass.clearColor;
  return fmt::format("({}, {}, {}, {})", shortest(c[0]), shortest(c[1]), shortest(c[2]),
                     shortest(c[3]));
}

json attachmentsOf(const FrameGraph& graph, std::uint32_t index) {
  const PassRecord& pass = graph.pass(index);
  json list = json::array();
  for (std::uint32_t i = 0; i < kAttachments; ++i) {
    const ImageRef& image = pass.images[i];
    if (!isThere(image)) continue;
    const std::uint32_t before = pass.cleared >> i & 1 ? kNone : graph.writerBefore(index, i);
    const bool isOff = i < kColors && !(pass.drawBuffers >> i & 1);
    const bool isWritten = pass.written >> i & 1;
    list.push_back({{"name", attachmentWords(pass, i)},
                    {"image", imageWords(image)},
                    {"size", sizeWords(image)},
                    {"format", image.format ? glName(image.format) : ""},
                    {"cleared", clearedTo(pass, i)},
                    {"holds", before == kNone ? json(false)
                                              : passLink(graph, before,
                                                         say("pass {}'s", graph.number(before)))},
                    {"use", isOff       ? say("no draw buffer")
                            : isWritten ? ""
                                        : say("unchanged")}});
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

json pictureOf(const Film& film, const PagePixels& pixels) {
  const CopyRecord& copy = *pixels.copy;
  const PassRecord& pass = film.graph.pass(copy.pass);
  std::string name = attachmentWords(pass, copy.attachment);
  if (copy.step != kNone) name += say(" after step {}", copy.step - pass.firstStep + 1);
  return {
      {"name", name},
      {"picture", pixels.picture},
      {"type", pixelTypeName(static_cast<PixelType>(copy.type))},
      {"width", copy.width},
      {"height", copy.height},
      {"values",
       pixels.values.empty() ? "" : fmt::format("values-{}", &pixels - film.pixels.copies.data())},
      {"low", fmt::format("{:.9g}", pixels.low)},
      {"high", fmt::format("{:.9g}", pixels.high)},
      {"linear", pixels.depth
                     ? fmt::format("{:.17g} {:.17g}", pixels.depth->numerator, pixels.depth->offset)
                     : ""},
      {"range", pixels.range},
      {"scale", scaleWords(pixels)},
      {"notANumber", sanitizeLine(pixels.notANumber)},
      {"passNumber", film.graph.number(copy.pass)}};
}

json passOf(const Film& film, std::uint32_t index) {
  const FrameGraph& graph = film.graph;
  const PassRecord& pass = graph.pass(index);
  json pictures = json::array(), reads = json::array(), readers = json::array(),
       messages = json::array();
  for (const PagePixels* pixels : film.pixelsOf(index))
    pictures.push_back(pictureOf(film, *pixels));
  for (const PassRead& read : graph.readsOf(index))
    reads.push_back(passLink(graph, read.writer, readWords(graph, read)));
  for (const PassRead& read : graph.readersOf(index))
    readers.push_back(passLink(graph, read.reader,
                               say("pass {} (its {})", graph.number(read.reader),
                                   attachmentWords(pass, read.attachment))));
  for (const InspectedMessage& message : film.frame.messages)
    if (message.pass == index) messages.push_back(sanitizeLine(message.text));
  const bool isWhole = pass.framebuffer == kNone || pass.status == GL_FRAMEBUFFER_COMPLETE;
  return {{"number", graph.number(index)},
          {"title", sanitizeLine(passTitle(pass))},
          {"notes", notesOf(film.notes[index - graph.first()])},
          {"hasPictures", !pictures.empty()},
          {"pictures", std::move(pictures)},
          {"framebuffer", pass.framebuffer == kNone ? ""
                          : pass.framebuffer == 0   ? say("0 (the window)")
                                                    : std::to_string(pass.framebuffer)},
          {"incomplete", isWhole ? "" : glName(pass.status)},
          {"viewport", rectangle(pass.viewport)},
          {"drawBuffers", drawBuffers(pass)},
          {"draws", say("{}, {} vertices", drawCount(pass.draws), grouped(pass.vertices))},
          {"milliseconds", millisecondsOf(pass)},
          {"hasAttachments", std::ranges::any_of(pass.images, isThere)},
          {"attachments", attachmentsOf(graph, index)},
          {"hasReads", !reads.empty()},
          {"reads", std::move(reads)},
          {"hasReaders", !readers.empty()},
          {"readers", std::move(readers)},
          {"hasMessages", !messages.empty()},
          {"messages", std::move(messages)},
          {"steps", stepsOf(graph, index)}};
}

// The top of the page.

json timesOf(const Film& film) {
  const double total = film.totalSeconds();
  json list = json::array();
  for (std::uint32_t i = 0; i < film.graph.count(); ++i) {
    const double seconds = film.graph.pass(film.graph.first() + i).seconds;
    if (seconds > 0)
      list.push_back({{"to", i + 1},
                      {"grow", fmt::format("{:.4f}", seconds * 1e3)},
                      {"share", fmt::format("{:.0f}%", 100 * seconds / total)},
                      {"wide", seconds > 0.03 * total},
                      {"milliseconds", fmt::format("{:.2f}", seconds * 1e3)}});
  }
  return list;
}

json messagesOf(const Film& film) {
  json list = json::array();
  for (const InspectedMessage& message : film.frame.messages) {
    const bool inPass = message.pass != kNone && film.graph.holds(message.pass);
    list.push_back({{"text", sanitizeLine(message.text)},
                    {"times", message.count > 1 ? grouped(message.count) : ""},
                    {"pass", inPass ? json(film.graph.number(message.pass)) : json(false)}});
  }
  return list;
}

std::string roomWords(const PagePixelsOfFrame& pixels, const InspectLimits& limits) {
  if (pixels.withoutValues == 0) return "";
  const std::string text =
      say("This page is limited to {}: {} of {} pictures are small and without "
          "values under the pointer.",
          byteWords(limits.bytes), pixels.withoutValues, pixels.copies.size());
  if (pixels.withoutPicture == 0) return text;
  return text + ' ' + say("{} of them are left out.", pixels.withoutPicture);
}

/// The exact values, as elements that no browser shows or runs.
std::string valueElements(const Film& film) {
  std::string html;
  for (std::size_t i = 0; i < film.pixels.copies.size(); ++i)
    if (const std::string& values = film.pixels.copies[i].values; !values.empty())
      html += fmt::format(
          "<script type=\"application/octet-stream\" id=\"values-{}\">{}</script>\n", i, values);
  return html;
}

} // namespace

std::string inspectPage(const InspectedFrame& frame, const InspectLimits& limits) {
  const Film film(frame, limits);
  const FrameGraph& graph = film.graph;
  const double milliseconds = film.totalSeconds() * 1e3;
  const bool whole = frame.frame < frame.trace.frames.size();
  const FrameTrace bytes = whole ? frame.trace.frames[frame.frame] : FrameTrace{};
  std::vector<Note> notes = frameNotes(frame);
  if (const std::string left = roomWords(film.pixels, limits); !left.empty())
    notes.push_back({Note::Kind::odd, left});
  json passes = json::array();
  for (std::uint32_t i = 0; i < graph.count(); ++i)
    passes.push_back(passOf(film, graph.first() + i));
  json page = {{"name", sanitizeLine(frame.name)},
               {"time", shortest(float(frame.time))},
               {"size", frame.width ? fmt::format("{} x {}", frame.width, frame.height) : ""},
               {"passCount", graph.count() == 1 ? say("1 pass") : say("{} passes", graph.count())},
               {"hasPasses", graph.count() > 0},
               {"milliseconds", milliseconds > 0 ? fmt::format("{:.1f}", milliseconds) : ""},
               {"times", timesOf(film)},
               {"shadersTimed", frame.shadersTimed},
               {"framesBefore", frame.framesBefore},
               {"renderer", sanitizeLine(frame.renderer)},
               {"imageBytes", whole ? byteWords(bytes.imageBytes) : ""},
               {"bufferBytes", byteWords(bytes.bufferBytes)},
               {"hasMessages", !frame.messages.empty()},
               {"messages", messagesOf(film)},
               {"notes", notesOf(notes)},
               {"cards", cardsOf(film)},
               {"passes", std::move(passes)}};
  setArcs(page, graph);
  std::string html = renderPage({templates::k_inspect_mustache, templates::k_inspect_js,
                                 templates::k_inspect_js_sha256, templates::k_inspect_css, true},
                                std::move(page), say("{}: a frame, pass by pass", frame.name));
  // Not through the template engine, which copies its data several times.
  constexpr std::string_view kPlace = "<!-- values -->\n";
  html.replace(html.find(kPlace), kPlace.size(), valueElements(film));
  return html;
}

} // namespace ggrade::report
