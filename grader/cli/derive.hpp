#pragma once
/// \file
/// What an assignment hands out, made from its solution.

#include "assignment/assignment.hpp"
#include "capture/channel_reader.hpp"
#include "grading/workspace.hpp"
#include "image/image.hpp"

#include <filesystem>
#include <set>

namespace ggrade::cli {

/// The editable files with the given TODOs filled in, into a folder that is there.
void writeSources(const Assignment& assignment, const std::filesystem::path& solutions,
                  const std::set<std::string>& filled, const std::filesystem::path& into);

/// The solution with some of its TODOs filled in, built to draw with.
class Program {
public:
  /// `name` is for errors. Throws UsageError where it doesn't build.
  Program(const Assignment& assignment, const std::filesystem::path& solutions,
          const std::set<std::string>& filled, const std::string& name);
  /// Throws UsageError where it doesn't render.
  channel::Capture draw(const nlohmann::json& scene, const std::vector<double>& times) const;

private:
  grading::TemporaryFolder folder_;
  std::string assignment_, name_;
};

/// The first frame's window.
Image window(const channel::Capture& capture);

/// Writes the stub, the handout's texts and, if `pictures`, the picture of every step (in
/// `into/handout`; the programs are built and run for them) into `into`. Throws UsageError for a
/// solution with a fault.
void deriveInto(const Assignment& assignment, const std::filesystem::path& solutions,
                const std::filesystem::path& into, bool pictures);

} // namespace ggrade::cli
