#include "grading/own_tapes.hpp"

namespace ggrade::grading {

namespace fs = std::filesystem;
using repair::Unit;

OwnTapes::OwnTapes(const Target& target, fs::path solutionFolder, const References& references)
    : target_(target), solutionFolder_(std::move(solutionFolder)), references_(references) {}

const tape::Tape& OwnTapes::reference(std::size_t scene) {
  const std::lock_guard lock(mutex_);
  const auto found = reference_.find(scene);
  if (found != reference_.end()) return found->second;
  return reference_
      .emplace(scene, recordOwn(target_, {solutionFolder_}, references_.scenes.at(scene),
                                references_.ownShaders))
      .first->second;
}

const Owners& OwnTapes::owners() {
  const std::lock_guard lock(learning_);
  if (!owners_) owners_.emplace(target_, solutionFolder_);
  return *owners_;
}

const std::map<Unit, std::string>& OwnTapes::unitsOf(const fs::path& patch) {
  const std::lock_guard lock(patches_);
  if (const auto known = unitsOf_.find(patch); known != unitsOf_.end()) return known->second;
  std::map<Unit, std::string> units;
  try {
    const tape::Tape tape = recordOwn(target_, {solutionFolder_, {patch}}, references_.scenes.at(0),
                                      references_.ownShaders);
    for (const repair::Difference& one : repair::compare(tape, reference(0)).differences)
      units.emplace(one.unit, one.own);
  } catch (const NoTape&) {
  }
  return unitsOf_.emplace(patch, std::move(units)).first->second;
}

} // namespace ggrade::grading
