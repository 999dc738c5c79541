#include <halfedge/build/build.h>
#include <halfedge/connectivity/compact.h>
#include <halfedge/mesh.h>
#include <halfedge/operations/operations.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

#include "contender.h"

namespace {

class Halfedges final : public Contender {
 public:
  void build(const TriangleMesh& input) override {
    halfedge::BuildReport report;
    const halfedge::Polygons polygons{input.positions, {}, input.corners};
    if (halfedge::build_from_polygons(mesh_, polygons, report)) return;
    std::fprintf(stderr, "halfedge refused the mesh: %s\n", report.problems[0].message.c_str());
    std::abort();
  }

  std::int64_t circulate() override {
    std::int64_t counter = 0;
    for (const halfedge::Vertex v : mesh_.vertices()) {
      for ([[maybe_unused]] const halfedge::Face f : mesh_.vertex_faces_cw(v)) ++counter;
    }
    for (const halfedge::Face f : mesh_.faces()) {
      for ([[maybe_unused]] const halfedge::Vertex v : mesh_.face_vertices_ccw(f)) --counter;
    }
    return counter;
  }

  std::uint64_t one_ring_sum() override {
    std::uint64_t sum = 0;
    for (const halfedge::Vertex v : mesh_.vertices()) {
      for (const halfedge::Vertex w : mesh_.vertex_vertices_cw(v)) sum += w.index();
    }
    return sum;
  }

  void keep() override { require(kept_.assign(mesh_)); }
  void restore() override { require(mesh_.assign(kept_)); }

  void subdivide() override {
    using namespace halfedge;
    std::vector<Point> moved(mesh_.vertex_slots());
    for (const Vertex v : mesh_.vertices()) {
      Point sum;
      unsigned valence = 0;
      for (const Vertex w : mesh_.vertex_vertices_cw(v)) {
        const Point p = mesh_.position(w);
        sum = {sum.x + p.x, sum.y + p.y, sum.z + p.z};
        ++valence;
      }
      const Point p = mesh_.position(v);
      const float weight = sqrt3_weight(valence);
      const float of_each = weight / float(valence);
      moved[v.index()] = {(1 - weight) * p.x + of_each * sum.x,
                          (1 - weight) * p.y + of_each * sum.y,
                          (1 - weight) * p.z + of_each * sum.z};
    }
    const Index edges = mesh_.edge_slots();
    const Index faces = mesh_.face_slots();
    require(mesh_.reserve(mesh_.vertex_slots() + faces, edges + 3 * faces, 3 * faces));
    for (const Face f : faces_as_stored()) require(bool(operations::split_face(mesh_, f)));
    for (Index v = 0; v < moved.size(); ++v) mesh_.set_position(Vertex(v), moved[v]);
    for (Index e = 0; e < edges; ++e) (void)operations::flip_edge(mesh_, Edge(e));
  }

  void split_and_collapse() override {
    using namespace halfedge;
    const Index vertices = mesh_.vertex_slots();
    const Index faces = mesh_.face_slots();
    for (Index f = 0; f < faces; ++f) require(bool(operations::split_face(mesh_, Face(f))));
    for (Index v = vertices; v < vertices + faces; ++v) {
      require(bool(operations::collapse(mesh_, mesh_.vertex_halfedge(Vertex(v)))));
    }
  }

  void compact() override { require(bool(halfedge::compact(mesh_))); }

  std::uint64_t valence_sum() override {
    std::uint64_t sum = mesh_.edge_count() + mesh_.face_count();
    for (const halfedge::Vertex v : mesh_.vertices()) {
      sum += std::uint64_t{mesh_.valence(v)} * mesh_.valence(v);
    }
    return sum;
  }

 private:
  // All faces, in the order in which their halfedges lie. These are numbered by vertex, not by face
  // as in the other libraries, where the order of the faces is that of the halfedges.
  [[nodiscard]] std::vector<halfedge::Face> faces_as_stored() const {
    std::vector<halfedge::Face> faces(mesh_.face_slots() + 1);  // one to write to in vain
    std::size_t count = 0;
    for (const halfedge::Halfedge h : mesh_.halfedges()) {
      const halfedge::Face f = mesh_.face(h);
      faces[count] = f;
      count += std::size_t(f.valid() && mesh_.face_halfedge(f) == h);  // no branch to mispredict
    }
    faces.resize(count);
    return faces;
  }

  static void require(bool done) {
    if (!done) std::abort();
  }

  halfedge::Mesh mesh_;
  halfedge::Mesh kept_;
};

}  // namespace

std::unique_ptr<Contender> make_halfedge() { return std::make_unique<Halfedges>(); }
