// The rest of every part's catalogue, see grade_catalogue_test.cpp.

#include "chosen.hpp"

#include <gmock/gmock.h>

using namespace tool;

namespace {

class LongCatalogue : public testing::TestWithParam<Catalogued> {};

TEST_P(LongCatalogue, IsGradedAsItSays) {
  gradeCatalogued(GetParam(), true);
}

INSTANTIATE_TEST_SUITE_P(Of, LongCatalogue, testing::ValuesIn(chosen(false)),
                         [](const auto& one) { return one.param.program.name; });

} // namespace
