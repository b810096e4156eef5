#include "cli/compare.hpp"

#include "image/difference.hpp"
#include "image/files.hpp"
#include "image/statistics.hpp"
#include "words/words.hpp"

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <exception>
#include <optional>
#include <ostream>
#include <string>
#include <system_error>

namespace ggrade::cli {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;
using gg::say;

// Everything that was found; without `comparable` only `verdict` and `reason` count.
struct Findings {
  CompareExit verdict = CompareExit::fileError;
  std::string reason; // one sentence; empty if the numbers say it all
  bool comparable = false;
  std::size_t pixels = 0;
  int channels = 0;
  ErrorStatistics statistics;
  Comparison tolerant;
  int judgedChannels = 0;
  double structural = 0;
  std::optional<Flip> flip;
  std::optional<Exposures> exposures; // of HDR-FLIP
};

const char* verdictName(CompareExit verdict) {
  switch (verdict) {
  case CompareExit::same:
    return "PASS";
  case CompareExit::warning:
    return "WARNING";
  case CompareExit::failure:
    return "FAILURE";
  case CompareExit::different:
    return "DIFFERENT";
  case CompareExit::fileError:
    break;
  }
  return "ERROR";
}

float warnLimit(const CompareArguments& a) {
  return a.warn.value_or(1e-6f);
}

// idiff's rule: too many pixels over the threshold, or one over the hard limit.
CompareExit verdict(const CompareArguments& a, const ErrorStatistics& s, std::size_t pixels) {
  const auto beyond = [&](std::size_t over, double percent, double hard) {
    return double(over) > percent / 100 * double(pixels) || s.maxError > hard;
  };
  if (beyond(s.failPixels, a.failPercent, a.hardFail)) return CompareExit::failure;
  const bool onlyTiny = !a.warn && s.failPixels == 0 && s.maxError <= a.hardWarn;
  if (onlyTiny) return CompareExit::same;
  if (beyond(s.warnPixels, a.warnPercent, a.hardWarn)) return CompareExit::warning;
  return CompareExit::same;
}

std::string describe(const FileImage& file) {
  const int channels = file.image.channels();
  return channels == 1 ? say("{} with 1 channel", file.image.sizeText())
                       : say("{} with {} channels", file.image.sizeText(), channels);
}

// Why the two cannot be compared; sets verdict and reason. True if they can.
bool comparable(const CompareArguments& a, const FileImage& image, const FileImage& reference,
                Findings& found) {
  const auto named = [](const fs::path& path) { return "'" + path.string() + "'"; };
  if (!sameSize(image.image, reference.image) ||
      image.image.channels() != reference.image.channels()) {
    found.verdict = CompareExit::different;
    found.reason = say("{} is {}, {} is {}; both must have the same size and channels",
                       named(a.image), describe(image), named(a.reference), describe(reference));
    return false;
  }
  for (const auto& [file, path] :
       {std::pair(&image, &a.image), std::pair(&reference, &a.reference)})
    if (const auto bad = findNonFinite(file->image)) {
      found.verdict = CompareExit::failure;
      found.reason = say("{}: {}; such pixels compare with nothing, so no numbers are given",
                         named(*path), bad->text(file->image.channels()));
      return false;
    }
  return true;
}

void addFlip(const CompareArguments& a, const FileImage& image, const FileImage& reference,
             Findings& found) {
  if (image.floats != reference.floats)
    throw std::runtime_error(
        say("--flip: one file holds linear floats, the other display values; save both alike"));
  if (found.channels == 2) throw std::runtime_error(say("--flip: two channels are no colour"));
  if (!image.floats) {
    found.flip = ldrFlip(image.image, reference.image, a.pixelsPerDegree);
    return;
  }
  found.flip = hdrFlip(image.image, reference.image, a.pixelsPerDegree);
  found.exposures = flipExposures(reference.image);
}

Findings compareFiles(const CompareArguments& a, const FileImage& image,
                      const FileImage& reference) {
  Findings found;
  if (!comparable(a, image, reference, found)) return found;
  found.comparable = true;
  found.pixels = reference.image.pixelCount();
  found.channels = reference.image.channels();
  found.statistics = errorStatistics(image.image, reference.image, a.fail, warnLimit(a));
  found.structural = ssim(image.image, reference.image);
  CompareOptions options = a.tolerant;
  if (options.channels == 0) options.channels = std::min(3, found.channels);
  if (options.channels > found.channels)
    throw std::runtime_error(
        say("--channels {}: the images have {}", options.channels, found.channels));
  found.judgedChannels = options.channels;
  found.tolerant = compare(image.image, reference.image, options);
  if (!found.tolerant.compared()) found.reason = found.tolerant.message;
  if (a.flip) addFlip(a, image, reference, found);
  found.verdict = verdict(a, found.statistics, found.pixels);
  return found;
}

// A - B as idiff writes it, but opaque: there, the difference of two alphas makes the picture
// invisible.
Image differenceImage(const CompareArguments& a, const Image& image, const Image& reference) {
  Image result = image;
  for (std::size_t i = 0; i < result.values().size(); ++i) {
    float& value = result.values()[i];
    value -= reference.values()[i];
    if (a.absolute) value = std::abs(value);
    value *= a.scale;
    if (result.channels() == 4 && i % 4 == 3) value = 1;
  }
  return result;
}

bool sameFile(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  return fs::equivalent(a, b, ignored);
}

std::string pixelText(std::span<const float> values) {
  return fmt::format("{:.8g}", fmt::join(values, ", "));
}

void printNumbers(std::ostream& out, const CompareArguments& a, const Findings& found,
                  const Image& image, const Image& reference) {
  const auto line = [&](int indent, const std::string& text) {
    out << std::string(std::size_t(indent), ' ') << text << '\n';
  };
  const auto& s = found.statistics;
  line(2, say("Mean error = {:g}", s.meanError));
  line(2, say("RMS error = {:g}", s.rmsError));
  line(2, say("Peak SNR = {:g}", s.psnr));
  if (s.maxError == 0)
    line(2, say("Max error  = 0"));
  else
    line(2, say("Max error  = {:g} @ ({}, {}, {})  values are {} vs {}", s.maxError, s.maxX, s.maxY,
                channelName(s.maxChannel, found.channels), pixelText(image.pixel(s.maxX, s.maxY)),
                pixelText(reference.pixel(s.maxX, s.maxY))));
  const auto over = [&](std::size_t pixels, double limit) {
    line(2, say("{} pixels ({:.3g}%) over {:g}", pixels,
                100 * double(pixels) / double(found.pixels), limit));
  };
  over(s.failPixels, double(a.fail));
  if (warnLimit(a) != a.fail) over(s.warnPixels, double(warnLimit(a)));
  line(2, say("As grades compare (tolerance {:.4g}, radius {}, {} of {} channels):",
              a.tolerant.tolerance, a.tolerant.radius, found.judgedChannels, found.channels));
  line(4, found.tolerant.message);
  line(4, say("mean difference {:+.4g}, SSIM {:.5f}", found.tolerant.meanDifference,
              found.structural));
  if (!found.flip) return;
  line(2, say("FLIP {:.6f} ({}, {:.4g} pixels per degree)", found.flip->mean,
              found.exposures ? "HDR" : "LDR", a.pixelsPerDegree));
  if (found.exposures)
    line(4, say("the largest of {} exposures from {:+.4g} to {:+.4g} stops", found.exposures->count,
                found.exposures->start, found.exposures->stop));
}

Json jsonOf(const CompareArguments& a, const Findings& found) {
  Json json{{"verdict", verdictName(found.verdict)},
            {"exitCode", int(found.verdict)},
            {"image", a.image.string()},
            {"reference", a.reference.string()}};
  if (!found.reason.empty()) json["reason"] = found.reason;
  if (!found.comparable) return json;
  const auto& s = found.statistics;
  json["pixels"] = found.pixels;
  json["meanError"] = s.meanError;
  json["rmsError"] = s.rmsError;
  json["peakSnr"] = s.psnr; // null for identical images: JSON has no infinity
  json["maxError"] = {
      {"value", s.maxError}, {"x", s.maxX}, {"y", s.maxY}, {"channel", s.maxChannel}};
  json["failPixels"] = s.failPixels;
  json["warnPixels"] = s.warnPixels;
  json["ssim"] = found.structural;
  if (found.flip)
    json["flip"] = {{"mean", found.flip->mean},
                    {"range", found.exposures ? "HDR" : "LDR"},
                    {"pixelsPerDegree", a.pixelsPerDegree}};
  if (found.exposures)
    json["flip"]["exposures"] = {{"start", found.exposures->start},
                                 {"stop", found.exposures->stop},
                                 {"count", found.exposures->count}};
  const auto& t = found.tolerant;
  const auto& w = t.densest;
  json["tolerant"] = {
      {"tolerance", a.tolerant.tolerance},
      {"radius", a.tolerant.radius},
      {"channels", found.judgedChannels},
      {"wrongShare", t.wrongShare},
      {"wrongPixels", t.wrongPixels},
      {"meanDifference", t.meanDifference},
      {"densestWindow",
       {{"x", w.x}, {"y", w.y}, {"width", w.width}, {"height", w.height}, {"share", w.share}}}};
  if (t.worst)
    json["tolerant"]["worst"] = {{"x", t.worst->x},
                                 {"y", t.worst->y},
                                 {"channel", t.worst->channel},
                                 {"error", t.worst->error}};
  return json;
}

void report(const CompareArguments& a, const Findings& found, const FileImage& image,
            const FileImage& reference, std::ostream& out) {
  if (a.json) {
    // Names need not be UTF-8.
    out << jsonOf(a, found).dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    return;
  }
  if (!a.quiet) {
    out << say("Comparing \"{}\" and \"{}\"", a.image.string(), a.reference.string()) << '\n';
    if (found.comparable) printNumbers(out, a, found, image.image, reference.image);
  }
  if (!found.reason.empty()) out << found.reason << '\n';
  if (!a.quiet || found.verdict != CompareExit::same) out << verdictName(found.verdict) << '\n';
}

} // namespace

