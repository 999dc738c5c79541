#pragma once

#include <halfedge/io/ply_reader.h>
#include <halfedge/sentence.h>

#include <algorithm>
#include <array>
#include <type_traits>

/// How PlyReader reads faces: polygons with the texture coordinates of their corners, and strips.
namespace halfedge::io {

template <class Source>
bool PlyReader<Source>::read_faces(const PlyElement& element) {
  const PlyProperty* const list = element.vertex_list();
  if (list == nullptr) return true;  // and no faces: the header was checked
  if (element.count > 0 && !list->name.starts_with("vertex_ind")) {
    note(sentence::of("took the list {} of {} for its vertices", quoted(list->name),
                      quoted(element.name)));
  }
  const std::uint64_t corners =
      std::min(3 * element.count, source_.room(list->type, element.count, *list->length_type));
  out_.reserve(0, static_cast<std::size_t>(corners));
  const auto texture =
      std::find_if(element.properties.begin(), element.properties.end(), &is_texture_list);
  // Behind the faces of strips, which come first, nothing would be where it belongs.
  const bool keeps = options_.attributes && out_.face_count() == 0;
  const bool has_texture = keeps && texture != element.properties.end();
  const std::array taken = {list, has_texture ? &*texture : list};
  if (!columns_.begin(element, SoupItem::kFace, taken, keeps)) out_.set_out_of_memory();
  if (has_texture) texture_ = columns_.add(texture_column(*texture));
  for (; row_ < element.count && !out_.out_of_memory(); ++row_) {
    out_.begin_face(source_.begin_row());
    out_.reached(source_.position());
    texture_begin_ = out_.corner_count();
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      const PlyProperty& property = element.properties[k];
      const bool ok = &property == list       ? read_corners(property)
                      : &property == taken[1] ? read_texture(property)
                                              : keep_or_skip(element, k);
      if (!ok) return false;
    }
    if (has_texture) end_texture();
  }
  return true;
}

/// Two numbers for each corner of a face, whose corners may come before or after.
template <class Source>
bool PlyReader<Source>::read_texture(const PlyProperty& list) {
  std::int64_t length = 0;
  if (!read_length(list, length)) return false;
  Array<std::byte>& values = columns_.column(*texture_).values;
  const std::size_t size = size_of(list.type);
  const std::size_t begin = 2 * size * texture_begin_;
  const std::size_t end = begin + size * static_cast<std::size_t>(length);
  if (end > values.capacity() && !values.reserve(end + end / 2) && !values.reserve(end)) {
    out_.set_out_of_memory();
    return true;
  }
  (void)values.resize(begin, std::byte{});  // there is room for both
  (void)values.resize(end);
  for (std::size_t at = begin; at < end; at += size) {
    if (source_.read(list.type, &values[at])) continue;
    return fail(source_.unexpected(
        sentence::of("the texture coordinates of face {}", out_.face_count()), list.type));
  }
  return true;
}

/// Gives each corner of the face a row, also where the list was too long or too short.
template <class Source>
void PlyReader<Source>::end_texture() {
  SoupAttribute& column = columns_.column(*texture_);
  const std::size_t end = column.stride() * out_.corner_count();
  wrong_textures_ += column.values.size() != end ? 1U : 0U;
  if (!column.values.resize(end, std::byte{})) out_.set_out_of_memory();
}

template <class Source>
bool PlyReader<Source>::read_corners(const PlyProperty& list) {
  std::int64_t degree = 0;
  if (!read_length(list, degree)) return false;
  if constexpr (!std::is_same_v<Source, PlyText>) {
    // A triangle of 32-bit indices, as nearly all are. Negative ones are too large without a sign.
    if (degree == 3 && (list.type == PlyType::kInt32 || list.type == PlyType::kUint32)) {
      const std::uint8_t* const at = source_.bytes().position();
      const ByteOrder order = source_.bytes().order();
      const Index a = load<Index>(at, order);
      const Index b = load<Index>(at + 4, order);
      const Index c = load<Index>(at + 8, order);
      if (std::max({a, b, c}) < vertices_) {
        out_.add_triangle(a, b, c);
        source_.bytes().skip(12);
        return true;
      }
    }
  }
  for (std::int64_t corner = 0; corner < degree; ++corner) {
    if (!read_corner(list, static_cast<std::size_t>(corner), degree)) return false;
  }
  out_.end_face();
  return true;
}

