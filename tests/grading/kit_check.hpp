#pragma once
/// \file
/// `ggrade check` of part mirror.

#include "kit.hpp"

namespace tool {

/// What to expect of part mirror, made once for all tests of the suite.
class Check : public testing::Test {
protected:
  static void SetUpTestSuite() {
    made_ = std::make_unique<TemporaryFolder>();
    fs::copy(expectedOf("mirror"), made_->path(), fs::copy_options::recursive);
  }
  static void TearDownTestSuite() { made_.reset(); }
  static fs::path expected() { return made_->path(); }

  Arguments command(const fs::path& files, const Arguments& more = {}) const {
    Arguments all = {kBuild / "bin/ggrade-check",
                     "mirror",
                     "--expected",
                     expected(),
                     "--folder",
                     files,
                     "--out",
                     folder_.path() / "check.html"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  nlohmann::json checked(const fs::path& files) const {
    const Ended ended = Running(command(files, {"--json"})).wait(100);
    EXPECT_NE(ended.out, "") << ended.errors;
    return ended.out.empty() ? nlohmann::json() : nlohmann::json::parse(ended.out).at(0);
  }

  static inline std::unique_ptr<TemporaryFolder> made_;
  TemporaryFolder folder_;
};

} // namespace tool
