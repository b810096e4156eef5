#pragma once
/// \file
/// `ggrade calibrate ID --drift`.

#include <filesystem>
#include <string>
#include <vector>

namespace ggrade::cli {

/// Calibrates anew with each way of drawing that this machine has, in processes of their own with
/// these words (`calibrate ID --seeds 1 ...`), compares the scores with those of the usual way,
/// and writes `out`/drift.json and each way's calibration.
void drift(const std::vector<std::string>& words, const std::filesystem::path& out, bool asJson);

} // namespace ggrade::cli
