#include <halfedge/io/copy_numbers.h>
#include <halfedge/io/ply_columns.h>
#include <halfedge/io/ply_header.h>
#include <halfedge/io/ply_source.h>
#include <halfedge/io/readers.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace halfedge {
namespace io {
namespace {

template <class T>
std::uint8_t* bytes_at(T* value) {
  return reinterpret_cast<std::uint8_t*>(value);
}

/// Reads the rows that a header announces. Source is PlyText or PlyBinary.
template <class Source>
class PlyReader {
 public:
  PlyReader(const PlyHeader& header, Source source, const Request& request)
      : header_(header),
        source_(std::move(source)),
        options_(request.options),
        out_(request.wanted),
        vertices_(header.find("vertex")->count) {}

  [[nodiscard]] std::optional<Error> read();
  [[nodiscard]] SoupWriter& out() { return out_; }
  [[nodiscard]] std::vector<std::string> notes();
  [[nodiscard]] std::vector<SoupAttribute>& columns() { return columns_; }

 private:
  [[nodiscard]] bool read_vertices(const PlyElement& element);
  [[nodiscard]] bool read_packed_vertices(const PlyElement& element);
  [[nodiscard]] bool read_faces(const PlyElement& element);
  [[nodiscard]] bool read_corners(const PlyProperty& list);
  [[nodiscard]] bool read_corner(const PlyProperty& list, std::size_t corner, std::int64_t degree);
  [[nodiscard]] bool read_strips(const PlyElement& element);
  [[nodiscard]] bool read_strip(const PlyProperty& list);
  [[nodiscard]] bool read_length(const PlyProperty& list, std::int64_t& length);
  [[nodiscard]] bool read_texture(const PlyProperty& list);
  void end_texture();
  [[nodiscard]] bool skip(const PlyElement& element, const PlyProperty& property);
  [[nodiscard]] bool keep_or_skip(const PlyElement& element, std::size_t property);
  [[nodiscard]] bool skip_rows(const PlyElement& element);

  /// Decides which properties become attributes, and makes room for so many more rows.
  void choose(const PlyElement& element, SoupItem item, std::span<const PlyProperty* const> taken,
              std::size_t rows_before);
  void note_unread(const PlyElement& element, std::span<const PlyProperty* const> read);
  [[nodiscard]] std::string in_row(const PlyElement& element) const {
    return " of " + quoted(element.name) + " " + std::to_string(row_) + " of " +
           std::to_string(element.count);
  }
  [[nodiscard]] Error wrong_index(std::size_t corner, std::int64_t vertex) const;
  [[nodiscard]] bool fail(Error error) {
    error_ = std::move(error);
    return false;
  }

