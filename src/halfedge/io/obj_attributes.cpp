#include <halfedge/io/obj_attributes.h>
#include <halfedge/sentence.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <utility>

namespace halfedge::io {
namespace {

/// Tables of names take more memory than the text of short ones.
constexpr std::size_t kMostNames = 1 << 16;

/// The rest of the line, without the blanks around it, up to a comment: a # within a word belongs
/// to it, as in steel#2, and so does a backslash at the end, as to the path of a folder.
std::string_view read_rest(TextScanner& text) {
  const std::string_view rest = text.rest();
  std::size_t begin = 0;
  while (begin < rest.size() && class_of(rest[begin]) == CharClass::kBlank) ++begin;
  std::size_t end = begin;
  for (std::size_t i = begin; i < rest.size(); ++i) {
    const CharClass c = class_of(rest[i]);
    const bool starts_word = end != i || i == begin;
    if (c == CharClass::kNewline || (c == CharClass::kComment && starts_word)) break;
    if (c != CharClass::kBlank) end = i + 1;
  }
  return rest.substr(begin, end - begin);
}

std::size_t read_floats(TextScanner& text, std::span<float> values) {
  std::size_t count = 0;
  for (text.skip_blanks(); count < values.size() && !text.at_line_end(); text.skip_blanks()) {
    if (!text.read_float(values[count])) break;
    ++count;
  }
  return count;
}

SoupAttribute column_of(const char* name, SoupItem item, Scalar type, Index components) {
  SoupAttribute column;
  column.name = name;
  column.item = item;
  column.type = type;
  column.components = components;
  column.on_split = type == Scalar::kInt32 ? OnSplit::kCopy : OnSplit::kInterpolate;
  if (column.name == "normal") column.on_split = OnSplit::kNormalize;
  return column;
}

template <class T>
bool set_values(SoupAttribute& column, std::span<const T> values) {
  return column.values.assign(std::as_bytes(values));
}

/// Whether colours are whole numbers from 0 to 255, as some programs write them, not from 0 to 1.
bool are_bytes(std::span<const float> colors) {
  const auto is_byte = [](float value) {
    return value >= 0 && value <= 255 && value == std::floor(value);
  };
  return std::all_of(colors.begin(), colors.end(), is_byte) &&
         std::any_of(colors.begin(), colors.end(), [](float value) { return value > 1; });
}

/// An alpha of 1 is that of a colour without one.
bool set_bytes(SoupAttribute& column, std::span<const float> colors) {
  if (!column.values.resize(colors.size())) return false;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const bool is_full = column.components == 4 && i % 4 == 3 && colors[i] == 1;
    column.values[i] = static_cast<std::byte>(is_full ? 255 : colors[i]);
  }
  return true;
}

/// Gives the faces of each run, up to the next one, the number of its id.
template <class Run, class NumberOf>
void set_runs(SoupAttribute& column, std::span<const Run> runs, std::size_t faces,
              const NumberOf& number_of) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::size_t end = i + 1 < runs.size() ? runs[i + 1].first_face : faces;
    const std::int32_t value = number_of(runs[i].id);
    for (std::size_t f = runs[i].first_face; f < end; ++f) {
      std::memcpy(&column.values[sizeof(value) * f], &value, sizeof(value));
    }
  }
}

/// Whether the name is a number as the writer spells it.
bool read_number(std::string_view name, std::int32_t& number) {
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  return error == std::errc() && end == name.data() + name.size() && std::to_string(number) == name;
}

}  // namespace

bool ObjAttributes::read_row(TextScanner& text, std::size_t width, Table& table) {
  float row[3] = {};
  const std::size_t count = read_floats(text, row);
  // A texture coordinate may have one number alone.
  const std::size_t fewest = width == 3 ? 3 : 1;
  malformed_ += count < fewest || !text.at_line_end() ? 1U : 0U;
  depths_ += width == 2 && row[2] != 0 ? 1U : 0U;
  for (std::size_t i = 0; i < width; ++i) {
    if (!table.values.push_back(row[i])) return false;
  }
  return true;
}

