#pragma once
/// \file
/// Which known mistake shows the same as a submission.

#include "diagnosis/views.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ggrade::diagnosis {

/// A known fault, and what it shows in the same scenes.
struct Signature {
  std::string name;
  std::string group; ///< signatures with one group are one diagnosis; empty: its name
  Run run;
  bool wholly = false; ///< named only where everything is alike, as an unfinished program is
};

/// How far apart two pictures are at every pixel, 0 (alike) to 1 (as far as counts): how far a
/// value of one lies outside of the range of the other's values within one pixel, both ways, beyond
/// the tolerance. Null stands for a picture that was not made. Another size is resized to `a`'s.
std::vector<float> distance(const Image* a, const Image* b);

/// Their mean: the share of two pictures that differs, 0 to 1. Of two nulls nothing does.
double differingShare(const Image* a, const Image* b);

/// Do both show the same, but for so little that nobody would see it? Two nulls do.
bool alike(const Image* a, const Image* b);

/// Are all windows of one scene alike?
bool sameWindows(const SceneViews& a, const SceneViews& b);

/// Are all pictures of one scene alike, those of passes, too?
bool samePictures(const SceneViews& a, const SceneViews& b);

/// Has every channel one value all over, within the tolerance?
bool isOneColour(const Image& picture);

/// The first picture of a run that isn't the reference's, in the order in which they are made.
struct FirstWrong {
  std::size_t scene = 0;
  std::optional<Slot> slot;  ///< nothing: only the window is wrong
  std::size_t frame = 0;     ///< of the window; of a pass always 0
  bool missing = false;      ///< the submission has no such picture
  double share = 0;          ///< of its pixels, each by how far it is from right
  double differing = 0;      ///< share of its pixels that differ at all
  double x = 0, y = 0;       ///< where most is wrong, 0 to 1 from the top left
  int width = 0, height = 0; ///< of the submission's picture, pixels; 0 where it is missing
};

/// A picture is wrong from this share of it on.
inline constexpr double kWrongShare = 1e-3;
/// Less than this share of a picture is no difference. What lies between the two may be wrong, and
/// may be another way of drawing the same.
inline constexpr double kFaintShare = 2e-4;

/// Over all scenes the earliest pass of which at least the share `least` is wrong, and the scene
/// where most of it is. Nothing where no picture is wrong.
std::optional<FirstWrong> firstWrong(const Run& student, const Run& reference,
                                     double least = kWrongShare);

/// How much of what is wrong in one of two runs is wrong in the same way in the other.
struct Likeness {
  double windows = 0; ///< over the window's frames; 1: all alike
  double all = 0;     ///< passes, too
  double first = 0;   ///< of the first wrong pass alone; 0 where the two begin to be wrong in
                      ///< different passes
};

/// Compares `student` with `signature` where either differs from `reference`. All have the same
/// scenes.
Likeness likeness(const Run& student, const Run& signature, const Run& reference);

/// What `identify` accepts.
struct Thresholds {
  double like = 0.85;      ///< least likeness
  double firstLike = 0.95; ///< least likeness of the first wrong pass where only that is alike
  double margin = 0.4; ///< what is unlike, at most this share of what is unlike in the next best
  double same = 0.97;  ///< signatures that are as alike as this can't be told apart
  double confidence = 0.9; ///< less is unknown: faults that nobody has listed reach 0.87
};

/// What a submission was found to be like.
struct Identified {
  std::size_t signature = 0;
  std::vector<std::size_t> alike; ///< others that show the same, so that it may be one of them
  enum class By { everything, windows, firstPass } by = By::everything;
  double likeness = 0;   ///< 0 to 1
  double next = 0;       ///< likeness of the best of the others, 0 to 1
  double confidence = 0; ///< 0 to 1
};

/// Calls task(0) ... task(count - 1), in any order, maybe several at a time.
using ForEach =
    std::function<void(std::size_t count, const std::function<void(std::size_t)>& task)>;

/// One after the other.
void inTurn(std::size_t count, const std::function<void(std::size_t)>& task);

/// Known faults, all rendered in the same scenes as the reference.
struct KnownFaults {
  Run reference;
  std::vector<Signature> signatures;
  ForEach forEach = inTurn; ///< signatures are compared so

  /// The signature that shows what the submission shows: in everything; else in the window, if that
  /// fault is not in a pass or the windows are the same and that pass is not the reference's (it
  /// may hold something else where a program is made in another way); else in the first wrong pass
  /// (something else is wrong later).
  /// A program for which that finds nothing is looked at once more with its passes brought into the
  /// reference's way, see `corresponding`: it may make them in another order or encoding.
  /// Nothing where none is like it, two different ones are almost equally like it, or what is
  /// alike holds one value all over, as many faults leave it. Signatures with `leftOut` set are not
  /// considered.
  std::optional<Identified> identify(const Run& student, const Thresholds& thresholds = {},
                                     const std::vector<bool>& leftOut = {}) const;
};

} // namespace ggrade::diagnosis
