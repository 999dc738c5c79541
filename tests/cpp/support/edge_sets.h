#pragma once

#include <halfedge/mesh.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <set>
#include <vector>

/// Sets of edges to cut a mesh along.
namespace halfedge::test {

inline std::vector<Edge> inner_edges(const Mesh& mesh) {
  std::vector<Edge> edges;
  for (const Edge e : mesh.edges()) {
    const Halfedge h = mesh.edge_halfedge(e);
    if (!mesh.is_boundary(e) && mesh.from_vertex(h) != mesh.to_vertex(h)) edges.push_back(e);
  }
  return edges;
}

/// The edges that a spanning tree of the faces doesn't cross: those along which a net is cut.
inline std::vector<Edge> edges_of_net(const Mesh& mesh) {
  std::set<Edge> crossed;
  std::set<Face> reached;
  for (const Face start : mesh.faces()) {
    if (!reached.insert(start).second) continue;
    std::vector<Face> queue = {start};
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (const Halfedge h : mesh.loop_ccw(mesh.face_halfedge(queue[i]))) {
        const Face across = mesh.face(Mesh::opposite(h));
        if (!across.valid() || !reached.insert(across).second) continue;
        crossed.insert(Mesh::edge(h));
        queue.push_back(across);
      }
    }
  }
  std::vector<Edge> edges;
  for (const Edge e : inner_edges(mesh)) {
    if (crossed.count(e) == 0) edges.push_back(e);
  }
  return edges;
}

/// Edges that can be cut beside each other, drawn at random.
class DrawEdges {
 public:
  DrawEdges(const Mesh& mesh, std::mt19937& random)
      : mesh_(mesh), random_(random), inner_(inner_edges(mesh)) {}

  /// Sparse and dense ones, spokes, walks that branch and close, seams around some faces, nets;
  /// seldom with one more that may have to be refused.
  std::vector<Edge> operator()() {
    if (!inner_.empty()) draw(below(6));
    std::vector<Edge> edges(drawn_.begin(), drawn_.end());
    if (below(25) == 0 && !edges.empty()) edges.push_back(edges[below(edges.size())]);
    if (below(25) == 0) edges.emplace_back(Index(below(mesh_.edge_slots() + 1U)));
    if (below(100) == 0) edges.emplace_back(mesh_.edge_slots());
    std::shuffle(edges.begin(), edges.end(), random_);
    return edges;
  }

 private:
  std::size_t below(std::size_t count) { return std::size_t(random_()) % count; }
  Edge one() { return inner_[below(inner_.size())]; }
  Vertex end_of_one() {
    const Edge e = one();
    return mesh_.to_vertex(mesh_.edge_halfedge(e, Index(below(2))));
  }
  bool add(Edge e) {
    const bool is_inner = std::count(inner_.begin(), inner_.end(), e) > 0;
    if (is_inner) drawn_.insert(e);
    return is_inner;
  }

  void draw(std::size_t way) {
    if (way == 0) return draw_some(inner_, 1 + below(10));
    if (way == 1) return draw_spokes();
    if (way == 2) return draw_walk();
    if (way == 3) return draw_seams();
    if (way == 4) return draw_some(edges_of_net(mesh_), 10);
    for (std::size_t count = 1 + below(4); count > 0; --count) add(one());
  }
  void draw_some(const std::vector<Edge>& edges, std::size_t of_ten) {
    for (const Edge e : edges) {
      if (below(10) < of_ten) add(e);
    }
  }
  void draw_spokes() {
    std::vector<Edge> spokes;
    for (const Edge e : mesh_.vertex_edges_cw(end_of_one())) spokes.push_back(e);
    draw_some(spokes, 3 + below(8));
  }
  void draw_walk() {
    std::vector<Vertex> reached = {end_of_one()};
    for (std::size_t steps = 1 + below(20); steps > 0; --steps) {
      const Vertex v = below(3) == 0 ? reached[below(reached.size())] : reached.back();
      Halfedge h = mesh_.vertex_halfedge(v);
      for (std::size_t turns = below(8); turns > 0; --turns) h = mesh_.rotate_cw(h);
      if (add(Mesh::edge(h))) reached.push_back(mesh_.to_vertex(h));
    }
  }
  void draw_seams() {
    std::set<Face> some;
    for (const Face f : mesh_.faces()) {
      if (below(3) == 0) some.insert(f);
    }
    for (const Edge e : inner_) {
      const Face f = mesh_.face(mesh_.edge_halfedge(e, 0));
      if (some.count(f) != some.count(mesh_.face(mesh_.edge_halfedge(e, 1)))) add(e);
    }
  }

  const Mesh& mesh_;
  std::mt19937& random_;
  std::vector<Edge> inner_;
  std::set<Edge> drawn_;
};

inline std::vector<Edge> draw_edges(const Mesh& mesh, std::mt19937& random) {
  return DrawEdges(mesh, random)();
}

}  // namespace halfedge::test
