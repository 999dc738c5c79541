#include "history.h"

#include <halfedge/build/build.h>
#include <halfedge/mesh.h>
#include <halfedge/operations/operations.h>

#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "measure.h"
#include "table.h"

namespace {

using namespace halfedge;

void require(bool done) {
  if (!done) std::abort();
}

void flip_edges(Mesh& mesh, Index edges) {
  for (Index e = 0; e < edges; ++e) {
    (void)operations::flip_edge(mesh, Edge(e));  // some have neighbours that are joined
    mesh.end_step();
  }
}

void split_edges(Mesh& mesh, Index edges) {
  for (Index e = 0; e < edges; ++e) {
    require(bool(operations::split_edge(mesh, Edge(e))));
    mesh.end_step();
  }
}

void split_faces(Mesh& mesh, Index faces) {
  for (Index f = 0; f < faces; ++f) {
    require(bool(operations::split_face(mesh, Face(f))));
    mesh.end_step();
  }
}

// Of the vertices that split_faces has added to so many faces.
void collapse_centres(Mesh& mesh, Index faces) {
  const Index all = mesh.vertex_slots();
  for (Index v = all - faces; v < all; ++v) {
    require(bool(operations::collapse(mesh, mesh.vertex_halfedge(Vertex(v)))));
    mesh.end_step();
  }
}

struct Workload {
  const char* name;
  void (*run)(Mesh&, Index count);
  bool of_edges;
  bool on_centres;
};
constexpr std::array kWorkloads = {
    Workload{"flip_edge", flip_edges, true, false},
    Workload{"split_edge", split_edges, true, false},
    Workload{"split_face", split_faces, false, false},
    Workload{"collapse", collapse_centres, false, true},
};

}  // namespace

void compare_history(const std::string& label, const TriangleMesh& input) {
  Mesh built;
  BuildReport report;
  require(build_from_polygons(built, {input.positions, {}, input.corners}, report));
  const Index edges = built.edge_slots();
  const Index faces = built.face_slots();
  Mesh mesh;
  for (const Workload& workload : kWorkloads) {
    const auto prepare = [&](bool has_history) {
      mesh.disable_history();
      require(mesh.assign(built));
      require(mesh.reserve(built.vertex_slots() + edges, 4 * edges, 3 * faces + 2 * edges));
      if (workload.on_centres) split_faces(mesh, faces);
      if (has_history) require(mesh.enable_history());
    };
    const auto run = [&] { workload.run(mesh, workload.of_edges ? edges : faces); };
    const std::vector<std::string> names{std::string(workload.name) + "/off",
                                         std::string(workload.name) + "/on"};
    print_row(label + " | " + workload.name, names,
              measure({{names[0], run, [&] { prepare(false); }},
                       {names[1], run, [&] { prepare(true); }}}));
  }
}
