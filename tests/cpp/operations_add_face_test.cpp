#include <gtest/gtest.h>
#include <halfedge/io/parse.h>
#include <halfedge/operations/add_face.h>
#include <halfedge/operations/deletion.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/canonical.h"
#include "support/data_files.h"
#include "support/sweep.h"

namespace halfedge::test {
namespace {

using operations::add_face;
using operations::check_add_face;

std::vector<Vertex> handles(const std::vector<Index>& corners) {
  std::vector<Vertex> vertices;
  for (const Index v : corners) vertices.push_back(Vertex(v));
  return vertices;
}

template <class AnyMesh>
void add_vertices(AnyMesh& mesh, const Polygons& polygons) {
  for (std::size_t v = 0; v < polygons.vertex_count(); ++v) {
    const float* p = &polygons.positions[3 * v];
    ASSERT_TRUE(mesh.add_vertex({p[0], p[1], p[2]}).valid());
  }
}

// Equal but for the numbering of edges.
void expect_same(const Mesh& added, const Mesh& built) {
  const Canonical a(added);
  const Canonical b(built);
  EXPECT_EQ(a.sides, b.sides);
  EXPECT_EQ(a.firsts, b.firsts);
  EXPECT_EQ(a.anchors, b.anchors);
}

/// Adds the faces in a random order, validating after each if `often`; then compares with the
/// builder, given the faces in that order.
void add_in_random_order(Shape shape, std::mt19937& random, bool often) {
  for (std::vector<Index>& face : shape.faces) {
    std::rotate(face.begin(), face.begin() + std::ptrdiff_t(random() % face.size()), face.end());
  }
  std::shuffle(shape.faces.begin(), shape.faces.end(), random);
  const Shape shuffled(shape.name, shape.vertices, shape.faces);
  Mesh mesh;
  add_vertices(mesh, shuffled.polygons());
  for (std::size_t i = 0; i < shuffled.faces.size(); ++i) {
    const Result<Face> f = add_face(mesh, handles(shuffled.faces[i]));
    ASSERT_TRUE(f) << f.error().message;
    ASSERT_EQ(f.value().index(), i);
    ASSERT_EQ(mesh.to_vertex(mesh.face_halfedge(f.value())).index(), shuffled.faces[i][0]);
    if (often) {
      ASSERT_FALSE(has_errors(validate(mesh))) << validate(mesh)[0].message;
      ASSERT_TRUE(Invariants(mesh).hold());
    }
  }
  ASSERT_FALSE(has_errors(validate(mesh)));
  expect_same(mesh, reference_build(shuffled));
}

TEST(AddFace, MakesWhatTheBuilderMakesInAnyOrder) {
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("order " + std::to_string(seed));
    std::mt19937 random(seed);
    const std::vector<Shape> shapes = all_shapes();
    const Shape& shape = shapes[seed % shapes.size()];
    SCOPED_TRACE(shape.name);
    add_in_random_order(shape, random, seed < 40);
    if (HasFatalFailure()) return;
  }
}

TEST(AddFace, MakesWhatTheBuilderMakesOfRandomPolygons) {
  for (std::uint32_t seed = 0; seed < 150; ++seed) {
    const Shape shape = random_polygons(seed);
    SCOPED_TRACE(shape.name);
    std::mt19937 random(seed);
    add_in_random_order(shape, random, seed < 4);
    if (HasFatalFailure()) return;
  }
}

/// A mesh of these faces, with attributes and history.
Mesh prepared(const Shape& shape) {
  Mesh mesh = reference_build(shape);
  add_attributes_of_all_kinds(mesh);
  return mesh;
}

/// Random corners: often along edges and boundaries of the mesh, so that much can go wrong.
std::vector<Index> random_corners(const Mesh& mesh, std::mt19937& random) {
  const auto below = [&](Index count) { return Index(random() % count); };
  std::vector<Index> corners;
  Vertex v(below(mesh.vertex_slots()));
  for (Index degree = 3 + below(3); degree > 0; --degree) {
    corners.push_back(v.index());
    const Halfedge out = mesh.vertex_halfedge(v);
    if (out.valid() && below(4) > 0) {
      Halfedge chosen = out;
      for (Index turns = below(4); turns > 0; --turns) chosen = mesh.rotate_cw(chosen);
      v = mesh.to_vertex(chosen);
    } else {
      v = Vertex(below(mesh.vertex_slots()));
    }
  }
  return corners;
}

TEST(AddFace, IsAllowedJustWhereTheBuilderTakesTheFace) {
  std::set<std::string_view> codes;
  int added = 0;
  std::uint32_t seed = 0;
  for (auto& [name, mesh] : meshes_to_sweep(12)) {
    if (mesh.vertex_slots() == 0) continue;
    SCOPED_TRACE(name + ", seed " + std::to_string(seed));
    std::mt19937 random(seed++);
    for (int i = 0; i < 60; ++i) {
      const std::vector<Index> corners = random_corners(mesh, random);
      SCOPED_TRACE(testing::PrintToString(corners));
      Polys faces;
      for (const Face f : mesh.faces()) faces.push_back(corners_of(mesh, mesh.face_halfedge(f)));
      faces.push_back(corners);
      const bool is_allowed = buildable(mesh.vertex_slots(), faces).has_value();
      Mesh after;
      const std::vector<Vertex> vertices = handles(corners);
      EXPECT_EQ(is_allowed, holds_contract(
                                mesh, [&](const Mesh& m) { return check_add_face(m, vertices); },
                                [&](Mesh& m) { return add_face(m, vertices); }, after));
      if (!is_allowed) {
        codes.insert(check_add_face(mesh, vertices).error().code);
        continue;
      }
      ++added;
      EXPECT_EQ(polys_of(after), in_order(faces));
      EXPECT_TRUE(operations::delete_face(after, Face(mesh.face_slots()),
                                          {.keep_isolated_vertices = true}));
      EXPECT_EQ(polys_of(after), polys_of(mesh));
      EXPECT_EQ(after.edge_count(), mesh.edge_count());
    }
  }
  EXPECT_GT(added, 100);
  EXPECT_EQ(codes, (std::set<std::string_view>{"duplicate-face", "edge-with-many-faces",
                                               "opposite-orientation", "pinched-vertex",
                                               "repeated-vertex"}));
}

// ---- refusals -------------------------------------------------------------------------------

TEST(AddFace, SaysWhyItCannot) {
  const auto refused = [](const Shape& shape, const std::vector<Index>& corners,
                          const std::string& code, const Witness& witness) {
    SCOPED_TRACE(testing::PrintToString(corners));
    Mesh mesh = prepared(shape);
    const Snapshot before(mesh);
    const Result<Face> result = add_face(mesh, handles(corners));
    expect_refused(result, code, mesh, before);
    EXPECT_EQ(result.error().witness, witness) << result.error().message;
  };
  const auto edge = [](const Shape& shape, Index a, Index b) {
    return reference_build(shape).find_edge(Vertex(a), Vertex(b)).index();
  };
  const Shape one = triangle();
  refused(one, {}, "degree-below-three", {});
  refused(one, {0, 1}, "degree-below-three", {.vertices = {0, 1}});
  refused(one, {0, 1, 7}, "not-a-vertex", {.vertices = {7}});
  refused(one, {0, kNone, 1}, "not-a-vertex", {});
  refused(with_isolated_vertices(), {0, 3, 5, 3}, "repeated-vertex", {.vertices = {3}});
  std::vector<Index> many(40);  // too many to compare each with each
  for (Index i = 0; i < 40; ++i) many[i] = i == 33 ? 5 : i;
  refused(quad_grid(6, 6), many, "repeated-vertex", {.vertices = {5}});
  refused(one, {1, 2, 0}, "duplicate-face", {.faces = {0}});
  refused(pillow(), {0, 1, 2}, "duplicate-face", {.faces = {0}});
  const Shape grid = quad_grid(2, 1);  // 3 4 5 over 0 1 2
  refused(grid, {0, 1, 5}, "opposite-orientation",
          {.vertices = {0, 1}, .edges = {edge(grid, 0, 1)}, .faces = {0}});
  const Shape with_one("", 7, grid.faces);
  refused(with_one, {4, 1, 6}, "edge-with-many-faces",
          {.edges = {edge(grid, 4, 1)}, .faces = {1, 0}});
  // The last side is the first that is looked for.
  refused(with_one, {1, 6, 4}, "edge-with-many-faces",
          {.edges = {edge(grid, 4, 1)}, .faces = {1, 0}});
  // A quad repeated in reverse, where another face lies behind one of its edges.
  refused(grid, {3, 4, 1, 0}, "duplicate-face", {.faces = {0}});
  // The hole of a cube without its bottom, turned over.
  Polys sides = cube().faces;
  sides.erase(sides.begin());
  const Shape open("", 8, sides);
  refused(open, {0, 1, 2, 3}, "opposite-orientation",
          {.vertices = {3, 0}, .edges = {edge(open, 3, 0)}, .faces = {4}});
  // Beside the closed fan of a disk, and closing one of two fans.
  refused(Shape("", 6, disk(3).faces), {0, 4, 5}, "pinched-vertex",
          {.vertices = {0}, .faces = {2}});
  refused(Shape("", 7, {{0, 1, 2}, {0, 2, 3}, {0, 5, 6}}), {3, 1, 0}, "pinched-vertex",
          {.vertices = {0}, .faces = {0, 2}});
}

TEST(AddFace, RefusesADeletedVertex) {
  Mesh mesh = prepared(cube());
  ASSERT_TRUE(operations::delete_vertex(mesh, Vertex(2)));
  const Snapshot before(mesh);
  expect_refused(add_face(mesh, handles({0, 1, 2})), "not-a-vertex", mesh, before);
}

// ---- fans -----------------------------------------------------------------------------------

TEST(AddFace, JoinsAnyTwoFansOfAPinchedVertex) {
  // Five fans of one triangle; a triangle between any two of them, whichever lie between.
  for (Index i = 0; i < 5; ++i) {
    for (Index j = 0; j < 5; ++j) {
      if (i == j) continue;
      Shape shape = pinched(5);
      shape.faces.push_back({0, 2 + 2 * i, 1 + 2 * j});
      SCOPED_TRACE(testing::PrintToString(shape.faces.back()));
      Mesh mesh = reference_build(pinched(5));
      ASSERT_TRUE(add_face(mesh, handles(shape.faces.back())));
      expect_same(mesh, reference_build(Shape("", shape.vertices, shape.faces)));
    }
  }
}

TEST(AddFace, ClosesFansAndMovesAnchors) {
  Mesh mesh = reference_build(Shape("", 5, {{0, 1, 2}, {0, 3, 4}, {0, 2, 3}}));
  EXPECT_TRUE(mesh.is_boundary(Vertex(0)));
  ASSERT_TRUE(add_face(mesh, handles({0, 4, 1})));
  EXPECT_FALSE(mesh.is_boundary(Vertex(0)));
  EXPECT_TRUE(validate(mesh).empty());
  ASSERT_TRUE(add_face(mesh, handles({4, 3, 2, 1})));
  EXPECT_TRUE(validate(mesh).empty());
  EXPECT_EQ(mesh.vertex_count() + mesh.face_count(), mesh.edge_count() + 2);
}

// ---- attributes, recycled slots, other storage ----------------------------------------------

TEST(AddFace, GivesNewItemsTheDefaults) {
  Mesh mesh = reference_build(triangle());
  (void)mesh.add_vertex({1, 1, 1});
  const double five[] = {5};
  std::vector<Attribute*> columns;
  for (const ItemKind kind : {ItemKind::kHalfedge, ItemKind::kEdge, ItemKind::kFace}) {
    columns.push_back(mesh.add_attribute(kind, "a", {.default_value = five}).value());
    for (Index i = 0; i < mesh.slots(kind); ++i) columns.back()->set(i, 0, 9, nullptr);
  }
  ASSERT_TRUE(operations::delete_face(mesh, Face(0), {.keep_isolated_vertices = true}));
  const Face f = add_face(mesh, handles({0, 1, 2})).value();
  EXPECT_EQ(f, Face(0));  // its slot is used again
  EXPECT_EQ(mesh.edge_slots(), 3U);
  ASSERT_TRUE(add_face(mesh, handles({2, 1, 3})));
  for (const Attribute* column : columns) {
    for (Index i = 0; i < column->slots(); ++i) EXPECT_EQ(column->get(i, 0), 5) << i;
  }
}

TEST(AddFace, WorksWherePrevIsNotStored) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Shape shape = seed == 0 ? pinched(5) : random_polygons(seed);
    SCOPED_TRACE(shape.name);
    BasicMesh<kWithoutPrev> mesh;
    add_vertices(mesh, shape.polygons());
    for (const std::vector<Index>& face : shape.faces) {
      ASSERT_TRUE(add_face(mesh, handles(face)));
    }
    Mesh whole;
    ASSERT_TRUE(convert(std::move(mesh), whole));
    EXPECT_FALSE(has_errors(validate(whole)));
    expect_same(whole, reference_build(shape));
  }
}

