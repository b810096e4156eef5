#include "cli/commands.hpp"

#include "authoring/comments.hpp"
#include "authoring/expected_of.hpp"
#include "authoring/kit.hpp"
#include "authoring/zip.hpp"
#include "cli/terminal.hpp"
#include "grading/workspace.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ggrade::cli {

namespace fs = std::filesystem;

namespace {

struct ReleaseOptions : authoring::KitOptions {
  std::string out;
  bool gradescope = false;
};

std::string listOf(const std::vector<authoring::HandedOut>& all) {
  std::string text;
  for (const authoring::HandedOut& one : all) {
    text += fmt::format("  {}: to do {}\n", one.assignment.id, fmt::join(one.blank, ", "));
    if (!one.filled.empty())
      text += fmt::format("  {}: comes filled in, so its answer is in this kit: {}\n",
                          one.assignment.id, fmt::join(one.filled, ", "));
  }
  return text;
}

/// Comments that a kit in Japanese has in English.
std::string lackingComments(const ReleaseOptions& options,
                            const std::vector<authoring::HandedOut>& all) {
  std::string text;
  if (options.language == gg::Language::english) return text;
  for (const authoring::HandedOut& one : all)
    for (const std::string& sentence :
         authoring::outOfStep(one.assignment, solutionFolder(one.assignment.id)))
      text += "  " + sentence + '\n';
  return text;
}

void release(const ReleaseOptions& options) {
  const fs::path out = outputFolder(options.out);
  fs::path zip = out, quizzes = out;
  zip += ".zip";
  quizzes += "-quiz";
  const std::vector<authoring::HandedOut> chosen = authoring::choose(options);
  if (options.gradescope) authoring::graded(options);
  grading::requireReplaceable(quizzes);
  Progress progress("release");
  const fs::path parent = fs::absolute(out).lexically_normal().parent_path();
  grading::TemporaryFolder work(parent), quizWork(parent);
  const bool asks = !options.gradescope && authoring::writeQuizzes(options, quizWork.path());
  if (options.gradescope)
    authoring::writeAutograder(options, work.path());
  else
    authoring::writeKit(options, work.path(), std::ref(progress));
  progress("packing", 0, 1);
  // An autograder's files lie at the top of its archive, a kit's in a folder.
  authoring::writeZip(work.path(), options.gradescope ? "" : out.filename().string(), zip);
  work.publish(out);
  if (asks) quizWork.publish(quizzes);
  progress.clear();
  fmt::print("{}\n{} ({:.1f} MB)\n", out.string(), zip.string(), double(fs::file_size(zip)) / 1e6);
  if (options.gradescope)
    fmt::print(
        "  grades {}; it holds the solution: upload it as the autograder, hand it to nobody\n",
        authoring::graded(options));
  else
    fmt::print("{}{}", listOf(chosen), lackingComments(options, chosen));
  if (asks)
    fmt::print("{}\n  the quizzes with their answers, and as GIFT for Moodle: not for students\n",
               quizzes.string());
}

} // namespace

void addRelease(CLI::App& app) {
  auto* command = app.add_subcommand(
      "release", "Makes what students receive: a kit without solutions that checks itself");
  auto options = std::make_shared<ReleaseOptions>();
  command
      ->add_option("--out", options->out,
                   "The kit's folder; beside it the same as a .zip, and in OUT-quiz "
                   "the answers of the quizzes")
      ->required();
  command
      ->add_option("--parts", options->parts,
                   "Parts (or assignments) that are to be done; all other TODOs come filled in")
      ->delimiter(',');
  command
      ->add_option("--blank", options->blank,
                   "TODOs that are to be done; all other TODOs come filled in")
      ->delimiter(',');
  command->add_flag(
      "--gradescope", options->gradescope,
      "An autograder's archive instead, for the one of --parts; --lang: of its reports");
  command->add_flag("--devcontainer", options->devcontainer,
                    "With a description of a container to work in");
  command->footer(
      "A part or TODO that comes filled in gives its answer away: release such a kit when that "
      "part is "
      "over.\n\nExamples:\n"
      "  ggrade release --out out/kit                           everything is to be done\n"
      "  ggrade release --parts mirror,shadow,bloom --out out/floor\n"
      "  ggrade release --parts shadow --out out/week2          the mirror comes filled in\n"
      "  ggrade release --blank mirror.4,mirror.5 --out out/short\n"
      "  ggrade release --lang ja --out out/kit-ja              comments in Japanese\n"
      "  ggrade release --gradescope --parts mirror --out out/autograder");
  command->callback([options] {
    options->language = gg::language();
    gg::setLanguage(gg::Language::english); // translated where it is read
    release(*options);
  });
}

void addExpect(CLI::App& app) {
  // Not listed: `ggrade check` in a tree with solutions calls it first.
  auto* command = app.add_subcommand("expect", "Makes what `check` compares with")->group("");
  struct Wanted {
    std::string id, out;
  };
  auto wanted = std::make_shared<Wanted>();
  command->add_option("--out", wanted->out)->required();
  command->add_option("ID", wanted->id)->required();
  command->callback([wanted] {
    gg::setLanguage(gg::Language::english); // as in a kit
    requireSandbox();
    Progress progress("expect");
    const Target target = findTarget(assignmentsFolder(), wanted->id);
    authoring::updateExpected(target, solutionFolder(target.assignment.id), wanted->out,
                              std::ref(progress));
    progress.clear();
  });
}

} // namespace ggrade::cli