bool ObjAttributes::read_color(TextScanner& text, std::size_t vertex) {
  float color[4] = {0, 0, 0, 1};
  const std::size_t count = read_floats(text, color);
  extra_ += count == 2 || !text.at_line_end() ? 1U : 0U;
  if (count < 3) {
    weights_ += count == 1 && color[0] != 1 ? 1U : 0U;
    return true;
  }
  if (color_width_ == 0) color_width_ = count;
  if (count > color_width_ && !widen_colors()) return false;
  while (colors_.size() < color_width_ * vertex) {
    if (!colors_.push_back(0)) return false;
  }
  for (std::size_t i = 0; i < color_width_; ++i) {
    if (!colors_.push_back(color[i])) return false;
  }
  return true;
}

/// An alpha of 1 for the colours so far.
bool ObjAttributes::widen_colors() {
  const std::size_t rows = colors_.size() / 3;
  if (!colors_.resize(4 * rows)) return false;
  for (std::size_t i = rows; i-- > 0;) {
    const float row[4] = {colors_[3 * i], colors_[3 * i + 1], colors_[3 * i + 2], 1};
    std::copy_n(row, 4, &colors_[4 * i]);
  }
  color_width_ = 4;
  return true;
}

bool ObjAttributes::read_smoothing(TextScanner& text, std::size_t face) {
  text.skip_blanks();
  std::int64_t group = 0;
  const bool is_number = text.read_integer(group) && text.at_token_end();
  if (!is_number && text.token() != "off") ++strange_;
  if (!is_number || group < INT32_MIN || group > INT32_MAX) {
    strange_ += is_number ? 1U : 0U;
    group = 0;
  }
  is_smooth_ |= group != 0;
  return smoothing_.push_back({face, static_cast<Index>(group)});
}

bool ObjAttributes::add_corner(std::size_t corner, const Corner& references) {
  return refer(textures_, 2, corner, references.texture) &&
         refer(normals_, 3, corner, references.normal);
}

/// What is referred to may be declared further down: compared with their number at the end.
bool ObjAttributes::refer(Table& table, std::size_t width, std::size_t corner,
                          std::int64_t reference) {
  if (reference == 0) return true;
  const auto count = static_cast<std::int64_t>(table.values.size() / width);
  const std::int64_t row = reference > 0 ? reference - 1 : count + reference;
  while (table.rows.size() < corner) {
    if (!table.rows.push_back(kNone)) return false;
  }
  return table.rows.push_back(row < 0 || row > kMaxSlots ? kMaxSlots : static_cast<Index>(row));
}

bool ObjAttributes::read_name(TextScanner& text, Name kind, std::size_t face) {
  Names& names = names_[static_cast<std::size_t>(kind)];
  const std::string_view name = read_rest(text);
  Index id = 0;  // of no name
  if (!name.empty() && !(kind == Name::kMaterial && name == kNoMaterial)) {
    const auto known = names.ids.find(name);
    if (known != names.ids.end()) {
      id = known->second;
    } else if (names.in_order.size() < kMostNames) {
      names.in_order.push_back(name);
      id = static_cast<Index>(names.in_order.size());
      names.ids.emplace(name, id);
    } else {
      names.is_cut = true;
    }
  }
  return names.runs.push_back({face, id});
}

void ObjAttributes::read_library(TextScanner& text) {
  if (libraries_.size() < kMostNames) libraries_.emplace_back(read_rest(text));
}

bool ObjAttributes::finish(std::size_t vertices, std::size_t faces, ParsedFile& file) {
  if (!finish_table(textures_, "uv", 2, file) || !finish_table(normals_, "normal", 3, file) ||
      !finish_colors(vertices, file)) {
    return false;
  }
  constexpr const char* kNames[] = {"group", "object", "material"};
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (!finish_names(names_[i], kNames[i], faces, file)) return false;
  }
  if (!finish_smoothing(faces, file)) return false;
  if (!libraries_.empty()) file.names.push_back({"library", std::move(libraries_)});
  if (unknown_ > 0) {
    file.notes.push_back(
        sentence::of("{}{} that the file doesn't have: what is missing is 0", unknown_,
                     unknown_ == 1 ? " corner has a texture coordinate or normal"
                                   : " corners have texture coordinates or normals"));
  }
  if (malformed_ > 0) {
    file.notes.push_back(
        sentence::of("{}{} not the numbers expected: what is missing is 0", malformed_,
                     malformed_ == 1 ? " texture coordinate or normal (vt, vn) has"
                                     : " texture coordinates or normals (vt, vn) have"));
  }
  note_losses(file);
  return true;
}