  const PlyHeader& header_;
  Source source_;
  ParseOptions options_;
  SoupWriter out_;
  std::uint64_t vertices_;
  std::uint64_t row_ = 0;
  std::vector<SoupAttribute> columns_;
  std::vector<PlyTarget> targets_;      // by property of the element that is read
  std::size_t rows_before_ = 0;         // of the columns that it fills
  std::optional<std::size_t> texture_;  // the column of the corners
  std::size_t texture_begin_ = 0;       // the first corner of the face that is read
  std::size_t wrong_textures_ = 0;
  Error error_;
  std::vector<std::string> notes_;
};

template <class Source>
std::optional<Error> PlyReader<Source>::read() {
  for (const PlyElement& element : header_.elements) {
    row_ = 0;
    bool ok = true;
    if (element.name == "vertex") {
      ok = read_vertices(element);
    } else if (element.name == "face") {
      ok = read_faces(element);
    } else if (element.name == "tristrips" && element.vertex_list() != nullptr) {
      ok = read_strips(element);
    } else {
      ok = skip_rows(element);
    }
    if (!ok) return error_;
    if (out_.out_of_memory()) break;
  }
  // Faces made of strips have no values.
  for (SoupAttribute& column : columns_) {
    if (column.item == SoupItem::kVertex) continue;
    const bool of_faces = column.item == SoupItem::kFace;
    const std::size_t rows = of_faces ? out_.face_count() : out_.corner_count();
    if (!column.values.resize(rows * column.stride(), std::byte{})) out_.set_out_of_memory();
  }
  return check_size(out_);
}

template <class Source>
void PlyReader<Source>::choose(const PlyElement& element, SoupItem item,
                               std::span<const PlyProperty* const> taken, std::size_t rows_before) {
  targets_.assign(element.properties.size(), {});
  rows_before_ = rows_before;
  if (options_.attributes) targets_ = choose_columns(element, item, taken, columns_);
  note_unread(element, taken);
  for (SoupAttribute& column : columns_) {
    if (column.item != item) continue;
    const std::size_t rows = rows_before + static_cast<std::size_t>(element.count);
    if (!column.values.resize(rows * column.stride(), std::byte{})) out_.set_out_of_memory();
  }
}

/// Reads a value into its column, if it has one. pre: the property is none that is taken
template <class Source>
bool PlyReader<Source>::keep_or_skip(const PlyElement& element, std::size_t property) {
  const PlyTarget& target = targets_[property];
  const PlyProperty& what = element.properties[property];
  if (target.column == PlyTarget::kNowhere) return skip(element, what);
  SoupAttribute& column = columns_[target.column];
  const std::size_t row = rows_before_ + static_cast<std::size_t>(row_);
  if (source_.read(what.type, &column.values[row * column.stride() + target.offset])) return true;
  return fail(source_.unexpected("a number for " + quoted(what.name) + in_row(element)));
}

template <class Source>
bool PlyReader<Source>::read_vertices(const PlyElement& element) {
  const std::array axes = {element.find("x"), element.find("y"), element.find("z")};
  choose(element, SoupItem::kVertex, axes, 0);
  if (std::any_of(axes.begin(), axes.end(),
                  [](const PlyProperty* axis) { return axis->type == PlyType::kFloat64; })) {
    notes_.push_back("read the positions of " + std::to_string(element.count) +
                     (element.count == 1 ? " vertex" : " vertices") + ", doubles, as floats");
  }
  out_.reserve(static_cast<std::size_t>(element.count), 0);
  if (out_.out_of_memory()) return true;
  if constexpr (!std::is_same_v<Source, PlyText>) {
    if (read_packed_vertices(element)) return true;
  }
  for (; row_ < element.count && !out_.out_of_memory(); ++row_) {
    source_.begin_row();
    out_.reached(source_.position());
    std::array<float, 3> p{};
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      const PlyProperty& property = element.properties[k];
      const auto axis = std::find(axes.begin(), axes.end(), &property);
      if (axis == axes.end()) {
        if (!keep_or_skip(element, k)) return false;
        continue;
      }
      const auto i = static_cast<std::size_t>(axis - axes.begin());
      if (source_.read(property.type, p[i])) continue;
      return fail(source_.unexpected(std::string("a number for ") + "xyz"[i] + in_row(element)));
    }
    out_.add_vertex(p[0], p[1], p[2]);
  }
  return true;
}

/// Nearly all binary files have floats x, y, z and rows of the same size. False, without moving, if
/// this one is another.
template <class Source>
bool PlyReader<Source>::read_packed_vertices(const PlyElement& element) {
  std::size_t size = 0;
  for (const PlyProperty& property : element.properties) {
    const bool is_axis = property.name == "x" || property.name == "y" || property.name == "z";
    if (property.length_type || (is_axis && property.type != PlyType::kFloat32)) return false;
    size += size_of(property.type);
  }
  ByteScanner& bytes = source_.bytes();
  if (element.count > bytes.left() / size) return false;
  const auto count = static_cast<std::size_t>(element.count);
  float* const positions = out_.add_vertices(count);
  if (positions == nullptr) return true;

  struct Piece {
    std::size_t from;
    std::size_t size;
    Numbers<std::uint8_t> to;
  };
  std::vector<Piece> pieces;
  std::size_t at = 0;
  for (std::size_t k = 0; k < element.properties.size(); ++k) {
    const PlyProperty& property = element.properties[k];
    const PlyTarget& target = targets_[k];
    const std::size_t axis = std::string_view("xyz").find(property.name);
    if (target.column != PlyTarget::kNowhere) {
      SoupAttribute& column = columns_[target.column];
      std::byte* const to = column.values.data() + target.offset;
      pieces.push_back({at, size_of(property.type), {bytes_at(to), column.stride()}});
    } else if (property.name.size() == 1 && element.find(property.name) == &property && axis < 3) {
      pieces.push_back({at, sizeof(float), {bytes_at(positions + axis), 3 * sizeof(float)}});
    }
    at += size_of(property.type);
  }
  // So many rows at a time that they stay in the nearest cache from piece to piece.
  constexpr std::size_t kRows = 256;
  for (std::size_t row = 0; row < count; row += kRows) {
    const std::size_t rows = std::min(kRows, count - row);
    for (Piece& piece : pieces) {
      copy_numbers({bytes.position() + piece.from, size}, piece.to, rows, piece.size,
                   Source::kIsReversed);
      piece.to.first += rows * piece.to.stride;
    }
    bytes.skip(rows * size);
    out_.reached(bytes.position());
    if (out_.out_of_memory()) break;
  }
  return true;
}

template <class Source>
bool PlyReader<Source>::read_faces(const PlyElement& element) {
  const PlyProperty* const list = element.vertex_list();
  if (list == nullptr) return true;  // and no faces: the header was checked
  const std::uint64_t corners =
      std::min(3 * element.count, source_.room(list->type, element.count, *list->length_type));
  out_.reserve(0, static_cast<std::size_t>(corners));
  const auto texture =
      std::find_if(element.properties.begin(), element.properties.end(), &is_texture_list);
  const bool has_texture = options_.attributes && texture != element.properties.end();
  const std::array taken = {list, has_texture ? &*texture : list};
  choose(element, SoupItem::kFace, taken, out_.face_count());
  if (has_texture) {
    texture_ = columns_.size();
    columns_.push_back(texture_column(*texture));
  }
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
  Array<std::byte>& values = columns_[*texture_].values;
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
    return fail(
        source_.unexpected("the texture coordinates of face " + std::to_string(out_.face_count())));
  }
  return true;
}

