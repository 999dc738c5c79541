#include <halfedge/inlining.h>
#include <halfedge/io/ply_header.h>
#include <halfedge/io/readers.h>
#include <halfedge/sentence.h>

#include <algorithm>
#include <string>
#include <utility>

namespace halfedge::io {
namespace {

std::optional<PlyType> type_of(std::string_view name) {
  constexpr std::pair<std::string_view, PlyType> kTypes[] = {
      {"char", PlyType::kInt8},      {"int8", PlyType::kInt8},
      {"uchar", PlyType::kUint8},    {"uint8", PlyType::kUint8},
      {"short", PlyType::kInt16},    {"int16", PlyType::kInt16},
      {"ushort", PlyType::kUint16},  {"uint16", PlyType::kUint16},
      {"int", PlyType::kInt32},      {"int32", PlyType::kInt32},
      {"uint", PlyType::kUint32},    {"uint32", PlyType::kUint32},
      {"int64", PlyType::kInt64},    {"uint64", PlyType::kUint64},
      {"float", PlyType::kFloat32},  {"float32", PlyType::kFloat32},
      {"double", PlyType::kFloat64}, {"float64", PlyType::kFloat64}};
  for (const auto& [known, type] : kTypes) {
    if (known == name) return type;
  }
  return std::nullopt;
}

class HeaderReader {
 public:
  explicit HeaderReader(std::span<const std::uint8_t> bytes) : bytes_(bytes), text_(bytes) {}

  [[nodiscard]] Result<PlyHeader> read();

 private:
  /// Reads the rest of a line after its keyword.
  [[nodiscard]] bool read_format();
  [[nodiscard]] bool read_element();
  [[nodiscard]] bool read_property();
  [[nodiscard]] bool read_type(PlyType& type);
  [[nodiscard]] bool read_name(std::string_view& name, const char* what);
  /// Nothing but blanks or a comment follows.
  [[nodiscard]] bool read_line_end();
  void end();
  [[nodiscard]] bool check_properties();
  [[nodiscard]] bool check_once(const PlyElement& element, const PlyProperty& property);
  [[nodiscard]] bool check_counts();

  /// The token after blanks; moves past it.
  [[nodiscard]] std::string_view word() {
    text_.skip_blanks();
    const std::string_view token = text_.token();
    text_.move_to(text_.position() + token.size());
    return token;
  }
  [[nodiscard]] bool fail(Error error) {
    error_ = std::move(error);
    return false;
  }
  [[nodiscard]] bool fail_expecting(const char* start, const std::string& expected) {
    text_.move_to(start);
    return fail(unexpected(text_, expected));
  }

