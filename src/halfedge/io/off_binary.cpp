#include <halfedge/io/byte_scanner.h>
#include <halfedge/io/off_attributes.h>
#include <halfedge/io/off_binary.h>
#include <halfedge/io/soup_writer.h>
#include <halfedge/sentence.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

namespace halfedge::io {
namespace {

constexpr std::size_t kWord = 4;
constexpr std::size_t kCounts = 3 * kWord;  // vertices, faces, edges

std::size_t vertex_size(const OffHeader& header) {
  return kWord * static_cast<std::size_t>(header.columns);
}

/// Reads the counts into the header, and compares them with the size of the file.
std::optional<Error> read_counts(ByteScanner& bytes, OffHeader& header) {
  const std::size_t start = bytes.offset();
  if (bytes.left() < kCounts) {
    return error_at_byte(start, "truncated",
                         sentence::of("expected the numbers of vertices, faces and edges, found "
                                      "the end of the file in {}",
                                      sentence::count_of(bytes.left(), "byte")));
  }
  header.vertices = bytes.take<std::uint32_t>();
  header.faces = bytes.take<std::uint32_t>();
  bytes.skip(kWord);
  const std::uint64_t left = bytes.left();
  if (header.vertices <= left / vertex_size(header) &&
      header.faces <= (left - header.vertices * vertex_size(header)) / kWord) {
    return std::nullopt;
  }
  return error_at_byte(
      start, "truncated",
      sentence::of("the header promises {} and {}, but is followed by only {}",
                   sentence::count_of(header.vertices, "vertex"),
                   sentence::count_of(header.faces, "face"), sentence::count_of(left, "byte")));
}

/// How many faces can be walked over as they stand, and whether they end where the file does.
struct Fit {
  /// Three corners or more, all of them vertices, and no more than four numbers of a colour.
  std::uint64_t sound = 0;
  /// All others. Where there are colours, their lengths taken for faces are among these: so a file
  /// that was cut doesn't pass for a whole one without colours. Where all faces are odd (segments,
  /// say), the more the better.
  std::uint64_t odd = 0;
  bool exact = false;

  [[nodiscard]] bool better_than(const Fit& other) const {
    if (sound != other.sound) return sound > other.sound;
    if (odd != other.odd) return (odd < other.odd) == (sound > 0);
    return exact && !other.exact;
  }
};

/// pre: read_counts() found nothing wrong
Fit fit_of(ByteScanner bytes, const OffHeader& header, bool colours) {
  constexpr std::size_t kMaxComponents = 4;
  const auto read_length = [&bytes](std::size_t& length) {
    if (bytes.left() < kWord) return false;
    length = bytes.take<std::uint32_t>();
    return length <= bytes.left() / kWord;
  };
  bytes.skip(static_cast<std::size_t>(header.vertices) * vertex_size(header));
  Fit fit;
  for (std::uint64_t face = 0; face < header.faces; ++face) {
    std::size_t degree = 0;
    std::size_t components = 0;
    if (!read_length(degree)) return fit;
    bool sound = degree >= 3;
    for (std::size_t i = 0; i < degree; ++i) {
      sound = bytes.take<std::uint32_t>() < header.vertices && sound;
    }
    if (colours && !read_length(components)) return fit;
    bytes.skip(components * kWord);
    ++(sound && components <= kMaxComponents ? fit.sound : fit.odd);
  }
  fit.exact = bytes.left() == 0;
  return fit;
}

class BinaryReader {
 public:
  /// pre: read_counts() found nothing wrong
  BinaryReader(ByteScanner bytes, const OffHeader& header, bool colours, const Request& request)
      : bytes_(bytes),
        header_(header),
        colours_(colours),
        options_(request.options),
        out_(request.wanted) {
    out_.follow({bytes.position(), bytes.left()}, options_.progress);
  }

  [[nodiscard]] Result<ParsedFile> read();

 private:
  void read_vertex();
  [[nodiscard]] bool read_face();
  /// Reads how many words of a face follow. False, with an error, where there are not so many.
  [[nodiscard]] bool read_length(std::uint32_t& length, const char* what);
  [[nodiscard]] std::uint32_t take() { return bytes_.take<std::uint32_t>(); }

