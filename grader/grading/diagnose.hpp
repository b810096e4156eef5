#pragma once
/// \file
/// From a judged submission to the words of its diagnosis.

#include "grading/grade.hpp"

namespace ggrade::grading {

/// The items of a part that lost points as the submission draws, without the bonus.
std::vector<std::string> lostItems(const results::Result& result, const Part& part);

/// Does a mistake of the catalogue change one of these things, too?
using Agrees =
    std::function<bool(const Mistake& mistake, const std::vector<results::ProvedCause>& causes)>;

/// At most one diagnosis a part that lost points, and none where nothing was lost; one for all
/// where the outcome says it.
/// \param leftOut names of mistakes that are not to be known, for measuring
/// Throws UsageError for a fault in the catalogue, and Interrupted.
std::vector<results::Diagnosis>
diagnosesOf(const Target& target, const Graded& graded,
            const std::function<Diagnoser&(const Part&)>& diagnoserOf, const Agrees& agrees,
            const std::set<std::string>& leftOut = {});

} // namespace ggrade::grading
