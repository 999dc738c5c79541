#include <halfedge/io/distinct_rows.h>
#include <halfedge/io/obj_writer.h>

#include <array>
#include <string>
#include <string_view>

namespace halfedge::io {
namespace {

bool is_real(const Attribute& column) { return column.type() <= Scalar::kFloat64; }

/// A word that reads back as one.
std::string spelt(std::string_view name) {
  std::string text(name);
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == '#') c = '_';
  }
  return text;
}

class ObjWriter {
 public:
  ObjWriter(const LiveMesh& mesh, std::span<const SoupNames> names, ByteWriter& out)
      : mesh_(mesh), names_(names), out_(out) {}

  void write() {
    choose();
    write_libraries();
    mesh_.for_each_vertex([this](Index v) {
      out_.text("v");
      for (std::size_t i = 0; i < 3; ++i) out_.number(' ', mesh_.position(v)[i]);
      if (color_ != nullptr) write_color(v);
      out_.text("\n");
    });
    write_references("vt", texture_);
    write_references("vn", normal_);
    mesh_.for_each_face([this](Index f, std::span<const Index> corners) {
      for (Label& label : labels_) {
        if (label.column != nullptr) write_label(label, f);
      }
      write_face(f, corners);
    });
  }

 private:
  /// What a corner refers to: values of its vertex or its own.
  struct Reference {
    const Attribute* column = nullptr;
    Array<Index> numbers;  // by halfedge
  };
  /// A statement that holds for the faces behind it.
  struct Label {
    const char* attribute;
    const char* statement;
    const Attribute* column = nullptr;
    const SoupNames* names = nullptr;
    double current = 0;
  };

  void choose() {
    color_ = mesh_.take(ItemKind::kVertex, "color", [](const Attribute& column) {
      const bool has_type = is_real(column) || column.type() == Scalar::kUint8;
      return has_type && (column.components() == 3 || column.components() == 4);
    });
    if (color_ != nullptr && !is_real(*color_)) {
      mesh_.note_change(*color_, "as numbers from 0 to 1");
    }
    texture_.column = take_reference("uv", 2);
    normal_.column = take_reference("normal", 3);
    for (const Attribute* column : {color_, texture_.column, normal_.column}) {
      if (column != nullptr && column->type() == Scalar::kFloat64) {
        mesh_.note_change(*column, "as doubles, which readers take for floats");
      }
    }
    for (Label& label : labels_) {
      label.column = mesh_.take(ItemKind::kFace, label.attribute, [](const Attribute& column) {
        return !is_real(column) && column.components() == 1;
      });
      label.names = names_of(label.attribute);
    }
  }
  [[nodiscard]] const Attribute* take_reference(const char* name, Index components) {
    const auto fits = [components](const Attribute& column) {
      return is_real(column) && column.components() == components;
    };
    const Attribute* const own = mesh_.take(ItemKind::kHalfedge, name, fits);
    return own != nullptr ? own : mesh_.take(ItemKind::kVertex, name, fits);
  }
  [[nodiscard]] const SoupNames* names_of(std::string_view attribute) const {
    for (const SoupNames& table : names_) {
      if (table.attribute == attribute) return &table;
    }
    return nullptr;
  }

  void write_libraries() {
    const SoupNames* const libraries = names_of("library");
    if (libraries == nullptr) return;
    for (const std::string& name : libraries->names) write_statement("mtllib", spelt(name));
  }
  void write_statement(const char* statement, const std::string& rest) {
    out_.text(statement);
    if (!rest.empty()) out_.text(" ");
    out_.text(rest);
    out_.text("\n");
  }

  void write_color(Index v) {
    for (Index i = 0; i < color_->components(); ++i) {
      if (is_real(*color_)) {
        write_number(*color_, v, i);
      } else {
        out_.number(' ', static_cast<float>(color_->get(v, i)) / 255);
      }
    }
  }
  void write_number(const Attribute& column, Index item, Index component) {
    const std::size_t at = column.stride() * item + size_of(column.type()) * component;
    out_.number(' ', column.type(), &column.bytes()[at]);
  }
  void write_row(const char* statement, const Attribute& column, Index item) {
    out_.text(statement);
    for (Index i = 0; i < column.components(); ++i) write_number(column, item, i);
    out_.text("\n");
  }

  void write_references(const char* statement, Reference& reference) {
    if (reference.column == nullptr) return;
    const Attribute& column = *reference.column;
    if (column.kind() == ItemKind::kVertex) {
      mesh_.for_each_vertex([&](Index v) { write_row(statement, column, v); });
      return;
    }
    DistinctRows rows(column);
    bool fits = reference.numbers.resize(column.slots(), kNone);
    mesh_.for_each_face([&](Index f, std::span<const Index>) {
      for (const Index h : mesh_.halfedges(f)) {
        const Index before = rows.count();
        fits = fits && rows.find_or_add(h, reference.numbers[h]);
        if (fits && rows.count() > before) write_row(statement, column, h);
      }
    });
    if (!fits) out_.set_out_of_memory();
  }

  void write_label(Label& label, Index face) {
    const double value = label.column->get(face, 0);
    if (value == label.current) return;
    label.current = value;
    const bool has_name =
        label.names != nullptr && value >= 0 && value < double(label.names->names.size());
    write_statement(label.statement, has_name ? spelt(label.names->names[std::size_t(value)])
                                              : std::to_string(std::int64_t(value)));
  }

  void write_face(Index f, std::span<const Index> corners) {
    if (out_.out_of_memory()) return;
    const bool by_halfedge = !texture_.numbers.empty() || !normal_.numbers.empty();
    const std::span<const Index> halfedges =
        by_halfedge ? mesh_.halfedges(f) : std::span<const Index>();
    const auto number = [&](const Reference& reference, std::size_t corner) {
      return reference.numbers.empty() ? mesh_.number(corners[corner]) + 1
                                       : reference.numbers[halfedges[corner]] + 1;
    };
    out_.text("f");
    for (std::size_t i = 0; i < corners.size(); ++i) {
      out_.number(' ', mesh_.number(corners[i]) + 1);
      if (texture_.column != nullptr) out_.number('/', number(texture_, i));
      if (normal_.column == nullptr) continue;
      if (texture_.column == nullptr) out_.text("/");
      out_.number('/', number(normal_, i));
    }
    out_.text("\n");
  }

  const LiveMesh& mesh_;
  std::span<const SoupNames> names_;
  ByteWriter& out_;
  const Attribute* color_ = nullptr;
  Reference texture_;
  Reference normal_;
  std::array<Label, 3> labels_ = {{{"object", "o"}, {"group", "g"}, {"material", "usemtl"}}};
};

}  // namespace

void write_obj(const LiveMesh& mesh, std::span<const SoupNames> names, ByteWriter& out) {
  ObjWriter(mesh, names, out).write();
}

}  // namespace halfedge::io
