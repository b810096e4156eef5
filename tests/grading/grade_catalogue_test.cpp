// Mistakes and right answers of every part's catalogue: a mistake loses the item that it must, a
// right answer loses nothing. The rest of the catalogue: long_catalogue_test.cpp.

#include "chosen.hpp"

#include <gmock/gmock.h>

using namespace tool;

namespace {

class Catalogue : public testing::TestWithParam<Catalogued> {};

TEST_P(Catalogue, IsGradedAsItSays) {
  gradeCatalogued(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Of, Catalogue, testing::ValuesIn(chosen(true)),
                         [](const auto& one) { return one.param.program.name; });

} // namespace
