#include "report/inspect_parts.hpp"

#include "report/inspect_words.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace ggrade::report {

using namespace trace;
using gg::say;

namespace {

constexpr std::size_t kMatricesShown = 24; ///< of a step; trace.json has all

Data stateOf(const StepRecord& step, const StepRecord* before) {
  const std::vector<StateWord> words = stateWords(step);
  const std::vector<StateWord> old = before ? stateWords(*before) : words;
  Data list = makeList();
  for (std::size_t i = 0; i < words.size(); ++i) {
    Data row(Data::type::object);
    row["label"] = Data(words[i].label);
    row["value"] = Data(words[i].value);
    const bool changed = words[i].value != old[i].value;
    row["changed"] = Data(changed);
    row["was"] = changed ? Data(old[i].value) : Data(false);
    row["quiet"] = Data(!changed && words[i].isOff);
    list.push_back(row);
  }
  return list;
}

Data textureOf(const FrameGraph& graph, const SampleRecord& sample) {
  Data row(Data::type::object);
  row["uniform"] = line(sample.uniform);
  row["unit"] = Data(std::to_string(sample.unit));
  const bool bound = sample.image.kind != std::uint32_t(ImageKind::none);
  const bool hasImage = bound && sample.image.width > 0;
  row["texture"] = Data(bound ? imageWords(sample.image) : say("nothing bound: reads black"));
  row["size"] = bound && !hasImage ? Data(say("no image: reads black"))
                : bound ? Data(sizeWords(sample.image) + " " + glName(sample.image.format))
                        : Data(false);
  row["sampler"] = hasImage && sample.magFilter ? Data(samplerWords(sample)) : Data(false);
  row["incomplete"] = Data(hasImage && sample.incomplete != 0);
  row["feedback"] = Data(sample.feedback != 0);
  row["writer"] = Data(false);
  row["earlier"] = Data(sample.writer < graph.first());
  row["uploaded"] = Data(sample.writer == kNone && hasImage);
  if (sample.writer != kNone && graph.holds(sample.writer)) {
    std::uint32_t attachment = kNone;
    for (const PassRead& read : graph.readersOf(sample.writer))
      if (const ImageRef& image = graph.pass(sample.writer).images[std::min(read.attachment, 9U)];
          read.attachment != kNone && image.name == sample.image.name &&
          image.kind == sample.image.kind)
        attachment = read.attachment;
    row["writer"] =
        passLink(graph, sample.writer, readWords(graph, {sample.writer, 0, attachment}));
  }
  return row;
}

Data matrixOf(const MatrixRecord& matrix) {
  Data data(Data::type::object);
  data["name"] = line(matrix.name);
  data["draw"] = Data(std::to_string(matrix.draw + 1));
  Data rows = makeList();
  for (int r = 0; r < 4; ++r) {
    Data row(Data::type::object), cells = makeList();
    for (int c = 0; c < 4; ++c) {
      Data cell(Data::type::object);
      cell["cell"] = Data(fmt::format("{:.4g}", matrix.values[c * 4 + r]));
      cells.push_back(cell);
    }
    row["cells"] = std::move(cells);
    rows.push_back(row);
  }
  data["rows"] = std::move(rows);
  return data;
}

bool sameTextures(std::span<const SampleRecord> a, std::span<const SampleRecord> b) {
  return std::ranges::equal(a, b, [](const SampleRecord& x, const SampleRecord& y) {
    return std::memcmp(&x, &y, sizeof x) == 0;
  });
}

} // namespace

Data stepsOf(const FilmParts& parts, std::uint32_t index) {
  const Trace& trace = parts.graph.trace();
  const auto steps = trace.stepsOf(parts.graph.pass(index));
  Data list = makeList();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const StepRecord& step = steps[i];
    const StepRecord* before = i > 0 ? &steps[i - 1] : nullptr;
    Data data(Data::type::object);
    data["step"] = Data(std::to_string(i + 1));
    data["work"] = step.draws == 0 ? Data(false)
                                   : Data(say("{} of {}, {} vertices", drawCount(step.draws),
                                              modeName(step.mode), grouped(step.vertices)));
    data["words"] = step.draws == 0 ? makeList() : stateOf(step, before);
    data["hasState"] = Data(step.draws > 0);

    const auto samples = trace.samplesOf(step);
    const bool same = before && !samples.empty() && sameTextures(samples, trace.samplesOf(*before));
    Data textures = makeList();
    if (!same)
      for (const SampleRecord& sample : samples) textures.push_back(textureOf(parts.graph, sample));
    data["hasTextures"] = Data(!samples.empty() && !same);
    data["sameTextures"] = Data(same);
    data["textures"] = std::move(textures);

    const auto matrices = trace.matricesOf(step);
    Data shown = makeList();
    for (const MatrixRecord& matrix : matrices.first(std::min(matrices.size(), kMatricesShown)))
      shown.push_back(matrixOf(matrix));
    data["matrices"] = std::move(shown);
    data["matrixCount"] = matrices.empty() ? Data(false) : Data(std::to_string(matrices.size()));
    data["matricesLeft"] = matrices.size() > kMatricesShown
                               ? Data(std::to_string(matrices.size() - kMatricesShown))
                               : Data(false);
    list.push_back(data);
  }
  return list;
}

} // namespace ggrade::report
