#include <halfedge/connectivity/array.h>

#include <cstdint>

namespace halfedge::internal {

void* reallocate(void* data, std::size_t count, std::size_t size) {
  return count <= PTRDIFF_MAX / size ? std::realloc(data, count * size) : nullptr;
}

void* reallocate_amply(void* data, std::size_t count, std::size_t size, std::size_t& capacity) {
  for (const std::size_t room : {ample_capacity(count, capacity), count}) {
    if (void* grown = reallocate(data, room, size); grown != nullptr) {
      capacity = room;
      return grown;
    }
  }
  return nullptr;
}

}  // namespace halfedge::internal
