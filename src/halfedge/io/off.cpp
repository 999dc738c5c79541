#include <halfedge/io/off_attributes.h>
#include <halfedge/io/off_binary.h>
#include <halfedge/io/off_header.h>
#include <halfedge/io/readers.h>
#include <halfedge/sentence.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace halfedge {
namespace io {
namespace {

/// Whether the text is so many faces of three corners or more, and nothing else.
bool is_just_faces(TextScanner text, std::uint64_t faces) {
  const auto read = [&text](std::int64_t& number) {
    text.skip_to_token();
    return text.read_integer(number) && text.at_token_end();
  };
  for (; faces > 0; --faces) {
    std::int64_t degree = 0;
    std::int64_t vertex = 0;
    if (!read(degree) || degree < 3) return false;
    for (; degree > 0; --degree) {
      if (!read(vertex)) return false;
    }
  }
  text.skip_to_token();
  return text.at_end();
}

/// How vertices, or faces, lie on lines.
enum class Layout : std::uint8_t {
  kUnknown,  // as kRecords, until something follows a record on its line
  kRecords,  // each begins a line, and may have colours and such behind
  kFree      // each begins behind the one before
};

/// A vertex is three numbers and a face a count with so many indices. Files put each on a line of
/// its own, and may add colours and such behind; but line breaks mean nothing to Geomview. So lines
/// are records, which gives errors their place, unless there are too many or too few of them: all
/// may be on one line, or a line may end in the middle of each.
class OffReader {
 public:
  /// `text` is behind the header.
  OffReader(const TextScanner& text, const OffHeader& header, const Request& request)
      : text_(text), data_(text), options_(request.options), out_(request.wanted), header_(header) {
    const std::string_view rest = text.rest();
    out_.follow({reinterpret_cast<const std::uint8_t*>(rest.data()), rest.size()},
                options_.progress);
  }

  [[nodiscard]] std::optional<Error> read();
  [[nodiscard]] SoupWriter& out() { return out_; }
  [[nodiscard]] std::vector<std::string> notes();
  [[nodiscard]] OffAttributes& attributes() { return attributes_; }

 private:
  void prepare();
  [[nodiscard]] bool read_vertex();
  [[nodiscard]] bool read_face();
  [[nodiscard]] bool read_corner(std::int64_t corner, std::int64_t degree);
  void look_behind_position();
  /// Whether what is left of the vertices and faces are just their numbers, on more lines than
  /// there are records.
  [[nodiscard]] bool vertices_cross_lines();
  void read_values_of_vertex();
  [[nodiscard]] bool read_behind_face();
  void read_color_of_face();
  /// Whether what is left on the line is no colour, but more faces.
  [[nodiscard]] bool faces_share_lines();

  /// To the next number of a record. False where the record ends too early.
  [[nodiscard]] bool skip_to_value(bool is_free);
  /// Lines with something on them after the header. Counted when first asked for.
  [[nodiscard]] std::uint64_t data_lines();
  [[nodiscard]] std::uint64_t records() const { return header_.vertices + header_.faces; }

  [[nodiscard]] bool fail(Error error) {
    error_ = std::move(error);
    return false;
  }

