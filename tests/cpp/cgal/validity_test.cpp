// `validate` beside CGAL's is_valid, level by level: on valid complexes, and on ones with wrong
// links. They agree but for the differences that are listed in validity.h.

#include "cgal/validity.h"

#include <gtest/gtest.h>
#include <halfedge/connectivity/compact.h>
#include <halfedge/decorator/decorator.h>

#include <iostream>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "support/complexes.h"
#include "support/random_polygons.h"

namespace halfedge::test {
namespace {

// Without deleted slots and isolated vertices.
Mesh compacted(const Mesh& mesh) {
  Mesh copy = copy_of(mesh);
  EXPECT_TRUE(decorator::keep_largest_connected_components(copy, kNone).ok());
  EXPECT_TRUE(compact(copy).ok());
  return copy;
}

// How often each thing was said of a level.
using Tally = std::map<std::string, int>;

void compare_all_levels(const Mesh& mesh, const Mirror& mirror, Tally& tally) {
  for (int level = 0; level <= kMaxValidationLevel; ++level) {
    const std::string said = compare_validity(mesh, mirror, level);
    EXPECT_EQ(said.find("unexplained"), std::string::npos) << said;
    ++tally[said.empty() ? "the same" : said];
  }
}

void print(const Tally& tally) {
  for (const auto& [said, count] : tally) std::cout << "  " << count << "  " << said << "\n";
}

TEST(CgalValidity, AcceptsTheSameValidComplexes) {
  std::set<std::string> no_polygon_meshes;
  for (const auto& [name, original] : all_complexes()) {
    SCOPED_TRACE(name);
    const Mesh mesh = compacted(original);
    Mirror mirror(mesh);
    for (int level = 0; level <= 3; ++level) {
      EXPECT_TRUE(they_accept(mirror.complex, level)) << level;
      EXPECT_TRUE(error_codes(mesh, level).empty()) << level;
    }
    mirror.complex.normalize_border();
    EXPECT_TRUE(they_accept(mirror.complex, 4));
    if (!error_codes(mesh, 4).empty()) no_polygon_meshes.insert(name);
  }
  // Our level 4 is for polygon meshes.
  EXPECT_EQ(no_polygon_meshes,
            (std::set<std::string>{"loop", "segment", "flower", "tree", "loop with a hole"}));
}

TEST(CgalValidity, OnlyTheirsWantsTheNormalOrderAndNoIsolatedVertices) {
  Mesh mesh = reference_build(quad_grid(2, 1));
  ASSERT_FALSE(decorator::is_boundary_normalized(mesh));
  Mirror mirror(mesh);
  EXPECT_FALSE(they_accept(mirror.complex, 4));
  EXPECT_TRUE(error_codes(mesh, 4).empty());
  ASSERT_TRUE(decorator::normalize_boundary(mesh).ok());
  Mirror normalized(mesh);
  EXPECT_FALSE(they_accept(normalized.complex, 4));  // it counts what normalize_border has counted
  normalized.complex.normalize_border();
  EXPECT_TRUE(they_accept(normalized.complex, 4));

  normalized.complex.vertices_push_back(Theirs::Vertex());
  ASSERT_TRUE(mesh.new_vertex().valid());
  EXPECT_FALSE(they_accept(normalized.complex, 0));
  EXPECT_TRUE(error_codes(mesh, 4).empty());
}

// Each link of a small complex, one at a time, with each value that it can have.
TEST(CgalValidity, EveryWrongLinkIsJudgedAlike) {
  Tally tally;
  for (const auto& [name, original] : all_complexes()) {
    Mesh mesh = compacted(original);
    if (mesh.edge_count() > 9) continue;
    SCOPED_TRACE(name);
    Mirror mirror(mesh);
    mirror.complex.normalize_border();
    for (int i = 0; i < kLinkKinds; ++i) {
      const auto kind = LinkKind(i);
      for (Index item = 0; item < link_count(mesh, kind); ++item) {
        const Index before = link_of(mesh, kind, item);
        for (Index target = 0; target <= target_count(mesh, kind); ++target) {
          SCOPED_TRACE("link " + std::to_string(i) + " of " + std::to_string(item) + " to " +
                       std::to_string(target));
          set_link(mesh, mirror, kind, item, target == target_count(mesh, kind) ? kNone : target);
          compare_all_levels(mesh, mirror, tally);
          if (HasFailure()) return;
        }
        set_link(mesh, mirror, kind, item, before);
      }
    }
  }
  print(tally);
  EXPECT_GT(tally["the same"], 10000);
}

// Up to four wrong links at once, some of them exchanged: these pass the lower levels more often.
TEST(CgalValidity, RandomWrongLinksAreJudgedAlike) {
  Tally tally;
  const auto complexes = all_complexes();
  for (std::uint32_t seed = 0; seed < 4000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const auto below = [&](std::size_t count) { return Index(random() % count); };
    const std::size_t pick = below(complexes.size() + 6);
    Mesh mesh = pick < complexes.size() ? compacted(complexes[pick].second)
                                        : compacted(reference_build(random_polygons(seed)));
    if (mesh.face_count() == 0) continue;
    Mirror mirror(mesh);
    if (below(4) > 0) mirror.complex.normalize_border();
    for (Index writes = 1 + below(3); writes > 0; --writes) {
      const auto kind = LinkKind(below(kLinkKinds));
      const Index item = below(link_count(mesh, kind));
      const Index other = below(link_count(mesh, kind));
      const Index value = link_of(mesh, kind, item);
      switch (below(4)) {
        case 0:
          set_link(mesh, mirror, kind, item, below(target_count(mesh, kind)));
          break;
        case 1:
          set_link(mesh, mirror, kind, item, link_of(mesh, kind, other));
          set_link(mesh, mirror, kind, other, value);
          break;
        case 2: {  // two loops become one, or one two: next and prev stay inverse
          const Halfedge h(below(mesh.halfedge_count()));
          const Halfedge g(below(mesh.halfedge_count()));
          const Index after_h = link_of(mesh, LinkKind::kNext, h.index());
          const Index after_g = link_of(mesh, LinkKind::kNext, g.index());
          if (after_h >= mesh.halfedge_count() || after_g >= mesh.halfedge_count()) break;
          set_link(mesh, mirror, LinkKind::kNext, h.index(), after_g);
          set_link(mesh, mirror, LinkKind::kNext, g.index(), after_h);
          set_link(mesh, mirror, LinkKind::kPrev, after_g, h.index());
          set_link(mesh, mirror, LinkKind::kPrev, after_h, g.index());
          break;
        }
        default:
          if (below(4) == 0) set_link(mesh, mirror, kind, item, kNone);
      }
    }
    compare_all_levels(mesh, mirror, tally);
    if (HasFailure()) return;
  }
  print(tally);
  EXPECT_GT(tally["the same"], 10000);
}

// What passes levels 0 and 1 and breaks a higher one: whole orbits, loops and faces are wrong.
TEST(CgalValidity, WrongOrbitsLoopsAndBoundariesAreJudgedAlike) {
  Tally tally;
  std::set<std::string> reached;  // the codes of levels 2 to 4
  const auto complexes = all_complexes();
  for (std::uint32_t seed = 0; seed < 3000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const auto below = [&](std::size_t count) { return Index(random() % count); };
    Mesh mesh = compacted(complexes[below(complexes.size())].second);
    if (mesh.face_count() < 2) continue;
    const bool normalized = below(2) == 0;
    const auto h = Halfedge(below(mesh.halfedge_count()));
    const auto g = Halfedge(below(mesh.halfedge_count()));
    const auto merge_vertices = [&](Vertex from, Vertex to) {
      for (const Halfedge x : mesh.halfedges()) {
        if (mesh.to_vertex(x) == from) mesh.set_to_vertex(x, to);
      }
    };
    const auto set_loop = [&](Halfedge on, Face f) {
      for (Halfedge x = on;;) {
        mesh.set_face(x, f);
        x = mesh.next(x);
        if (x == on) break;
      }
    };
    switch (below(4)) {
      case 0: {  // two vertices are one, with two orbits; the other one anchors nothing
        const Vertex from = mesh.to_vertex(h);
        const Vertex to = mesh.to_vertex(g);
        merge_vertices(from, to);
        break;
      }
      case 1:  // two loops are one face
        if (!mesh.is_boundary(g)) set_loop(h, mesh.face(g));
        break;
      case 2:  // a face is a boundary loop, to which its old face still leads
        set_loop(h, Face{});
        break;
      default:  // a boundary vertex, or any other, has another anchor
        mesh.set_vertex_halfedge(mesh.from_vertex(h), h);
    }
    // Sometimes the vertex or face left over is taken out, so that no link is wrong by itself.
    if (below(3) > 0) {
      std::set<Index> vertices;
      std::set<Index> faces;
      for (const Halfedge x : mesh.halfedges()) {
        vertices.insert(mesh.to_vertex(x).index());
        faces.insert(mesh.face(x).index());
      }
      for (Index v = 0; v < mesh.vertex_slots(); ++v) {
        if (vertices.count(v) == 0) mesh.release(Vertex(v));
      }
      for (Index f = 0; f < mesh.face_slots(); ++f) {
        if (faces.count(f) == 0) mesh.release(Face(f));
      }
    }
    Mirror mirror(mesh);
    if (normalized) mirror.complex.normalize_border();
    compare_all_levels(mesh, mirror, tally);
    for (const std::string& code : error_codes(mesh, 4)) reached.insert(code);
    if (HasFailure()) return;
  }
  print(tally);
  for (const char* code :
       {"unreachable-halfedge", "face-with-many-loops", "interior-anchor", "edge-without-face",
        "degree-below-three", "repeated-vertex", "duplicate-halfedge", "same-face-twice"}) {
    EXPECT_EQ(reached.count(code), 1U) << code;
  }
}

}  // namespace
}  // namespace halfedge::test
