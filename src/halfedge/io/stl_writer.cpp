#include <halfedge/algorithms/triangulate_polygon.h>
#include <halfedge/io/stl_writer.h>
#include <halfedge/sentence.h>

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

/// Cuts faces into the triangles of a file.
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
      next_[i] = Index(i + 1 == n ? 0 : i + 1);
      prev_[i] = Index(i == 0 ? n - 1 : i - 1);
    }
    ears_.clear();
    // Without forbidden diagonals nothing else can be wrong.
    return triangulator_.run(points_.span(), {}, ears_) == PolygonTriangulator::Outcome::kDone;
  }

  const LiveMesh& mesh_;
  PolygonTriangulator triangulator_;
  Array<Point> points_;
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

void write_stl(const LiveMesh& mesh, Encoding encoding, ByteWriter& out) {
  encoding == Encoding::kText ? write_text_stl(mesh, out) : write_binary_stl(mesh, out);
}

}  // namespace halfedge::io
