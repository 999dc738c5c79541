#include <halfedge/algorithms/polygon_cutter.h>
#include <halfedge/io/position_table.h>
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
      if (fits) cutter_.for_each_triangle(ears_.span(), visit_corners);
    });
    return fits;
  }

 private:
  /// Where each way to cut a face takes an edge that there is, it is cut along that.
  [[nodiscard]] bool cut(std::span<const Index> corners) {
    using Outcome = PolygonCutter::Outcome;
    corners_.clear();
    points_.clear();
    ears_.clear();
    for (const Index corner : corners) {
      const float* const p = mesh_.position(corner);
      if (!corners_.push_back(Vertex(corner)) || !points_.push_back({p[0], p[1], p[2]})) {
        return false;
      }
    }
    const auto is_edge = [this](Vertex a, Vertex b) {
      return mesh_.are_joined(a.index(), b.index());
    };
    Outcome outcome = cutter_.cut(corners_.span(), points_.span(), is_edge, ears_);
    if (outcome == Outcome::kBlocked) outcome = cutter_.cut_anyhow(points_.span(), ears_);
    return outcome == Outcome::kDone && cutter_.keep_diagonals(corners_.span());
  }

  const LiveMesh& mesh_;
  PolygonCutter cutter_;
  Array<Vertex> corners_;
  Array<Point> points_;
  Array<Index> ears_;
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