// ---- what it costs --------------------------------------------------------------------------

/// Counts the steps round vertices and faces.
template <Storage kStored>
class Counting : public BasicMesh<kStored> {
  using Mesh = BasicMesh<kStored>;

 public:
  [[nodiscard]] Halfedge next(Halfedge h) const { return counted(Mesh::next(h)); }
  [[nodiscard]] Halfedge rotate_cw(Halfedge h) const { return counted(Mesh::rotate_cw(h)); }
  [[nodiscard]] Halfedge next_on_vertex(Halfedge h) const {
    return counted(Mesh::next_on_vertex(h));
  }
  mutable std::uint64_t steps = 0;

 private:
  [[nodiscard]] Halfedge counted(Halfedge h) const {
    ++steps;
    return h;
  }
};

using CountingMesh = Counting<kEverything>;

/// The steps that it takes to add these triangles around one vertex or two, each vertex before the
/// first face that has it; then compares with the builder.
template <Storage kStored = kEverything>
std::uint64_t steps_to_add(const Shape& shape, const std::vector<std::size_t>& order) {
  Counting<kStored> mesh;
  std::vector<std::vector<Index>> faces;
  for (const std::size_t f : order) {
    const std::vector<Index>& face = shape.faces[f];
    while (mesh.vertex_slots() <= *std::max_element(face.begin(), face.end())) {
      (void)mesh.add_vertex({0, 0, 0});
    }
    EXPECT_TRUE(add_face(mesh, handles(face)));
    faces.push_back(face);
  }
  const std::uint64_t steps = mesh.steps;
  Mesh whole;
  EXPECT_TRUE(convert(static_cast<BasicMesh<kStored>&&>(mesh), whole));
  expect_same(whole, reference_build(Shape(shape.name, whole.vertex_slots(), faces)));
  return steps;
}