CompareExit runCompare(const CompareArguments& a, std::ostream& out, std::ostream& errors) try {
  const FileImage image = readImageFile(a.image), reference = readImageFile(a.reference);
  if (!a.quiet && sameFile(a.image, a.reference))
    errors << "ggrade compare: " << say("note: both names are the same file") << '\n';
  for (const auto& [file, path] :
       {std::pair(&image, &a.image), std::pair(&reference, &a.reference)})
    if (!a.quiet && file->parts > 1)
      errors << "ggrade compare: "
             << say("note: '{}' holds several images; only the first is compared", path->string())
             << '\n';
  if (!a.out.empty() && (sameFile(a.out, a.image) || sameFile(a.out, a.reference)))
    throw std::runtime_error(
        say("'{}' is one of the images; give --out another name", a.out.string()));

  const Findings found = compareFiles(a, image, reference);
  if (!a.out.empty() && found.comparable)
    writeImageFile(a.out, found.flip ? heatPicture(found.flip->map)
                                     : differenceImage(a, image.image, reference.image));
  report(a, found, image, reference, out);
  if (!out.flush()) throw std::runtime_error(say("cannot write to standard output"));
  return found.verdict;
} catch (const std::exception& error) {
  errors << "ggrade compare: " << error.what() << '\n';
  if (a.json) {
    Findings failed;
    failed.reason = error.what();
    out << jsonOf(a, failed).dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
  }
  return CompareExit::fileError;
}

} // namespace ggrade::cli
