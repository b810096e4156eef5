/// \file
/// `ggrade-look`, the commands that look at programs and judge nothing; `ggrade` starts it.

#include "cli/commands.hpp"

int main(int argc, char** argv) {
  using namespace ggrade::cli;
  return runCommands(argc, argv, {addList, addRender, addInspect});
}
