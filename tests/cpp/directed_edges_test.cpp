// Directed Edges against the full mesh: the same circulators, refusals and numbers, in 64 bytes.

#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/directed_edges/build.h>
#include <halfedge/directed_edges/convert.h>
#include <halfedge/directed_edges/validate.h>
#include <halfedge/io/parse.h>
#include <halfedge/validate/validate.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "support/data_files.h"
#include "support/limited_memory.h"
#include "support/random_polygons.h"
#include "support/same_but_prev.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

// ---- what is compared

using Item = std::pair<Index, Index>;

// Items by what doesn't depend on how halfedges and edges are numbered.
template <class Mesh>
Item shown(const Mesh&, Vertex v) {
  return {v.index(), 0};
}
template <class Mesh>
Item shown(const Mesh&, Face f) {
  return {f.index(), 0};
}
template <class Mesh>
Item shown(const Mesh& mesh, Halfedge h) {
  if (!h.valid()) return {kNone, kNone};
  return {mesh.from_vertex(h).index(), mesh.to_vertex(h).index()};
}
template <class Mesh>
Item shown(const Mesh& mesh, Edge e) {
  const Item ends = shown(mesh, mesh.edge_halfedge(e, 0));
  return std::minmax(ends.first, ends.second);
}

using Items = std::vector<Item>;

template <class Mesh, class Range>
Items items(const Mesh& mesh, const Range& range) {
  Items list;
  for (const auto item : range) list.push_back(shown(mesh, item));
  return list;
}

// Which of its halfedges is side 0 of an edge is a matter of numbering.
Items sorted(Items list) {
  std::sort(list.begin(), list.end());
  return list;
}

template <class Mesh>
std::vector<Items> around(const Mesh& mesh, Vertex v) {
  std::vector<Items> lists = {
      items(mesh, mesh.outgoing_cw(v)),        items(mesh, mesh.outgoing_ccw(v)),
      items(mesh, mesh.incoming_cw(v)),        items(mesh, mesh.incoming_ccw(v)),
      items(mesh, mesh.vertex_vertices_cw(v)), items(mesh, mesh.vertex_vertices_ccw(v)),
      items(mesh, mesh.vertex_edges_cw(v)),    items(mesh, mesh.vertex_edges_ccw(v)),
      items(mesh, mesh.vertex_faces_cw(v)),    items(mesh, mesh.vertex_faces_ccw(v))};
  if (mesh.is_isolated(v)) return lists;
  const Halfedge start = mesh.rotate_cw(mesh.vertex_halfedge(v));
  lists.push_back(items(mesh, mesh.outgoing_cw(v, start)));
  lists.push_back(items(mesh, mesh.vertex_faces_ccw(v, start)));
  lists.push_back({{mesh.valence(v), mesh.is_boundary(v)}, {mesh.is_manifold(v), 0}});
  return lists;
}

template <class Mesh>
std::vector<Items> around(const Mesh& mesh, Face f) {
  const Halfedge start = mesh.next(mesh.face_halfedge(f));
  return {items(mesh, mesh.face_halfedges_ccw(f)),      items(mesh, mesh.face_halfedges_cw(f)),
          items(mesh, mesh.face_vertices_ccw(f)),       items(mesh, mesh.face_vertices_cw(f)),
          items(mesh, mesh.face_edges_ccw(f)),          items(mesh, mesh.face_edges_cw(f)),
          items(mesh, mesh.face_faces_ccw(f)),          items(mesh, mesh.face_faces_cw(f)),
          items(mesh, mesh.face_vertices_cw(f, start)), {{mesh.degree(f), mesh.is_boundary(f)}}};
}

template <class Mesh>
std::vector<Items> at(const Mesh& mesh, Halfedge h) {
  const Edge e = mesh.edge(h);
  return {items(mesh, mesh.loop_ccw(h)),
          items(mesh, mesh.loop_cw(h)),
          sorted(items(mesh, mesh.edge_halfedges(e))),
          sorted(items(mesh, mesh.edge_vertices(e))),
          sorted(items(mesh, mesh.edge_faces(e))),
          {shown(mesh, mesh.opposite(h)), shown(mesh, mesh.next_on_vertex(h)),
           shown(mesh, mesh.prev_on_vertex(h)), shown(mesh, mesh.rotate_ccw(h)),
           shown(mesh, mesh.face(h)), shown(mesh, e)},
          {{mesh.is_boundary(h), mesh.is_boundary(e)}}};
}

