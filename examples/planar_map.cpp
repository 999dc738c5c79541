// A planar map: connectivity alone, without any geometry. A street block with two plots and a pond
// in one of them; every halfedge has a face, the unbounded one included.
//
//     3 ------------- 2        faces: south (0 1 2), with the pond 4 5 6 as a hole in it,
//     |           .   |               north (0 2 3), the pond, and outside
//     | north  .  4   |
//     |     .    / \  |
//     |  .      5---6 |
//     0 ------------- 1

#include <halfedge/halfedge.h>

#include <algorithm>
#include <cstdio>
#include <initializer_list>
#include <vector>

namespace {

using namespace halfedge;

struct PlanarMap {
  Connectivity links;
  /// One halfedge of each loop around a hole, beside that of the face's outer loop.
  std::vector<std::pair<Face, Halfedge>> holes;
};

// The halfedge from one vertex to another, made with its edge if need be. Edges of a planar map may
// be found by their ends as long as no two have the same.
Halfedge side(Connectivity& map, Index from, Index to) {
  for (const Halfedge h : map.halfedges()) {
    if (map.from_vertex(h) == Vertex(from) && map.to_vertex(h) == Vertex(to)) return h;
  }
  const Halfedge h = map.new_edge(Vertex(from), Vertex(to));
  map.set_vertex_halfedge(Vertex(from), h);
  map.set_vertex_halfedge(Vertex(to), Connectivity::opposite(h));
  return h;
}

// Links the sides of a polygon to a loop, and returns its last.
Halfedge make_loop(Connectivity& map, std::initializer_list<Index> corners) {
  std::vector<Halfedge> sides;
  for (const Index* at = corners.begin(); at != corners.end(); ++at) {
    const Index* const next = at + 1 == corners.end() ? corners.begin() : at + 1;
    sides.push_back(side(map, *at, *next));
  }
  for (std::size_t i = 0; i < sides.size(); ++i) map.link(sides[i], sides[(i + 1) % sides.size()]);
  return sides.back();
}

// By next, not by a circulator: those are good until the connectivity changes.
void set_face_of_loop(Connectivity& map, Halfedge first, Face f) {
  Halfedge h = first;
  do {
    map.set_face(h, f);
    h = map.next(h);
  } while (h != first);
}

Face add_face(Connectivity& map, std::initializer_list<Index> corners) {
  const Halfedge h = make_loop(map, corners);
  const Face f = map.new_face(h);
  set_face_of_loop(map, h, f);
  return f;
}

constexpr Face kOutside(3);

PlanarMap street_block() {
  PlanarMap map;
  for (int i = 0; i < 7; ++i) (void)map.links.new_vertex();
  const Face south = add_face(map.links, {0, 1, 2});
  add_face(map.links, {0, 2, 3});     // north
  add_face(map.links, {4, 5, 6});     // the pond
  add_face(map.links, {3, 2, 1, 0});  // outside
  const Halfedge shore = make_loop(map.links, {6, 5, 4});
  set_face_of_loop(map.links, shore, south);
  map.holes.emplace_back(south, shore);
  return map;
}

// The dual: a vertex for each face, a face for each vertex, an edge across each edge, which keeps
// its index. The halfedge of h leads from the face on its left to the one on its right, and then
// on, clockwise around the vertex that h leaves.
Connectivity dual_of(const Connectivity& map) {
  Connectivity dual;
  for (Index f = 0; f < map.face_slots(); ++f) (void)dual.new_vertex();
  for (const Edge e : map.edges()) {
    const Halfedge h = map.edge_halfedge(e);
    (void)dual.new_edge(Vertex(map.face(h).index()), Vertex(map.face(map.opposite(h)).index()));
  }
  for (const Halfedge h : map.halfedges()) {
    dual.link(h, map.rotate_cw(h));
    dual.set_vertex_halfedge(Vertex(map.face(h).index()), h);
  }
  for (const Vertex v : map.vertices()) {
    set_face_of_loop(dual, map.vertex_halfedge(v), dual.new_face(map.vertex_halfedge(v)));
  }
  return dual;
}

void print_faces(const PlanarMap& map) {
  for (const Face f : map.links.faces()) {
    std::printf("face %u:", f.index());
    for (const Vertex v : map.links.face_vertices_ccw(f)) std::printf(" %u", v.index());
    for (const auto& [face, hole] : map.holes) {
      if (face != f) continue;
      std::printf(", around a hole:");
      for (const Halfedge h : map.links.loop_ccw(hole)) {
        std::printf(" %u", map.links.to_vertex(h).index());
      }
    }
    std::printf(f == kOutside ? ", unbounded\n" : "\n");
  }
}

void print_faces_across(const Connectivity& map, Halfedge loop) {
  for (const Halfedge h : map.loop_ccw(loop)) {
    std::printf(" %u", map.face(map.opposite(h)).index());
  }
  std::printf("\n");
}

}  // namespace

int main() {
  const PlanarMap map = street_block();
  print_faces(map);
  // Two connected parts in the plane: V - E + F = 1 + 2.
  std::printf("V - E + F = %d\n", int(euler_characteristic(map.links)));
  std::printf("neighbours of face 0:");
  print_faces_across(map.links, map.links.face_halfedge(Face(0)));
  std::printf("across its hole:");
  print_faces_across(map.links, map.holes.front().second);

  const Connectivity dual = dual_of(map.links);
  for (const Face f : dual.faces()) {
    std::vector<Vertex> corners;
    for (const Vertex v : dual.face_vertices_ccw(f)) corners.push_back(v);
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    std::printf("dual of vertex %u: faces", f.index());
    for (const Vertex v : corners) std::printf(" %u", v.index());
    std::printf("\n");
  }

  // Links know nothing of holes: a face with two loops is right up to level 2.
  std::printf("valid at level 2: %s\n", has_errors(validate(map.links, 2)) ? "no" : "yes");
  for (const Problem& problem : validate(map.links, 3)) {
    std::printf("level 3, one loop to a face: %s\n", problem.message.c_str());
  }
  return 0;
}
