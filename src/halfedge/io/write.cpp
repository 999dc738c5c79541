#include <halfedge/io/byte_writer.h>
#include <halfedge/io/live_mesh.h>
#include <halfedge/io/obj_writer.h>
#include <halfedge/io/off_writer.h>
#include <halfedge/io/ply_writer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace halfedge {
namespace io {
namespace {

// ---- STL -------------------------------------------------------------------------------------

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

/// Calls `visit(face, normal and corners)` for each triangle of the fans.
template <class Visit>
void for_each_triangle(const LiveMesh& mesh, const Visit& visit) {
  mesh.for_each_face([&](Index f, std::span<const Index> corners) {
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const float* const a = mesh.position(corners[0]);
      const float* const b = mesh.position(corners[i - 1]);
      const float* const c = mesh.position(corners[i]);
      const Vector n = normal_of(a, b, c);
      visit(f, std::array<const float*, 4>{n.data(), a, b, c});
    }
  });
}

void write_text_stl(const LiveMesh& mesh, ByteWriter& out) {
  out.text("solid\n");
  for_each_triangle(mesh, [&out](Index, const std::array<const float*, 4>& points) {
    constexpr std::string_view kWords[] = {"facet normal", "outer loop\nvertex", "vertex",
                                           "vertex"};
    for (std::size_t i = 0; i < 4; ++i) {
      out.text(kWords[i]);
      for (std::size_t axis = 0; axis < 3; ++axis) out.number(' ', points[i][axis]);
      out.text("\n");
    }
    out.text("endloop\nendfacet\n");
  });
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
  for_each_triangle(mesh, [&](Index f, const std::array<const float*, 4>& points) {
    for (const float* const point : points) {
      for (std::size_t axis = 0; axis < 3; ++axis) out.binary<kLittle>(point[axis]);
    }
    const double value = attribute == nullptr ? 0 : attribute->get(f, 0);
    out.binary<kLittle>(static_cast<std::uint16_t>(value));
  });
}

/// What STL can't hold.
std::optional<Error> check_stl(const LiveMesh& mesh, std::span<const Index> used) {
  if (mesh.triangle_count() > 0xFFFF'FFFFU) {
    return Error{"too-large", "the mesh has " + std::to_string(mesh.triangle_count()) +
                                  " triangles, expected at most 4294967295 in STL"};
  }
  for (const Index v : used) {
    const float* const p = mesh.position(v);
    if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])) continue;
    Error error{"non-finite-position", "vertex " + std::to_string(v) + " has the position " +
                                           std::to_string(p[0]) + ", " + std::to_string(p[1]) +
                                           ", " + std::to_string(p[2]) +
                                           ", expected finite numbers in STL"};
    error.witness.vertices = {v};
    return error;
  }
  return std::nullopt;
}

/// False if the format has no such encoding.
bool write_as(const LiveMesh& mesh, Format format, Encoding encoding,
              std::span<const SoupNames> names, ByteWriter& out) {
  const bool text = encoding == Encoding::kText;
  switch (format) {
    case Format::kObj:
      if (text) write_obj(mesh, names, out);
      return text;
    case Format::kOff:
      write_off(mesh, encoding, out);
      return true;
    case Format::kPly:
      write_ply(mesh, encoding, out);
      return true;
    case Format::kStl:
      if (encoding == Encoding::kBinaryBigEndian) return false;
      text ? write_text_stl(mesh, out) : write_binary_stl(mesh, out);
      return true;
  }
  return false;
}

}  // namespace
}  // namespace io

Result<Array<std::uint8_t>> write_faces(const WriteSource& source, Format format,
                                        const WriteOptions& options) {
  const bool binary = format == Format::kPly || format == Format::kStl;
  const Encoding encoding = options.encoding.value_or(binary ? Encoding::kBinary : Encoding::kText);
  std::vector<std::string> notes;
  io::LiveMesh mesh(source, options.notes != nullptr ? *options.notes : notes);
  if (std::optional<Error> error = mesh.prepare()) return *std::move(error);
  if (format == Format::kStl) {
    if (auto error = io::check_stl(mesh, source.faces.items.span())) return *std::move(error);
  }
  io::ByteWriter out;
  if (!io::write_as(mesh, format, encoding, options.names, out)) {
    return Error{"unsupported-format",
                 std::string(name_of(format)) + (format == Format::kObj
                                                     ? " has no binary form, expected text"
                                                     : " has no big-endian form")};
  }
  if (out.out_of_memory()) return io::no_memory_for_a_file();
  if (format != Format::kPly) {
    mesh.leave_out_rest(std::string(name_of(format)) + " has no place for it");
  }
  out.bytes().shrink_to_fit();
  return std::move(out.bytes());
}

}  // namespace halfedge
