#include "cli/commands.hpp"

int main(int argc, char** argv) {
  using namespace ggrade::cli;
  return runCommands(
      argc, argv,
      {addList, addRender, addInspect, addGrade, addBatch, addMerge, addWorker, addDemo, addJudge});
}
