#pragma once

#include <cstddef>

namespace halfedge::fuzz {

/// Measures the heap: the most that was allocated at a time since the meter was made, beyond what
/// was allocated then. An array that grows counts twice while it moves. One meter at a time.
class MemoryMeter {
 public:
  MemoryMeter();
  /// In bytes.
  [[nodiscard]] std::size_t peak() const;
};

}  // namespace halfedge::fuzz
