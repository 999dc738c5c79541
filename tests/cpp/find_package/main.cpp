#include <halfedge/halfedge.h>

#include <cstdint>
#include <cstdio>
#include <string_view>
#include <vector>

// Reads a tetrahedron, builds it and walks around one of its vertices: reader, builder and
// circulators of the installed library. Exit code 0 if the one-ring has its three vertices.
int main() {
  constexpr std::string_view kTetrahedron =
      "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
      "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  const std::vector<std::uint8_t> bytes(kTetrahedron.begin(), kTetrahedron.end());
  const halfedge::Result<halfedge::ParsedFile> file = halfedge::parse(bytes);
  if (!file.ok()) return std::puts(file.error().message.c_str()), 1;

  halfedge::Mesh mesh;
  halfedge::BuildReport report;
  if (!halfedge::build_from_polygons(mesh, file.value().soup.view(), report)) {
    return std::puts(report.problems.front().message.c_str()), 1;
  }
  int count = 0;
  for (const halfedge::Vertex v : mesh.vertex_vertices_ccw(halfedge::Vertex(0))) {
    std::printf("vertex %u\n", v.index());
    ++count;
  }
  return count == 3 ? 0 : 1;
}
