#pragma once

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

/// While this exists, only `left` more descriptors can be opened.
class FewDescriptors {
public:
  explicit FewDescriptors(rlim_t left) {
    getrlimit(RLIMIT_NOFILE, &before_);
    const int next = open("/dev/null", O_RDONLY | O_CLOEXEC); // the lowest that is free
    close(next);
    const rlimit few = {rlim_t(next) + left, before_.rlim_max};
    setrlimit(RLIMIT_NOFILE, &few);
  }
  ~FewDescriptors() { setrlimit(RLIMIT_NOFILE, &before_); }
  FewDescriptors(const FewDescriptors&) = delete;
  FewDescriptors& operator=(const FewDescriptors&) = delete;

private:
  rlimit before_{};
};