template <class Mesh>
std::vector<Item> all_edges(const Mesh& mesh) {
  return sorted(items(mesh, mesh.edges()));
}

// All circulators in both directions, and all queries, element for element.
void expect_same(const DirectedEdgesMesh& compact, const Mesh& full) {
  ASSERT_EQ(compact.vertex_count(), full.vertex_count());
  ASSERT_EQ(compact.halfedge_count(), full.halfedge_count());
  ASSERT_EQ(compact.edge_count(), full.edge_count());
  ASSERT_EQ(compact.face_count(), full.face_count());
  ASSERT_TRUE(same(compact.positions(), full.positions()));
  ASSERT_EQ(all_edges(compact), all_edges(full));
  for (const Vertex v : full.vertices()) {
    ASSERT_EQ(around(compact, v), around(full, v)) << "vertex " << v.index();
  }
  for (const Face f : full.faces()) {
    ASSERT_EQ(around(compact, f), around(full, f)) << "face " << f.index();
  }
  for (const Halfedge h : compact.halfedges()) {
    const Halfedge other = full.find_halfedge(compact.from_vertex(h), compact.to_vertex(h));
    ASSERT_TRUE(other.valid());
    ASSERT_EQ(compact.find_halfedge(compact.from_vertex(h), compact.to_vertex(h)), h);
    ASSERT_EQ(at(compact, h), at(full, other)) << "halfedge " << h.index();
  }
}

void expect_same_links(const DirectedEdges& a, const DirectedEdges& b) {
  EXPECT_EQ(a.links().sides, b.links().sides);
  EXPECT_TRUE(same(a.links().opposite, b.links().opposite));
  EXPECT_TRUE(same(a.links().to_vertex, b.links().to_vertex));
  EXPECT_TRUE(same(a.links().boundary_next, b.links().boundary_next));
  EXPECT_TRUE(same(a.links().boundary_prev, b.links().boundary_prev));
  EXPECT_TRUE(same(a.links().vertex_halfedge, b.links().vertex_halfedge));
}

std::string first_problem(const std::vector<Problem>& problems) {
  return has_errors(problems) ? problems.front().message : "";
}

// Built both ways, converted both ways.
void expect_equivalent(const Polygons& triangles) {
  BuildReport report;
  Mesh full;
  ASSERT_TRUE(build_from_polygons(full, triangles, report)) << report.problems[0].message;
  DirectedEdgesMesh compact;
  ASSERT_TRUE(build_from_triangles(compact, triangles, report)) << report.problems[0].message;
  EXPECT_EQ(first_problem(validate(compact)), "");
  expect_same(compact, full);

  Mesh converted;
  ASSERT_TRUE(to_mesh(compact, converted));
  EXPECT_EQ(first_problem(validate(converted)), "");
  expect_same_but_prev(converted, full);
  EXPECT_TRUE(same(converted.links().prev, full.links().prev));

  DirectedEdgesMesh back;
  const Result<void> result = from_mesh(full, back);
  ASSERT_TRUE(result) << result.error().message;
  expect_same_links(back, compact);
  EXPECT_TRUE(same(back.positions(), compact.positions()));
}

// ---- shapes

// Each face as a fan of triangles around its first corner.
Shape triangulated(const Shape& shape) {
  std::vector<std::vector<Index>> faces;
  for (const std::vector<Index>& face : shape.faces) {
    for (std::size_t i = 2; i < face.size(); ++i) faces.push_back({face[0], face[i - 1], face[i]});
  }
  return {shape.name, shape.vertices, std::move(faces)};
}

Shape in_random_order(Shape shape, std::uint32_t seed = 1) {
  std::shuffle(shape.faces.begin(), shape.faces.end(), std::mt19937(seed));
  return {shape.name, shape.vertices, shape.faces};
}

// Two vertices of high valence; the last vertex is one of them.
Shape bipyramid(Index valence) {
  std::vector<std::vector<Index>> faces;
  for (Index i = 0; i < valence; ++i) {
    const Index a = 1 + i;
    const Index b = 1 + (i + 1) % valence;
    faces.push_back({0, a, b});
    faces.push_back({valence + 1, b, a});
  }
  return {"bipyramid", valence + 2, std::move(faces)};
}

