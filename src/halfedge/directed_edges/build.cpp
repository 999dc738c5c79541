#include <halfedge/build/diagnose.h>
#include <halfedge/build/strict.h>
#include <halfedge/directed_edges/build.h>
#include <halfedge/directed_edges/connect.h>
#include <halfedge/sentence.h>

#include <cstddef>

namespace halfedge {

namespace {

void report_other_faces(const Polygons& polygons, BuildReport& report) {
  ProblemSink problems(report);
  std::size_t first = 0;
  for (std::size_t f = 0; f < polygons.sizes.size(); ++f) {
    const Index size = polygons.sizes[f];
    const auto corners = polygons.corners.subspan(first, size);
    first += size;
    if (size == 3) continue;
    problems.add([&] {
      return Error{"not-a-triangle",
                   sentence::of("Face {} has {}; Directed Edges hold triangles only.", f,
                                sentence::count_of(size, "corner")),
                   {.vertices = corners, .faces = {Index(f)}}};
    });
  }
}

}  // namespace

bool build_from_triangles(DirectedEdgesMesh& mesh, const Polygons& polygons, BuildReport& report) {
  report = {};
  mesh.clear();
  ConnectResult result = ConnectResult::kNotManifold;
  if (can_be_connected(polygons)) {
    if (!polygons.are_triangles()) {
      report_other_faces(polygons, report);
      return false;
    }
    result = connect_triangles(polygons, mesh.mutable_links());
  }
  if (result == ConnectResult::kDone) {
    result = copy_positions(polygons.positions, mesh.mutable_positions());
  }
  if (result != ConnectResult::kDone) mesh.clear();
  return explain(result, polygons, report);
}

}  // namespace halfedge
