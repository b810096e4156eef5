#include "attacker.hpp"

#include <cstdio>
#include <cstring>

namespace attacker {

void Attempts::add(const std::string& what, bool worked) {
  const int error = errno;
  if (worked)
    std::printf("ESCAPED %s\n", what.c_str());
  else
    std::printf("refused %s: %s\n", what.c_str(), std::strerror(error));
  escaped_ = escaped_ || worked;
}

} // namespace attacker

int main(int argc, char** argv) {
  using namespace attacker;
  Attacks attacks;
  addFileAttacks(attacks);
  addMemoryAttacks(attacks);
  addProcessAttacks(attacks);
  addKernelAttacks(attacks);
  const auto found = attacks.find(argc > 1 ? argv[1] : "");
  if (found == attacks.end()) {
    std::fputs("unknown attack\n", stderr);
    return 99;
  }
  return found->second(Arguments(argv + 2, argv + argc));
}
