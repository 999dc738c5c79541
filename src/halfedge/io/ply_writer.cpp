#include <halfedge/io/ply_columns.h>
#include <halfedge/io/ply_writer.h>
#include <halfedge/io/text_scanner.h>
#include <halfedge/sentence.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace halfedge::io {
namespace {

const char* name_in_ply(Scalar type) {
  constexpr const char* kNames[] = {"float", "double", "char", "uchar",
                                    "short", "ushort", "int",  "uint"};
  return kNames[static_cast<std::size_t>(type)];
}

/// Float, double, and then the integers, which come first there.
PlyType ply_type_of(Scalar type) { return static_cast<PlyType>((static_cast<int>(type) + 6) % 8); }

/// What the components of an attribute are called.
std::vector<std::string> property_names(const Attribute& attribute) {
  const std::string& name = attribute.name();
  const Index count = attribute.components();
  if (name == "normal" && count == 3) return {"nx", "ny", "nz"};
  if (name == "color" && count == 3) return {"red", "green", "blue"};
  if (name == "color" && count == 4) return {"red", "green", "blue", "alpha"};
  if (name == "uv" && count == 2 && attribute.kind() == ItemKind::kVertex) return {"s", "t"};
  if (count == 1) return {name};
  std::vector<std::string> names;
  for (Index i = 0; i < count; ++i) names.push_back(sentence::of("{}[{}]", name, i));
  return names;
}

bool is_one_word(std::string_view name) {
  return std::all_of(name.begin(), name.end(),
                     [](char c) { return class_of(c) == CharClass::kOther && c != '\0'; });
}

class PlyWriter {
 public:
  PlyWriter(const LiveMesh& mesh, Encoding encoding, ByteWriter& out)
      : mesh_(mesh),
        out_(out),
        is_text_(encoding == Encoding::kText),
        is_big_(encoding == Encoding::kBinaryBigEndian),
        is_reversed_(is_big_ != (__BYTE_ORDER__ == __ORDER_BIG_ENDIAN__)),
        length_type_(length_type(mesh.largest_degree())),
        texture_length_type_(length_type(2 * std::uint64_t{mesh.largest_degree()})) {}

  void write() {
    write_header();
    mesh_.for_each_vertex([this](Index v) {
      const float* const p = mesh_.position(v);
      put('\n', Scalar::kFloat32, p, 3);
      for (const Attribute* column : of_vertices_) put_values(*column, v);
    });
    mesh_.for_each_face([this](Index f, std::span<const Index> corners) {
      put_length('\n', length_type_, corners.size());
      for (const Index v : corners) {
        const Index number = mesh_.number(v);
        put(' ', Scalar::kUint32, &number, 1);
      }
      for (const Attribute* column : of_faces_) put_values(*column, f);
      if (texture_ == nullptr) return;
      put_length(' ', texture_length_type_, 2 * corners.size());
      for (const Index h : mesh_.halfedges(f)) put_values(*texture_, h);
    });
    if (is_text_) out_.text("\n");
  }

 private:
  void write_header() {
    out_.text("ply\nformat ");
    out_.text(is_text_ ? "ascii" : is_big_ ? "binary_big_endian" : "binary_little_endian");
    out_.text(" 1.0\nelement vertex");
    out_.number(' ', mesh_.vertex_count());
    out_.text("\nproperty float x\nproperty float y\nproperty float z");
    of_vertices_ = write_properties(ItemKind::kVertex, {"x", "y", "z"});
    out_.text("\nelement face");
    out_.number(' ', mesh_.face_count());
    write_list(length_type_, "int vertex_indices");
    of_faces_ = write_properties(ItemKind::kFace, {"vertex_indices", "vertex_index", "texcoord"});
    for (const Attribute* column : mesh_.attributes(ItemKind::kHalfedge)) {
      const bool is_real = column->type() <= Scalar::kFloat64;
      if (column->name() == "uv" && column->components() == 2 && is_real) {
        texture_ = column;
        write_list(texture_length_type_, sentence::of("{} texcoord", name_in_ply(column->type())));
      } else {
        mesh_.leave_out(*column, "of halfedges PLY has only uv, two floats or doubles");
      }
    }
    for (const Attribute* column : mesh_.attributes(ItemKind::kEdge)) {
      mesh_.leave_out(*column, "PLY has none by edge");
    }
    out_.text("\nend_header");
    if (!is_text_) out_.text("\n");
  }