std::vector<std::size_t> in_order_of(std::size_t count) {
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = i;
  return order;
}

TEST(AddFace, WalksRoundAGrowingFanOnlyOnce) {
  constexpr Index kFaces = 3000;
  constexpr std::uint64_t kEach = 60;  // a walk round all of them is 6000 on the average
  const Shape fan = disk(kFaces);
  std::vector<std::size_t> order = in_order_of(kFaces);
  EXPECT_LT(steps_to_add(fan, order), kEach * kFaces);
  EXPECT_LT(steps_to_add<kWithoutPrev>(fan, order), kEach * kFaces);
  std::reverse(order.begin(), order.end());
  EXPECT_LT(steps_to_add(fan, order), kEach * kFaces);
  for (std::size_t i = 0; i < kFaces; ++i) order[i] = i % 2 == 0 ? i / 2 : kFaces - 1 - i / 2;
  EXPECT_LT(steps_to_add(fan, order), kEach * kFaces);
  // A while there is another fan, which becomes part of it.
  order = in_order_of(kFaces);
  std::rotate(order.begin() + 100, order.begin() + 200, order.begin() + 201);
  EXPECT_LT(steps_to_add(fan, order), kEach * kFaces);
  const Shape two_fans = bipyramid(kFaces);
  EXPECT_LT(steps_to_add(two_fans, in_order_of(two_fans.faces.size())),
            kEach * two_fans.faces.size());
  Shape many("bipyramids", 0, {});
  for (int i = 0; i < 5; ++i) {
    for (std::vector<Index> face : two_fans.faces) {
      for (Index& v : face) v += many.vertices;
      many.faces.push_back(face);
    }
    many.vertices += two_fans.vertices;
  }
  EXPECT_LT(steps_to_add(many, in_order_of(many.faces.size())), kEach * many.faces.size());
}

