#include <halfedge/algorithms/triangulate_polygon.h>
#include <halfedge/io/position_table.h>
#include <halfedge/io/stl_writer.h>
#include <halfedge/operations/face_plan.h>
#include <halfedge/sentence.h>
#include <halfedge/sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace halfedge::io {
namespace {

using Vector = std::array<float, 3>;

/// Of unit length, or zero.
Vector normal_of(const float* a, const float* b, const float* c) {
  std::array<double, 3> u;
  std::array<double, 3> v;
  for (std::size_t i = 0; i < 3; ++i) {
    u[i] = static_cast<double>(b[i]) - static_cast<double>(a[i]);
    v[i] = static_cast<double>(c[i]) - static_cast<double>(a[i]);
  }
  const std::array<double, 3> n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                   u[0] * v[1] - u[1] * v[0]};
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  Vector normal{};
  for (std::size_t i = 0; i < 3 && length > 0; ++i)
    normal[i] = static_cast<float>(n[i] / length) + 0.0F;  // no -0
  return normal;
}

/// Cuts faces into the triangles of a file: as triangulate does, along no diagonal that is an edge
/// already, or a diagonal of an earlier face, so that readers find no edge with four faces.
class Cutter {
 public:
  explicit Cutter(const LiveMesh& mesh) : mesh_(mesh) {}

  /// Calls `visit(face, normal and corners)` for each triangle, in the order in which they are cut
  /// off. False when memory is exhausted.
  template <class Visit>
  [[nodiscard]] bool for_each_triangle(const Visit& visit) {
    bool fits = true;
    mesh_.for_each_face([&](Index f, std::span<const Index> corners) {
      if (!fits || corners.size() < 3) return;
      const auto visit_corners = [&](Index i, Index j, Index k) {
        const float* const a = mesh_.position(corners[i]);
        const float* const b = mesh_.position(corners[j]);
        const float* const c = mesh_.position(corners[k]);
        const Vector n = normal_of(a, b, c);
        visit(f, std::array<const float*, 4>{n.data(), a, b, c});
      };
      if (corners.size() == 3) return visit_corners(0, 1, 2);
      fits = cut(corners);
      if (!fits) return;
      for (const Index ear : ears_) {
        visit_corners(prev_[ear], ear, next_[ear]);
        next_[prev_[ear]] = next_[ear];
        prev_[next_[ear]] = prev_[ear];
      }
      const Index left = next_[ears_[ears_.size() - 1]];
      visit_corners(prev_[left], left, next_[left]);
    });
    return fits;
  }

 private:
  [[nodiscard]] bool cut(std::span<const Index> corners) {
    const std::size_t n = corners.size();
    if (!points_.recreate(n) || !next_.recreate(n) || !prev_.recreate(n)) return false;
    for (std::size_t i = 0; i < n; ++i) {
      const float* const p = mesh_.position(corners[i]);
      points_[i] = {p[0], p[1], p[2]};
    }
    forbidden_.clear();
    for (;;) {
      ears_.clear();
      switch (triangulator_.run(points_.span(), forbidden_.span(), ears_)) {
        case PolygonTriangulator::Outcome::kOutOfMemory:
          return false;
        case PolygonTriangulator::Outcome::kBlocked:
          return cut_in_any_way(corners);
        case PolygonTriangulator::Outcome::kDone:
          break;
      }
      const std::size_t known = forbidden_.size();
      if (!list_diagonals() || !forbid_existing(corners)) return false;
      if (forbidden_.size() == known) return keep_diagonals(corners);
    }
  }

  /// Without forbidden diagonals nothing but memory can be in the way.
  [[nodiscard]] bool cut_in_any_way(std::span<const Index> corners) {
    ears_.clear();
    return triangulator_.run(points_.span(), {}, ears_) == PolygonTriangulator::Outcome::kDone &&
           list_diagonals() && keep_diagonals(corners);
  }

  void join_in_a_ring() {
    const std::size_t n = points_.size();
    for (std::size_t i = 0; i < n; ++i) {
      next_[i] = Index(i + 1 == n ? 0 : i + 1);
      prev_[i] = Index(i == 0 ? n - 1 : i - 1);
    }
  }

  /// Those along which the ears are cut off. Afterwards the corners are a ring again.
  [[nodiscard]] bool list_diagonals() {
    join_in_a_ring();
    diagonals_.clear();
    for (const Index ear : ears_) {
      const Index a = prev_[ear];
      const Index b = next_[ear];
      if (!diagonals_.push_back({std::min(a, b), std::max(a, b)})) return false;
      next_[a] = b;
      prev_[b] = a;
    }
    join_in_a_ring();
    return true;
  }

  /// Puts those that join what is joined already on the list of the forbidden.
  [[nodiscard]] bool forbid_existing(std::span<const Index> corners) {
    for (const Diagonal& diagonal : diagonals_) {
      const Index a = corners[diagonal.a];
      const Index b = corners[diagonal.b];
      if (!mesh_.are_joined(a, b) && !taken_.contains(Vertex(a), Vertex(b))) continue;
      if (!forbidden_.push_back(diagonal)) return false;
    }
    introsort(forbidden_.begin(), forbidden_.end());
    return true;
  }

