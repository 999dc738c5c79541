#include <halfedge/build/polygons.h>

#include <utility>

namespace halfedge {

MissingVertices::MissingVertices() = default;
MissingVertices::MissingVertices(MissingVertices&& other) noexcept = default;
MissingVertices& MissingVertices::operator=(MissingVertices&& other) noexcept = default;
MissingVertices::~MissingVertices() = default;

void MissingVertices::add(std::size_t corner, std::string name) {
  push_back({corner, std::move(name)});
}

bool Polygons::are_triangles() const {
  Index different = 0;
  for (const Index size : sizes) different |= size ^ 3U;
  return different == 0;
}

}  // namespace halfedge
