#pragma once

#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstddef>
#include <fstream>
#include <functional>
#include <memory>
#include <string>

#include "contender.h"

/// Heap bytes of one mesh: in use when it is built, and the most that was resident on the way.
struct HeapUse {
  std::size_t in_use = 0;
  std::size_t peak = 0;
};

/// Keeps all memory in one heap that never shrinks: builds then recycle memory that is there, as in
/// a program that has run for a while, instead of timing the system's fresh pages.
inline void keep_one_heap() {
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
}

/// The value of a line of /proc/self/status, in bytes.
inline std::size_t process_status(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind(key, 0) == 0) return std::stoul(line.substr(key.size() + 1)) * 1024;
  }
  return 0;
}

/// Builds the mesh in a process of its own, where large arrays come from the system, so that the
/// resident memory tells the peak.
inline HeapUse measure_heap(const std::function<std::unique_ptr<Circulated>()>& make,
                            const TriangleMesh& input) {
  int ends[2];
  HeapUse use;
  if (pipe(ends) != 0) return use;
  if (const pid_t child = fork(); child == 0) {
    mallopt(M_MMAP_MAX, 1 << 16);
    mallopt(M_MMAP_THRESHOLD, 1 << 16);
    malloc_trim(0);
    const auto contender = make();
    std::ofstream("/proc/self/clear_refs") << 5;  // forgets the peak so far
    const struct mallinfo2 before = mallinfo2();
    const std::size_t resident = process_status("VmRSS:");
    contender->build(input);
    const struct mallinfo2 after = mallinfo2();
    use.in_use = after.uordblks + after.hblkhd - before.uordblks - before.hblkhd;
    use.peak = process_status("VmHWM:") - resident;
    const bool written = write(ends[1], &use, sizeof use) == sizeof use;
    _exit(written ? 0 : 1);
  } else if (child > 0) {
    if (read(ends[0], &use, sizeof use) != sizeof use) use = {};
    waitpid(child, nullptr, 0);
  }
  close(ends[0]);
  close(ends[1]);
  return use;
}
