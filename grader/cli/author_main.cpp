/// \file
/// `ggrade-author`, the commands of who makes assignments; `ggrade` starts it.

#include "cli/commands.hpp"

int main(int argc, char** argv) {
  using namespace ggrade::cli;
  return runCommands(argc, argv,
                     {addCalibrate, addTradeoff, addDerive, addNew, addRelease, addExpect});
}