  ByteScanner bytes_;
  const OffHeader& header_;
  bool colours_;
  ParseOptions options_;
  SoupWriter out_;
  OffAttributes attributes_;
  Error error_;
};

Result<ParsedFile> BinaryReader::read() {
  out_.reserve(
      static_cast<std::size_t>(header_.vertices),
      static_cast<std::size_t>(std::min<std::uint64_t>(3 * header_.faces, bytes_.left() / kWord)));
  for (std::uint64_t i = 0; i < header_.vertices && !out_.out_of_memory(); ++i) read_vertex();
  for (std::uint64_t i = 0; i < header_.faces && !out_.out_of_memory(); ++i) {
    if (!read_face()) return error_;
  }
  if (std::optional<Error> error = check_size(out_)) return *std::move(error);
  const std::size_t vertices = out_.vertex_count();
  const std::size_t faces = out_.face_count();
  ParsedFile file{Format::kOff, std::move(out_.soup()), {}, true};
  if (!attributes_.finish(vertices, faces, file)) return no_memory_for_attributes();
  if (bytes_.left() > 0) {
    file.notes.push_back(sentence::of("ignored the {} behind the last face",
                                      sentence::count_of(bytes_.left(), "byte")));
  }
  return file;
}

void BinaryReader::read_vertex() {
  out_.reached(bytes_.position());
  out_.begin_vertex(bytes_.text());
  std::array<float, 4> p{0, 0, 0, 1};
  const auto coordinates = static_cast<std::size_t>(header_.coordinates);
  for (std::size_t i = 0; i < coordinates; ++i) p[i] = bytes_.take<float>();
  if (coordinates == 4) {
    for (std::size_t i = 0; i < 3; ++i) p[i] /= p[3];
  }
  std::array<float, 9> more{};
  const std::size_t count = static_cast<std::size_t>(header_.columns) - coordinates;
  for (std::size_t i = 0; i < count; ++i) more[i] = bytes_.take<float>();
  if (options_.attributes && count > 0) {
    attributes_.vertex_colors().see_floats();
    if (!attributes_.add_vertex(header_, out_.vertex_count(), {more.data(), count})) {
      out_.set_out_of_memory();
    }
  }
  out_.add_vertex(p[0], p[1], p[2]);
}

bool BinaryReader::read_face() {
  out_.reached(bytes_.position());
  out_.begin_face(bytes_.text());
  std::uint32_t degree = 0;
  if (!read_length(degree, "the number of vertices")) return false;
  for (std::uint32_t corner = 0; corner < degree; ++corner) {
    const std::size_t offset = bytes_.offset();
    const std::uint32_t vertex = take();
    if (vertex < header_.vertices || options_.for_repair) {
      const bool is_there = vertex < header_.vertices;
      out_.add_corner(is_there ? vertex : out_.missing_vertex(static_cast<std::int32_t>(vertex)));
      continue;
    }
    const std::size_t face = out_.face_count();
    error_ = error_at_byte(
        offset, "index-out-of-range",
        sentence::of("corner {} of face {} is {}{}", corner, face,
                     std::to_string(static_cast<std::int32_t>(vertex)),
                     (header_.vertices == 0 ? ", but the file has no vertices"
                                            : ", expected a vertex from 0 to " +
                                                  std::to_string(header_.vertices - 1))));
    error_.witness.faces = {static_cast<Index>(face)};
    return false;
  }
  std::uint32_t components = 0;
  if (colours_ && !read_length(components, "the number of colour components")) return false;
  if (options_.attributes && components > 0) {
    std::array<float, 4> color{};
    const std::size_t count = std::min<std::size_t>(components, color.size());
    ByteScanner ahead = bytes_;
    for (std::size_t i = 0; i < count; ++i) color[i] = ahead.take<float>();
    attributes_.face_colors().see_floats();
    if (!attributes_.add_face(out_.face_count(), {color.data(), count})) out_.set_out_of_memory();
  }
  bytes_.skip(components * kWord);
  out_.end_face();
  return true;
}

bool BinaryReader::read_length(std::uint32_t& length, const char* what) {
  const std::size_t offset = bytes_.offset();
  const auto name = [&] {
    return sentence::of("{} of face {} of {}", what, out_.face_count(), header_.faces);
  };
  if (bytes_.left() < kWord) {
    error_ = error_at_byte(offset, "truncated",
                           sentence::of("expected {}, found the end of the file", name()));
    return false;
  }
  length = take();
  if (length <= bytes_.left() / kWord) return true;
  error_ = error_at_byte(
      offset, "truncated",
      sentence::of("{} is {}, more than the rest of the file can hold", name(), length));
  return false;
}

/// A way in which programs write the file.
struct Candidate {
  ByteOrder order = ByteOrder::kBig;
  bool colours = true;
  Fit fit;
};

/// Tries one byte order, with and without colours, unless there is nothing to be better than.
void compare(ByteScanner bytes, OffHeader header, std::optional<Candidate>& best) {
  if (best && best->fit.exact && best->fit.odd == 0) return;
  if (read_counts(bytes, header)) return;
  for (const bool colours : {true, false}) {
    const Fit fit = fit_of(bytes, header, colours);
    if (!best || fit.better_than(best->fit)) best = Candidate{bytes.order(), colours, fit};
  }
}

}  // namespace

Result<ParsedFile> read_off_binary(std::span<const std::uint8_t> bytes, std::size_t offset,
                                   OffHeader header, const Request& request) {
  std::optional<Candidate> best;
  for (const ByteOrder order : {ByteOrder::kBig, ByteOrder::kLittle}) {
    compare(ByteScanner(bytes, offset, order), header, best);
  }
  const Candidate chosen = best.value_or(Candidate{});
  ByteScanner data(bytes, offset, chosen.order);
  if (auto error = read_counts(data, header)) return *std::move(error);
  return BinaryReader(data, header, chosen.colours, request).read();
}

}  // namespace halfedge::io