template <class Source>
bool PlyReader<Source>::read_corner(const PlyProperty& list, std::size_t corner,
                                    std::int64_t degree) {
  const auto start = source_.mark();
  std::int64_t vertex = 0;
  if (!source_.read(list.type, vertex)) {
    return fail(source_.unexpected(
        sentence::of("vertex {} of the {} of face {}", corner + 1, degree, out_.face_count()),
        list.type));
  }
  const bool exists = vertex >= 0 && static_cast<std::uint64_t>(vertex) < vertices_;
  if (exists || options_.for_repair) {
    const auto spell = [&] { return source_.number_at(start, list.type); };
    out_.add_corner(exists ? static_cast<Index>(vertex) : out_.missing_vertex(vertex, spell));
    return true;
  }
  source_.move_to(start);
  return fail(wrong_index(corner, list));
}

/// Triangle strips, as the Stanford models have them: each vertex makes a triangle with the two
/// before it, of alternating orientation; -1 starts a new strip. A triangle with a repeated vertex
/// only turns the strip.
template <class Source>
bool PlyReader<Source>::read_strips(const PlyElement& element) {
  const PlyProperty* const list = element.vertex_list();
  (void)columns_.begin(element, SoupItem::kFace, {&list, 1}, false);
  for (; row_ < element.count && !out_.out_of_memory(); ++row_) {
    source_.begin_row();
    out_.reached(source_.position());
    for (const PlyProperty& property : element.properties) {
      if (!(&property == list ? read_strip(property) : skip(element, property))) return false;
    }
  }
  return true;
}

template <class Source>
bool PlyReader<Source>::read_strip(const PlyProperty& list) {
  std::int64_t length = 0;
  if (!read_length(list, length)) return false;
  const auto exists = [this](std::int64_t vertex) {
    return vertex >= 0 && static_cast<std::uint64_t>(vertex) < vertices_;
  };
  std::array<std::int64_t, 2> before{};
  std::size_t in_strip = 0;
  for (std::int64_t i = 0; i < length; ++i) {
    const auto start = source_.mark();
    std::int64_t vertex = 0;
    if (!source_.read(list.type, vertex)) {
      return fail(source_.unexpected(
          sentence::of("value {} of the {} of the triangle strips", i + 1, length), list.type));
    }
    if (vertex == -1) {
      in_strip = 0;
      continue;
    }
    if (!exists(vertex) && !options_.for_repair) {
      source_.move_to(start);
      return fail(wrong_index(2, list));
    }
    const auto [a, b] = before;
    if (in_strip >= 2 && a != b && b != vertex && vertex != a) {
      for (const std::int64_t v : {in_strip % 2 == 0 ? a : b, in_strip % 2 == 0 ? b : a, vertex}) {
        out_.add_corner(exists(v) ? static_cast<Index>(v) : out_.missing_vertex(v));
      }
      out_.end_face();
    }
    before = {b, vertex};
    ++in_strip;
  }
  return true;
}

template <class Source>
Error PlyReader<Source>::wrong_index(std::size_t corner, const PlyProperty& list) const {
  Error error = source_.index_error(corner, out_.face_count(), list.type);
  error.message += vertices_ == 0 ? ", but the file has no vertices"
                                  : sentence::of(", expected a vertex from 0 to {}", vertices_ - 1);
  return error;
}

}  // namespace halfedge::io
