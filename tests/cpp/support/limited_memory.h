#pragma once

// HALFEDGE_CAN_LIMIT_MEMORY is defined where a test can run short of memory on purpose: on Linux,
// and not under AddressSanitizer, which needs a large address space itself.

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define __SANITIZE_ADDRESS__ 1
#endif
#endif
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)
#define HALFEDGE_CAN_LIMIT_MEMORY 1

#include <sys/resource.h>
#include <unistd.h>

#include <cstddef>
#include <fstream>

namespace halfedge::test {

inline std::size_t address_space_in_use() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * std::size_t(sysconf(_SC_PAGESIZE));
}

/// Limits the address space of the process to `bytes`. False if the system refuses.
inline bool limit_address_space(std::size_t bytes) {
  const rlimit limit{bytes, RLIM_INFINITY};
  return setrlimit(RLIMIT_AS, &limit) == 0;
}

}  // namespace halfedge::test

#endif
