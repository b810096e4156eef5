// Ends a program before anything else where the processor lacks what it is compiled for: so this
// file is compiled for every processor, and its function comes before all that is made before main.
#include <unistd.h>

#ifdef __x86_64__
[[gnu::constructor(101)]] static void requireAvx() {
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx")) return;
  constexpr char kText[] =
      "ggrade: this processor has no AVX (as most do since 2011), which ggrade is compiled for. "
      "Remedy: another machine; in a virtual one, let it have the host's processor\n";
  (void)!write(STDERR_FILENO, kText, sizeof kText - 1);
  _exit(3); // as where there is no sandbox: nothing can be graded here
}
#endif
