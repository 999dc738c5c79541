#include <halfedge/io/byte_writer.h>
#include <halfedge/io/write.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace halfedge {
namespace io {
namespace {

/// The live vertices and faces of a mesh, numbered without gaps.
class LiveMesh {
 public:
  LiveMesh(std::span<const float> positions, const Adjacency& faces,
           std::span<const std::uint8_t> deleted)
      : positions_(positions), faces_(faces), deleted_(deleted) {}

  /// Numbers and counts.
  [[nodiscard]] std::optional<Error> prepare();

  [[nodiscard]] Index vertex_count() const { return vertex_count_; }
  [[nodiscard]] Index face_count() const { return face_count_; }
  [[nodiscard]] Index largest_degree() const { return largest_degree_; }
  [[nodiscard]] std::size_t corner_count() const { return faces_.items.size(); }
  [[nodiscard]] std::uint64_t triangle_count() const { return triangle_count_; }

  /// Calls `visit(x, y, z)` for each vertex.
  template <class Visit>
  void for_each_vertex(const Visit& visit) const {
    for (std::size_t v = 0; 3 * v < positions_.size(); ++v) {
      if (is_live(v)) visit(positions_[3 * v], positions_[3 * v + 1], positions_[3 * v + 2]);
    }
  }
  /// Calls `visit(slots of its vertices)` for each face; number() tells what to write for them.
  template <class Visit>
  void for_each_face(const Visit& visit) const {
    for (std::size_t f = 0; f + 1 < faces_.offsets.size(); ++f) {
      const Index begin = faces_.offsets[f];
      const Index size = faces_.offsets[f + 1] - begin;
      if (size > 0) visit(faces_.items.span().subspan(begin, size));
    }
  }
  [[nodiscard]] Index number(Index slot) const { return numbers_.empty() ? slot : numbers_[slot]; }
  [[nodiscard]] const float* position(Index slot) const {
    return &positions_[3 * std::size_t{slot}];
  }

 private:
  [[nodiscard]] bool is_live(std::size_t v) const { return deleted_.empty() || deleted_[v] == 0; }