/// Gives each corner of the face a row, also where the list was too long or too short.
template <class Source>
void PlyReader<Source>::end_texture() {
  SoupAttribute& column = columns_[*texture_];
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
    constexpr ByteOrder kOrder = Source::kByteOrder;
    if (degree == 3 && (list.type == PlyType::kInt32 || list.type == PlyType::kUint32)) {
      const std::uint8_t* const at = source_.bytes().position();
      const Index a = load<Index, kOrder>(at);
      const Index b = load<Index, kOrder>(at + 4);
      const Index c = load<Index, kOrder>(at + 8);
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
    return fail(source_.unexpected("vertex " + std::to_string(corner + 1) + " of the " +
                                   std::to_string(degree) + " of face " +
                                   std::to_string(out_.face_count())));
  }
  const bool exists = vertex >= 0 && static_cast<std::uint64_t>(vertex) < vertices_;
  if (exists || options_.for_repair) {
    out_.add_corner(exists ? static_cast<Index>(vertex) : missing_vertex(vertex));
    return true;
  }
  source_.move_to(start);
  return fail(wrong_index(corner, vertex));
}

/// Triangle strips, as the Stanford models have them: each vertex makes a triangle with the two
/// before it, of alternating orientation; -1 starts a new strip. A triangle with a repeated vertex
/// only turns the strip.
template <class Source>
bool PlyReader<Source>::read_strips(const PlyElement& element) {
  const PlyProperty* const list = element.vertex_list();
  targets_.clear();
  note_unread(element, {&list, 1});
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
  std::array<Index, 2> before{};
  std::size_t in_strip = 0;
  for (std::int64_t i = 0; i < length; ++i) {
    const auto start = source_.mark();
    std::int64_t vertex = 0;
    if (!source_.read(list.type, vertex)) {
      return fail(source_.unexpected("value " + std::to_string(i + 1) + " of the " +
                                     std::to_string(length) + " of the triangle strips"));
    }
    if (vertex == -1) {
      in_strip = 0;
      continue;
    }
    const bool exists = vertex >= 0 && static_cast<std::uint64_t>(vertex) < vertices_;
    if (!exists && !options_.for_repair) {
      source_.move_to(start);
      return fail(wrong_index(2, vertex));
    }
    const Index c = exists ? static_cast<Index>(vertex) : missing_vertex(vertex);
    const auto [a, b] = before;
    if (in_strip >= 2 && a != b && b != c && c != a) {
      in_strip % 2 == 0 ? out_.add_triangle(a, b, c) : out_.add_triangle(b, a, c);
    }
    before = {b, c};
    ++in_strip;
  }
  return true;
}

template <class Source>
bool PlyReader<Source>::read_length(const PlyProperty& list, std::int64_t& length) {
  const auto start = source_.mark();
  const auto expected = [&] {
    return "the length of the list " + quoted(list.name) + " of row " + std::to_string(row_);
  };
  if (!source_.read(*list.length_type, length)) return fail(source_.unexpected(expected()));
  if (length < 0) {
    source_.move_to(start);
    return fail(source_.error(
        "parse-error", expected() + " is " + std::to_string(length) + ", expected 0 or more"));
  }
  if (static_cast<std::uint64_t>(length) <= source_.room(list.type)) return true;
  source_.move_to(start);
  return fail(source_.error("truncated", expected() + " is " + std::to_string(length) +
                                             ", more than the rest of the file can hold"));
}

