#include <halfedge/halfedge.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string_view>
#include <vector>

namespace {

// The programs of docs/files.md, docs/repairs.md and docs/editing.md: one header has all that they
// need. Of a file with a face that is there twice, the colours stay, the hole is filled, and a
// collapse is refused.
int repair() {
  constexpr std::string_view kOpen =
      "COFF\n4 4 0\n0 0 0 1 0 0\n1 0 0 0 1 0\n0 1 0 0 0 1\n0 0 1 1 1 1\n"
      "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 2 1\n";
  const std::vector<std::uint8_t> bytes(kOpen.begin(), kOpen.end());
  halfedge::Mesh mesh;
  halfedge::Result<halfedge::ParsedFile> file =
      halfedge::parse(bytes, std::nullopt, {.for_repair = true});
  halfedge::RepairReport report;
  if (!halfedge::build_from_soup(mesh, file.value().soup.view(), {.weld = 0}, report)) return 2;
  if (!halfedge::add_attributes(mesh, file.value().soup.view(), &report, file.value().attributes)) {
    return 3;
  }
  if (mesh.find_attribute(halfedge::ItemKind::kVertex, "color") == nullptr) return 4;

  (void)mesh.enable_history();
  const halfedge::Result<halfedge::mend::Report> filled =
      halfedge::mend::fill_holes(mesh, {.max_edges = 100});
  if (!filled || mesh.face_count() != 4) return 5;
  mesh.end_step();
  if (halfedge::operations::collapse(mesh, halfedge::Halfedge(0))) return 6;  // a tetrahedron
  return mesh.undo() && mesh.face_count() == 3 ? 0 : 7;
}

}  // namespace

// Reads a tetrahedron, builds it, walks around one of its vertices and measures it: reader,
// builder, circulators and geometry of the installed library. Exit code 0 if the one-ring has its
// three vertices, the volume is right, and the programs of the documentation do what they say.
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
  if (std::abs(halfedge::geometry::volume(mesh).value() - 1.0 / 6) > 1e-15) return 1;
  return count == 3 ? repair() : 1;
}
