#include "grading/reference_pictures.hpp"

#include "report/picture.hpp"

namespace ggrade::grading {

const std::vector<ReferencePictures::Frame>&
ReferencePictures::of(const std::filesystem::path& folder) {
  const std::lock_guard lock(mutex_);
  const auto [entry, fresh] = known_.try_emplace(folder);
  if (fresh)
    for (rubric::RawFrame& raw : rubric::readFrames(folder)) {
      Image image = rubric::toImage(raw);
      std::string png = report::pngDataUri(image);
      entry->second.push_back({std::move(raw), std::move(image), std::move(png)});
    }
  return entry->second;
}

} // namespace ggrade::grading
