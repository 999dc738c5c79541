#include <halfedge/io/off_attributes.h>
#include <halfedge/sentence.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace halfedge::io {
namespace {

[[nodiscard]] bool append(Array<float>& values, std::span<const float> row) {
  for (const float value : row) {
    if (!values.push_back(value)) return false;
  }
  return true;
}

[[nodiscard]] bool add_floats(const char* name, Index components, Array<float>& values,
                              ParsedFile& file) {
  if (values.empty()) return true;
  SoupAttribute& column = file.attributes.emplace_back();
  column.name = name;
  column.components = components;
  if (column.name == "normal") column.on_split = OnSplit::kNormalize;
  const bool fits = column.values.assign(std::as_bytes(std::as_const(values).span()));
  values.reset();
  return fits;
}

}  // namespace

bool OffColors::add(std::size_t item, std::span<const float> color) {
  if (!values_.reserve_more(4 * (item + 1) - values_.size()) ||
      !rows_.reserve_more(item + 1 - rows_.size())) {
    return false;
  }
  (void)values_.resize(4 * item, 0);  // in the room made above, as the rest
  (void)rows_.resize(item, {});
  have_alpha_ |= color.size() == 4;
  (void)append(values_, color);
  (void)values_.resize(4 * (item + 1), 0);
  (void)rows_.push_back({static_cast<std::uint8_t>(color.size()), is_of_integers_});
  are_integers_ &= is_of_integers_;
  is_of_integers_ = true;
  return true;
}

bool OffColors::is_byte_row(std::size_t item) const {
  const float* const color = &values_[4 * item];
  const float most = *std::max_element(color, color + 4);
  return rows_[item].is_of_integers && most > 1 && most <= 255;
}

bool OffColors::finish(SoupItem item, std::size_t count, ParsedFile& file) {
  if (values_.empty()) return true;
  if (!values_.resize(4 * count, 0) || !rows_.resize(count, {})) return false;
  const std::size_t width = have_alpha_ ? 4 : 3;
  float most = 0;
  for (const float value : values_) most = std::max(most, value);
  const bool are_bytes = are_integers_ && most <= 255 && most != 1;

  SoupAttribute& column = file.attributes.emplace_back();
  column.name = "color";
  column.item = item;
  column.type = are_bytes ? Scalar::kUint8 : Scalar::kFloat32;
  column.components = static_cast<Index>(width);
  if (!column.values.resize(column.stride() * count)) return false;
  std::byte* to = column.values.data();
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_scaled = !are_integers_ && is_byte_row(i);
    for (std::size_t k = 0; k < width; ++k) {
      float value = values_[4 * i + k];
      if (is_scaled) value /= 255;
      if (k == 3 && rows_[i].width == 3) value = are_bytes ? 255 : 1;
      if (are_bytes) {
        *to++ = static_cast<std::byte>(value);
      } else {
        std::memcpy(to, &value, sizeof(value));
        to += sizeof(value);
      }
    }
  }
  values_.reset();
  rows_.reset();
  return true;
}

bool OffAttributes::add_vertex(const OffHeader& header, std::size_t vertex,
                               std::span<const float> numbers) {
  const std::size_t others = (header.normals ? 3U : 0U) + (header.texture ? 2U : 0U);
  const std::size_t of_color = header.colors ? (numbers.size() == others + 3 ? 3U : 4U) : 0U;
  other_ += numbers.size() > others + of_color ? 1U : 0U;
  incomplete_ += numbers.size() < others + of_color ? 1U : 0U;
  float row[9] = {};
  std::copy_n(numbers.begin(), std::min(numbers.size(), std::size(row)), row);
  const float* at = row;
  if (header.normals && !append(normals_, {at, 3})) return false;
  at += header.normals ? 3 : 0;
  if (header.colors && !vertex_colors_.add(vertex, {at, of_color})) return false;
  at += of_color;
  return !header.texture || append(textures_, {at, 2});
}

bool OffAttributes::add_face(std::size_t face, std::span<const float> numbers) {
  if (numbers.size() >= 3) return face_colors_.add(face, numbers.first(numbers.size() > 3 ? 4 : 3));
  ++of_table_;
  return true;
}

bool OffAttributes::finish(std::size_t vertices, std::size_t faces, ParsedFile& file) {
  const auto note = [&file](std::size_t count, const char* noun, const char* what) {
    if (count == 0) return;
    file.notes.push_back(sentence::of("of {} {}: {}", count, noun, what));
  };
  const char* const vertex = incomplete_ == 1 ? "vertex" : "vertices";
  note(incomplete_, vertex, "fewer numbers than the header word promises, those missing are 0");
  note(other_, other_ == 1 ? "vertex" : "vertices",
       "ignored what is more than the header word promises");
  note(of_table_, of_table_ == 1 ? "face" : "faces",
       "ignored a colour that is no red, green and blue");
  return add_floats("normal", 3, normals_, file) &&
         vertex_colors_.finish(SoupItem::kVertex, vertices, file) &&
         add_floats("uv", 2, textures_, file) && face_colors_.finish(SoupItem::kFace, faces, file);
}

}  // namespace halfedge::io
