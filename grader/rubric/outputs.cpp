#include "rubric/rubric.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace ggrade::rubric {

using nlohmann::json;

namespace {

std::map<std::string, Finder>& finders() {
  static std::map<std::string, Finder> all;
  return all;
}

/// Tags of the scenes that show items after this one, whatever stands between them.
std::set<std::string> tagsAfter(const std::string& item,
                                const std::vector<ItemDeclaration>& items) {
  std::set<std::string> tags;
  for (const ItemDeclaration& other : items) {
    if (other.after != item) continue;
    tags.insert(other.scenes.begin(), other.scenes.end());
    tags.merge(tagsAfter(other.id, items));
  }
  return tags;
}

bool hasAny(const SceneEvidence& scene, const std::set<std::string>& tags) {
  return std::any_of(tags.begin(), tags.end(), [&](const auto& tag) { return scene.has(tag); });
}

const trace::ImageRef& imageOf(const trace::Trace& trace, const PassOutput& output) {
  return trace.passes.at(output.pass).images[output.attachment];
}

/// Textures of equal size and format, of which the reference's has been copied.
bool match(const trace::Trace& own, const PassOutput& a, const trace::Trace& reference,
           const PassOutput& b) {
  const trace::ImageRef &image = imageOf(own, a), &wanted = imageOf(reference, b);
  return image.kind == std::uint32_t(trace::ImageKind::texture) && image.kind == wanted.kind &&
         image.format == wanted.format && image.width == wanted.width &&
         image.height == wanted.height && image.samples == 0 && a.attachment < trace::kStencil &&
         (a.attachment == trace::kDepth) == (b.attachment == trace::kDepth) &&
         reference.copyOf(b.pass, b.attachment);
}

json pairsOf(const Finder& finder, const SceneEvidence& scene) {
  const std::vector<PassOutput> own = finder({scene, scene.student, scene.studentTrace});
  if (own.empty()) return {};
  const std::vector<PassOutput> wanted = finder({scene, scene.reference, scene.referenceTrace});
  if (own.size() != wanted.size()) return {};
  json pairs = json::array();
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (!match(scene.studentTrace, own[i], scene.referenceTrace, wanted[i])) return {};
    pairs.push_back({own[i].pass, own[i].attachment, wanted[i].pass, wanted[i].attachment});
  }
  return pairs;
}

/// What the item has earned in a scene; 0 in one that it doesn't look at.
double creditIn(const Decision& decision, const std::string& scene) {
  for (const results::SceneCredit& one : decision.credits)
    if (one.scene == scene) return one.credit;
  return 0;
}

} // namespace

bool addFinder(const std::string& item, Finder finder) {
  return finders().emplace(item, std::move(finder)).second;
}

json outputsOf(const ItemDeclaration& item, const std::vector<ItemDeclaration>& items,
               const Decision& decision, const Evidence& evidence) {
  const auto finder = finders().find(item.id);
  if (finder == finders().end() || !evidence.again.empty() || decision.credit >= kNearlyAll)
    return {};
  const std::set<std::string> tags = tagsAfter(item.id, items);
  json all;
  for (std::size_t i = 0; i < evidence.scenes.size(); ++i) {
    const SceneEvidence& scene = evidence.scenes[i];
    if (!hasAny(scene, tags) || scene.student.size() < scene.frameCount ||
        creditIn(decision, scene.name) >= kNearlyAll)
      continue;
    if (json pairs = pairsOf(finder->second, scene); !pairs.empty())
      all.push_back({{"scene", i}, {"pairs", std::move(pairs)}});
  }
  return all;
}

} // namespace ggrade::rubric
