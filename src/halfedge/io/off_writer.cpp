#include <halfedge/io/off_writer.h>

#include <algorithm>

namespace halfedge::io {
namespace {

class OffWriter {
 public:
  OffWriter(const LiveMesh& mesh, Encoding encoding, ByteWriter& out)
      : mesh_(mesh), out_(out), is_text_(encoding == Encoding::kText) {}

  void write() {
    choose();
    write_header();
    mesh_.for_each_vertex([this](Index v) {
      for (std::size_t i = 0; i < 3; ++i) put(i == 0 ? '\n' : ' ', mesh_.position(v)[i]);
      put_values(normal_, v);
      put_color(of_vertices_, v);
      put_values(texture_, v);
    });
    mesh_.for_each_face([this](Index f, std::span<const Index> corners) {
      put('\n', static_cast<Index>(corners.size()));
      for (const Index v : corners) put(' ', mesh_.number(v));
      if (!is_text_) put(' ', of_faces_.components());
      put_color(of_faces_, f);
    });
    if (is_text_) out_.text("\n");
  }

 private:
  static constexpr ByteOrder kBig = ByteOrder::kBig;

  struct Colors {
    const Attribute* column = nullptr;
    bool bytes_as_fractions = false;  // a byte is written as the number from 0 to 1 it stands for

    [[nodiscard]] Index components() const { return column == nullptr ? 0 : column->components(); }
  };

  void choose() {
    const auto of_width = [](Index components) {
      return [components](const Attribute& column) {
        return column.type() == Scalar::kFloat32 && column.components() == components;
      };
    };
    normal_ = mesh_.take(ItemKind::kVertex, "normal", of_width(3));
    texture_ = mesh_.take(ItemKind::kVertex, "uv", of_width(2));
    of_vertices_ = choose_colors(ItemKind::kVertex);
    of_faces_ = choose_colors(ItemKind::kFace);
    if (gets_alpha(of_vertices_)) mesh_.note_change(*of_vertices_.column, "with an alpha of 1");
  }

  [[nodiscard]] Colors choose_colors(ItemKind kind) {
    Colors colors;
    colors.column = mesh_.take(kind, "color", [](const Attribute& column) {
      return (column.type() == Scalar::kFloat32 || column.type() == Scalar::kUint8) &&
             (column.components() == 3 || column.components() == 4);
    });
    if (colors.column == nullptr || colors.column->type() == Scalar::kFloat32) return colors;
    // Readers take integers up to 1 for numbers from 0 to 1; zeros alone are black either way.
    const bool has_255 = kind == ItemKind::kVertex && colors.components() == 3;  // its alpha
    colors.bytes_as_fractions = !is_text_ || (!has_255 && most(*colors.column, kind) == 1);
    if (colors.bytes_as_fractions) mesh_.note_change(*colors.column, "as numbers from 0 to 1");
    return colors;
  }
  /// A colour of a vertex has four numbers, by the definition of the format; one of a face may have
  /// three.
  [[nodiscard]] bool gets_alpha(const Colors& colors) const {
    return &colors == &of_vertices_ && colors.components() == 3;
  }
  /// Of what will be written: the slots of deleted items don't count.
  [[nodiscard]] float most(const Attribute& column, ItemKind kind) const {
    float most = 0;
    const auto see = [&](Index item) {
      for (Index i = 0; i < column.components(); ++i) most = std::max(most, value(column, item, i));
    };
    if (kind == ItemKind::kVertex) {
      mesh_.for_each_vertex(see);
    } else {
      mesh_.for_each_face([&see](Index f, std::span<const Index>) { see(f); });
    }
    return most;
  }

  void write_header() {
    if (texture_ != nullptr) out_.text("ST");
    if (of_vertices_.column != nullptr) out_.text("C");
    if (normal_ != nullptr) out_.text("N");
    out_.text(is_text_ ? "OFF" : "OFF BINARY\n");
    put('\n', mesh_.vertex_count());
    put(' ', mesh_.face_count());
    put(' ', Index{0});  // edges, which nobody reads
  }

  void put_values(const Attribute* column, Index item) {
    if (column == nullptr) return;
    for (Index i = 0; i < column->components(); ++i) put(' ', value(*column, item, i));
  }
  void put_color(const Colors& colors, Index item) {
    if (colors.column == nullptr) return;
    const bool are_bytes = colors.column->type() == Scalar::kUint8;
    const auto put_component = [&](float number) {
      if (are_bytes && !colors.bytes_as_fractions) {
        put(' ', static_cast<Index>(number));
      } else {
        put_fraction(are_bytes ? number / 255 : number);
      }
    };
    for (Index i = 0; i < colors.components(); ++i) put_component(value(*colors.column, item, i));
    if (gets_alpha(colors)) put_component(are_bytes ? 255 : 1);
  }
  void put_fraction(float number) {
    put(' ', number);
    if (is_text_ && is_whole(number)) out_.text(".0");  // no integer
  }
  /// Whether it is written without a point and without an exponent.
  [[nodiscard]] static bool is_whole(float number) {
    char text[kMaxNumberLength];
    const char* const end = write_float(text, number);
    return std::all_of(static_cast<const char*>(text), end,
                       [](char c) { return (c >= '0' && c <= '9') || c == '-'; });
  }
  [[nodiscard]] static float value(const Attribute& column, Index item, Index component) {
    return static_cast<float>(column.get(item, component));
  }

  void put(char before, float number) {
    is_text_ ? out_.number(before, number) : out_.binary<kBig>(number);
  }
  void put(char before, Index number) {
    is_text_ ? out_.number(before, number) : out_.binary<kBig>(number);
  }

  const LiveMesh& mesh_;
  ByteWriter& out_;
  bool is_text_;
  const Attribute* normal_ = nullptr;
  const Attribute* texture_ = nullptr;
  Colors of_vertices_;
  Colors of_faces_;
};

}  // namespace

void write_off(const LiveMesh& mesh, Encoding encoding, ByteWriter& out) {
  OffWriter(mesh, encoding, out).write();
}

}  // namespace halfedge::io