DirectedEdgesMesh built(const Shape& shape) {
  DirectedEdgesMesh mesh;
  BuildReport report;
  EXPECT_TRUE(build_from_triangles(mesh, shape.polygons(), report)) << report.problems[0].message;
  return mesh;
}

// ---- tests

TEST(DirectedEdges, NumbersHalfedgesByTheirFacesAndTheBoundaryAfterThem) {
  const DirectedEdgesMesh mesh = built({"two triangles", 4, {{0, 1, 2}, {2, 1, 3}}});
  const auto ends = [&](Index h) { return shown(mesh, Halfedge(h)); };
  EXPECT_EQ(ends(0), Item(2, 0));
  EXPECT_EQ(ends(1), Item(0, 1));
  EXPECT_EQ(ends(2), Item(1, 2));
  EXPECT_EQ(ends(3), Item(3, 2));
  EXPECT_EQ(mesh.halfedge_count(), 10U);
  EXPECT_EQ(mesh.boundary_halfedge_count(), 4U);
  EXPECT_EQ(ends(6), Item(0, 2));  // in the order of their opposites
  EXPECT_EQ(ends(7), Item(1, 0));
  EXPECT_EQ(mesh.face(Halfedge(6)), Face{});
  EXPECT_EQ(mesh.face(Halfedge(5)), Face(1));
  EXPECT_EQ(mesh.prev(Halfedge(3)), Halfedge(5));
  EXPECT_EQ(mesh.next(Halfedge(5)), Halfedge(3));
  EXPECT_EQ(mesh.next(Halfedge(6)), mesh.find_halfedge(Vertex(2), Vertex(3)));
}

TEST(DirectedEdges, AnEdgeHasTheIndexOfItsSmallerHalfedge) {
  const DirectedEdgesMesh mesh = built({"two triangles", 4, {{0, 1, 2}, {2, 1, 3}}});
  std::vector<Index> edges;
  for (const Edge e : mesh.edges()) {
    edges.push_back(e.index());
    EXPECT_LT(mesh.edge_halfedge(e, 0), mesh.edge_halfedge(e, 1));
    EXPECT_EQ(mesh.edge(mesh.edge_halfedge(e, 0)), e);
    EXPECT_EQ(mesh.edge(mesh.edge_halfedge(e, 1)), e);
  }
  EXPECT_EQ(edges, (std::vector<Index>{0, 1, 2, 3, 5}));
  EXPECT_EQ(mesh.edge_count(), 5U);
  EXPECT_EQ(mesh.edge_slots(), 6U);
  EXPECT_TRUE(mesh.is_deleted(Edge(4)));
  EXPECT_FALSE(mesh.is_live(Edge(6)));
}

TEST(DirectedEdges, TakeSixtyFourBytesAVertexOnAClosedMesh) {
  const DirectedEdgesMesh mesh = built(in_random_order(triangulated(torus(40, 30))));
  const DirectedLinks& links = mesh.links();
  std::size_t bytes = mesh.positions().size_bytes();
  for (const Array<Index>* array : {&links.opposite, &links.to_vertex, &links.boundary_next,
                                    &links.boundary_prev, &links.vertex_halfedge}) {
    EXPECT_EQ(array->capacity(), array->size());
    bytes += array->capacity() * sizeof(Index);
  }
  EXPECT_EQ(bytes, 64U * mesh.vertex_count());
}

TEST(DirectedEdges, GiveTheSameAsTheFullMeshOnEveryShape) {
  for (const Shape& shape : all_shapes()) {
    SCOPED_TRACE(shape.name);
    expect_equivalent(triangulated(shape).polygons());
    expect_equivalent(in_random_order(triangulated(shape)).polygons());
  }
}

TEST(DirectedEdges, GiveTheSameAsTheFullMeshOnRandomTriangleMeshes) {
  int pinched_vertices = 0;
  int isolated_vertices = 0;
  for (std::uint32_t seed = 0; seed < 400 && !HasFatalFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Shape shape = triangulated(random_polygons(seed));
    BuildReport report;
    Mesh full;
    // Cutting a face can run along an edge there is.
    if (!build_from_polygons(full, shape.polygons(), report)) continue;
    for (const Vertex v : full.vertices()) {
      pinched_vertices += full.is_manifold(v) ? 0 : 1;
      isolated_vertices += full.is_isolated(v) ? 1 : 0;
    }
    expect_equivalent(shape.polygons());
  }
  EXPECT_GT(pinched_vertices, 100);
  EXPECT_GT(isolated_vertices, 100);
}

