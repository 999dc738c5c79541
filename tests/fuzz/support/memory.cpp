#include "support/memory.h"

#include <sanitizer/allocator_interface.h>

#include <algorithm>
#include <cstdint>

namespace halfedge::fuzz {
namespace {

// The targets have one thread.
std::int64_t in_use = 0;
std::int64_t most = 0;

void count_allocated(const volatile void*, std::size_t size) {
  in_use += std::int64_t(size);
  most = std::max(most, in_use);
}

void count_freed(const volatile void* block) {
  const void* const freed = const_cast<const void*>(block);
  if (freed != nullptr) in_use -= std::int64_t(__sanitizer_get_allocated_size(freed));
}

}  // namespace

MemoryMeter::MemoryMeter() {
  [[maybe_unused]] static const int installed =
      __sanitizer_install_malloc_and_free_hooks(count_allocated, count_freed);
  in_use = 0;
  most = 0;
}

std::size_t MemoryMeter::peak() const { return std::size_t(most); }

}  // namespace halfedge::fuzz
