#include <halfedge/inlining.h>
#include <halfedge/io/obj_attributes.h>
#include <halfedge/io/readers.h>
#include <halfedge/sentence.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace halfedge {
namespace io {
namespace {

enum class Statement : std::uint8_t {
  kVertex,
  kTexture,
  kNormal,
  kFace,
  kGroup,
  kObject,
  kMaterial,
  kSmoothing,
  kLibrary,
  kPoint,
  kLine,
  kFreeForm,
  kOther,
  kOtherName,
  kUnknown
};

/// Statements that carry nothing for a mesh, and need no note: of numbers and keywords, and of
/// names.
constexpr std::array kOtherWords = std::to_array<std::string_view>(
    {"vp",    "vc",    "mg",   "lod",  "bevel", "deg", "bmat", "step",     "cstype",
     "parm",  "trim",  "hole", "scrv", "sp",    "end", "con",  "c_interp", "d_interp",
     "ctech", "stech", "bsp",  "bzp",  "cdc",   "cdp", "res"});
constexpr std::array kOtherNames =
    std::to_array<std::string_view>({"usemap", "maplib", "shadow_obj", "trace_obj", "call", "csh"});

HALFEDGE_NOINLINE bool is_one_of(std::span<const std::string_view> words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

Statement longer_statement_of(std::string_view word) {
  if (word == "vt") return Statement::kTexture;
  if (word == "vn") return Statement::kNormal;
  if (word == "fo") return Statement::kFace;  // before version 3.0
  if (word == "usemtl") return Statement::kMaterial;
  if (word == "mtllib") return Statement::kLibrary;
  if (word == "curv" || word == "curv2" || word == "surf") return Statement::kFreeForm;
  if (is_one_of(kOtherWords, word)) return Statement::kOther;
  return is_one_of(kOtherNames, word) ? Statement::kOtherName : Statement::kUnknown;
}

Statement statement_of(std::string_view word) {
  if (word.size() != 1) return longer_statement_of(word);
  switch (word[0]) {
    case 'v':
      return Statement::kVertex;
    case 'f':
      return Statement::kFace;
    case 'g':
      return Statement::kGroup;
    case 'o':
      return Statement::kObject;
    case 'l':
      return Statement::kLine;
    case 'p':
      return Statement::kPoint;
    case 's':
      return Statement::kSmoothing;
    default:
      return Statement::kUnknown;
  }
}

/// Names, such as the path of a folder, and what is unknown. In other statements one at the end of
/// a line joins the next to it.
bool may_end_with_backslash(Statement statement) {
  switch (statement) {
    case Statement::kGroup:
    case Statement::kObject:
    case Statement::kMaterial:
    case Statement::kLibrary:
    case Statement::kOtherName:
    case Statement::kUnknown:
      return true;
    default:
      return false;
  }
}

class ObjReader {
 public:
  ObjReader(std::span<const std::uint8_t> bytes, const Request& request)
      : text_(without_padding(bytes)), options_(request.options), out_(request.wanted) {
    out_.follow(bytes, options_.progress);
  }

  [[nodiscard]] std::optional<Error> read() {
    for (; !text_.at_end() && !out_.out_of_memory(); text_.skip_line()) {
      out_.reached(text_.position());
      text_.skip_blanks();
      if (text_.at_line_end()) {
        painted_ += options_.attributes && text_.skip("#MRGB ") ? 1U : 0U;
        continue;
      }
      if (!read_statement()) return error_;
    }
    if (std::optional<Error> error = check_size(out_)) return error;
    if (!any_known_ && unknown_ != 0) {
      text_.move_to(first_unknown_);
      return unexpected(text_, "a statement of an OBJ file, such as v or f");
    }
    return std::nullopt;
  }

  [[nodiscard]] SoupWriter& out() { return out_; }
  [[nodiscard]] ObjAttributes& attributes() { return attributes_; }
  [[nodiscard]] std::vector<std::string> notes();

 private:
  [[nodiscard]] bool read_statement();
  [[nodiscard]] bool read_vertex();
  void read_behind_position();
  [[nodiscard]] bool read_face();
  [[nodiscard]] bool read_corner();
  [[nodiscard]] bool read_longer_corner(std::int64_t& vertex);
  [[nodiscard]] int read_indices(std::array<std::int64_t, 3>& indices);
  [[nodiscard]] Error wrong_index(std::int64_t vertices);
  void read_attribute(Statement statement);

  [[nodiscard]] bool fail(Error error) {
    error_ = std::move(error);
    return false;
  }

  TextScanner text_;
  ParseOptions options_;
  SoupWriter out_;
  ObjAttributes attributes_;
  Error error_;
  std::size_t points_ = 0;
  std::size_t lines_ = 0;
  std::size_t free_form_ = 0;
  std::size_t painted_ = 0;  // comments in which ZBrush stores the colours of vertices
  std::size_t unknown_ = 0;
  bool any_known_ = false;
  const char* first_unknown_ = nullptr;
};

bool ObjReader::read_statement() {
  // Files that were put together have the byte-order mark of each.
  while (text_.skip(kByteOrderMark)) text_.skip_blanks();
  if (text_.at_line_end()) return true;
  const char* const start = text_.position();
  const std::string_view word = text_.token();
  const Statement statement = statement_of(word);
  text_.move_to(start + word.size());
  any_known_ |= statement != Statement::kUnknown;
  switch (statement) {
    case Statement::kVertex:
      out_.begin_vertex(start);
      return read_vertex();
    case Statement::kFace:
      out_.begin_face(start);
      return read_face();
    case Statement::kTexture:
    case Statement::kNormal:
    case Statement::kGroup:
    case Statement::kObject:
    case Statement::kMaterial:
    case Statement::kSmoothing:
    case Statement::kLibrary:
      if (options_.attributes) read_attribute(statement);
      break;
    case Statement::kPoint:
      ++points_;
      break;
    case Statement::kLine:
      ++lines_;
      break;
    case Statement::kFreeForm:
      ++free_form_;
      break;
    case Statement::kOther:
    case Statement::kOtherName:
      break;
    case Statement::kUnknown:
      if (unknown_++ == 0) first_unknown_ = start;
      break;
  }
  if (!may_end_with_backslash(statement)) text_.skip_tokens();
  return true;
}

void ObjReader::read_attribute(Statement statement) {
  using Name = ObjAttributes::Name;
  bool fits = true;
  if (statement == Statement::kTexture) {
    fits = attributes_.read_texture(text_);
  } else if (statement == Statement::kNormal) {
    fits = attributes_.read_normal(text_);
  } else if (statement == Statement::kLibrary) {
    attributes_.read_library(text_);
  } else if (statement == Statement::kSmoothing) {
    fits = attributes_.read_smoothing(text_, out_.face_count());
  } else {
    const Name kind = statement == Statement::kGroup    ? Name::kGroup
                      : statement == Statement::kObject ? Name::kObject
                                                        : Name::kMaterial;
    fits = attributes_.read_name(text_, kind, out_.face_count());
  }
  if (!fits) out_.set_out_of_memory();
}

bool ObjReader::read_vertex() {
  std::array<float, 3> xyz;
  for (std::size_t i = 0; i < 3; ++i) {
    text_.skip_blanks();
    if (text_.read_float(xyz[i])) continue;
    return fail(unexpected(text_, sentence::of("a number for {} of the vertex",
                                               std::string_view("xyz").substr(i, 1))));
  }
  if (!text_.at_line_end()) read_behind_position();
  out_.add_vertex(xyz[0], xyz[1], xyz[2]);
  return true;
}

/// A weight, a colour, or blanks.
void ObjReader::read_behind_position() {
  if (options_.attributes && !attributes_.read_color(text_, out_.vertex_count())) {
    out_.set_out_of_memory();
  }
  text_.skip_tokens();
}

bool ObjReader::read_face() {
  for (;;) {
    text_.skip_blanks();
    if (text_.at_line_end()) break;
    if (!read_corner()) return false;
  }
  out_.end_face();
  return true;
}

/// Most are just a number, and are read without a call.
bool ObjReader::read_corner() {
  const char* const start = text_.position();
  std::int64_t index = 0;
  // Its vertex may be declared further down: compared with their number at the end.
  if (!text_.read_integer(index) || !text_.at_token_end() || index <= 0 || index > kMaxSlots) {
    text_.move_to(start);
    if (!read_longer_corner(index)) return false;
  }
  out_.add_corner(static_cast<Index>(index - 1));
  return true;
}

/// One to three, with slashes between them, of which the second may be empty; 0 if there is none.
int ObjReader::read_indices(std::array<std::int64_t, 3>& indices) {
  int count = 0;
  do {
    const bool is_there = text_.read_integer(indices[static_cast<std::size_t>(count)]);
    if (count == 0 && !is_there) return 0;
    ++count;
  } while (count < 3 && text_.skip('/'));
  return count;
}

/// 3, 3/1, 3/1/2, 3//2, and the same with signs; `vertex` counts from 1.
bool ObjReader::read_longer_corner(std::int64_t& vertex) {
  const char* const start = text_.position();
  std::array<std::int64_t, 3> indices{};
  const int count = read_indices(indices);
  const bool well_formed = count > 0;
  const std::int64_t index = indices[0];
  if (count > 1) {
    const ObjAttributes::Corner references{indices[1], indices[2]};
    if (options_.attributes && !attributes_.add_corner(out_.corner_count(), references)) {
      out_.set_out_of_memory();
    }
  }
  if (!well_formed || !text_.at_token_end()) {
    text_.move_to(start);
    return fail(unexpected(text_, "a vertex of the face, as 3, 3/1, 3/1/2 or 3//2"));
  }

  const auto vertices = static_cast<std::int64_t>(out_.vertex_count());
  if (index >= -vertices || options_.for_repair) {
    vertex = std::int64_t{out_.missing_vertex(index >= 0 ? index - 1 : vertices + index)} + 1;
    return true;
  }
  text_.move_to(start);
  return fail(wrong_index(vertices));
}

/// pre: the cursor is at a corner that counts back too far
Error ObjReader::wrong_index(std::int64_t vertices) {
  Error error = index_error(text_, out_.corners_of_face(), out_.face_count());
  error.message +=
      vertices == 0 ? ", but no vertex comes before it"
                    : sentence::of(", expected -1 to -{}, counted back from the last vertex so far",
                                   vertices);
  return error;
}

std::vector<std::string> ObjReader::notes() {
  std::vector<std::string> notes;
  const auto add = [&notes](std::size_t count, const std::string& what) {
    if (count == 0) return;
    notes.push_back(
        sentence::of("ignored {} {}{}", count, what, count == 1 ? " statement" : " statements"));
  };
  add(points_, "point (p)");
  add(lines_, "line (l)");
  add(free_form_, "curve or surface (curv, curv2, surf)");
  add(painted_, "colour (#MRGB)");
  add(unknown_, "unknown");
  if (unknown_ != 0) {
    text_.move_to(first_unknown_);
    notes.back() += sentence::of(", the first in line {}: {}", text_.line(), text_.found());
  }
  return notes;
}

/// Reads the file again to find the place. Takes the soup, to free it before.
/// pre: a corner is beyond the vertices.
Error unknown_vertex(std::span<const std::uint8_t> bytes, PolygonSoup soup) {
  const std::size_t vertices = soup.positions.size() / 3;
  const Index* const bad = std::find_if(soup.corners.begin(), soup.corners.end(),
                                        [vertices](Index vertex) { return vertex >= vertices; });
  auto corner = static_cast<std::size_t>(bad - soup.corners.begin());
  std::size_t face = corner / 3;
  if (soup.sizes.empty()) {
    corner %= 3;
  } else {
    for (face = 0; corner >= soup.sizes[face]; ++face) corner -= soup.sizes[face];
  }

  soup = {};
  const auto wanted = static_cast<Index>(face);
  Places places({&wanted, 1});
  (void)read_obj(bytes, {{.attributes = false, .for_repair = true}, {.faces = &places}});
  const char* const start = places.positions()[0];
  if (start == nullptr) {
    return {"out-of-memory", "memory was exhausted while a wrong index was looked for"};
  }
  TextScanner text(bytes);
  text.move_to(start);
  for (std::size_t i = 0; i <= corner; ++i) {  // past the keyword and the corners before
    text.skip_token();
    text.skip_blanks();
  }
  Error error = index_error(text, corner, face);
  error.message += vertices == 0 ? ", but the file has no vertices"
                                 : sentence::of(", expected a vertex from 1 to {}", vertices);
  return error;
}

}  // namespace

Result<ParsedFile> read_obj(std::span<const std::uint8_t> bytes, const Request& request) {
  ObjReader reader(bytes, request);
  if (std::optional<Error> error = reader.read()) return *std::move(error);
  SoupWriter& out = reader.out();
  const bool complete = out.corner_count() == 0 || out.largest_index() < out.vertex_count();
  if (!complete && !request.options.for_repair) return unknown_vertex(bytes, std::move(out.soup()));
  const std::size_t vertices = out.vertex_count();
  const std::size_t faces = out.face_count();
  ParsedFile file{Format::kObj, std::move(out.soup()), reader.notes()};
  if (!reader.attributes().finish(vertices, faces, file)) {
    return no_memory_for_attributes();
  }
  return file;
}

bool looks_like_obj(TextScanner text) {
  constexpr std::size_t kLooked = 1 << 16;
  const char* const start = text.position();
  for (; !text.at_end() && text.position() < start + kLooked; text.skip_line()) {
    text.skip_blanks();
    const std::string_view word = text.token();
    if (word == "mtllib" || word == "usemtl") return true;
    if (word != "v" && word != "vn" && word != "vt" && word != "f") continue;
    text.move_to(text.position() + word.size());
    text.skip_blanks();
    std::int64_t index = 0;
    float number = 0;
    // What is glued to the number, as in 0,5, is for the reader to explain.
    if (text.read_integer(index) || (word != "f" && text.read_float(number))) return true;
  }
  return false;
}

}  // namespace io

Result<ParsedFile> read_obj(std::span<const std::uint8_t> bytes, const ParseOptions& options) {
  return io::read_obj(bytes, {options});
}

}  // namespace halfedge
