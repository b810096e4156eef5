#pragma once
// What the rubrics of both parts share: pictures that passes drew into textures.

#include "rubric/measures.hpp"
#include "rubric/passes.hpp"
#include "words/words.hpp"

#include <map>
#include <string>
#include <vector>

namespace deferred_rubric {

using namespace ggrade;
using namespace ggrade::rubric;

/// What `make()` says of something that stays where it is (a scene, a frame, a trace): worked out
/// once, however many items ask. One table for each place that calls it.
template <class Make> const auto& remembered(const void* of, Make make) {
  static std::map<const void*, decltype(make())> known;
  const auto found = known.find(of);
  return found != known.end() ? found->second : known.emplace(of, make()).first->second;
}

/// A colour texture that a pass of the first frame drew and a later one read. RGB, as stored, but
/// of light nothing beyond -4 to 4: more is cut off in the window anyway.
struct Texture {
  Drawn drawn;
  Image image;
};

/// Every texture of a run that is as large as the window, in the order in which they were drawn.
const std::vector<Texture>& texturesOf(const trace::Trace& trace, const Image& window);

/// The reference's texture that its shaders read as `sampler`; null where this scene has none.
const Texture* wanted(const SceneEvidence& scene, const std::string& sampler);

/// Where that texture lies in any trace; empty if it has none under this name.
std::vector<PassOutput> outputOf(const trace::Trace& trace,
                                 const std::vector<std::string>& samplers);

/// The same of textures that objects are drawn into. Where some of them are attached but not drawn
/// into, as without glDrawBuffers: all that the reference's pass draws, in the first pass that
/// draws objects into textures.
std::vector<PassOutput> outputOfObjects(const View& view, const std::vector<std::string>& samplers);

/// What a picture is worth that no texture has.
Verdict nowhere(const std::string& name);

/// How right the submission's best texture is, where `region` says.
struct Match {
  Verdict verdict;
  const Texture* texture = nullptr; ///< null: there is none that comes into question
};
/// `accept(texture)` says which ones come into question; `name` stands in the message.
/// `nothingLeft`: the share of wrong pixels at which it is worth nothing.
template <class Accept>
Match bestMatch(const View& view, const Texture& right, const Mask& region, const std::string& name,
                Accept accept, double nothingLeft = kNothingLeft);

/// The same of one texture.
Match match(const Texture& found, const Texture& right, const Mask& region, const std::string& name,
            double nothingLeft = kNothingLeft);

template <class Accept>
Match bestMatch(const View& view, const Texture& right, const Mask& region, const std::string& name,
                Accept accept, double nothingLeft) {
  Match best{nowhere(name)};
  for (const Texture& found : texturesOf(view.trace, view.scene.reference.at(0))) {
    if (!accept(found)) continue;
    const Match one = match(found, right, region, name, nothingLeft);
    if (!best.texture || one.verdict.quality > best.verdict.quality) best = one;
  }
  return best;
}

/// What several pictures are worth together: half of it the worst of them, half of it their mean.
/// One that is wrong costs most of it, but those that are right are worth something.
Verdict together(const std::vector<Verdict>& pictures);

/// The window against the reference, where `region(frame)` says; the worst frame.
template <class Region> Verdict picture(const View& view, Region region) {
  return worstFrame(view, [&](std::size_t i) -> Verdict {
    const Mask where = region(i);
    if (tooSmall(where)) return {1, gg::say("nothing to see in this frame")};
    return within(view, i, where, gg::say("window"));
  });
}

/// A picture as right as this is made by passes that are right, in whatever way.
inline constexpr double kRightPicture = 0.97;

/// What the passes show, or the picture if that is right.
Verdict passesOrPicture(const Verdict& passes, const Verdict& picture);

/// Is a later frame that must be the very same as the first one the same? The program is compared
/// with itself, whatever it shows.
Verdict sameAgain(const View& view);

/// Do outlines in the window change place when time passes? Likewise with itself.
Verdict outlinesFollow(const View& view);

} // namespace deferred_rubric
