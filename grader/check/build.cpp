#include "check/build.hpp"

#include "grading/overlay.hpp"
#include "grading/toolchain.hpp"
#include "report/write_file.hpp"

#include <set>

namespace ggrade::check {

namespace fs = std::filesystem;

namespace {

/// All that the compiler reads.
std::string compiledText(const fs::path& folder) {
  std::set<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (grading::isCompiled(entry.path())) files.insert(entry.path());
  std::string text;
  for (const fs::path& file : files) text += file.filename().string() + '\n' + readFile(file);
  return text;
}

/// Was the program built of this very text, with the framework as it is?
bool isBuilt(const fs::path& program, const fs::path& note, const std::string& text) {
  const fs::path framework = fs::path(toolchain::kKitFolder) / "lib" / ".stamp";
  return fs::exists(program) && fs::exists(note) && readFile(note) == text &&
         fs::last_write_time(note) > fs::last_write_time(framework);
}

} // namespace

grading::Happened buildChanged(const Assignment& assignment, const fs::path& folder,
                               const fs::path& program) {
  const fs::path note = program / ".compiled";
  for (const fs::directory_entry& entry : fs::directory_iterator(program))
    if (entry.path() != note && entry.path() != program / assignment.id) fs::remove(entry.path());
  grading::overlay(assignment, folder, program);
  const std::string text = compiledText(program);
  grading::Happened happened;
  happened.outcome = results::Outcome::graded;
  if (isBuilt(program / assignment.id, note, text)) return happened;
  fs::remove(note);
  happened = grading::buildProgram(assignment.id, program, sandbox::Isolation::none);
  if (happened.ok()) report::writeFile(note, text);
  return happened;
}

} // namespace ggrade::check