  /// Of those for long lists, int is the one that all readers know.
  [[nodiscard]] static Scalar length_type(std::uint64_t longest) {
    return longest < 256 ? Scalar::kUint8 : Scalar::kInt32;
  }
  void write_list(Scalar length_type, const std::string& property) {
    out_.text("\nproperty list ");
    out_.text(name_in_ply(length_type));
    out_.text(" ");
    out_.text(property);
  }

  /// Those that could be written. `names` are taken.
  [[nodiscard]] std::vector<const Attribute*> write_properties(ItemKind kind,
                                                               std::vector<std::string> names) {
    std::vector<const Attribute*> written;
    const std::size_t others = names.size();
    for (const Attribute* column : mesh_.attributes(kind)) {
      const std::vector<std::string> own = property_names(*column);
      const auto taken = std::find_first_of(own.begin(), own.end(), names.begin(), names.end());
      if (!is_one_word(column->name())) {
        mesh_.leave_out(*column, "a name in PLY is one word");
      } else if (taken != own.end()) {
        mesh_.leave_out(*column, sentence::of("there is another property {}", quoted(*taken)));
      } else {
        for (const std::string& name : own) {
          out_.text("\nproperty ");
          out_.text(name_in_ply(column->type()));
          out_.text(" ");
          out_.text(name);
        }
        names.insert(names.end(), own.begin(), own.end());
        written.push_back(column);
      }
    }
    note_other_names(kind, written, std::span(names).subspan(others));
    return written;
  }
  /// Asks the reader what it would make of the properties, one attribute after the other, with
  /// these names.
  void note_other_names(ItemKind kind, const std::vector<const Attribute*>& columns,
                        std::span<const std::string> names) const {
    PlyElement element;
    for (const Attribute* column : columns) {
      for (Index i = 0; i < column->components(); ++i) {
        element.properties.push_back(
            {names[element.properties.size()], ply_type_of(column->type()), std::nullopt});
      }
    }
    std::vector<SoupAttribute> read;
    const SoupItem item = kind == ItemKind::kFace ? SoupItem::kFace : SoupItem::kVertex;
    const std::vector<PlyTarget> targets = choose_columns(element, item, {}, read);
    std::size_t first = 0;
    for (const Attribute* column : columns) {
      const std::size_t target = targets[first].column;
      first += column->components();
      if (target == PlyTarget::kNowhere) {
        mesh_.note_change(*column, "behind so many others that readers leave it out");
      } else if (read[target].name != column->name() ||
                 read[target].components != column->components()) {
        mesh_.note_change(*column,
                          sentence::of("as what readers take for {}", quoted(read[target].name)));
      }
    }
  }

  void put_values(const Attribute& column, Index item) {
    put(' ', column.type(), column.bytes().data() + column.stride() * item, column.components());
  }
  void put_length(char before, Scalar type, std::size_t length) {
    const auto word = static_cast<std::uint32_t>(length);
    const auto byte = static_cast<std::uint8_t>(length);
    type == Scalar::kUint8 ? put(before, type, &byte, 1) : put(before, type, &word, 1);
  }
  /// `before` is written before the first number of a text, blanks between them.
  void put(char before, Scalar type, const void* values, std::size_t count) {
    if (!is_text_) return out_.binary(type, values, count, is_reversed_);
    const auto* value = static_cast<const std::byte*>(values);
    for (; count > 0; --count, value += size_of(type), before = ' ') {
      out_.number(before, type, value);
    }
  }

  const LiveMesh& mesh_;
  ByteWriter& out_;
  bool is_text_;
  bool is_big_;
  bool is_reversed_;
  Scalar length_type_;
  Scalar texture_length_type_;
  std::vector<const Attribute*> of_vertices_;
  std::vector<const Attribute*> of_faces_;
  const Attribute* texture_ = nullptr;  // by halfedge
};

}  // namespace

void write_ply(const LiveMesh& mesh, Encoding encoding, ByteWriter& out) {
  PlyWriter(mesh, encoding, out).write();
}

}  // namespace halfedge::io
