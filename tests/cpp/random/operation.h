#pragma once

#include <halfedge/mesh.h>
#include <halfedge/result.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// What random sequences of operations are made of: calls with arguments drawn at random, and what
/// each operation says of itself that can be checked whatever it is called with.
namespace halfedge::test {

using MeshWithoutPrev = BasicMesh<kWithoutPrev>;

/// The arguments of one operation; those that it doesn't take are empty.
struct Call {
  Halfedge h = {};
  Halfedge g = {};
  Edge e = {};
  Vertex v = {};
  Face f = {};
  std::vector<Halfedge> path = {};
  std::vector<Edge> edges = {};
  std::vector<Vertex> corners = {};
  std::optional<Point> position = {};
  Index count = 0;
  double number = 0.5;
  bool option = false;
};

/// Items by their indices: those that an operation may delete, or those near its arguments.
struct Items {
  std::set<Index> vertices;
  std::set<Index> edges;
  std::set<Index> faces;

  void add(Vertex v) { vertices.insert(v.index()); }
  void add(Halfedge h) { edges.insert(h.index() / 2); }
  void add(Edge e) { edges.insert(e.index()); }
  void add(Face f) {
    if (f.valid()) faces.insert(f.index());
  }
};

/// Numbers and items drawn at random. Most items are live; some are deleted or don't exist.
class Draw {
 public:
  explicit Draw(std::uint32_t seed) : random_(seed) {}
  /// Draws what the bytes say, as long as there are some.
  explicit Draw(std::span<const std::uint8_t> bytes) : bytes_(bytes), ends_(true) {}

  std::size_t below(std::size_t count) { return std::size_t(number(count)) % count; }
  /// The bytes to draw from have been used up.
  [[nodiscard]] bool used_up() const { return ends_ && bytes_.empty(); }
  bool one_in(std::size_t count) { return below(count) == 0; }

  Vertex vertex(const Mesh& mesh) { return item<Vertex>(mesh, mesh.vertex_count()); }
  Halfedge halfedge(const Mesh& mesh) { return item<Halfedge>(mesh, mesh.halfedge_count()); }
  Edge edge(const Mesh& mesh) { return item<Edge>(mesh, mesh.edge_count()); }
  Face face(const Mesh& mesh) { return item<Face>(mesh, mesh.face_count()); }

  /// Mostly one without a face, if there is such.
  Halfedge boundary_halfedge(const Mesh& mesh) {
    std::vector<Halfedge> found;
    for (const Halfedge h : mesh.halfedges()) {
      if (mesh.is_boundary(h)) found.push_back(h);
    }
    return found.empty() || one_in(10) ? halfedge(mesh) : found[below(found.size())];
  }
  /// Some steps on in the loop of `h`, or anywhere.
  Halfedge on_loop_of(const Mesh& mesh, Halfedge h) {
    if (!mesh.is_live(h) || one_in(10)) return halfedge(mesh);
    for (std::size_t steps = below(6); steps > 0; --steps) h = mesh.next(h);
    return h;
  }
  /// Some halfedges, each of which begins where the one before it ends: one loop that closes early,
  /// or a path along some faces.
  std::vector<Halfedge> path(const Mesh& mesh) {
    std::vector<Halfedge> found{halfedge(mesh)};
    const std::size_t length = 1 + below(6);
    while (found.size() < length && mesh.is_live(found.back())) {
      const Halfedge last = found.back();
      if (mesh.to_vertex(last) == mesh.from_vertex(found.front()) && !one_in(5)) break;
      Halfedge leaving = mesh.next(last);
      for (std::size_t steps = below(4); steps > 0; --steps) leaving = mesh.rotate_cw(leaving);
      found.push_back(leaving);
    }
    return found;
  }
  /// Another that leaves the same vertex, or anywhere.
  Halfedge around_start_of(const Mesh& mesh, Halfedge h) {
    if (!mesh.is_live(h) || one_in(10)) return halfedge(mesh);
    for (std::size_t steps = below(6); steps > 0; --steps) h = mesh.rotate_cw(h);
    return h;
  }
  std::optional<Point> position() {
    if (one_in(3)) return std::nullopt;
    const auto number = [this] { return float(below(1000)) / 1000; };
    const float x = number();
    const float y = number();
    return Point{x, y, number()};
  }

 private:
  template <class Item>
  Item item(const Mesh& mesh, Index live) {
    const Index slots = mesh.slots(Item{});
    if (live == 0 || one_in(60)) {
      return one_in(3) ? Item{} : Item(Index(below(std::size_t{slots} + 2)));
    }
    for (;;) {
      const Item drawn(Index(below(slots)));
      if (mesh.is_live(drawn)) return drawn;
    }
  }

  std::uint32_t number(std::size_t count) {
    if (bytes_.empty()) return std::uint32_t(random_());
    std::uint32_t drawn = 0;
    for (std::size_t reach = 1; reach < count && !bytes_.empty(); reach *= 256) {
      drawn = 256 * drawn + bytes_.front();
      bytes_ = bytes_.subspan(1);
    }
    return drawn;
  }

  std::mt19937 random_;
  std::span<const std::uint8_t> bytes_;
  bool ends_ = false;
};

/// Whether an operation makes the mesh larger: small meshes get more of those that do, large ones
/// of those that don't.
enum class Growth { kGrows, kKeeps, kShrinks };

/// One operation: how to draw its arguments, how to call it and its check, and what it promises.
struct Operation {
  std::string name;
  Growth growth = Growth::kKeeps;
  void (*draw)(const Mesh&, Draw&, Call&) = nullptr;
  Result<void> (*check)(const Mesh&, const Call&) = nullptr;
  Result<void> (*run)(Mesh&, const Call&) = nullptr;
  Result<void> (*check_without_prev)(const MeshWithoutPrev&, const Call&) = nullptr;
  Result<void> (*run_without_prev)(MeshWithoutPrev&, const Call&) = nullptr;
  /// By how much it changes V - E + F, if that doesn't depend on the arguments.
  std::optional<int> euler = 0;
  /// Whether it changes items all over the mesh, or only those with an end at a vertex of a face or
  /// boundary loop that one of its arguments lies at.
  bool everywhere = false;
  /// Whether vertices may have another position afterwards.
  bool moves = false;
  /// The live items that it may delete; without it, none.
  void (*deletes)(const Mesh&, const Call&, Items&) = nullptr;
  /// How seldom it is drawn beside the others.
  std::size_t rarity = 1;
};

using Operations = std::vector<Operation>;

/// An operation made of one generic check and one generic function, so that it is called in the
/// same words of both mesh types.
template <class Check, class Run>
Operation operation(std::string name, Growth growth, void (*draw)(const Mesh&, Draw&, Call&),
                    Check check, Run run) {
  Operation made;
  made.name = std::move(name);
  made.growth = growth;
  made.draw = draw;
  made.check = check;
  made.run = run;
  made.check_without_prev = check;
  made.run_without_prev = run;
  return made;
}

/// Whether it succeeded, without what it returned.
template <class T>
Result<void> outcome(const Result<T>& result) {
  if (result.ok()) return {};
  return result.error();
}

/// All of them.
const Operations& all_operations();

}  // namespace halfedge::test