void ObjAttributes::note_losses(ParsedFile& file) const {
  const auto note = [&file](std::size_t count, const char* one, const char* many) {
    if (count == 0) return;
    file.notes.push_back(sentence::of("ignored {} {}", count, count == 1 ? one : many));
  };
  note(depths_, "third texture coordinate that is not 0",
       "third texture coordinates that are not 0");
  note(extra_, "end of the line of a vertex that is neither weight nor colour",
       "ends of lines of vertices that are neither weights nor colours");
  note(weights_, "weight of a vertex", "weights of vertices");
  note(unused_[0], "texture coordinate (vt) to which no face refers",
       "texture coordinates (vt) to which no face refers");
  note(unused_[1], "normal (vn) to which no face refers", "normals (vn) to which no face refers");
  note(strange_, "smoothing group (s) that is neither an integer of 32 bits, signed, nor off",
       "smoothing groups (s) that are neither integers of 32 bits, signed, nor off");
}

bool ObjAttributes::finish_table(Table& table, const char* name, Index width, ParsedFile& file) {
  const std::size_t count = table.values.size() / width;
  std::size_t& unused = unused_[width - 2];
  unused = count;
  if (table.rows.empty()) return true;
  Array<bool> is_used;
  if (!is_used.resize(count, false)) return false;
  for (Index& row : table.rows) {
    if (row < count) {
      unused -= is_used[row] ? 0U : 1U;
      is_used[row] = true;
    } else if (row != kNone) {
      row = kNone;
      ++unknown_;
    }
  }
  SoupAttribute& column =
      file.attributes.emplace_back(column_of(name, SoupItem::kCorner, Scalar::kFloat32, width));
  column.rows = std::move(table.rows);
  const bool fits = set_values(column, std::as_const(table.values).span());
  table.values.reset();
  return fits;
}

bool ObjAttributes::finish_colors(std::size_t vertices, ParsedFile& file) {
  if (color_width_ == 0) return true;
  if (!colors_.resize(color_width_ * vertices, 0)) return false;
  const std::span<const float> values = std::as_const(colors_).span();
  const bool bytes = are_bytes(values);
  SoupAttribute& column = file.attributes.emplace_back(
      column_of("color", SoupItem::kVertex, bytes ? Scalar::kUint8 : Scalar::kFloat32,
                static_cast<Index>(color_width_)));
  const bool fits = bytes ? set_bytes(column, values) : set_values(column, values);
  if (bytes) file.notes.emplace_back("read the colours of vertices as numbers from 0 to 255");
  colors_.reset();
  return fits;
}

/// Names that are all numbers, as the writer makes them up for a mesh without names, are the ids
/// themselves.
bool ObjAttributes::finish_names(Names& names, const char* name, std::size_t faces,
                                 ParsedFile& file) {
  if (names.in_order.empty()) return true;
  std::vector<std::int32_t> numbers = {0};
  for (const std::string_view spelt : names.in_order) {
    std::int32_t number = 0;
    if (!read_number(spelt, number)) break;
    numbers.push_back(number);
  }
  const bool are_numbers = numbers.size() == names.in_order.size() + 1;

  SoupAttribute& column =
      file.attributes.emplace_back(column_of(name, SoupItem::kFace, Scalar::kInt32, 1));
  if (!column.values.resize(sizeof(std::int32_t) * faces, std::byte{})) return false;
  set_runs(column, std::as_const(names.runs).span(), faces,
           [&](Index id) { return are_numbers ? numbers[id] : static_cast<std::int32_t>(id); });
  if (!are_numbers) {
    SoupNames& table = file.names.emplace_back();
    table.attribute = name;
    table.names.emplace_back();
    table.names.insert(table.names.end(), names.in_order.begin(), names.in_order.end());
  }
  if (names.is_cut) {
    file.notes.push_back(sentence::of(
        "the file has more than {} different names of a {}: faces of further ones have none",
        kMostNames, name));
  }
  return true;
}

bool ObjAttributes::finish_smoothing(std::size_t faces, ParsedFile& file) {
  if (!is_smooth_) return true;
  SoupAttribute& column =
      file.attributes.emplace_back(column_of("smoothing", SoupItem::kFace, Scalar::kInt32, 1));
  if (!column.values.resize(sizeof(std::int32_t) * faces, std::byte{})) return false;
  set_runs(column, std::as_const(smoothing_).span(), faces,
           [](Index id) { return static_cast<std::int32_t>(id); });
  return true;
}

}  // namespace halfedge::io