  /// Faces to come know the diagonals of this one.
  [[nodiscard]] bool keep_diagonals(std::span<const Index> corners) {
    for (const Diagonal& diagonal : diagonals_) {
      const Vertex a(corners[diagonal.a]);
      const Vertex b(corners[diagonal.b]);
      if (!taken_.contains(a, b) && !taken_.insert(a, b)) return false;
    }
    return true;
  }

  const LiveMesh& mesh_;
  PolygonTriangulator triangulator_;
  operations::internal::PlannedEdges taken_;  // diagonals of the faces so far
  Array<Point> points_;
  Array<Diagonal> forbidden_;
  Array<Diagonal> diagonals_;
  Array<Index> ears_;
  Array<Index> next_;  // of the corners that are left
  Array<Index> prev_;
};

void write_text_stl(const LiveMesh& mesh, ByteWriter& out) {
  out.text("solid\n");
  const bool fits =
      Cutter(mesh).for_each_triangle([&out](Index, const std::array<const float*, 4>& points) {
        constexpr std::string_view kWords[] = {"facet normal", "outer loop\nvertex", "vertex",
                                               "vertex"};
        for (std::size_t i = 0; i < 4; ++i) {
          out.text(kWords[i]);
          for (std::size_t axis = 0; axis < 3; ++axis) out.number(' ', points[i][axis]);
          out.text("\n");
        }
        out.text("endloop\nendfacet\n");
      });
  if (!fits) out.set_out_of_memory();
  out.text("endsolid\n");
}

void write_binary_stl(const LiveMesh& mesh, ByteWriter& out) {
  constexpr ByteOrder kLittle = ByteOrder::kLittle;
  out.text(std::string(80, ' '));
  out.binary<kLittle>(static_cast<std::uint32_t>(mesh.triangle_count()));
  const Attribute* const attribute =
      mesh.take(ItemKind::kFace, "attribute", [](const Attribute& column) {
        return column.type() == Scalar::kUint16 && column.components() == 1;
      });
  const bool fits =
      Cutter(mesh).for_each_triangle([&](Index f, const std::array<const float*, 4>& points) {
        for (const float* const point : points) {
          for (std::size_t axis = 0; axis < 3; ++axis) out.binary<kLittle>(point[axis]);
        }
        const double value = attribute == nullptr ? 0 : attribute->get(f, 0);
        out.binary<kLittle>(static_cast<std::uint16_t>(value));
      });
  if (!fits) out.set_out_of_memory();
}

}  // namespace

std::optional<Error> check_stl(const LiveMesh& mesh, std::span<const Index> used) {
  if (mesh.triangle_count() > 0xFFFF'FFFFU) {
    return Error{"too-large",
                 sentence::of("the mesh has {} triangles, expected at most 4294967295 in STL",
                              mesh.triangle_count())};
  }
  for (const Index v : used) {
    const float* const p = mesh.position(v);
    if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])) continue;
    Error error{
        "non-finite-position",
        sentence::of("vertex {} has the position {}, {}, {}, expected finite numbers in STL", v,
                     sentence::number(p[0]), sentence::number(p[1]), sentence::number(p[2]))};
    error.witness.vertices = {v};
    return error;
  }
  return std::nullopt;
}

bool note_vertices(const LiveMesh& mesh, std::span<const Index> used) {
  Array<std::uint8_t> seen;
  Array<float> places;
  if (!seen.resize(mesh.vertex_slots(), 0)) return false;
  for (const Index v : used) {
    if (seen[v] != 0) continue;
    seen[v] = 1;
    const float* const p = mesh.position(v);
    if (!places.push_back(p[0]) || !places.push_back(p[1]) || !places.push_back(p[2])) return false;
  }
  const std::size_t vertices = places.size() / 3;
  const std::size_t isolated = mesh.vertex_count() - vertices;
  if (isolated > 0) {
    mesh.note(sentence::of("left out {} without faces: STL has no place for {}",
                           sentence::count_of(isolated, "vertex"), isolated == 1 ? "it" : "them"));
  }
  PositionTable table;
  Array<float> distinct;
  Array<Index> indices;
  if (!indices.recreate(vertices) || !table.reserve(vertices) ||
      !table.weld(places.data(), vertices, distinct, indices.data())) {
    return false;
  }
  const std::size_t joined = vertices - distinct.size() / 3;
  if (joined > 0) {
    mesh.note(sentence::of("wrote {} in the same place as {}, with which readers of STL join {}",
                           sentence::count_of(joined, "vertex"), joined == 1 ? "another" : "others",
                           joined == 1 ? "it" : "them"));
  }
  return true;
}

void write_stl(const LiveMesh& mesh, Encoding encoding, ByteWriter& out) {
  encoding == Encoding::kText ? write_text_stl(mesh, out) : write_binary_stl(mesh, out);
}

}  // namespace halfedge::io