TEST(DirectedEdges, GiveTheSameAsTheFullMeshOnTheCollection) {
  HALFEDGE_NEEDS_DATA();
  constexpr std::size_t kMaxFaces = 5000;  // or it takes minutes under the sanitizers
  std::size_t checked = 0;
  for (const auto& path : data_files("good", {".obj", ".off"})) {
    SCOPED_TRACE(path.filename());
    const std::string bytes = read_file(path);
    const Result<ParsedFile> file =
        parse({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    if (!file || file.value().soup.view().face_count() > kMaxFaces) continue;
    const Polygons polygons = file.value().soup.view();
    if (std::any_of(polygons.sizes.begin(), polygons.sizes.end(),
                    [](Index size) { return size != 3; })) {
      continue;
    }
    expect_equivalent(polygons);
    ++checked;
  }
  EXPECT_GE(checked, 20U);
}

TEST(DirectedEdges, GiveTheSameAsTheFullMeshAroundVerticesOfHighValence) {
  expect_equivalent(disk(1000).polygons());
  expect_equivalent(in_random_order(disk(1000)).polygons());
  expect_equivalent(in_random_order(bipyramid(1000)).polygons());
  expect_equivalent(in_random_order(pinched(500)).polygons());
}

double seconds_to_build(const Shape& shape) {
  double fastest = 1e30;
  for (int round = 0; round < 2; ++round) {
    DirectedEdgesMesh mesh;
    BuildReport report;
    const std::clock_t start = std::clock();
    EXPECT_TRUE(build_from_triangles(mesh, shape.polygons(), report));
    fastest = std::min(fastest, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return fastest;
}

TEST(DirectedEdges, FansOfAHundredThousandTrianglesTakeNoQuadraticTime) {
  for (const auto& make : {disk, bipyramid, pinched}) {
    const double small = seconds_to_build(in_random_order(make(10'000)));
    const double large = seconds_to_build(in_random_order(make(100'000)));
    EXPECT_LT(large, 50 * small) << small << " s, " << large << " s";
  }
}

// Each of these breaks one rule; indices are as in the shapes they come from.
std::vector<Shape> refused_shapes() {
  std::vector<Shape> shapes = {
      {"three faces on an edge", 5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}},
      {"three faces on an edge, last one down", 5, {{0, 1, 2}, {1, 0, 3}, {1, 0, 4}}},
      {"two sides up", 4, {{0, 1, 2}, {0, 1, 3}}},
      {"two sides down", 4, {{1, 0, 2}, {1, 0, 3}}},
      {"two pairs of sides", 6, {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {1, 0, 5}}},
      {"a face twice", 3, {{0, 1, 2}, {1, 2, 0}}},
      {"a Moebius strip", 6, {{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {2, 5, 4}, {2, 3, 5}, {3, 0, 5}}},
      {"a repeated vertex", 3, {{0, 1, 1}}},
      {"a vertex that isn't there", 3, {{0, 1, 3}}},
      {"a vertex far out of range", 3, {{0, 1, 0xFFFFFFFF}}},
      {"two corners", 3, {{0, 1}}},
      {"two closed fans at a vertex",
       7,
       {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}, {4, 6, 5}}},
      {"a closed and an open fan at a vertex",
       6,
       {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}, {0, 4, 5}}},
  };
  // Sides that repeat where groups are large.
  for (const std::vector<Index>& extra :
       {std::vector<Index>{0, 7, 101}, {7, 0, 101}, {0, 101, 7}}) {
    Shape large = disk(100);
    large.faces.push_back(extra);
    shapes.push_back({"a disk and one more face", 102, large.faces});
  }
  return shapes;
}

void expect_same_refusal(const Polygons& polygons) {
  Mesh full;
  BuildReport expected;
  ASSERT_FALSE(build_from_polygons(full, polygons, expected));
  DirectedEdgesMesh compact = built(tetrahedron());
  BuildReport report;
  ASSERT_FALSE(build_from_triangles(compact, polygons, report));
  EXPECT_EQ(compact.vertex_count(), 0U);
  EXPECT_EQ(compact.halfedge_count(), 0U);
  EXPECT_TRUE(compact.positions().empty());
  ASSERT_EQ(report.problem_count, expected.problem_count);
  ASSERT_EQ(report.problems.size(), expected.problems.size());
  for (std::size_t i = 0; i < report.problems.size(); ++i) {
    EXPECT_EQ(report.problems[i].code, expected.problems[i].code);
    EXPECT_EQ(report.problems[i].message, expected.problems[i].message);
    EXPECT_EQ(report.problems[i].witness, expected.problems[i].witness);
  }
}

TEST(DirectedEdges, RefuseWhatTheFullMeshRefusesInTheSameWords) {
  for (const Shape& shape : refused_shapes()) {
    SCOPED_TRACE(shape.name);
    expect_same_refusal(shape.polygons());
    expect_same_refusal(in_random_order(shape).polygons());
  }
  Shape not_finite = triangle();
  not_finite.positions[4] = std::nanf("");
  expect_same_refusal(not_finite.polygons());
  const Shape shape = triangle();
  expect_same_refusal({std::span(shape.positions).first(8), {}, shape.corners});
  expect_same_refusal({shape.positions, {}, std::span(shape.corners).first(2)});
}

TEST(DirectedEdges, RefuseRandomTrianglesAsTheFullMeshDoes) {
  int refused = 0;
  int accepted = 0;
  for (std::uint32_t seed = 0; seed < 3000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::vector<std::vector<Index>> faces(1 + random() % 6);
    for (std::vector<Index>& face : faces) {
      for (int i = 0; i < 3; ++i) face.push_back(Index(random() % 7));
    }
    const Shape shape{"random", 7, std::move(faces)};
    Mesh full;
    BuildReport report;
    if (build_from_polygons(full, shape.polygons(), report)) {
      expect_equivalent(shape.polygons());
      ++accepted;
    } else {
      expect_same_refusal(shape.polygons());
      ++refused;
    }
  }
  EXPECT_GT(accepted, 300);
  EXPECT_GT(refused, 300);
}

TEST(DirectedEdges, AFaceThatIsNoTriangleIsNamed) {
  DirectedEdgesMesh mesh;
  BuildReport report;
  const Shape shape = mixed_polygons();
  ASSERT_FALSE(build_from_triangles(mesh, shape.polygons(), report));
  ASSERT_EQ(report.problem_count, 3U);
  EXPECT_EQ(report.problems[0].code, "not-a-triangle");
  EXPECT_EQ(report.problems[0].message,
            "Face 1 has 4 corners; Directed Edges hold triangles only.");
  EXPECT_EQ(report.problems[0].witness, (Witness{.vertices = {0, 2, 3, 4}, .faces = {1}}));

  Mesh full;
  ASSERT_TRUE(build_from_polygons(full, shape.polygons(), report));
  const Result<void> result = from_mesh(full, mesh);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, "not-a-triangle");
  EXPECT_EQ(result.error().message, "Face 1 has 4 corners; Directed Edges hold triangles only.");
  EXPECT_EQ(mesh.vertex_count(), 0U);
}

TEST(DirectedEdges, ABuildInUsedMemoryIsTheSame) {
  DirectedEdgesMesh mesh = built(triangulated(torus(30, 30)));
  BuildReport report;
  const Shape smaller = in_random_order(triangle_grid(9, 9));
  const std::uint64_t version = mesh.version();
  ASSERT_TRUE(build_from_triangles(mesh, smaller.polygons(), report));
  EXPECT_NE(mesh.version(), version);
  expect_same_links(mesh, built(smaller));
  EXPECT_EQ(first_problem(validate(mesh)), "");

  DirectedEdgesMesh copy;
  ASSERT_TRUE(copy.assign(mesh));
  expect_same_links(copy, mesh);
  DirectedEdgesMesh moved;
  moved = std::move(copy);
  expect_same_links(moved, mesh);
  EXPECT_EQ(copy.face_count(), 0U);  // NOLINT(bugprone-use-after-move): what it is left as
}

// ---- conversions of meshes that no builder made

TEST(DirectedEdges, ConversionsKeepAnchorsAndFirstHalfedges) {
  Mesh full;
  BuildReport report;
  ASSERT_TRUE(build_from_polygons(full, triangulated(torus(4, 4)).polygons(), report));
  for (const Vertex v : full.vertices()) {
    full.set_vertex_halfedge(v, full.rotate_cw(full.vertex_halfedge(v)));
  }
  for (const Face f : full.faces()) full.set_face_halfedge(f, full.prev(full.face_halfedge(f)));
  DirectedEdgesMesh compact;
  ASSERT_TRUE(from_mesh(full, compact));
  expect_same(compact, full);
  Mesh back;
  ASSERT_TRUE(to_mesh(compact, back));
  expect_same(compact, back);
}

TEST(DirectedEdges, AreMadeOfAMeshWithoutPrev) {
  const Shape shape = in_random_order(triangle_grid(5, 4));
  BasicMesh<kWithoutPrev> without;
  BuildReport report;
  ASSERT_TRUE(build_from_polygons(without, shape.polygons(), report));
  DirectedEdgesMesh compact;
  ASSERT_TRUE(from_mesh(without, compact));
  expect_same_links(compact, built(shape));
}

TEST(DirectedEdges, AMeshWithDeletedItemsIsRefused) {
  Mesh full;
  BuildReport report;
  ASSERT_TRUE(build_from_polygons(full, with_isolated_vertices().polygons(), report));
  full.release(Vertex(3));
  DirectedEdgesMesh compact;
  const Result<void> result = from_mesh(full, compact);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, "deleted-item");
  EXPECT_EQ(result.error().message,
            "Vertex 3 is deleted; Directed Edges have no deleted items: compact the mesh first.");
}

TEST(DirectedEdges, ConversionsOfCorruptMeshesEndInAnErrorOrAMesh) {
  int errors = 0;
  for (std::uint32_t seed = 0; seed < 3000; ++seed) {
    std::mt19937 random(seed);
    Mesh full;
    BuildReport report;
    ASSERT_TRUE(build_from_polygons(full, triangle_grid(2, 2).polygons(), report));
    Links& links = full.mutable_links();
    const std::vector<Array<Index>*> arrays = {
        &links.next,         &links.prev, &links.to_vertex, &links.face, &links.vertex_halfedge,
        &links.face_halfedge};
    for (int i = 0; i < 2; ++i) {
      Array<Index>& array = *arrays[random() % arrays.size()];
      array[random() % array.size()] = random() % 4 == 0 ? Index(random()) : Index(random() % 40);
    }
    DirectedEdgesMesh compact;
    const Result<void> result = from_mesh(full, compact);
    errors += result ? 0 : 1;
    (void)validate(compact);
  }
  EXPECT_GT(errors, 1000);
}

// ---- validation

std::vector<std::string> codes_of(const DirectedEdgesMesh& mesh) {
  std::vector<std::string> codes;
  for (const Problem& problem : validate(mesh)) codes.emplace_back(problem.code);
  return codes;
}

TEST(DirectedEdgesValidate, NamesEachKindOfDamage) {
  using Codes = std::vector<std::string>;
  const auto damaged = [](const auto& damage) {
    DirectedEdgesMesh mesh = built({"two triangles", 4, {{0, 1, 2}, {2, 1, 3}}});
    damage(mesh.mutable_links());
    return codes_of(mesh);
  };
  EXPECT_EQ(damaged([](DirectedLinks&) {}), Codes{});
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.to_vertex.pop_back(); }), Codes{"array-size"});
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.boundary_prev.pop_back(); }), Codes{"array-size"});
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.sides = 7; }), Codes{"array-size"});
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.sides = 12; }), Codes{"array-size"});
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.opposite[1] = 10; }), Codes{"index-out-of-range"});
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.opposite[1] = kNone; }), Codes{"empty-link"});
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.to_vertex[1] = 4; }), Codes{"index-out-of-range"});
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.boundary_next[0] = 5; }), Codes{"index-out-of-range"});
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.vertex_halfedge[0] = 10; }),
            Codes{"index-out-of-range"});
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.opposite[0] = 0; }),
            (Codes{"opposite-mismatch", "opposite-mismatch"}));
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.vertex_halfedge[0] = 2; }), Codes{"anchor-elsewhere"});
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.vertex_halfedge[0] = kNone; }),
            (Codes{"missing-anchor", "missing-anchor"}));
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.vertex_halfedge[0] = 1; }), Codes{"interior-anchor"});
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.boundary_next[0] = 6; }),
            (Codes{"next-prev-mismatch"}));
  EXPECT_EQ(
      damaged([](DirectedLinks& l) {
        std::swap(l.opposite[0], l.opposite[1]);
        std::swap(l.opposite[6], l.opposite[7]);
      }),
      (Codes{"to-from-mismatch", "to-from-mismatch", "to-from-mismatch", "to-from-mismatch"}));
}