  std::span<const std::uint8_t> bytes_;
  TextScanner text_;
  PlyHeader header_;
  bool has_format_ = false;
  bool cr_only_ = false;  // lines end with CR
  Error error_;
};

Result<PlyHeader> HeaderReader::read() {
  text_.skip_to_token();
  if (word() != "ply") return error_at(text_, "parse-error", "expected the word ply");
  cr_only_ = text_.rest().starts_with('\r') && !text_.rest().starts_with("\r\n");
  // Old versions of Blender wrote "Created by ..." without the word comment.
  for (text_.skip_line();; text_.skip_line()) {
    text_.skip_to_token();
    const char* const start = text_.position();
    const std::string_view keyword = word();
    bool ok = true;
    if (keyword == "format") {
      ok = read_format();
    } else if (keyword == "element") {
      ok = read_element();
    } else if (keyword == "property") {
      ok = read_property();
    } else if (keyword == "end_header") {
      break;
    } else if (keyword != "comment" && keyword != "obj_info" && keyword != "Created") {
      ok = fail_expecting(start, "format, element, property, comment, obj_info or end_header");
    }
    if (!ok) return error_;
  }
  if (!has_format_) return error_at(text_, "parse-error", "the header has no line format");
  end();
  if (!check_properties() || !check_counts()) return error_;
  return std::move(header_);
}

/// Finds the first byte after the line of end_header. A binary file may start with any byte, so
/// that LF behind CR belongs to the data where all lines end with CR.
void HeaderReader::end() {
  const char* const end_header = text_.position();
  if (header_.encoding == PlyEncoding::kText) {
    text_.skip_line();
  } else {
    while (text_.skip(' ') || text_.skip('\t')) {
    }
    const bool cr = text_.skip('\r');
    if (!cr || !cr_only_) text_.skip('\n');
  }
  header_.size = bytes_.size() - text_.rest().size();
  text_.move_to(end_header);
}

bool HeaderReader::read_format() {
  if (has_format_) {
    return fail(
        error_at(text_, "parse-error", "the header has a line format already, expected it once"));
  }
  text_.skip_blanks();
  const char* const start = text_.position();
  const std::string_view name = word();
  has_format_ = true;
  if (name == "ascii") {
    header_.encoding = PlyEncoding::kText;
  } else if (name == "binary_little_endian") {
    header_.encoding = PlyEncoding::kLittleEndian;
  } else if (name == "binary_big_endian") {
    header_.encoding = PlyEncoding::kBigEndian;
  } else {
    return fail_expecting(start, "ascii, binary_little_endian or binary_big_endian");
  }
  text_.skip_blanks();
  const char* const version = text_.position();
  const std::string_view given = word();
  if (!given.empty() && given != "1.0") return fail_expecting(version, "the version 1.0");
  return read_line_end();
}

bool HeaderReader::read_element() {
  PlyElement element;
  if (!read_name(element.name, "the name of the element")) return false;
  const bool needed = element.name == "vertex" || element.name == "face";
  if (needed && header_.find(element.name) != nullptr) {
    return fail(error_at(text_, "parse-error",
                         sentence::of("the header has the element {} already, expected it once",
                                      quoted(element.name))));
  }
  text_.skip_blanks();
  const char* const start = text_.position();
  std::int64_t count = 0;
  if (!text_.read_integer(count) || count < 0 || !text_.at_token_end()) {
    return fail_expecting(start, "the number of elements");
  }
  if (count == INT64_MAX) {
    text_.move_to(start);
    return fail(
        error_at(text_, "truncated",
                 sentence::of("the header promises {} elements {}, more than a file can hold",
                              text_.number(), quoted(element.name))));
  }
  element.count = static_cast<std::uint64_t>(count);
  header_.elements.push_back(std::move(element));
  return read_line_end();
}

bool HeaderReader::read_property() {
  text_.skip_blanks();
  if (header_.elements.empty()) {
    return fail(error_at(text_, "parse-error", "this property comes before any element"));
  }
  PlyProperty property{};
  if (text_.token() == "list") {
    (void)word();
    PlyType length{};
    if (!read_type(length)) return false;
    property.length_type = length;
  }
  if (!read_type(property.type) || !read_name(property.name, "the name of the property")) {
    return false;
  }
  header_.elements.back().properties.push_back(property);
  return read_line_end();
}

bool HeaderReader::read_type(PlyType& type) {
  text_.skip_blanks();
  const char* const start = text_.position();
  const std::optional<PlyType> found = type_of(word());
  if (!found) return fail_expecting(start, "a type, such as float, uchar or int32");
  type = *found;
  return true;
}

bool HeaderReader::read_name(std::string_view& name, const char* what) {
  text_.skip_blanks();
  const char* const start = text_.position();
  name = word();
  return !name.empty() || fail_expecting(start, what);
}

bool HeaderReader::read_line_end() {
  text_.skip_blanks();
  return text_.at_line_end() || fail_expecting(text_.position(), "the end of the line");
}

bool HeaderReader::check_once(const PlyElement& element, const PlyProperty& property) {
  const PlyProperty* const end = element.properties.data() + element.properties.size();
  const PlyProperty* const again = std::find_if(
      &property + 1, end, [&](const PlyProperty& other) { return other.name == property.name; });
  if (again == end) return true;
  text_.move_to(again->name.data());
  return fail(error_at(text_, "parse-error",
                       sentence::of("the element {} has the property {} already, expected it once",
                                    quoted(element.name), quoted(property.name))));
}

bool HeaderReader::check_properties() {
  const PlyElement* const vertex = header_.find("vertex");
  if (vertex == nullptr) {
    return fail(error_at(text_, "parse-error", "the header has no element vertex"));
  }
  for (const std::string_view axis : {"x", "y", "z"}) {
    const PlyProperty* const property = vertex->find(axis);
    if (property != nullptr && !property->length_type) {
      if (!check_once(*vertex, *property)) return false;
      continue;
    }
    return fail(error_at(
        text_, "parse-error",
        sentence::of("the element vertex has no property {}, expected the numbers x, y and z",
                     axis)));
  }
  const PlyElement* const face = header_.find("face");
  if (face != nullptr && face->count > 0 && face->vertex_list() == nullptr) {
    return fail(error_at(text_, "parse-error",
                         "the element face has no list vertex_indices (or vertex_index)"));
  }
  return true;
}

/// The fewest bytes of a row: in text a digit and a blank for each value, but for the last one of
/// the file.
bool HeaderReader::check_counts() {
  const bool text = header_.encoding == PlyEncoding::kText;
  const std::uint64_t left = bytes_.size() - header_.size;
  std::uint64_t room = text ? left + 1 : left;
  for (const PlyElement& element : header_.elements) {
    std::uint64_t row = 0;
    for (const PlyProperty& property : element.properties) {
      row += text ? 2 : size_of(property.length_type.value_or(property.type));
    }
    if (row == 0) continue;
    if (element.count > room / row) {
      return fail(error_at(text_, "truncated",
                           sentence::of("the header promises {} {}, but is followed by only {}",
                                        sentence::count_of(element.count, "element"),
                                        quoted(element.name), sentence::count_of(left, "byte"))));
    }
    room -= element.count * row;
  }
  return true;
}

}  // namespace

const PlyProperty* PlyElement::find(std::string_view property) const {
  const auto at = std::find_if(properties.begin(), properties.end(),
                               [property](const PlyProperty& p) { return p.name == property; });
  return at == properties.end() ? nullptr : &*at;
}

const PlyProperty* PlyElement::vertex_list() const {
  for (const std::string_view usual : {"vertex_indices", "vertex_index"}) {
    const PlyProperty* const property = find(usual);
    if (property != nullptr && property->length_type) return property;
  }
  const PlyProperty* only = nullptr;
  for (const PlyProperty& property : properties) {
    if (!property.length_type || !is_integer(property.type)) continue;
    if (only != nullptr) return nullptr;
    only = &property;
  }
  return only;
}

HALFEDGE_COLD std::string PlyElement::name_of(const std::vector<bool>& which) const {
  constexpr std::size_t kNamed = 8;
  std::string names;
  std::size_t found = 0;
  for (std::size_t k = 0; k < properties.size(); ++k) {
    if (which[k] && found++ < kNamed) {
      names += (found == 1 ? "" : ", ") + quoted(properties[k].name);
    }
  }
  if (found == 0) return {};
  if (found > kNamed) names += sentence::of(" and {} more", found - kNamed);
  return sentence::of("{}{} of {}", found == 1 ? "the property " : "the properties ", names,
                      quoted(name));
}

const PlyElement* PlyHeader::find(std::string_view element) const {
  const auto at = std::find_if(elements.begin(), elements.end(),
                               [element](const PlyElement& e) { return e.name == element; });
  return at == elements.end() ? nullptr : &*at;
}

std::uint64_t PlyHeader::rows() const {
  std::uint64_t rows = 0;
  for (const PlyElement& element : elements) rows += element.properties.empty() ? 0 : element.count;
  return rows;
}

Result<PlyHeader> read_ply_header(std::span<const std::uint8_t> bytes) {
  return HeaderReader(bytes).read();
}

bool looks_like_ply(TextScanner text) {
  text.skip_to_token();
  return text.token() == "ply";
}

}  // namespace halfedge::io
