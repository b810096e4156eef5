#pragma once
/// \file
/// Identifiers that a person takes for one another.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ggrade::gradebook {

/// Equal for identifiers that are equal or look it: plainIdentifier in Normalization Form KC,
/// without case and without what shows nothing (zero-width characters, signs of direction), runs of
/// white space as one space, none at the ends; Cyrillic and Greek letters that look like Latin ones
/// as these. The table of letters is our own and far smaller than Unicode's confusables.txt: no
/// digits (0 and o, 1 and l), no other scripts.
/// \param identifier what is not UTF-8 in it counts as U+FFFD
std::string skeleton(std::string_view identifier);

/// To each identifier the places of the others that look like it.
std::vector<std::vector<std::size_t>> lookAlikes(const std::vector<std::string>& identifiers);

/// In quotes, with whatever can't be seen or is taken for another letter by its number:
/// `"ada\u{200B}"`, `"\u{430}da"`; spaces at the ends or beside others as `␣`.
std::string visible(std::string_view identifier);

} // namespace ggrade::gradebook
