#include "cli/commands.hpp"

int main(int argc, char** argv) {
  using namespace ggrade::cli;
  return runCommands(argc, argv, {addGrade, addBatch, addMerge, addWorker, addDemo, addJudge});
}
