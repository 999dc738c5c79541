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

}  // namespace halfedge
