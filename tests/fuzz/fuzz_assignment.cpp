// Any bytes as an assignment's declarations, as the grader reads them. Only UsageError may be
// thrown, with the file; points and weights that are taken can be added up.
#include "require.hpp"

#include "../unit/framework_temporary_folder.hpp"

#include "assignment/assignment.hpp"

#include <cmath>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ggrade;
  static const TemporaryFolder folder;
  const auto file =
      folder.write("floor/assignment.json", {reinterpret_cast<const char*>(data), size});
  try {
    const Assignment assignment = Assignment::load(file.parent_path());
    require(assignment.id == "floor");
    Target whole{assignment, assignment.parts, "floor"};
    require(std::isfinite(whole.maxScore()) && whole.maxScore() >= 0);
    for (const ItemDeclaration& item : whole.items())
      require(std::isfinite(item.points) && item.points >= 0);
  } catch (const UsageError& error) {
    require(std::string(error.what()).starts_with(file.string()));
  }
  return 0;
}
