#include <halfedge/io/byte_writer.h>
#include <halfedge/io/live_mesh.h>
#include <halfedge/io/obj_writer.h>
#include <halfedge/io/off_writer.h>
#include <halfedge/io/ply_writer.h>
#include <halfedge/io/stl_writer.h>
#include <halfedge/sentence.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace halfedge {
namespace io {
namespace {

void note_positions(const LiveMesh& mesh) {
  std::size_t lost = 0;
  mesh.for_each_vertex([&](Index v) {
    const float* const p = mesh.position(v);
    lost += std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]) ? 0U : 1U;
  });
  if (lost == 0) return;
  mesh.note(sentence::of(
      "wrote {} whose {}: readers leave {} out", sentence::count_of(lost, "vertex"),
      lost == 1 ? "position isn't finite" : "positions aren't finite", lost == 1 ? "it" : "them"));
}

/// Notes what PLY writes as numbers without the names that these stand for.
void note_names(const LiveMesh& mesh, std::span<const SoupNames> names) {
  for (const SoupNames& table : names) {
    const auto any = [](const Attribute&) { return true; };
    const Attribute* const column = mesh.take(ItemKind::kFace, table.attribute, any);
    if (column != nullptr) mesh.note_change(*column, "as numbers, without their names");
  }
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
      write_stl(mesh, encoding, out);
      return true;
  }
  return false;
}

}  // namespace

Error no_memory_for_a_file() {
  return {"out-of-memory", "memory was exhausted while a file was written"};
}

}  // namespace io

bool has_polygons(const Adjacency& faces) {
  for (std::size_t f = 0; f + 1 < faces.offsets.size(); ++f) {
    if (faces.offsets[f + 1] - faces.offsets[f] > 3) return true;
  }
  return false;
}

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
  if (format != Format::kStl && options.notes != nullptr) io::note_positions(mesh);
  if (format == Format::kStl && options.notes != nullptr &&
      !io::note_vertices(mesh, source.faces.items.span())) {
    return io::no_memory_for_a_file();
  }
  if (format == Format::kPly) {
    io::note_names(mesh, options.names);
  } else {
    const bool text_stl = format == Format::kStl && encoding == Encoding::kText;
    mesh.leave_out_rest(
        sentence::of("{}{} has no place for it", text_stl ? "text " : "", name_of(format)));
  }
  out.bytes().shrink_to_fit();
  return std::move(out.bytes());
}

}  // namespace halfedge
