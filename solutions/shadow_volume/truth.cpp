// The shadows held against ray-traced ones.

#include "truth_room.hpp"

using namespace shadow_volume_truth;

namespace {

/// Errors:
///   wrong pixels  share of the pixels that show light for shadow or the other way round
///   false shadow  share of the pixels with light that show a shadow
///   false light   share of the pixels in shadow that show light
/// Left out are pixels whose eight neighbours are not all on the same smooth piece of a surface,
/// and all in shadow or all lit; surfaces turned from the lamp; pixels whose two colours are too
/// close to be told apart. Shadows are hard and as fine as the window here, so that nothing else is
/// forgiven: a right picture has no wrong pixel.
truth::Judgement judge(const truth::Rendered& rendered) {
  const auto shadows = truth::kept<Shadows>(rendered, shadowsOf);
  truth::Judgement answer;
  const Counts counts = count(*shadows, rendered.window, &answer.difference);
  const auto share = [](std::size_t wrong, std::size_t of) {
    return of > 0 ? double(wrong) / double(of) : 0;
  };
  answer.errors = {{"wrong pixels", share(counts.wrong(), counts.judged())},
                   {"false shadow", share(counts.falseShadow, counts.lit)},
                   {"false light", share(counts.falseLight, counts.dark)}};
  answer.truth = shadows->picture;
  answer.rendered = firstChannels(rendered.window, 3);
  return answer;
}

GGRADE_TRUTH("shadow_volume", judge);

} // namespace