TEST(DirectedEdgesValidate, WarnsOfPinchedAndTellsOfIsolatedVertices) {
  EXPECT_EQ(codes_of(built(pinched(2))), std::vector<std::string>{"pinched-vertex"});
  EXPECT_EQ(codes_of(built(with_isolated_vertices())),
            (std::vector<std::string>(3, "isolated-vertex")));
}

TEST(DirectedEdgesValidate, ClosedFansThatShareAVertexAreUnreachable) {
  // Two tetrahedra; then vertex 4 of the second becomes vertex 0 of the first.
  DirectedEdgesMesh mesh = built(
      {"two tetrahedra",
       8,
       {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}, {4, 5, 6}, {4, 6, 7}, {4, 7, 5}, {5, 7, 6}}});
  DirectedLinks& links = mesh.mutable_links();
  std::replace(links.to_vertex.begin(), links.to_vertex.end(), 4U, 0U);
  links.vertex_halfedge[4] = kNone;
  const std::vector<Problem> problems = validate(mesh, 2);
  ASSERT_EQ(problems.size(), 3U);
  EXPECT_EQ(problems[0].code, "unreachable-halfedge");
}

// The links that `validate` lets pass are those of a mesh, which the full validator accepts too.
TEST(DirectedEdgesValidate, AgreesWithTheFullValidatorOnRandomDamage) {
  int invalid = 0;
  int still_valid = 0;
  for (std::uint32_t seed = 0; seed < 5000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    DirectedEdgesMesh mesh = built(seed % 2 == 0 ? triangle_grid(2, 2) : pinched(3));
    DirectedLinks& links = mesh.mutable_links();
    const std::vector<Array<Index>*> arrays = {&links.opposite, &links.to_vertex,
                                               &links.boundary_next, &links.boundary_prev,
                                               &links.vertex_halfedge};
    Array<Index>& array = *arrays[random() % arrays.size()];
    const std::size_t i = random() % array.size();
    const std::size_t j = random() % array.size();
    if (random() % 2 == 0) {
      std::swap(array[i], array[j]);
    } else {
      array[i] = Index(random() % 32) - 1;
    }
    const bool loops_hold = !has_errors(validate(mesh, 1));
    Mesh full;
    const Result<void> converted = to_mesh(mesh, full);
    ASSERT_EQ(bool(converted), loops_hold);
    if (!converted) {
      EXPECT_EQ(converted.error().code, "corrupt-connectivity");
      ++invalid;
      continue;
    }
    for (int level = 2; level <= kMaxValidationLevel; ++level) {
      EXPECT_EQ(has_errors(validate(mesh, level)), has_errors(validate(full, level))) << level;
    }
    ++still_valid;
  }
  EXPECT_GT(invalid, 1000);
  EXPECT_GT(still_valid, 100);
}

