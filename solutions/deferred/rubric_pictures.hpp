#pragma once
// What the rubrics of both parts share: pictures that passes drew into textures.

#include "rubric/measures.hpp"
#include "rubric/passes.hpp"

#include <string>
#include <vector>

namespace deferred_rubric {

using namespace ggrade;
using namespace ggrade::rubric;

/// A colour texture that a pass of the first frame drew and a later one read. RGB, as stored, but
/// nothing beyond -4 to 4: more is cut off in the window anyway.
struct Texture {
  Drawn drawn;
  Image image;
};

/// Every texture of a run that is as large as the window, in the order in which they were drawn.
const std::vector<Texture>& texturesOf(const trace::Trace& trace, const Image& window);

/// The reference's texture that its shaders read as `sampler`; null where this scene has none.
const Texture* wanted(const SceneEvidence& scene, const std::string& sampler);

/// Where that texture lies in any trace; empty if it has none under this name.
std::vector<PassOutput> outputOf(const View& view, const std::vector<std::string>& samplers);

/// How right the submission's best texture is, where `region` says.
struct Match {
  double quality = 0;
  const Texture* texture = nullptr;
  std::string message;
};
/// `accept(texture)` says which ones come into question; `name` stands in the message.
template <class Accept>
Match bestMatch(const View& view, const Texture& right, const Mask& region, const std::string& name,
                Accept accept);

/// The same of one texture.
Match match(const Texture& found, const Texture& right, const Mask& region,
            const std::string& name);

template <class Accept>
Match bestMatch(const View& view, const Texture& right, const Mask& region, const std::string& name,
                Accept accept) {
  Match best{0, nullptr, name + ": no pass draws it into a texture that a later pass reads"};
  for (const Texture& found : texturesOf(view.trace, view.scene.reference.at(0))) {
    if (!accept(found)) continue;
    const Match one = match(found, right, region, name);
    if (!best.texture || one.quality > best.quality) best = one;
  }
  return best;
}

/// The window against the reference, where `region(frame)` says; the worst frame.
template <class Region> Verdict picture(const View& view, Region region) {
  return worstFrame(view, [&](std::size_t i) -> Verdict {
    const Mask where = region(i);
    if (tooSmall(where)) return {1, "nothing to see in this frame"};
    return within(view, i, where, "window");
  });
}

/// A picture as right as this is made by passes that are right, in whatever way.
inline constexpr double kRightPicture = 0.9;

/// What the passes show, or the picture if that is right.
Verdict passesOrPicture(const Verdict& passes, const Verdict& picture);

/// Is a later frame that must be the very same as the first one the same? The program is compared
/// with itself, whatever it shows.
Verdict sameAgain(const View& view);

} // namespace deferred_rubric
