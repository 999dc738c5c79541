#include <halfedge/io/off_writer.h>

#include <algorithm>
#include <string_view>

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
      put_color(color_, v);
      put_values(texture_, v);
    });
    mesh_.for_each_face([this](Index f, std::span<const Index> corners) {
      put('\n', static_cast<Index>(corners.size()));
      for (const Index v : corners) put(' ', mesh_.number(v));
      if (!is_text_) put(' ', of_faces_ == nullptr ? Index{0} : of_faces_->components());
      put_color(of_faces_, f);
    });
    if (is_text_) out_.text("\n");
  }

 private:
  static constexpr ByteOrder kBig = ByteOrder::kBig;

  void choose() {
    const auto of_width = [](Index components) {
      return [components](const Attribute& column) {
        return column.type() == Scalar::kFloat32 && column.components() == components;
      };
    };
    const auto is_color = [](const Attribute& column) {
      return (column.type() == Scalar::kFloat32 || column.type() == Scalar::kUint8) &&
             (column.components() == 3 || column.components() == 4);
    };
    normal_ = mesh_.take(ItemKind::kVertex, "normal", of_width(3));
    texture_ = mesh_.take(ItemKind::kVertex, "uv", of_width(2));
    color_ = mesh_.take(ItemKind::kVertex, "color", is_color);
    of_faces_ = mesh_.take(ItemKind::kFace, "color", is_color);
    for (const Attribute* column : {color_, of_faces_}) {
      if (column == nullptr) continue;
      if (!is_text_ && column->type() == Scalar::kUint8) {
        mesh_.note_change(*column, "as numbers from 0 to 1");
      } else if (is_text_ && looks_like_floats(*column)) {
        mesh_.note_change(*column, "as 0 and 1, which readers take for floats");
      }
      if (!is_text_ && column == color_ && column->components() == 3) {
        mesh_.note_change(*column, "with an alpha of 1");
      }
    }
  }
  /// Of integers without any above 1 nobody can tell that they aren't from 0 to 1.
  [[nodiscard]] static bool looks_like_floats(const Attribute& column) {
    if (column.type() != Scalar::kUint8) return false;
    const std::span<const std::byte> values = column.bytes();
    const auto most = std::max_element(values.begin(), values.end());
    return most != values.end() && *most == std::byte{1};
  }

  void write_header() {
    if (texture_ != nullptr) out_.text("ST");
    if (color_ != nullptr) out_.text("C");
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
  void put_color(const Attribute* column, Index item) {
    if (column == nullptr) return;
    for (Index i = 0; i < column->components(); ++i) {
      const float number = value(*column, item, i);
      if (!is_text_) {
        put(' ', column->type() == Scalar::kUint8 ? number / 255 : number);
      } else if (column->type() == Scalar::kUint8) {
        put(' ', static_cast<Index>(number));
      } else {
        put(' ', number);
        if (is_whole(number)) out_.text(".0");  // no integer
      }
    }
    if (!is_text_ && column == color_ && column->components() == 3) put(' ', 1.0F);
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
  const Attribute* color_ = nullptr;
  const Attribute* of_faces_ = nullptr;
};

}  // namespace

void write_off(const LiveMesh& mesh, Encoding encoding, ByteWriter& out) {
  OffWriter(mesh, encoding, out).write();
}

}  // namespace halfedge::io