  std::span<const float> positions_;
  const Adjacency& faces_;
  std::span<const std::uint8_t> deleted_;
  Array<Index> numbers_;  // of vertices; empty if there are no gaps
  Index vertex_count_ = 0;
  Index face_count_ = 0;
  Index largest_degree_ = 0;
  std::uint64_t triangle_count_ = 0;
};

Error out_of_memory() { return {"out-of-memory", "memory was exhausted while a file was written"}; }

std::optional<Error> LiveMesh::prepare() {
  const std::size_t slots = positions_.size() / 3;
  vertex_count_ = static_cast<Index>(slots);
  if (!deleted_.empty()) {
    if (!numbers_.resize(slots)) return out_of_memory();
    vertex_count_ = 0;
    for (std::size_t v = 0; v < slots; ++v) numbers_[v] = is_live(v) ? vertex_count_++ : kNone;
  }
  const auto bad = std::find_if(faces_.items.begin(), faces_.items.end(),
                                [&](Index v) { return v >= slots || !is_live(v); });
  if (bad != faces_.items.end()) {
    return Error{"corrupt-connectivity", "a face has the vertex " + std::to_string(*bad) +
                                             ", which is no live one: validate names the face"};
  }
  for_each_face([this](std::span<const Index> corners) {
    const auto degree = static_cast<Index>(corners.size());
    ++face_count_;
    largest_degree_ = std::max(largest_degree_, degree);
    triangle_count_ += degree < 3 ? 0 : degree - 2;
  });
  return std::nullopt;
}

// ---- OBJ and OFF -----------------------------------------------------------------------------

void write_obj(const LiveMesh& mesh, ByteWriter& out) {
  mesh.for_each_vertex([&out](float x, float y, float z) {
    out.text("v");
    for (const float p : {x, y, z}) out.number(' ', p);
    out.text("\n");
  });
  mesh.for_each_face([&](std::span<const Index> corners) {
    out.text("f");
    for (const Index v : corners) out.number(' ', mesh.number(v) + 1);
    out.text("\n");
  });
}

/// Rows as OFF and text PLY have them.
void write_text_rows(const LiveMesh& mesh, ByteWriter& out) {
  mesh.for_each_vertex([&out](float x, float y, float z) {
    out.number('\n', x);
    out.number(' ', y);
    out.number(' ', z);
  });
  mesh.for_each_face([&](std::span<const Index> corners) {
    out.number('\n', static_cast<Index>(corners.size()));
    for (const Index v : corners) out.number(' ', mesh.number(v));
  });
  out.text("\n");
}

void write_text_off(const LiveMesh& mesh, ByteWriter& out) {
  out.text("OFF");
  out.number('\n', mesh.vertex_count());
  out.number(' ', mesh.face_count());
  out.text(" 0");  // edges, which nobody reads
  write_text_rows(mesh, out);
}

void write_binary_off(const LiveMesh& mesh, ByteWriter& out) {
  constexpr ByteOrder kBig = ByteOrder::kBig;
  out.text("OFF BINARY\n");
  for (const Index count : {mesh.vertex_count(), mesh.face_count(), Index{0}}) {
    out.binary<kBig>(count);
  }
  mesh.for_each_vertex([&out](float x, float y, float z) {
    for (const float p : {x, y, z}) out.binary<kBig>(p);
  });
  mesh.for_each_face([&](std::span<const Index> corners) {
    out.binary<kBig>(static_cast<Index>(corners.size()));
    for (const Index v : corners) out.binary<kBig>(mesh.number(v));
    out.binary<kBig>(Index{0});  // components of a colour
  });
}

// ---- PLY -------------------------------------------------------------------------------------

void write_ply_header(const LiveMesh& mesh, const char* encoding, ByteWriter& out) {
  out.text("ply\nformat ");
  out.text(encoding);
  out.text(" 1.0\nelement vertex");
  out.number(' ', mesh.vertex_count());
  out.text("\nproperty float x\nproperty float y\nproperty float z\nelement face");
  out.number(' ', mesh.face_count());
  out.text(mesh.largest_degree() < 256 ? "\nproperty list uchar" : "\nproperty list uint");
  out.text(" int vertex_indices\nend_header");
}

template <ByteOrder kOrder>
void write_binary_ply(const LiveMesh& mesh, ByteWriter& out) {
  const bool small = mesh.largest_degree() < 256;
  write_ply_header(mesh, kOrder == ByteOrder::kBig ? "binary_big_endian" : "binary_little_endian",
                   out);
  out.text("\n");
  mesh.for_each_vertex([&out](float x, float y, float z) {
    for (const float p : {x, y, z}) out.binary<kOrder>(p);
  });
  mesh.for_each_face([&](std::span<const Index> corners) {
    if (small) {
      out.binary<kOrder>(static_cast<std::uint8_t>(corners.size()));
    } else {
      out.binary<kOrder>(static_cast<Index>(corners.size()));
    }
    for (const Index v : corners) out.binary<kOrder>(mesh.number(v));
  });
}

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

/// Calls `visit(normal and corners)` for each triangle of the fans.
template <class Visit>
void for_each_triangle(const LiveMesh& mesh, const Visit& visit) {
  mesh.for_each_face([&](std::span<const Index> corners) {
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const float* const a = mesh.position(corners[0]);
      const float* const b = mesh.position(corners[i - 1]);
      const float* const c = mesh.position(corners[i]);
      const Vector n = normal_of(a, b, c);
      visit(std::array<const float*, 4>{n.data(), a, b, c});
    }
  });
}

void write_text_stl(const LiveMesh& mesh, ByteWriter& out) {
  out.text("solid\n");
  for_each_triangle(mesh, [&out](const std::array<const float*, 4>& points) {
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
  for_each_triangle(mesh, [&out](const std::array<const float*, 4>& points) {
    for (const float* const point : points) {
      for (std::size_t axis = 0; axis < 3; ++axis) out.binary<kLittle>(point[axis]);
    }
    out.binary<kLittle>(std::uint16_t{0});
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
bool write_as(const LiveMesh& mesh, Format format, Encoding encoding, ByteWriter& out) {
  const bool text = encoding == Encoding::kText;
  switch (format) {
    case Format::kObj:
      if (text) write_obj(mesh, out);
      return text;
    case Format::kOff:
      text ? write_text_off(mesh, out) : write_binary_off(mesh, out);
      return true;
    case Format::kPly:
      if (text) {
        write_ply_header(mesh, "ascii", out);
        write_text_rows(mesh, out);
      } else if (encoding == Encoding::kBinary) {
        write_binary_ply<ByteOrder::kLittle>(mesh, out);
      } else {
        write_binary_ply<ByteOrder::kBig>(mesh, out);
      }
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

Result<Array<std::uint8_t>> write_faces(std::span<const float> positions, const Adjacency& faces,
                                        std::span<const std::uint8_t> is_deleted, Format format,
                                        const WriteOptions& options) {
  const bool binary = format == Format::kPly || format == Format::kStl;
  const Encoding encoding = options.encoding.value_or(binary ? Encoding::kBinary : Encoding::kText);
  io::LiveMesh mesh(positions, faces, is_deleted);
  if (std::optional<Error> error = mesh.prepare()) return *std::move(error);
  if (format == Format::kStl) {
    if (auto error = io::check_stl(mesh, faces.items.span())) return *std::move(error);
  }
  io::ByteWriter out;
  if (!io::write_as(mesh, format, encoding, out)) {
    return Error{"unsupported-format",
                 std::string(name_of(format)) + (format == Format::kObj
                                                     ? " has no binary form, expected text"
                                                     : " has no big-endian form")};
  }
  if (out.out_of_memory()) return io::out_of_memory();
  out.bytes().shrink_to_fit();
  return std::move(out.bytes());
}

}  // namespace halfedge