/// The fan of vertex 0 in which the triangles from `first` up to `last` lie.
void add_fan(CountingMesh& mesh, Index first, Index last) {
  for (Index i = first; i < last; ++i) ASSERT_TRUE(add_face(mesh, handles({0, i, i + 1})));
}

TEST(AddFace, KnowsOfAFanOnlyWhatIsStillTrue) {
  // After 100 triangles the fan at vertex 0 is known to be the only one; then it isn't any more.
  const auto grow = [](CountingMesh& mesh) {
    for (Index v = 0; v < 300; ++v) (void)mesh.add_vertex({0, 0, 0});
    add_fan(mesh, 10, 110);
  };
  const auto expect_built = [](const Mesh& mesh) {
    Polys faces;
    for (const Face f : mesh.faces()) faces.push_back(corners_of(mesh, mesh.face_halfedge(f)));
    EXPECT_FALSE(has_errors(validate(mesh)));
    const Mesh built = reference_build(Shape("", mesh.vertex_slots(), faces));
    EXPECT_EQ(Canonical(mesh).anchors, Canonical(built).anchors);
    EXPECT_EQ(Canonical(mesh).sides, Canonical(built).sides);
  };
  {
    SCOPED_TRACE("another fan, by add_face");
    CountingMesh mesh;
    grow(mesh);
    add_fan(mesh, 200, 201);
    add_fan(mesh, 9, 10);                                 // where it ends
    ASSERT_TRUE(add_face(mesh, handles({0, 110, 250})));  // which brings it behind the other
    EXPECT_EQ(mesh.to_vertex(mesh.vertex_halfedge(Vertex(0))), Vertex(201));
    add_fan(mesh, 2, 3);
    add_fan(mesh, 250, 260);
    expect_built(mesh);
  }
  {
    SCOPED_TRACE("another fan, as a face was deleted");
    CountingMesh mesh;
    grow(mesh);
    const Face f = mesh.face(mesh.find_halfedge(Vertex(0), Vertex(60)));
    ASSERT_TRUE(operations::delete_face(mesh, f, {.keep_isolated_vertices = true}));
    add_fan(mesh, 110, 120);
    EXPECT_FALSE(has_errors(validate(mesh)));
    EXPECT_EQ(mesh.to_vertex(mesh.vertex_halfedge(Vertex(0))), Vertex(60));
  }
  {
    SCOPED_TRACE("another fan, as one was undone that joined both");
    CountingMesh mesh;
    ASSERT_TRUE(mesh.enable_history());
    grow(mesh);
    add_fan(mesh, 112, 113);
    mesh.end_step();
    const Snapshot before(mesh);
    add_fan(mesh, 110, 112);
    add_fan(mesh, 113, 190);  // now one is known again
    mesh.end_step();
    ASSERT_TRUE(mesh.undo());
    EXPECT_EQ(Snapshot(mesh), before);
    ASSERT_TRUE(add_face(mesh, handles({0, 110, 200})));
    expect_built(mesh);
  }
  {
    SCOPED_TRACE("closed, and opened again");
    CountingMesh mesh;
    grow(mesh);
    ASSERT_TRUE(add_face(mesh, handles({0, 110, 10})));
    EXPECT_FALSE(mesh.is_boundary(Vertex(0)));
    expect_built(mesh);
    EXPECT_EQ(check_add_face(mesh, handles({0, 200, 201})).error().code, "pinched-vertex");
    const Face f = mesh.face(mesh.find_halfedge(Vertex(0), Vertex(60)));
    ASSERT_TRUE(operations::delete_face(mesh, f, {.keep_isolated_vertices = true}));
    add_fan(mesh, 200, 201);
    EXPECT_FALSE(has_errors(validate(mesh)));
  }
  {
    SCOPED_TRACE("of another mesh");
    CountingMesh mesh;
    grow(mesh);
    Mesh other;
    for (Index v = 0; v < 300; ++v) (void)other.add_vertex({0, 0, 0});
    ASSERT_TRUE(add_face(other, {Vertex(0), Vertex(10), Vertex(11)}));
    ASSERT_TRUE(add_face(other, {Vertex(0), Vertex(104), Vertex(105)}));
    static_cast<Mesh&>(mesh) = std::move(other);
    add_fan(mesh, 11, 20);
    ASSERT_TRUE(add_face(mesh, handles({0, 20, 200})));
    expect_built(mesh);
  }
}

