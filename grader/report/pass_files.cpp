#include "report/pass_files.hpp"

#include "image/png.hpp"
#include "report/write_file.hpp"
#include "trace/picture.hpp"

#include <fmt/format.h>

#include <bit>

namespace ggrade::report {

namespace {

/// Without the ending.
std::string nameOf(const trace::Trace& trace, const trace::CopyRecord& copy) {
  const trace::PassRecord& pass = trace.passes.at(copy.pass);
  const std::string step =
      copy.step == trace::kNone ? "" : fmt::format("step-{}-", copy.step - pass.firstStep);
  return fmt::format("frame-{}/pass-{:02}-{}{}", pass.frame, copy.pass, step,
                     trace::attachmentName(copy.attachment));
}

std::string floatBytes(const Image& image) {
  static_assert(std::endian::native == std::endian::little);
  const auto values = image.values();
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

} // namespace

std::vector<trace::CopyFiles> writePassFiles(const trace::Trace& trace,
                                             const std::filesystem::path& folder, bool raw) {
  std::vector<trace::CopyFiles> all;
  for (const trace::CopyRecord& copy : trace.copies) {
    const std::string name = nameOf(trace, copy);
    std::filesystem::create_directories((folder / name).parent_path());
    const trace::CopyPicture picture = trace::picture(trace, copy);
    trace::CopyFiles files{name + ".png", "", picture.scale, picture.low, picture.high};
    writePng(folder / files.image, picture.rgb, PngEffort::fast);
    if (raw) {
      files.raw = name + ".f32";
      writeFile(folder / files.raw, floatBytes(trace.image(copy)));
    }
    all.push_back(std::move(files));
  }
  return all;
}

} // namespace ggrade::report
