#pragma once

#include <halfedge/connectivity/connectivity.h>

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace halfedge::test {

/// One of our meshes as `Matching` sees a complex.
template <class Mesh>
struct View {
  using H = Index;
  using V = Index;
  using F = Index;

  const Mesh& mesh;

  [[nodiscard]] H next(H h) const { return mesh.next(Halfedge(h)).index(); }
  [[nodiscard]] H opposite(H h) const { return mesh.opposite(Halfedge(h)).index(); }
  [[nodiscard]] V vertex(H h) const { return mesh.to_vertex(Halfedge(h)).index(); }
  [[nodiscard]] F face(H h) const { return mesh.face(Halfedge(h)).index(); }
  [[nodiscard]] F no_face() const { return kNone; }
  [[nodiscard]] std::size_t vertices() const { return mesh.vertex_count(); }
  [[nodiscard]] std::size_t halfedges() const { return mesh.halfedge_count(); }
  [[nodiscard]] std::size_t faces() const { return mesh.face_count(); }
  [[nodiscard]] static std::string name(H h) { return "halfedge " + std::to_string(h); }
};
template <class Mesh>
View(const Mesh&) -> View<Mesh>;

/// Whether two complexes are the same but for the numbering of their items. Some halfedges are
/// given as matched; whatever is reached from them by next and opposite is then matched too, and
/// must agree in both directions.
template <class A, class B>
class Matching {
 public:
  using Matched = std::vector<std::pair<typename A::H, typename B::H>>;

  Matching(A a, B b) : a_(a), b_(b) {}

  /// The first difference, or an empty string.
  [[nodiscard]] std::string run(Matched stack) {
    while (!stack.empty()) {
      const auto [h, g] = stack.back();
      stack.pop_back();
      const auto known = to_b_.find(h);
      if (known != to_b_.end() && known->second == g) continue;
      if (!one_to_one(to_b_, to_a_, h, g)) return A::name(h) + " matches two halfedges, or none";
      if (!one_to_one(vertices_, vertices_back_, a_.vertex(h), b_.vertex(g))) {
        return "the vertex of " + A::name(h) + " differs";
      }
      const bool has_face = a_.face(h) != a_.no_face();
      if (has_face != (b_.face(g) != b_.no_face()) ||
          (has_face && !one_to_one(faces_, faces_back_, a_.face(h), b_.face(g)))) {
        return "the face of " + A::name(h) + " differs";
      }
      stack.emplace_back(a_.next(h), b_.next(g));
      stack.emplace_back(a_.opposite(h), b_.opposite(g));
    }
    if (a_.vertices() != b_.vertices()) return "the numbers of vertices differ";
    if (a_.halfedges() != b_.halfedges()) return "the numbers of halfedges differ";
    if (a_.faces() != b_.faces()) return "the numbers of faces differ";
    if (to_b_.size() != a_.halfedges()) return "not all halfedges are matched";
    return {};
  }

  [[nodiscard]] const std::map<typename A::H, typename B::H>& halfedges() const { return to_b_; }
  [[nodiscard]] const std::map<typename A::V, typename B::V>& vertices() const { return vertices_; }
  [[nodiscard]] const std::map<typename A::F, typename B::F>& faces() const { return faces_; }

 private:
  template <class X, class Y>
  static bool one_to_one(std::map<X, Y>& there, std::map<Y, X>& back, X x, Y y) {
    return there.emplace(x, y).first->second == y && back.emplace(y, x).first->second == x;
  }

  A a_;
  B b_;
  std::map<typename A::H, typename B::H> to_b_;
  std::map<typename B::H, typename A::H> to_a_;
  std::map<typename A::V, typename B::V> vertices_;
  std::map<typename B::V, typename A::V> vertices_back_;
  std::map<typename A::F, typename B::F> faces_;
  std::map<typename B::F, typename A::F> faces_back_;
};

}  // namespace halfedge::test