  TextScanner text_;
  TextScanner data_;  // stays behind the header
  ParseOptions options_;
  SoupWriter out_;
  OffAttributes attributes_;
  OffHeader header_;
  Error error_;
  Layout vertices_ = Layout::kUnknown;
  Layout faces_ = Layout::kUnknown;
  std::optional<std::uint64_t> data_lines_;
  // Of how many something was passed over that can't be read.
  std::uint64_t vertices_with_words_ = 0;
  std::uint64_t faces_with_more_ = 0;
};

std::optional<Error> OffReader::read() {
  prepare();
  for (std::uint64_t i = 0; i < header_.vertices && !out_.out_of_memory(); ++i) {
    if (!read_vertex()) return error_;
  }
  for (std::uint64_t i = 0; i < header_.faces && !out_.out_of_memory(); ++i) {
    if (!read_face()) return error_;
  }
  return check_size(out_);
}

void OffReader::prepare() {
  text_.skip_to_token();
  const std::size_t columns = text_.columns_of_line();
  const auto expected = static_cast<std::size_t>(header_.columns);
  const bool has_all = columns / expected >= header_.vertices;
  const bool may_share = columns > expected && (columns % expected == 0 || has_all);
  if (may_share && data_lines() < records()) vertices_ = Layout::kFree;
  // Most faces are triangles; an index takes two bytes.
  const std::uint64_t corners = std::min<std::uint64_t>(3 * header_.faces, text_.rest().size() / 2);
  out_.reserve(static_cast<std::size_t>(header_.vertices), static_cast<std::size_t>(corners));
}

std::uint64_t OffReader::data_lines() {
  if (data_lines_) return *data_lines_;
  std::uint64_t lines = 0;
  TextScanner text = data_;
  for (text.skip_to_token(); !text.at_end(); text.skip_to_token()) {
    ++lines;
    text.skip_line();
  }
  data_lines_ = lines;
  return lines;
}

bool OffReader::skip_to_value(bool is_free) {
  text_.skip_blanks();
  if (!text_.at_line_end()) return true;
  if (!is_free && data_lines() <= records()) return false;
  text_.skip_to_token();
  return !text_.at_end();
}

bool OffReader::read_vertex() {
  text_.skip_to_token();
  out_.reached(text_.position());
  out_.begin_vertex(text_.position());
  std::array<float, 4> p{};
  const auto coordinates = static_cast<std::size_t>(header_.coordinates);
  for (std::size_t i = 0; i < coordinates; ++i) {
    if (skip_to_value(vertices_ == Layout::kFree) && text_.read_float(p[i])) continue;
    return fail(unexpected(text_, sentence::of("a number for {} of vertex {} of {}",
                                               std::string_view("xyzw").substr(i, 1),
                                               out_.vertex_count(), header_.vertices)));
  }
  if (coordinates == 4) {
    for (std::size_t i = 0; i < 3; ++i) p[i] /= p[3];
  }
  const bool is_plain = header_.columns == header_.coordinates;
  if (is_plain && vertices_ != Layout::kFree) look_behind_position();
  const bool has_more = !is_plain || !text_.at_line_end();
  const bool is_free = vertices_ == Layout::kFree;
  if (is_free || (options_.attributes && has_more)) read_values_of_vertex();
  if (!is_free) text_.skip_tokens();
  out_.add_vertex(p[0], p[1], p[2]);
  return true;
}

/// The layout matters where something follows a position on its line that doesn't belong there.
void OffReader::look_behind_position() {
  text_.skip_blanks();
  if (text_.at_line_end() || vertices_ != Layout::kUnknown) return;
  vertices_ = Layout::kRecords;
  if (vertices_cross_lines()) vertices_ = faces_ = Layout::kFree;
}

bool OffReader::vertices_cross_lines() {
  if (data_lines() <= records()) return false;
  TextScanner ahead = text_;
  const std::uint64_t vertices = header_.vertices - out_.vertex_count() - 1;
  for (std::uint64_t left = vertices * static_cast<std::uint64_t>(header_.columns); left > 0;
       --left) {
    float number = 0;
    ahead.skip_to_token();
    if (!ahead.read_float(number)) return false;
  }
  return is_just_faces(ahead, header_.faces);
}

/// What the vertex has behind its position: all of the line, or so many numbers as it should have.
void OffReader::read_values_of_vertex() {
  constexpr std::size_t kMostValues = 10;  // one more than there can be
  std::array<float, kMostValues> numbers{};
  std::array<std::string_view, kMostValues> tokens;
  const auto promised = static_cast<std::size_t>(header_.columns - header_.coordinates);
  const bool is_free = vertices_ == Layout::kFree;
  const std::size_t most = is_free ? promised : kMostValues;
  std::size_t count = 0;
  for (; count < most; ++count) {
    text_.skip_blanks();
    if (text_.at_line_end() && (!is_free || !skip_to_value(true))) break;
    tokens[count] = text_.token();
    if (!text_.read_float(numbers[count])) break;
  }
  if (!options_.attributes) return;
  if (count < most && !is_free && !text_.at_line_end()) ++vertices_with_words_;
  const std::size_t color = header_.normals ? 3 : 0;
  const std::size_t behind = color + (header_.texture ? 2 : 0);
  for (std::size_t i = color; header_.colors && i + behind < count + color && i < color + 4; ++i) {
    attributes_.vertex_colors().see(tokens[i]);
  }
  if (!attributes_.add_vertex(header_, out_.vertex_count(), {numbers.data(), count})) {
    out_.set_out_of_memory();
  }
}

bool OffReader::read_face() {
  text_.skip_to_token();
  out_.reached(text_.position());
  out_.begin_face(text_.position());
  const TextScanner start = text_;
  std::int64_t degree = 0;
  if (!text_.read_integer(degree) || degree < 0 || !text_.at_token_end()) {
    return fail(unexpected(start, sentence::of("the number of vertices of face {} of {}",
                                               out_.face_count(), header_.faces)));
  }
  for (std::int64_t corner = 0; corner < degree; ++corner) {
    if (!read_corner(corner, degree)) return false;
  }
  if (text_.at_line_end() || !read_behind_face()) text_.skip_tokens();
  out_.end_face();
  return true;
}

/// A colour, blanks, or more faces. Whether it is more faces.
bool OffReader::read_behind_face() {
  text_.skip_blanks();
  if (text_.at_line_end()) return false;
  if (faces_ == Layout::kUnknown) {
    faces_ = faces_share_lines() ? Layout::kFree : Layout::kRecords;
  }
  if (faces_ == Layout::kFree) return true;
  if (options_.attributes) read_color_of_face();
  return false;
}

/// Looked at only if it matters: where something follows a face on its line. A file that was cut
/// has too few lines as well, so what is left must be faces and nothing else; and where each has a
/// line, the four numbers behind it are a colour, even if they look like a triangle.
bool OffReader::faces_share_lines() {
  std::uint64_t lines = 0;
  TextScanner ahead = text_;
  const std::uint64_t left = header_.faces - out_.face_count();
  for (; lines < left && !ahead.at_end(); ++lines) {
    ahead.skip_line();
    ahead.skip_to_token();
  }
  const bool may_be_color = lines > 1 && text_.columns_of_line() == 4;
  return lines < left && !may_be_color && is_just_faces(text_, left - 1);
}

/// Three or four numbers, from 0 to 1 or integers from 0 to 255.
void OffReader::read_color_of_face() {
  std::array<float, 4> color{};
  std::array<std::string_view, 4> tokens;
  std::size_t count = 0;
  for (; count < color.size() && !text_.at_line_end(); text_.skip_blanks(), ++count) {
    tokens[count] = text_.token();
    if (!text_.read_float(color[count])) break;
  }
  if (!text_.at_line_end()) ++faces_with_more_;
  if (count == 0) return;
  for (std::size_t i = 0; count >= 3 && i < count; ++i) attributes_.face_colors().see(tokens[i]);
  if (!attributes_.add_face(out_.face_count(), {color.data(), count})) out_.set_out_of_memory();
}

bool OffReader::read_corner(std::int64_t corner, std::int64_t degree) {
  const bool any = skip_to_value(vertices_ == Layout::kFree || faces_ == Layout::kFree);
  const TextScanner start = text_;
  std::int64_t vertex = 0;
  const bool well_formed = any && text_.read_integer(vertex) && text_.at_token_end();
  if (well_formed && vertex >= 0 && static_cast<std::uint64_t>(vertex) < header_.vertices) {
    out_.add_corner(static_cast<Index>(vertex));
    return true;
  }
  if (well_formed && options_.for_repair) {
    out_.add_corner(out_.missing_vertex(vertex, [&start] { return start.number(); }));
    return true;
  }
  const std::string face = sentence::of("face {}", out_.face_count());
  if (!well_formed) {
    return fail(
        unexpected(start, sentence::of("vertex {} of the {} of {}", corner + 1, degree, face)));
  }
  Error error = index_error(start, static_cast<std::size_t>(corner), out_.face_count());
  error.message += header_.vertices == 0
                       ? ", but the file has no vertices"
                       : sentence::of(", expected a vertex from 0 to {}", header_.vertices - 1);
  return fail(std::move(error));
}

std::vector<std::string> OffReader::notes() {
  std::vector<std::string> notes;
  if (vertices_with_words_ > 0) {
    notes.push_back(sentence::of("Of {}: ignored words behind the position, expected numbers",
                                 sentence::count_of(vertices_with_words_, "vertex")));
  }
  if (faces_with_more_ > 0) {
    notes.push_back(
        sentence::of("Of {}: ignored what follows the vertices and is no colour of 3 or 4 numbers",
                     sentence::count_of(faces_with_more_, "face")));
  }
  text_.skip_to_token();
  if (!text_.at_end()) {
    notes.push_back(sentence::of("ignored what follows the last face, from line {} on: {}",
                                 text_.line(), text_.found()));
  }
  return notes;
}

}  // namespace

Result<ParsedFile> read_off(std::span<const std::uint8_t> bytes, const Request& request) {
  TextScanner text(without_padding(bytes));
  Result<OffHeader> header = read_off_header(text);
  if (!header) return header;
  if (header.value().binary) {
    // Of which NULs at the end are a part.
    const std::size_t data = without_padding(bytes).size() - text.rest().size();
    return read_off_binary(bytes, data, header.value(), request);
  }
  OffReader reader(text, header.value(), request);
  if (std::optional<Error> error = reader.read()) return *std::move(error);
  const std::size_t vertices = reader.out().vertex_count();
  const std::size_t faces = reader.out().face_count();
  ParsedFile file{Format::kOff, std::move(reader.out().soup()), reader.notes()};
  if (!reader.attributes().finish(vertices, faces, file)) return no_memory_for_attributes();
  return file;
}

}  // namespace io

Result<ParsedFile> read_off(std::span<const std::uint8_t> bytes, const ParseOptions& options) {
  return io::read_off(bytes, {options});
}

}  // namespace halfedge
