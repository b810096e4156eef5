#pragma once
/// \file
/// Which of a submission's programs is which of the reference's.

#include <nlohmann/json.hpp>

#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace ggrade::repair {

/// Programs as draws of a tape have them ("program").
class Programs {
public:
  /// \param blobs that both tapes' stages name; more may come
  Programs(const std::vector<std::vector<std::byte>>& blobs) : blobs_(blobs) {}

  void addOwn(const nlohmann::json& commands);
  void addReferences(const nlohmann::json& commands);

  /// Is it a program that the reference has for something else than `wanted`?
  bool isForSomethingElse(const nlohmann::json& program, const nlohmann::json& wanted) const;

  /// The submission's that is most like this one of the reference's. Null: none is like it.
  const nlohmann::json* likest(const nlohmann::json& wanted);

private:
  /// The share of the wanted program's lines that a program has.
  double likenessOf(const nlohmann::json& program, const nlohmann::json& wanted) const;

  const std::vector<std::vector<std::byte>>& blobs_;
  std::set<nlohmann::json> own_;
  std::set<nlohmann::json> stages_; ///< of the reference's
  std::map<nlohmann::json, const nlohmann::json*> likest_;
};

} // namespace ggrade::repair
