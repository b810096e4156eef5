#include "calibration/programs.hpp"

#include "calibration/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace ggrade::calibration {

namespace fs = std::filesystem;

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

} // namespace ggrade::calibration
