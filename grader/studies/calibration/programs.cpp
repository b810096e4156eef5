#include "calibration/programs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <set>
#include <stdexcept>

namespace ggrade::calibration {

namespace fs = std::filesystem;
using rubric::RawFrame;

std::string_view name(Kind kind) {
  switch (kind) {
  case Kind::reference:
    return "reference";
  case Kind::variant:
    return "variant";
  case Kind::mistake:
    return "mistake";
  case Kind::pair:
    return "pair";
  case Kind::pictures:
    return "pictures";
  case Kind::stub:
    return "stub";
  }
  return "";
}

namespace {

std::vector<KnownAnswer> everyProgram(const Assignment& assignment,
                                      const grading::Catalogue& catalogue,
                                      const fs::path& solutionFolder) {
  std::vector<KnownAnswer> all;
  KnownAnswer reference;
  reference.kind = Kind::reference;
  reference.name = "reference";
  reference.title = "The reference";
  reference.recipe = {solutionFolder};
  all.push_back(reference);
  for (const grading::Variant& variant : catalogue.variants) {
    KnownAnswer program;
    program.kind = Kind::variant;
    program.name = variant.name;
    program.title = variant.title;
    program.recipe = {solutionFolder, {variant.patch}};
    program.loses = variant.loses;
    program.outcome = variant.outcome;
    all.push_back(std::move(program));
  }
  for (const grading::Mistake& mistake : catalogue.mistakes) {
    KnownAnswer program;
    program.kind = Kind::mistake;
    program.name = mistake.name;
    program.title = mistake.title;
    program.recipe = {solutionFolder, {mistake.patch}};
    program.fails = mistake.fails;
    program.outcome = mistake.outcome;
    all.push_back(std::move(program));
  }
  for (const auto& [first, second] : catalogue.pairs) {
    const grading::Mistake &a = *catalogue.mistake(first), &b = *catalogue.mistake(second);
    KnownAnswer program;
    program.kind = Kind::pair;
    // The part's name once is enough.
    program.name = fmt::format("{} + {}", a.name, b.name.substr(catalogue.part.size() + 1));
    program.title = fmt::format("{}; {}", a.title, b.title);
    program.recipe = {solutionFolder, {a.patch, b.patch}};
    program.of = {a.name, b.name};
    all.push_back(std::move(program));
  }
  for (const PictureKind& kind : pictureKinds()) {
    KnownAnswer program;
    program.kind = Kind::pictures;
    program.name = kind.name;
    program.title = kind.title;
    program.most = kind.most;
    all.push_back(std::move(program));
  }
  KnownAnswer stub;
  stub.kind = Kind::stub;
  stub.name = "stub";
  stub.title = "The files as they are handed out";
  stub.recipe = {assignment.folder};
  all.push_back(stub);
  return all;
}

} // namespace

std::vector<KnownAnswer> programsOf(const Assignment& assignment,
                                    const grading::Catalogue& catalogue,
                                    const fs::path& solutionFolder,
                                    const std::vector<std::string>& only) {
  std::vector<KnownAnswer> all = everyProgram(assignment, catalogue, solutionFolder);
  if (only.empty()) return all;
  std::set<std::string> wanted;
  for (const std::string& one : only) {
    bool found = false;
    for (const KnownAnswer& program : all) {
      const bool named = program.name == one || program.name == catalogue.part + '_' + one ||
                         name(program.kind) == one;
      if (!named) continue;
      found = true;
      wanted.insert(program.name);
      wanted.insert(program.of.begin(), program.of.end());
    }
    if (!found)
      throw UsageError(
          fmt::format("--only {}: {} has no program of this name or kind", one, catalogue.part));
  }
  std::erase_if(all, [&](const KnownAnswer& program) { return !wanted.count(program.name); });
  return all;
}

const std::vector<PictureKind>& pictureKinds() {
  static const std::vector<PictureKind> kinds = {
      {"black", "Black frames"},
      {"grey", "Frames of one grey"},
      {"white", "White frames"},
      {"noise", "Noise"},
      {"frozen", "The first frame again and again", kStillScore},
      {"other scene", "Right pictures, but of another scene"},
      {"public frames", "The public scene's right pictures in every scene"}};
  return kinds;
}

namespace {

/// The picture at the size of `like`: the nearest pixel of `from`, each.
std::vector<std::uint8_t> resized(const RawFrame& from, const RawFrame& like) {
  std::vector<std::uint8_t> pixels(like.pixels.size());
  for (std::uint32_t y = 0; y < like.height; ++y)
    for (std::uint32_t x = 0; x < like.width; ++x) {
      const std::size_t u = std::size_t(x) * from.width / like.width;
      const std::size_t v = std::size_t(y) * from.height / like.height;
      std::copy_n(&from.pixels[(v * from.width + u) * 4], 4,
                  &pixels[(std::size_t(y) * like.width + x) * 4]);
    }
  return pixels;
}

} // namespace

std::vector<RawFrame> pictures(const std::string& kind,
                               const std::vector<std::vector<RawFrame>>& all,
                               const std::vector<bool>& isPublic, std::size_t index) {
  std::vector<RawFrame> frames = all.at(index);
  const auto fill = [&](auto&& value) {
    for (RawFrame& frame : frames)
      for (std::size_t i = 0; i < frame.pixels.size(); ++i)
        frame.pixels[i] = i % 4 == 3 ? 255 : std::uint8_t(value());
  };
  const auto show = [&](std::size_t scene) {
    for (std::size_t i = 0; i < frames.size(); ++i)
      frames[i].pixels = resized(all[scene].at(std::min(i, all[scene].size() - 1)), frames[i]);
  };
  if (kind == "black") {
    fill([] { return 0; });
  } else if (kind == "grey") {
    fill([] { return 128; });
  } else if (kind == "white") {
    fill([] { return 255; });
  } else if (kind == "noise") {
    std::mt19937 engine(static_cast<unsigned>(index));
    fill([&] { return engine() >> 24; });
  } else if (kind == "frozen") {
    for (RawFrame& frame : frames) frame.pixels = frames[0].pixels;
  } else if (kind == "other scene") {
    show((index + 1) % all.size());
  } else if (kind == "public frames") {
    const auto known = std::find(isPublic.begin(), isPublic.end(), true);
    show(known == isPublic.end() ? 0 : std::size_t(known - isPublic.begin()));
  } else {
    throw std::logic_error("no pictures of kind " + kind);
  }
  return frames;
}

} // namespace ggrade::calibration
