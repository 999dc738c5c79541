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

#include <array>
#include <cstddef>
#include <cstdlib>
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

inline constexpr bool kCanLimitMemory = true;

/// Sixteen pieces of 2 KiB that are kept back until memory is limited: enough for an error, even
/// where an array has grown until it did not fit. What would be left by itself depends on where the
/// heap happens to end, and can be nothing. Each piece is the second half of a block, so that
/// neither an array before it nor another piece can grow by it.
class PiecesForErrors {
 public:
  PiecesForErrors() {
    for (void*& block : blocks_) block = std::malloc(2 * kPiece);
  }

  void give_back() {
    for (void*& block : blocks_) {
      block = std::realloc(block, kPiece);
      if (block == nullptr) std::_Exit(2);
    }
  }

 private:
  static constexpr std::size_t kPiece = std::size_t{2} << 10U;
  std::array<void*, 16> blocks_{};
};

/// Leaves the process some pieces for errors and nothing else of more than a few bytes. Returns how
/// many bytes of address space are in use then, which could not be asked for without memory.
inline std::size_t use_up_memory() {
  PiecesForErrors pieces;
  const std::size_t in_use = address_space_in_use();
  if (!limit_address_space(in_use)) std::_Exit(2);
  for (std::size_t size = std::size_t{1} << 26U; size >= 32; size /= 2) {
    // Written to, so that no compiler leaves it out; freed when the process ends.
    while (void* block = std::malloc(size)) *static_cast<volatile char*>(block) = 1;
  }
  pieces.give_back();
  return in_use;
}

/// Leaves the process so many bytes more, and pieces for errors: whatever was freed before is used
/// up.
inline void leave_memory(std::size_t bytes) {
  const std::size_t in_use = use_up_memory();
  if (!limit_address_space(in_use + bytes)) std::_Exit(2);
}

/// There is as much as the machine has again.
inline void stop_limiting_memory() { (void)limit_address_space(RLIM_INFINITY); }

}  // namespace halfedge::test

#else

namespace halfedge::test {

inline constexpr bool kCanLimitMemory = false;
inline std::size_t use_up_memory() { return 0; }
inline void stop_limiting_memory() {}

}  // namespace halfedge::test

#endif

#include <cstdlib>

namespace halfedge::test {

/// Ends the process: 0 if the condition holds.
[[noreturn]] inline void leave(bool holds) { std::_Exit(holds ? 0 : 1); }

}  // namespace halfedge::test

#define HALFEDGE_NEEDS_A_MEMORY_LIMIT() \
  if (!halfedge::test::kCanLimitMemory) GTEST_SKIP() << "memory can't be limited here"
