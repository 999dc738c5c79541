// The OpenMesh dialect against OpenMesh: one program, written in OpenMesh's names, runs over their
// mesh and over ours, and both must say the same.

#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/dialects/openmesh.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <algorithm>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "support/random_polygons.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

using Theirs = OpenMesh::PolyMesh_ArrayKernelT<>;
using Dialect = dialects::openmesh::PolyMesh<Mesh>;
using ConstDialect = dialects::openmesh::PolyMesh<const Mesh>;

// The program. Items are told by their vertices, since halfedges and edges are numbered
// differently. Around pinched vertices OpenMesh's order depends on that of insertion, and around
// isolated ones it reads out of bounds.
template <class MyMesh>
class Tour {
 public:
  explicit Tour(MyMesh& mesh) : mesh(mesh) {}

  std::vector<std::string> run() {
    say("counts", std::to_string(mesh.n_vertices()) + " " + std::to_string(mesh.n_halfedges()) +
                      " " + std::to_string(mesh.n_edges()) + " " + std::to_string(mesh.n_faces()));
    bool pinched = false;
    for (typename MyMesh::VertexIter v_it = mesh.vertices_begin(); v_it != mesh.vertices_end();
         ++v_it) {
      if (mesh.is_isolated(*v_it)) continue;
      pinched = pinched || !mesh.is_manifold(*v_it);
      say("is_boundary " + name(*v_it), std::to_string(mesh.is_boundary(*v_it)));
      say("valence", std::to_string(mesh.valence(*v_it)));
      if (mesh.is_manifold(*v_it)) vertex(*v_it);
    }
    for (typename MyMesh::FaceIter f_it = mesh.faces_begin(); f_it != mesh.faces_end(); f_it++) {
      face(*f_it);
    }
    if (!pinched) loops();
    return std::move(said);
  }

 private:
  void say(const std::string& question, const std::string& answer) {
    said.push_back(question + ": " + answer);
  }

  std::string name(typename MyMesh::VertexHandle v) { return std::to_string(v.idx()); }
  std::string name(typename MyMesh::HalfedgeHandle h) {
    return name(mesh.from_vertex_handle(h)) + ">" + name(mesh.to_vertex_handle(h));
  }
  std::string name(typename MyMesh::EdgeHandle e) {
    const auto [a, b] = std::minmax({name(mesh.to_vertex_handle(mesh.halfedge_handle(e, 0))),
                                     name(mesh.to_vertex_handle(mesh.halfedge_handle(e, 1)))});
    return a + "-" + b;
  }
  std::string name(typename MyMesh::FaceHandle f) { return "f" + std::to_string(f.idx()); }