// ---- memory

#if defined(HALFEDGE_CAN_LIMIT_MEMORY)

// Exits with 0 if each build and conversion that memory didn't suffice for ended in an error.
[[noreturn]] void build_with_more_and_more_memory(const Shape& shape) {
  constexpr std::size_t kStep = std::size_t{1} << 20U;
  const std::size_t in_use = address_space_in_use();
  for (int failures = 0;; ++failures) {
    if (!limit_address_space(in_use + kStep * std::size_t(failures))) std::_Exit(2);
    DirectedEdgesMesh mesh;
    Mesh full;
    BuildReport report;
    if (build_from_triangles(mesh, shape.polygons(), report)) {
      const Result<void> converted = to_mesh(mesh, full);
      const Result<void> back = converted ? from_mesh(full, mesh) : Result<void>{};
      if (converted && back) std::_Exit(failures > 20 ? 0 : 3);
      const Error& error = (converted ? back : converted).error();
      if (error.code != "out-of-memory") std::_Exit(4);
      if ((converted ? mesh.vertex_count() : full.vertex_slots()) != 0) std::_Exit(5);
    } else if (report.problem_count != 1 || report.problems[0].code != "out-of-memory" ||
               mesh.vertex_count() != 0) {
      std::_Exit(6);
    }
  }
}

TEST(DirectedEdgesMemoryDeathTest, WhereverMemoryEndsTheBuildEndsInAnError) {
  const Shape shape = triangle_grid(400, 400);
  EXPECT_EXIT(build_with_more_and_more_memory(shape), testing::ExitedWithCode(0), "");
}

#endif

}  // namespace
}  // namespace halfedge::test
