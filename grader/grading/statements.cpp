#include "grading/statements.hpp"

#include "authoring/solution_blocks.hpp"
#include "report/write_file.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ggrade::grading {

namespace fs = std::filesystem;

namespace {

/// The file beside a program that says which statement it leaves out, from 1.
constexpr const char* kFile = "left_out";

/// Stands at the top of each file.
constexpr const char* kSwitch = R"(#ifndef GGRADE_LEFT_OUT
#define GGRADE_LEFT_OUT
#include <filesystem>
#include <fstream>
inline bool ggradeLeavesOut(int statement) {{
  static const int leftOut = [] {{
    int number = 0;
    std::ifstream(std::filesystem::read_symlink("/proc/self/exe").parent_path() / "{}") >> number;
    return number;
  }}();
  return statement == leftOut;
}}
#endif
)";

bool isWhole(const std::string& line) {
  return std::ranges::count(line, '(') == std::ranges::count(line, ')');
}

} // namespace

Statements::Statements(const Target& target, const fs::path& solutionFolder) : target_(target) {
  writeFiles(target.assignment, {solutionFolder}, sources_.path());
  for (const std::string& file : target.assignment.files)
    if (file.ends_with(".cpp") || file.ends_with(".hpp"))
      report::writeFile(sources_.path() / file,
                        withSwitches(readFile(sources_.path() / file), file));
  program_.emplace(target.assignment, Recipe{sources_.path()});
  if (const Happened& built = program_->build(); !built.ok())
    throw std::runtime_error("the solution isn't compiled with a switch before each statement: " +
                             built.output);
}

std::string Statements::withSwitches(const std::string& text, const std::string& file) {
  const auto isTargets = [&](const std::string& todo) {
    return std::ranges::any_of(target_.parts, [&](const Part& part) {
      return std::ranges::find(part.todos, todo, &Todo::id) != part.todos.end();
    });
  };
  std::string out = fmt::format(kSwitch, kFile);
  for (const authoring::BlockLine& line : authoring::blockLines(text, file)) {
    if (line.marker || !isTargets(line.todo) || !authoring::isPlainStatement(line.text) ||
        !isWhole(line.text)) {
      out += line.text + '\n';
      continue;
    }
    todos_.push_back(line.todo);
    const std::string statement = line.text.substr(0, line.text.rfind(';'));
    out += fmt::format("ggradeLeavesOut({}) ? void() : void({});\n", todos_.size(), statement);
  }
  return out;
}

Rendering Statements::renderWithout(std::size_t at, const nlohmann::json& scene,
                                    const Moments& times, const ShaderCache& shaders,
                                    const trace::Request& trace) {
  TemporaryFolder work(programs_.path());
  const fs::path folder = work.makeVisible("program");
  fs::copy(program_->folder(), folder, fs::copy_options::recursive);
  report::writeFile(folder / kFile, std::to_string(at + 1));
  return renderScene(target_.assignment.id, folder, scene, times, shaders, isolation(), trace);
}

} // namespace ggrade::grading
