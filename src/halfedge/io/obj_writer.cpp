#include <halfedge/io/distinct_rows.h>
#include <halfedge/io/obj_attributes.h>
#include <halfedge/io/obj_writer.h>
#include <halfedge/sentence.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace halfedge::io {
namespace {

bool is_real(const Attribute& column) { return column.type() <= Scalar::kFloat64; }

/// A name that reads back as one: a # that starts a word would start a comment.
std::string spelt(std::string_view name) {
  const std::size_t begin = std::min(name.find_first_not_of(' '), name.size());
  std::string text(name.substr(begin, name.find_last_not_of(' ') + 1 - begin));
  bool starts_word = true;
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || (c == '#' && starts_word)) c = '_';
    starts_word = c == ' ';
  }
  return text;
}

/// Whether it is one that readers take for the number itself.
bool is_number(const std::string& text) {
  std::int32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && std::to_string(number) == text;
}

/// Of what will be written: the slots of deleted faces don't count.
bool fits_int32(const LiveMesh& mesh, const Attribute& column) {
  if (column.type() != Scalar::kUint32) return true;
  bool fits = true;
  mesh.for_each_face(
      [&](Index f, std::span<const Index>) { fits &= column.get(f, 0) <= INT32_MAX; });
  return fits;
}

class ObjWriter {
 public:
  ObjWriter(const LiveMesh& mesh, std::span<const SoupNames> names, ByteWriter& out)
      : mesh_(mesh), names_(names), out_(out) {}

