#pragma once
/// \file
/// What must hold of every kit, for tests.

#include "tool.hpp"

namespace tool {

/// The states of a part's TODOs, as ggrade-check sees the files in `folder`; `said` becomes all
/// that it says.
std::vector<std::string> statesOf(const std::string& part, const fs::path& expected,
                                  const fs::path& folder, std::string* said = nullptr);

/// What `check` expects of a part, or of "floor": all parts. Made once.
fs::path expectedOf(const std::string& part);

/// Takes out the lines that are comments alone.
void takeOutComments(const fs::path& folder);

/// A kit of these assignments with everything to do, as `release` made it: no solution is in it,
/// and each step's program has the first k TODOs done and nothing else begun.
void expectKit(const fs::path& kit, const Ended& released,
               const std::vector<ggrade::Assignment>& assignments);

/// A kit of part "ssao" builds itself and says that nothing is begun.
void expectThatItChecks(const fs::path& kit, Environment environment);

} // namespace tool
