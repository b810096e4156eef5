#pragma once
/// \file
/// What tests of worksheets share.

#include "gradebook/worksheet.hpp"

#include <gtest/gtest.h>

namespace ggrade::gradebook {

inline Entry entry(const std::string& student, std::optional<double> score,
                   const std::string& feedback = "") {
  return {student, "", score, 100, 0, feedback};
}

inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

} // namespace ggrade::gradebook
