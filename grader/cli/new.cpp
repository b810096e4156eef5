#include "authoring/derive.hpp"
#include "authoring/new_assignment.hpp"
#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "grading/toolchain.hpp"
#include "grading/workspace.hpp"

#include <fmt/format.h>

namespace ggrade::cli {

namespace fs = std::filesystem;

namespace {

const fs::path kRoot = toolchain::kSourceFolder;

/// One side of the new assignment: made aside, then moved into place.
class Side {
public:
  Side(const std::string& name, const std::string& id, const std::string& title)
      : aside_(kRoot / name, "Give yourself write permission, or work in a copy of this tree"),
        made_(aside_.path() / id), place_(kRoot / name / id) {
    const fs::path templates = kRoot / "grader/authoring/new" / name / "new_assignment";
    authoring::writeTemplate(templates, id, title, made_);
  }

  const fs::path& made() const { return made_; }
  /// Throws where something has come to stand there meanwhile.
  void publish() const { fs::rename(made_, place_); }
  void withdraw() const {
    std::error_code none;
    fs::rename(place_, made_, none);
  }

private:
  grading::TemporaryFolder aside_;
  fs::path made_, place_;
};

void printWhatIsThere(const std::string& id) {
  fmt::print("solutions/{0}: the reference, its marked blocks, the handout, rubric, scenes, a "
             "mistake, a right answer\n"
             "assignments/{0}: what students receive, made from the solution; but assignment.json "
             "and scene.json are yours\n\n"
             "It works as it is. Change it from there; after every change of the solution:\n",
             id);
  const std::string grade = fmt::format("grade {0} solutions/{0} --solution", id);
  const auto step = [&](const std::string& command, const char* does) {
    fmt::print("  ./ggrade {:<{}}   {}\n", command, grade.size(), does);
  };
  step("derive " + id, "makes the stub and the handout");
  step(grade, "the reference has all points");
  step("calibrate " + id + " --seeds 2", "right and wrong answers separate");
  fmt::print("docs/authoring.md, \"A new assignment\", says what to change, step by step.\n");
}

void make(const std::string& id, const std::string& title) {
  if (!fs::is_directory(kRoot / "solutions"))
    throw UsageError(fmt::format("{} has no solutions folder: it is a student's kit. Assignments "
                                 "are made in the whole tree",
                                 kRoot.string()));
  authoring::requireFreeId(id, kRoot, fs::path(toolchain::kBuildFolder) / "build.ninja");
  authoring::requireTitle(title);
  const Side solution("solutions", id, title), assignment("assignments", id, title);
  {
    Progress progress("handout pictures of " + id);
    authoring::deriveInto(Assignment::load(assignment.made()), solution.made(),
                          gg::Language::english, assignment.made(), std::ref(progress));
  }
  if (grading::interrupted) throw grading::Interrupted{};
  solution.publish();
  try {
    assignment.publish();
  } catch (...) {
    solution.withdraw();
    throw;
  }
  printWhatIsThere(id);
}

} // namespace

void addNew(CLI::App& app) {
  struct Options {
    std::string id, title;
  };
  auto* command =
      app.add_subcommand("new", "Makes a new assignment: a small one that works, to be changed");
  auto options = std::make_shared<Options>();
  command->add_option("ID", options->id, "Its name: lower case letters, digits and _")->required();
  command->add_option("--title", options->title, "What people read (default: made from the ID)");
  command->footer("Writes assignments/ID and solutions/ID, and changes no other file.\n\n"
                  "Examples:\n"
                  "  ggrade new soft_light\n"
                  "  ggrade new soft_light --title \"Light from a window\"");
  command->callback([options, command] {
    const bool titled = command->count("--title") > 0;
    make(options->id, titled ? options->title : authoring::titleOf(options->id));
  });
}

} // namespace ggrade::cli
