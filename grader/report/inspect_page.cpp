#include "report/inspect_parts.hpp"

#include "report/inspect_words.hpp"
#include "report/templates.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ggrade::report {

using namespace trace;
using gg::say;

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

Data times(const FilmParts& parts) {
  Data list = makeList();
  for (std::uint32_t i = 0; i < parts.graph.count(); ++i) {
    const PassRecord& pass = parts.graph.pass(parts.graph.first() + i);
    if (!(pass.seconds > 0)) continue;
    Data bar(Data::type::object);
    bar["to"] = Data(std::to_string(i + 1));
    bar["grow"] = Data(fmt::format("{:.4f}", pass.seconds * 1e3));
    bar["share"] = Data(fmt::format("{:.0f}%", 100 * pass.seconds / parts.totalSeconds()));
    bar["wide"] = Data(pass.seconds > 0.03 * parts.totalSeconds());
    bar["milliseconds"] = Data(fmt::format("{:.2f}", pass.seconds * 1e3));
    list.push_back(bar);
  }
  return list;
}

Data messages(const FilmParts& parts) {
  Data list = makeList();
  for (const InspectedMessage& message : parts.frame.messages) {
    Data entry(Data::type::object);
    entry["text"] = line(message.text);
    entry["times"] = message.count > 1 ? Data(grouped(message.count)) : Data(false);
    entry["pass"] = message.pass != kNone && parts.graph.holds(message.pass)
                        ? Data(std::to_string(parts.graph.number(message.pass)))
                        : Data(false);
    list.push_back(entry);
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
std::string valueElements(const FilmParts& parts) {
  std::string html;
  for (std::size_t i = 0; i < parts.pixels.copies.size(); ++i)
    if (const std::string& values = parts.pixels.copies[i].values; !values.empty())
      html += fmt::format(
          "<script type=\"application/octet-stream\" id=\"values-{}\">{}</script>\n", i, values);
  return html;
}

} // namespace

FilmParts::FilmParts(const InspectedFrame& inspected, const InspectLimits& limits)
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

std::vector<const PagePixels*> FilmParts::pixelsOf(std::uint32_t pass) const {
  std::vector<const PagePixels*> found;
  for (const PagePixels& copy : pixels.copies)
    if (copy.copy->pass == pass) found.push_back(&copy);
  return found;
}

double FilmParts::totalSeconds() const {
  double sum = 0;
  for (std::uint32_t i = 0; i < graph.count(); ++i) sum += graph.pass(graph.first() + i).seconds;
  return sum;
}

std::string inspectPage(const InspectedFrame& frame, const InspectLimits& limits) {
  const FilmParts parts(frame, limits);
  Data page(Data::type::object);
  addLanguage(page);
  page["name"] = line(frame.name);
  page["time"] = Data(shortest(float(frame.time)));
  page["size"] =
      frame.width ? Data(fmt::format("{} x {}", frame.width, frame.height)) : Data(false);
  page["passCount"] =
      Data(parts.graph.count() == 1 ? say("1 pass") : say("{} passes", parts.graph.count()));
  page["hasPasses"] = Data(parts.graph.count() > 0);
  const bool measured = parts.totalSeconds() > 0;
  page["milliseconds"] =
      measured ? Data(fmt::format("{:.1f}", parts.totalSeconds() * 1e3)) : Data(false);
  page["times"] = times(parts);
  page["shadersTimed"] = Data(frame.shadersTimed);
  page["renderer"] = line(frame.renderer);
  const bool whole = frame.frame < frame.trace.frames.size();
  const FrameTrace bytes = whole ? frame.trace.frames[frame.frame] : FrameTrace{};
  page["imageBytes"] = whole ? Data(byteWords(bytes.imageBytes)) : Data(false);
  page["bufferBytes"] = Data(byteWords(bytes.bufferBytes));
  page["hasMessages"] = Data(!frame.messages.empty());
  page["messages"] = messages(parts);
  std::vector<Note> notes = frameNotes(frame);
  if (const std::string left = roomWords(parts.pixels, limits); !left.empty())
    notes.push_back({Note::Kind::odd, left});
  page["notes"] = notesData(notes);
  page["cards"] = cardsOf(parts);
  addArcs(parts, page);
  Data passes = makeList();
  for (std::uint32_t i = 0; i < parts.graph.count(); ++i)
    passes.push_back(passOf(parts, parts.graph.first() + i));
  page["passes"] = std::move(passes);

  std::string html = renderPage({templates::k_inspect_mustache, templates::k_inspect_js,
                                 templates::k_inspect_js_sha256, templates::k_inspect_css},
                                std::move(page), say("{}: a frame, pass by pass", frame.name));
  // Not through the template engine, which copies its data several times.
  constexpr std::string_view kPlace = "<!-- values -->\n";
  html.replace(html.find(kPlace), kPlace.size(), valueElements(parts));
  return html;
}

} // namespace ggrade::report
