#pragma once
/// \file
/// What proved causes cost: the work of which items they are, and that each costs once
/// (docs/fairness.md).

#include "assignment/assignment.hpp"
#include "results/results.hpp"

#include <map>
#include <string>
#include <vector>

namespace ggrade::grading {

class Charges {
public:
  explicit Charges(const std::vector<ItemDeclaration>& items);

  /// The TODO that an item stands for.
  const std::string& stepOf(const std::string& item) const { return declared_.at(item).step; }

  /// Is this one of the causes the work of an item? Items say what their work is; else it is the
  /// step's that they stand for. What was right from the start is the work of those that keep it.
  bool isWorkOf(const results::ProvedCause& cause, const std::string& item,
                const std::vector<results::ProvedCause>& causes) const;
  /// Are all of them?
  bool areWorkOf(const std::vector<results::ProvedCause>& causes, const std::string& item) const;

  /// Items have what they have where all is repaired that isn't their work; `before`: where nothing
  /// is. A fault is never free: where none of those whose work it is lost anything, the item that
  /// lost most by it loses it, but no more than the work is worth. What was right before and was
  /// spoiled costs the same however many items see it.
  void settle(std::vector<results::Item>& items, const std::vector<results::Item>& before,
              const std::vector<results::ProvedCause>& causes) const;

private:
  bool isNamed(const results::ProvedCause& cause) const;
  std::map<std::string, ItemDeclaration> declared_;
};

} // namespace ggrade::grading