// ---- real meshes ----------------------------------------------------------------------------

TEST(AddFace, MakesRealMeshesInRandomOrder) {
  HALFEDGE_NEEDS_DATA();
  constexpr std::size_t kMaxFaces = 15000;  // or it takes minutes under the sanitizers
  std::uint32_t seed = 0;
  for (const auto& path : data_files("good", {".obj", ".off", ".ply", ".stl"})) {
    SCOPED_TRACE(path.filename().string() + ", seed " + std::to_string(++seed));
    const Result<ParsedFile> file = parse_file(path);
    ASSERT_TRUE(file) << file.error().message;
    const Polygons polygons = file.value().soup.view();
    if (polygons.face_count() > kMaxFaces) continue;
    std::vector<std::vector<Index>> faces;
    for (std::size_t f = 0, c = 0; f < polygons.face_count(); ++f) {
      const Index size = polygons.sizes.empty() ? 3 : polygons.sizes[f];
      faces.emplace_back(&polygons.corners[c], &polygons.corners[c] + size);
      c += size;
    }
    std::mt19937 random(seed);
    std::shuffle(faces.begin(), faces.end(), random);

    const Shape shuffled("", Index(polygons.vertex_count()), faces);
    Mesh built;
    BuildReport report;
    ASSERT_TRUE(build_from_polygons(built, shuffled.polygons(), report));
    Mesh mesh;
    add_vertices(mesh, shuffled.polygons());
    for (const std::vector<Index>& face : faces) {
      const Result<Face> f = add_face(mesh, handles(face));
      ASSERT_TRUE(f) << f.error().message;
    }
    expect_same(mesh, built);
  }
  EXPECT_GE(seed, 80U);
}

TEST(AddFace, TakesCornersInBraces) {
  Mesh mesh;
  const Vertex a = mesh.add_vertex({0, 0, 0});
  const Vertex b = mesh.add_vertex({1, 0, 0});
  const Vertex c = mesh.add_vertex({0, 1, 0});
  EXPECT_TRUE(check_add_face(mesh, {a, b, c}));
  const Result<Face> f = add_face(mesh, {a, b, c});
  ASSERT_TRUE(f);
  EXPECT_EQ(mesh.to_vertex(mesh.face_halfedge(f.value())), a);
  EXPECT_EQ(check_add_face(mesh, {c, a, b}).error().code, "duplicate-face");
  EXPECT_EQ(add_face(mesh, {}).error().code, "degree-below-three");
}

}  // namespace
}  // namespace halfedge::test
