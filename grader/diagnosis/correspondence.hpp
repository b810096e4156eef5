#pragma once
/// \file
/// Which of a program's passes are the reference's, where a program makes them in another way: in
/// another order or encoding, or some of them not at all.

#include "diagnosis/views.hpp"

namespace ggrade::diagnosis {

/// How well a pixel of `a` tells what the same pixel of `b` is, 0 (not at all) to 1: the share of
/// b's variance that a explains, whatever function it takes (the correlation ratio of Roche et al.,
/// "The correlation ratio as a new similarity measure for multimodal image registration", MICCAI
/// 1998). 0 if `b` has one colour all over. `b` is resized to `a`'s size.
double correlationRatio(const Image& a, const Image& b);

/// Do both hold the same in two encodings, as normals do with and without an offset?
bool holdTheSame(const Image& a, const Image& b);

/// `run` with its passes in the reference's slots: what is most alike belongs together. What holds
/// the same as the reference's is the reference's; what belongs to none is left out.
Run corresponding(const Run& run, const Run& reference);

/// `reference` without the passes that `run` lacks: nothing can be said of them.
Run withPassesOf(const Run& run, const Run& reference);

} // namespace ggrade::diagnosis
