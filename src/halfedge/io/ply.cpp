#include <halfedge/io/ply_header.h>
#include <halfedge/io/ply_source.h>
#include <halfedge/io/readers.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace halfedge {
namespace io {
namespace {

/// Reads the rows that a header announces. Source is PlyText or PlyBinary.
template <class Source>
class PlyReader {
 public:
  PlyReader(const PlyHeader& header, Source source, FacePositions* wanted)
      : header_(header),
        source_(std::move(source)),
        out_(wanted),
        vertices_(header.find("vertex")->count) {}

  [[nodiscard]] std::optional<Error> read();
  [[nodiscard]] SoupWriter& out() { return out_; }
  [[nodiscard]] std::vector<std::string> notes();

 private:
  [[nodiscard]] bool read_vertices(const PlyElement& element);
  [[nodiscard]] bool read_packed_vertices(const PlyElement& element);
  [[nodiscard]] bool read_faces(const PlyElement& element);
  [[nodiscard]] bool read_corners(const PlyProperty& list);
  [[nodiscard]] bool read_corner(const PlyProperty& list, std::size_t corner, std::int64_t degree);
  [[nodiscard]] bool read_strips(const PlyElement& element);
  [[nodiscard]] bool read_strip(const PlyProperty& list);
  [[nodiscard]] bool read_length(const PlyProperty& list, std::int64_t& length);
  [[nodiscard]] bool skip(const PlyElement& element, const PlyProperty& property);
  [[nodiscard]] bool skip_rows(const PlyElement& element);

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
  SoupWriter out_;
  std::uint64_t vertices_;
  std::uint64_t row_ = 0;
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
  return check_size(out_);
}

template <class Source>
bool PlyReader<Source>::read_vertices(const PlyElement& element) {
  const std::array axes = {element.find("x"), element.find("y"), element.find("z")};
  note_unread(element, axes);
  out_.reserve(static_cast<std::size_t>(element.count), 0);
  if constexpr (!std::is_same_v<Source, PlyText>) {
    if (read_packed_vertices(element)) return true;
  }
  for (; row_ < element.count && !out_.out_of_memory(); ++row_) {
    source_.begin_row();
    std::array<float, 3> p{};
    for (const PlyProperty& property : element.properties) {
      const auto axis = std::find(axes.begin(), axes.end(), &property);
      if (axis == axes.end()) {
        if (!skip(element, property)) return false;
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
  constexpr ByteOrder kOrder = Source::kByteOrder;
  std::size_t x = 0;
  std::size_t y = 0;
  std::size_t z = 0;
  std::size_t size = 0;
  for (const PlyProperty& property : element.properties) {
    if (property.length_type) return false;
    for (const auto& [axis, offset] : {std::pair{"x", &x}, {"y", &y}, {"z", &z}}) {
      if (&property != element.find(axis)) continue;
      if (property.type != PlyType::kFloat32) return false;
      *offset = size;
    }
    size += size_of(property.type);
  }
  ByteScanner& bytes = source_.bytes();
  if (element.count > bytes.left() / size) return false;
  for (std::uint64_t i = 0; i < element.count; ++i) {
    const std::uint8_t* const row = bytes.position();
    out_.add_vertex(load<float, kOrder>(row + x), load<float, kOrder>(row + y),
                    load<float, kOrder>(row + z));
    bytes.skip(size);
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
  note_unread(element, {&list, 1});
  for (; row_ < element.count && !out_.out_of_memory(); ++row_) {
    out_.begin_face(source_.begin_row());
    for (const PlyProperty& property : element.properties) {
      if (!(&property == list ? read_corners(property) : skip(element, property))) return false;
    }
  }
  return true;
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
  if (vertex >= 0 && static_cast<std::uint64_t>(vertex) < vertices_) {
    out_.add_corner(static_cast<Index>(vertex));
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
  note_unread(element, {&list, 1});
  for (; row_ < element.count && !out_.out_of_memory(); ++row_) {
    source_.begin_row();
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
    if (vertex < 0 || static_cast<std::uint64_t>(vertex) >= vertices_) {
      source_.move_to(start);
      return fail(wrong_index(2, vertex));
    }
    const auto c = static_cast<Index>(vertex);
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
  for (; row_ < element.count; ++row_) {
    source_.begin_row();
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
  if (std::string rest = source_.rest(); !rest.empty()) notes_.push_back(std::move(rest));
  return std::move(notes_);
}

template <class Source>
Result<ParsedFile> read_rows(const PlyHeader& header, Source source, FacePositions* wanted) {
  PlyReader<Source> reader(header, std::move(source), wanted);
  if (std::optional<Error> error = reader.read()) return *std::move(error);
  const bool binary = header.encoding != PlyEncoding::kText;
  return ParsedFile{Format::kPly, std::move(reader.out().soup()), reader.notes(), binary};
}

}  // namespace

Result<ParsedFile> read_ply(std::span<const std::uint8_t> bytes, FacePositions* wanted) {
  const Result<PlyHeader> header = read_ply_header(bytes);
  if (!header) return header.error();
  const std::size_t start = header.value().size;
  switch (header.value().encoding) {
    case PlyEncoding::kText:
      return read_rows(header.value(), PlyText(bytes, start), wanted);
    case PlyEncoding::kLittleEndian:
      return read_rows(header.value(), PlyBinary<ByteOrder::kLittle>(bytes, start), wanted);
    case PlyEncoding::kBigEndian:
      return read_rows(header.value(), PlyBinary<ByteOrder::kBig>(bytes, start), wanted);
  }
  return Error{"parse-error", "the encoding of the file does not exist"};
}

}  // namespace io

Result<ParsedFile> read_ply(std::span<const std::uint8_t> bytes) {
  return io::read_ply(bytes, nullptr);
}

}  // namespace halfedge