  void write() {
    choose();
    write_libraries();
    // An empty file is of no format: this statement, which changes nothing, tells that it is OBJ.
    if (mesh_.vertex_count() == 0) out_.text("# no vertices\nusemtl (null)\n");
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
  static constexpr std::string_view kSmoothing = "smoothing";  // whose groups have no names
  static constexpr const char* kSpelling =
      "control characters and a # that starts a word become _, blanks at the ends are left out";

  /// What a corner refers to: values of its vertex or its own.
  struct Reference {
    const Attribute* column = nullptr;
    Array<Index> numbers;  // by halfedge
  };
  /// A statement that holds for the faces behind it.
  struct Label {
    std::string_view attribute;
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
    if (color_ != nullptr) choose_color();
    texture_.column = take_reference("uv", 2);
    normal_.column = take_reference("normal", 3);
    for (const Attribute* column : {color_, texture_.column, normal_.column}) {
      if (column != nullptr && column->type() == Scalar::kFloat64) {
        mesh_.note_change(*column, "as doubles, which readers take for floats");
      }
    }
    for (const Attribute* column : {texture_.column, normal_.column}) {
      if (column != nullptr && column->kind() == ItemKind::kVertex) {
        mesh_.note_change(*column, mesh_.face_count() > 0
                                       ? "for the corners of faces, to which readers give it"
                                       : "for corners of faces, of which there are none");
      }
    }
    for (Label& label : labels_) choose(label);
  }
  /// Whether all values are whole numbers from 0 to 255, and one is above 1 (see ObjAttributes).
  [[nodiscard]] bool has_bytes(const Attribute& column) const {
    bool are_bytes = true;
    bool is_above = false;
    mesh_.for_each_vertex([&](Index v) {
      for (Index i = 0; i < column.components(); ++i) {
        const double value = column.get(v, i);
        are_bytes &= value >= 0 && value <= 255 && value == std::floor(value);
        is_above |= value > 1;
      }
    });
    return are_bytes && is_above;
  }
  /// Some readers leave out vertices with seven numbers, or refuse the file.
  void choose_color() {
    if (!is_real(*color_)) {
      mesh_.note_change(*color_, "as numbers from 0 to 1");
    } else if (has_bytes(*color_)) {
      mesh_.note_change(*color_, "as numbers that readers take for uint8");
    }
    color_width_ = color_->components();
    if (color_width_ == 3) return;
    const double full = is_real(*color_) ? 1 : 255;
    bool is_opaque = true;
    mesh_.for_each_vertex([&](Index v) { is_opaque &= color_->get(v, 3) == full; });
    if (is_opaque) color_width_ = 3;
    mesh_.note_change(*color_, is_opaque ? "without its alpha, which is 1 everywhere"
                                         : "with an alpha, for which some readers refuse the file");
  }
  void choose(Label& label) {
    label.column = mesh_.take(ItemKind::kFace, label.attribute, [this](const Attribute& column) {
      if (is_real(column) || column.components() != 1) return false;
      if (!fits_int32(mesh_, column)) {
        mesh_.leave_out(column, "readers of OBJ take numbers up to 2147483647");
        return false;
      }
      // Such faces need no statement, and where there is none, readers find no labels.
      if (is_zero_everywhere(column)) {
        mesh_.leave_out(column, "it is 0 for all faces, for which OBJ has no statement");
        return false;
      }
      return true;
    });
    if (label.column == nullptr) return;
    if (label.column->type() != Scalar::kInt32) {
      mesh_.note_change(*label.column, "as numbers that readers take for int32");
    }
    if (label.attribute != kSmoothing) label.names = names_of(label.attribute);
    if (label.names != nullptr) note_names(label);
  }
  [[nodiscard]] bool is_zero_everywhere(const Attribute& column) const {
    bool has_faces = false;
    bool is_zero = true;
    mesh_.for_each_face([&](Index f, std::span<const Index>) {
      has_faces = true;
      is_zero &= column.get(f, 0) == 0;
    });
    return has_faces && is_zero;
  }
  /// Says which names readers will not give back as they are.
  void note_names(const Label& label) const {
    const std::vector<std::string>& names = label.names->names;
    std::vector<bool> is_used(names.size());
    bool any_without = false;
    mesh_.for_each_face([&](Index f, std::span<const Index>) {
      const double value = label.column->get(f, 0);
      if (has_name(label, value)) {
        is_used[std::size_t(value)] = true;
      } else {
        any_without = true;
      }
    });
    std::size_t changed = 0;
    std::size_t empty = 0;
    std::size_t none = 0;
    std::size_t numbers = 0;
    std::size_t used = 0;
    for (std::size_t i = 1; i < names.size(); ++i) {  // the first is that of no name
      if (!is_used[i]) continue;
      const std::string text = spelt(names[i]);
      ++used;
      changed += text != names[i] ? 1U : 0U;
      empty += text.empty() ? 1U : 0U;
      none += is_material(label) && text == kNoMaterial ? 1U : 0U;
      numbers += is_number(text) ? 1U : 0U;
    }
    const auto note = [&](std::size_t count, const char* verb, const char* what) {
      if (count == 0) return;
      mesh_.note_change(*label.column,
                        sentence::of("with {} of its {} names {} {}", count, used, verb, what));
    };
    note(changed, "changed:", kSpelling);
    note(empty, "left out,", "being empty");
    note(none, "left out,", "being (null), which stands for none");
    if (numbers + empty == used) note(numbers, "that", "are numbers, for which readers take them");
    if (any_without && numbers + empty < used) {
      mesh_.note_change(*label.column, "with names that are the numbers of faces which have none");
    }
  }
  [[nodiscard]] static bool is_material(const Label& label) {
    return label.attribute == "material";
  }
  [[nodiscard]] static bool has_name(const Label& label, double value) {
    return label.names != nullptr && value >= 0 && value < double(label.names->names.size());
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
    std::size_t changed = 0;
    for (const std::string& name : libraries->names) {
      const std::string text = spelt(name);
      changed += text != name ? 1U : 0U;
      write_statement("mtllib", text);
    }
    if (changed == 0) return;
    mesh_.note(sentence::of("wrote {} of {} names of libraries changed: {}", changed,
                            libraries->names.size(), kSpelling));
  }
  void write_statement(const char* statement, const std::string& rest) {
    out_.text(statement);
    if (!rest.empty()) out_.text(" ");
    out_.text(rest);
    out_.text("\n");
  }

  void write_color(Index v) {
    for (Index i = 0; i < color_width_; ++i) {
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
    std::string name = has_name(label, value) ? spelt(label.names->names[std::size_t(value)])
                                              : std::to_string(std::int64_t(value));
    // Readers pass over the statement without a name, which leaves the material as it was, or stop
    // at it.
    if (is_material(label) && name.empty()) name = kNoMaterial;
    write_statement(label.statement, name);
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
  Index color_width_ = 0;  // of what is written of it
  Reference texture_;
  Reference normal_;
  std::array<Label, 4> labels_ = {
      {{"object", "o"}, {"group", "g"}, {"material", "usemtl"}, {kSmoothing, "s"}}};
};

}  // namespace

void write_obj(const LiveMesh& mesh, std::span<const SoupNames> names, ByteWriter& out) {
  ObjWriter(mesh, names, out).write();
}

}  // namespace halfedge::io