template <class Source>
bool PlyReader<Source>::skip(const PlyElement& element, const PlyProperty& property) {
  std::int64_t count = 1;
  if (property.length_type && !read_length(property, count)) return false;
  if (source_.skip(property.type, static_cast<std::uint64_t>(count))) return true;
  return fail(source_.unexpected("the value of " + quoted(property.name) + in_row(element)));
}

template <class Source>
bool PlyReader<Source>::skip_rows(const PlyElement& element) {
  if (element.count > 0) {
    notes_.push_back("ignored the " + std::to_string(element.count) + " elements " +
                     quoted(element.name));
  }
  if (element.properties.empty()) return true;
  for (; row_ < element.count && !out_.out_of_memory(); ++row_) {
    source_.begin_row();
    out_.reached(source_.position());
    for (const PlyProperty& property : element.properties) {
      if (!skip(element, property)) return false;
    }
  }
  return true;
}

template <class Source>
Error PlyReader<Source>::wrong_index(std::size_t corner, std::int64_t vertex) const {
  Error error = source_.index_error(corner, out_.face_count(), vertex);
  error.message += vertices_ == 0
                       ? ", but the file has no vertices"
                       : ", expected a vertex from 0 to " + std::to_string(vertices_ - 1);
  return error;
}

/// Says which properties of an element nobody reads: the first few by name.
template <class Source>
void PlyReader<Source>::note_unread(const PlyElement& element,
                                    std::span<const PlyProperty* const> read) {
  constexpr std::size_t kNamed = 8;
  std::string names;
  std::size_t count = 0;
  for (const PlyProperty& property : element.properties) {
    const auto k = static_cast<std::size_t>(&property - element.properties.data());
    if (k < targets_.size() && targets_[k].column != PlyTarget::kNowhere) continue;
    if (std::find(read.begin(), read.end(), &property) != read.end()) continue;
    if (count++ < kNamed) names += (count == 1 ? "" : ", ") + quoted(property.name);
  }
  if (count == 0 || element.count == 0) return;
  if (count > kNamed) names += " and " + std::to_string(count - kNamed) + " more";
  notes_.push_back((count == 1 ? "ignored the property " : "ignored the properties ") + names +
                   " of " + quoted(element.name));
}

template <class Source>
std::vector<std::string> PlyReader<Source>::notes() {
  if (wrong_textures_ > 0) {
    notes_.push_back("the list \"texcoord\" of " + std::to_string(wrong_textures_) +
                     (wrong_textures_ == 1 ? " face" : " faces") +
                     " has not two numbers for each corner: what is missing is 0");
  }
  if (std::string rest = source_.rest(); !rest.empty()) notes_.push_back(std::move(rest));
  return std::move(notes_);
}

template <class Source>
Result<ParsedFile> read_rows(std::span<const std::uint8_t> bytes, const PlyHeader& header,
                             Source source, const Request& request) {
  PlyReader<Source> reader(header, std::move(source), request);
  reader.out().follow(bytes, request.options.progress);
  if (std::optional<Error> error = reader.read()) return *std::move(error);
  const bool binary = header.encoding != PlyEncoding::kText;
  return ParsedFile{Format::kPly, std::move(reader.out().soup()), reader.notes(), binary,
                    std::move(reader.columns())};
}

}  // namespace

Result<ParsedFile> read_ply(std::span<const std::uint8_t> bytes, const Request& request) {
  const Result<PlyHeader> header = read_ply_header(bytes);
  if (!header) return header.error();
  const std::size_t start = header.value().size;
  switch (header.value().encoding) {
    case PlyEncoding::kText:
      return read_rows(bytes, header.value(), PlyText(bytes, start), request);
    case PlyEncoding::kLittleEndian:
      return read_rows(bytes, header.value(), PlyBinary<ByteOrder::kLittle>(bytes, start), request);
    case PlyEncoding::kBigEndian:
      return read_rows(bytes, header.value(), PlyBinary<ByteOrder::kBig>(bytes, start), request);
  }
  return Error{"parse-error", "the encoding of the file does not exist"};
}

}  // namespace io

Result<ParsedFile> read_ply(std::span<const std::uint8_t> bytes, const ParseOptions& options) {
  return io::read_ply(bytes, {options});
}

}  // namespace halfedge