  template <class Iter>
  std::string while_valid(Iter it) {
    std::string items;
    for (; it.is_valid(); ++it) items += " " + name(*it);
    return items;
  }
  template <class Iter>
  std::string until(Iter it, Iter end) {
    std::string items;
    while (it != end) items += " " + name(*it++);
    return items;
  }
  // Back from the end, and one lap no more; OpenMesh deprecates that for its unnamed direction.
  template <class Iter>
  std::string backwards(Iter end) {
    std::string items;
    Iter it = end;
    for (--it; it.is_valid(); --it) items += " " + std::to_string(it->idx() >= 0) + name(*it);
    return items;
  }
  template <class Range>
  std::string all(const Range& range) {
    std::string items;
    for (const auto item : range) items += " " + name(item);
    return items;
  }

#define TOUR(xx, item)  \
  TOUR_ITERS(xx, item); \
  TOUR_BOTH_ENDS(xx, item)

#define TOUR_ITERS(xx, item)                                      \
  say(#xx "_iter", while_valid(mesh.xx##_iter(item)));            \
  say(#xx "_cwiter", while_valid(mesh.xx##_cwiter(item)));        \
  say(#xx "_ccwiter", while_valid(mesh.xx##_ccwiter(item)));      \
  say("c" #xx "_iter", while_valid(mesh.c##xx##_iter(item)));     \
  say("c" #xx "_cwiter", while_valid(mesh.c##xx##_cwiter(item))); \
  say("c" #xx "_ccwiter", while_valid(mesh.c##xx##_ccwiter(item)))

#define TOUR_BOTH_ENDS(xx, item)                                                 \
  TOUR_ENDS(xx, item);                                                           \
  say(#xx "_cwbegin", until(mesh.xx##_cwbegin(item), mesh.xx##_cwend(item)));    \
  say(#xx "_ccwbegin", until(mesh.xx##_ccwbegin(item), mesh.xx##_ccwend(item))); \
  say(#xx "_cwend", backwards(mesh.xx##_cwend(item)));                           \
  say(#xx "_ccwend", backwards(mesh.xx##_ccwend(item)))

#define TOUR_ENDS(xx, item)                                                       \
  say(#xx "_begin", until(mesh.xx##_begin(item), mesh.xx##_end(item)));           \
  say("c" #xx "_begin", until(mesh.c##xx##_begin(item), mesh.c##xx##_end(item))); \
  say(#xx "_range", all(mesh.xx##_range(item)));                                  \
  say(#xx "_cw_range", all(mesh.xx##_cw_range(item)));                            \
  say(#xx "_ccw_range", all(mesh.xx##_ccw_range(item)))

  void vertex(typename MyMesh::VertexHandle v) {
    say("halfedge_handle", name(mesh.halfedge_handle(v)));
    TOUR(vv, v);
    TOUR(voh, v);
    TOUR(vih, v);
    TOUR(ve, v);
    TOUR(vf, v);
    for (typename MyMesh::VertexOHalfedgeIter voh_it = mesh.voh_iter(v); voh_it.is_valid();
         ++voh_it) {
      const typename MyMesh::HalfedgeHandle h = *voh_it;
      const typename MyMesh::HalfedgeHandle arriving = mesh.opposite_halfedge_handle(h);
      say("voh_range " + name(h), all(mesh.voh_range(h)));
      say("voh_cw_range", all(mesh.voh_cw_range(h)));
      say("voh_ccw_range", all(mesh.voh_ccw_range(h)));
      say("vih_range " + name(arriving), all(mesh.vih_range(arriving)));
      say("vih_cw_range", all(mesh.vih_cw_range(arriving)));
      say("vih_ccw_range", all(mesh.vih_ccw_range(arriving)));
      say("cw_rotated", name(mesh.cw_rotated_halfedge_handle(h)));
      say("ccw_rotated", name(mesh.ccw_rotated_halfedge_handle(h)));
      say("find_halfedge", name(mesh.find_halfedge(v, mesh.to_vertex_handle(h))));
      say("is_boundary edge", std::to_string(mesh.is_boundary(mesh.edge_handle(h))));
    }
  }

  void face(typename MyMesh::FaceHandle f) {
    say("is_boundary " + name(f),
        std::to_string(mesh.is_boundary(f)) + " " + std::to_string(mesh.is_boundary(f, true)));
    say("valence", std::to_string(mesh.valence(f)));
    TOUR(fv, f);
    TOUR(fh, f);
    TOUR(fe, f);
    // ff_cwbegin and ff_cwend of OpenMesh 9 never meet at a boundary: they begin apart.
    TOUR_ITERS(ff, f);
    TOUR_ENDS(ff, f);
  }

  void loops() {
    for (typename MyMesh::EdgeIter e_it = mesh.edges_begin(); e_it != mesh.edges_end(); ++e_it) {
      edges.push_back(name(*e_it));
    }
    std::sort(edges.begin(), edges.end());
    for (const std::string& edge : edges) say("edge", edge);
    for (const auto v : mesh.vertices()) {
      if (mesh.is_isolated(v)) continue;
      for (const auto h : mesh.voh_range(v)) {
        say("prev", name(mesh.prev_halfedge_handle(h)));
        say("next", name(mesh.next_halfedge_handle(h)));
        say("is_boundary", std::to_string(mesh.is_boundary(h)));
        say("face_handle", name(mesh.face_handle(h)));
        say("opposite_face_handle", name(mesh.opposite_face_handle(h)));
        TOUR_BOTH_ENDS(hl, h);
      }
    }
  }

#undef TOUR_ENDS
#undef TOUR_BOTH_ENDS
#undef TOUR_ITERS
#undef TOUR

  MyMesh& mesh;
  std::vector<std::string> edges;
  std::vector<std::string> said;
};

// Both meshes of the same faces; false if OpenMesh doesn't take them in this order.
bool build_both(const Shape& shape, Mesh& ours, Theirs& theirs) {
  BuildReport report;
  EXPECT_TRUE(build_from_polygons(ours, shape.polygons(), report)) << report.problems[0].message;
  for (Index v = 0; v < shape.vertices; ++v) {
    const float* p = &shape.positions[3 * std::size_t{v}];
    theirs.add_vertex({p[0], p[1], p[2]});
  }
  omerr().disable();
  bool taken = true;
  for (const std::vector<Index>& face : shape.faces) {
    std::vector<OpenMesh::VertexHandle> corners;
    for (const Index v : face) corners.emplace_back(int(v));
    taken = taken && theirs.add_face(corners).is_valid();
  }
  omerr().enable();
  return taken;
}

void expect_same_tour(const Shape& shape, Mesh& ours, Theirs& theirs) {
  SCOPED_TRACE(shape.name);
  Dialect dialect(ours);
  const std::vector<std::string> said_by_theirs = Tour<Theirs>(theirs).run();
  const std::vector<std::string> said_by_ours = Tour<Dialect>(dialect).run();
  ASSERT_EQ(said_by_ours.size(), said_by_theirs.size());
  for (std::size_t i = 0; i < said_by_ours.size(); ++i) {
    ASSERT_EQ(said_by_ours[i], said_by_theirs[i]) << "after " << said_by_ours[i == 0 ? 0 : i - 1];
  }
}

TEST(OpenMeshDialect, RunsTheSameProgramWithTheSameResultAsOpenMesh) {
  for (const Shape& shape : all_shapes()) {
    Mesh ours;
    Theirs theirs;
    ASSERT_TRUE(build_both(shape, ours, theirs)) << shape.name;
    expect_same_tour(shape, ours, theirs);
  }
}

TEST(OpenMeshDialect, AgreesWithOpenMeshOnRandomPolygons) {
  int compared = 0;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    const Shape shape = random_polygons(seed);
    Mesh ours;
    Theirs theirs;
    if (!build_both(shape, ours, theirs)) continue;  // OpenMesh depends on the order of the faces
    expect_same_tour(shape, ours, theirs);
    ++compared;
  }
  EXPECT_GE(compared, 20);
}

// A face is moved to where none was, by low-level functions of the same names on both sides: the
// vertices it left behind need adjust_outgoing_halfedge, and show it.
template <class MyMesh>
std::vector<std::string> move_face(MyMesh& mesh) {
  using HalfedgeHandle = typename MyMesh::HalfedgeHandle;
  const typename MyMesh::FaceHandle face(0);
  HalfedgeHandle gap;
  for (const auto h : mesh.halfedges()) {
    if (mesh.is_boundary(h)) gap = h;
  }
  std::vector<HalfedgeHandle> left;
  for (const auto h : mesh.fh_range(face)) left.push_back(h);
  std::vector<HalfedgeHandle> filled;
  for (const auto h : mesh.hl_range(gap)) filled.push_back(h);
  for (const HalfedgeHandle h : left) mesh.set_boundary(h);
  for (const HalfedgeHandle h : filled) mesh.set_face_handle(h, face);
  // Halfedges are numbered differently: the one that leads to the smallest vertex.
  mesh.set_halfedge_handle(
      face,
      *std::min_element(filled.begin(), filled.end(), [&](HalfedgeHandle a, HalfedgeHandle b) {
        return mesh.to_vertex_handle(a).idx() < mesh.to_vertex_handle(b).idx();
      }));
  std::vector<std::string> said;
  for (const auto v : mesh.vertices()) {
    const bool before = mesh.is_boundary(v);
    mesh.adjust_outgoing_halfedge(v);
    said.push_back(std::to_string(before) + std::to_string(mesh.is_boundary(v)));
  }
  return said;
}

TEST(OpenMeshDialect, AdjustsTheOutgoingHalfedgeAfterALowLevelEdit) {
  const Shape open_box("open box", 8,
                       {{0, 3, 2, 1}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
  Mesh ours;
  Theirs theirs;
  ASSERT_TRUE(build_both(open_box, ours, theirs));
  Dialect dialect(ours);
  const std::vector<std::string> said = move_face(dialect);
  EXPECT_EQ(said, move_face(theirs));
  // The bottom is on the boundary now, and four vertices needed to be told so.
  EXPECT_EQ(said, (std::vector<std::string>{"01", "01", "01", "01", "00", "00", "00", "00"}));
  expect_same_tour(open_box, ours, theirs);
}

// OpenMesh has the same low-level functions; what they don't say is which links new items have.
template <class MyMesh>
std::vector<std::string> build_triangle(MyMesh& mesh) {
  typename MyMesh::VertexHandle v[3];
  for (auto& vertex : v) vertex = mesh.new_vertex();
  typename MyMesh::HalfedgeHandle h[3];
  for (int i = 0; i < 3; ++i) h[i] = mesh.new_edge(v[i], v[(i + 1) % 3]);
  const typename MyMesh::FaceHandle f = mesh.new_face();
  for (int i = 0; i < 3; ++i) {
    mesh.set_next_halfedge_handle(h[i], h[(i + 1) % 3]);
    mesh.set_next_halfedge_handle(mesh.opposite_halfedge_handle(h[(i + 1) % 3]),
                                  mesh.opposite_halfedge_handle(h[i]));
    mesh.set_face_handle(h[i], f);
    mesh.set_halfedge_handle(v[i], h[i]);
  }
  mesh.set_halfedge_handle(f, h[2]);
  for (auto& vertex : v) mesh.adjust_outgoing_halfedge(vertex);
  return Tour<MyMesh>(mesh).run();
}

TEST(OpenMeshDialect, BuildsATriangleByLowLevelFunctions) {
  Mesh ours;
  Theirs theirs;
  Dialect dialect(ours);
  EXPECT_EQ(build_triangle(dialect), build_triangle(theirs));
  EXPECT_EQ(dialect.valence(Dialect::VertexHandle(0)), 2U);
}

// The smoother of OpenMesh's tutorial, which calculates with points.
template <class MyMesh>
std::string smooth(MyMesh& mesh) {
  std::vector<typename MyMesh::Point> means;
  for (auto v_it = mesh.vertices_begin(); v_it != mesh.vertices_end(); ++v_it) {
    typename MyMesh::Point mean(0, 0, 0);
    typename MyMesh::Scalar valence = 0;
    for (auto vv_it = mesh.vv_iter(*v_it); vv_it.is_valid(); ++vv_it) {
      mean += mesh.point(*vv_it);
      ++valence;
    }
    means.push_back(mean / valence);
  }
  std::ostringstream said;
  auto mean = means.begin();
  for (auto v_it = mesh.vertices_begin(); v_it != mesh.vertices_end(); ++v_it, ++mean) {
    if (!mesh.is_boundary(*v_it)) mesh.set_point(*v_it, *mean);
    said << mesh.point(*v_it) << '\n';
  }
  return said.str();
}

TEST(OpenMeshDialect, SmoothsAsTheTutorialDoes) {
  const Shape shape = triangle_grid(4, 5);
  Mesh ours;
  Theirs theirs;
  ASSERT_TRUE(build_both(shape, ours, theirs));
  for (const Vertex v : ours.vertices()) {
    const Point p = {float(v.index()), float(v.index() % 3), 1};
    ours.set_position(v, p);
    theirs.set_point(Theirs::VertexHandle(int(v.index())), {p.x, p.y, p.z});
  }
  Dialect dialect(ours);
  EXPECT_EQ(smooth(dialect), smooth(theirs));
}

// All that a point can do, as one text.
template <class Vec>
std::string calculate() {
  const Vec a(1, 2.5F, -3);
  const Vec b(0.5F, -4, 8);
  Vec c;
  std::ostringstream said;
  c.vectorize(2);
  said << a + b << '|' << a - b << '|' << a * b << '|' << a / b << '|' << -a << '|' << c << '|';
  said << a * 3.0F << '|' << 3.0F * a << '|' << a / 4.0F << '|' << (a | b) << '|' << a % b << '|';
  said << a.norm() << '|' << a.length() << '|' << a.sqrnorm() << '|' << a.normalized() << '|';
  said << a.dot(b) << '|' << a.cross(b) << '|' << Vec(7) << '|' << a[2] << '|' << Vec().size()
       << '|';
  c += a;
  c -= b;
  c *= a;
  c /= b;
  c *= 2.0F;
  c /= 3.0F;
  c[1] = c.data()[0];
  said << c << '|' << (a == b) << (a != b) << (c == c) << '|' << c.normalize() << '|';
  said << Vec(0, 0, 0).normalize_cond() << '|' << c.normalize_cond();
  return said.str();
}

TEST(OpenMeshDialect, CalculatesWithPointsAsOpenMeshDoes) {
  EXPECT_EQ(calculate<Dialect::Point>(), calculate<OpenMesh::Vec3f>());
}

TEST(OpenMeshDialect, GivesEmptyRangesAroundAnIsolatedVertexWhereOpenMeshReadsOutOfBounds) {
  Mesh ours;
  const Dialect::VertexHandle v = ours.add_vertex({1, 2, 3});
  const ConstDialect mesh(ours);
  EXPECT_FALSE(mesh.vv_iter(v).is_valid());
  EXPECT_FALSE(mesh.vf_ccwiter(v).is_valid());
  EXPECT_EQ(mesh.voh_begin(v), mesh.voh_end(v));
  EXPECT_EQ(mesh.vih_ccwbegin(v), mesh.vih_ccwend(v));
  EXPECT_EQ(mesh.point(v), (Point{1, 2, 3}));
}

TEST(OpenMeshDialect, HasHandlesThatAreOursAndOpenMeshs) {
  const Dialect::VertexHandle none;
  EXPECT_FALSE(none.is_valid());
  EXPECT_EQ(none.idx(), -1);
  EXPECT_EQ(none, Dialect::VertexHandle(-1));
  EXPECT_EQ(none, Dialect::InvalidVertexHandle);
  EXPECT_FALSE(Dialect::InvalidHalfedgeHandle.is_valid());
  EXPECT_FALSE(Dialect::InvalidEdgeHandle.is_valid());
  EXPECT_FALSE(Dialect::InvalidFaceHandle.is_valid());
  Dialect::VertexHandle v(4);
  EXPECT_EQ(v, Vertex(4));
  EXPECT_LT(v, Dialect::VertexHandle(5));
  v.invalidate();
  EXPECT_EQ(v, none);
  static_assert(sizeof(Dialect::VertexHandle) == sizeof(Vertex));
  static_assert(!std::is_convertible_v<Dialect::VertexHandle, Dialect::FaceHandle>);
}

TEST(OpenMeshDialect, StoresNothing) { EXPECT_EQ(sizeof(Dialect), sizeof(void*)); }

}  // namespace
}  // namespace halfedge::test
