#include <halfedge/connectivity/array.h>
#include <halfedge/operations/distinct.h>
#include <halfedge/refusals.h>
#include <halfedge/sort.h>

#include <cstddef>

namespace halfedge::operations::internal {

Result<Vertex> find_repeated(std::span<const Vertex> vertices) {
  constexpr std::size_t kFew = 16;  // up to here comparing all is fastest, and takes no memory
  if (vertices.size() <= kFew) {
    for (std::size_t i = 1; i < vertices.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (vertices[i] == vertices[j]) return vertices[i];
      }
    }
    return Vertex{};
  }
  Array<Vertex> sorted;
  if (!sorted.assign(vertices)) return refusals::no_memory("the corners of the face");
  return sort_and_find_repeated(sorted.span());
}

}  // namespace halfedge::operations::internal
