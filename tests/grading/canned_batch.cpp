// `ggrade batch` as it is, with a worker that grades nothing: what a submission gets is told by the
// name of its folder, at once. It publishes as the real one does. For batch_failing_calls_test.
#include "canned_batch.hpp"
#include "failing_calls.hpp"

#include "batch/record.hpp"
#include "batch/worker.hpp"
#include "cli/commands.hpp"
#include "grading/grade.hpp"

#include <algorithm>

namespace {

namespace fs = std::filesystem;
using namespace ggrade;

struct Options {
  std::string id, out, reveal = "names";
  unsigned run = 1;
};

results::Result resultOf(const Target& target, const grading::ScenePlan& plan,
                         const std::string& name) {
  const auto canned = std::ranges::find(canned::kUploads, name, &canned::Upload::name);
  if (canned == std::end(canned::kUploads)) throw std::runtime_error("who is " + name + "?");
  results::Result result = grading::ungraded(
      target, plan, results::parseOutcome(canned->outcome).value(), "as it stands in the can");
  result.timings = {{"total", 1}};
  if (result.outcome == results::Outcome::buildFailed) return result;
  // The first items are full, one is partly earned, the rest are lost.
  double left = canned->score;
  for (results::Item& item : result.items) {
    item.judged = true;
    item.message = "canned";
    if (item.kind != results::ItemKind::gain) continue;
    item.earned = std::min(left, item.points);
    left -= item.earned;
  }
  grading::addUp(result);
  results::Scene scene;
  scene.name = "public";
  scene.isPublic = true;
  results::Frame frame;
  frame.student = frame.reference = Image(8, 8, 3);
  scene.frames = {frame};
  result.scenes = {scene};
  return result;
}

void work(const Options& options) {
  batch::endWithParent();
  const Target target = findTarget(cli::assignmentsFolder(), options.id);
  const fs::path solutions = cli::solutionFolder(target.assignment.id);
  const grading::ScenePlan plan = grading::drawScenes(target, solutions, {});
  const std::string grader = batch::graderOf(target, solutions, plan);
  batch::answerJobs([&](const batch::Job& job) {
    const results::Result result = resultOf(target, plan, job.upload.name);
    batch::publish(result, job,
                   {options.out, *report::parseReveal(options.reveal), grader, options.run});
    return batch::Reply{
        {}, std::string(results::name(result.outcome)), result.score, result.maxScore, 1};
  });
}

void addCannedWorker(CLI::App& app) {
  auto* command = app.add_subcommand("worker")->allow_extras();
  auto options = std::make_shared<Options>();
  command->add_option("ID", options->id)->required();
  command->add_option("--out", options->out)->required();
  command->add_option("--run", options->run);
  command->add_option("--reveal", options->reveal);
  command->callback([options] { work(*options); });
}

} // namespace

int main(int argc, char** argv) {
  failing_calls::beginHere();
  return cli::runCommands(argc, argv, {cli::addBatch, addCannedWorker});
}
