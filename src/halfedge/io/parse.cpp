#include <halfedge/io/parse.h>
#include <halfedge/io/readers.h>
#include <halfedge/sentence.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

namespace halfedge {
namespace {

/// Whether a word with something behind it follows the brace, as in "{ OFF 8 6 12", and no colon.
bool is_geomview(std::string_view text) {
  constexpr const char* kBlanks = " \t\r\n";
  const std::size_t word = std::min(text.find_first_not_of(kBlanks, 1), text.size());
  const std::size_t end = std::min(text.find_first_of(kBlanks, word), text.size());
  const std::size_t behind = text.find_first_not_of(kBlanks, end);
  const std::string_view letters = text.substr(word, end - word);
  return !letters.empty() && behind != std::string_view::npos && text[behind] != ':' &&
         std::all_of(letters.begin(), letters.end(),
                     [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; });
}

/// Formats that are recognised only so that the error can say what the file is: by its bytes, or by
/// its text behind comments.
const char* name_of_unreadable(std::string_view bytes, std::string_view text) {
  struct Sign {
    std::string_view start;
    const char* name;
  };
  constexpr Sign kSigns[] = {
      {"glTF", "a GLB file"},
      {"<", "an HTML or XML file"},
      {"version https://git-lfs", "a Git LFS pointer, which stands for the file itself"},
      {"\x1F\x8B", "a gzip archive, to be unpacked first"},
      {"PK\x03\x04", "a ZIP archive (perhaps 3MF), to be unpacked first"},
      {"Kaydara FBX Binary", "an FBX file"},
      {"; FBX", "an FBX file"},
      {"BLENDER", "a Blender file"},
      {"DRACO", "a Draco file"},
      {"ISO-10303-21", "a STEP file"},
      {"# vtk DataFile", "a VTK file"},
      {"#VRML", "a VRML file"},
      {"$MeshFormat", "a Gmsh file"},
      {"%PDF-", "a PDF document"},
      {"# .PCD", "a PCD point cloud"},
      {"#usda", "a USD file"},
      {"PXR-USDC", "a USD file"},
      {"MeshVersionFormatted", "a Medit file"},
      {"7z\xBC\xAF\x27\x1C", "a 7z archive, to be unpacked first"},
      {"Rar!", "a RAR archive, to be unpacked first"},
      {"BZh", "a bzip2 archive, to be unpacked first"},
      {"\xFD\x37zXZ", "an xz archive, to be unpacked first"},
      {"\x28\xB5\x2F\xFD", "a Zstandard archive, to be unpacked first"},
      {"\x89PNG", "a PNG image"},
      {"\xFF\xD8\xFF", "a JPEG image"},
  };
  for (const auto& [start, name] : kSigns) {
    if (bytes.starts_with(start) || text.starts_with(start)) return name;
  }
  if (text.starts_with("{")) {
    return is_geomview(text) ? "a Geomview file with objects in braces"
                             : "a JSON (perhaps glTF) file";
  }
  return nullptr;
}

/// UTF-16 by its byte-order mark or, without one, by the NULs that it makes of plain letters.
bool looks_like_utf16(std::string_view bytes) {
  using namespace std::string_view_literals;
  if (bytes.starts_with("\xFF\xFE"sv) || bytes.starts_with("\xFE\xFF"sv)) return true;
  if (bytes.size() < 4) return false;
  const auto nul = [bytes](std::size_t i) { return bytes[i] == '\0'; };
  return (nul(0) && !nul(1) && nul(2) && !nul(3)) || (!nul(0) && nul(1) && !nul(2) && nul(3));
}

Result<Format> detect(std::span<const std::uint8_t> bytes, std::optional<Format> claimed) {
  constexpr std::size_t kLooked = 4096;
  const std::string_view raw(reinterpret_cast<const char*>(bytes.data()),
                             std::min(bytes.size(), kLooked));
  if (raw.empty()) {
    return Error{"unknown-format",
                 "the file is empty (0 bytes), expected an OBJ, OFF, PLY or STL file"};
  }
  const io::StlKind stl = io::kind_of_stl(bytes);
  if (stl == io::StlKind::kBinary) return Format::kStl;  // whatever its header looks like
  if (looks_like_utf16(raw)) {
    return Error{"not-text", "the file is encoded in UTF-16, expected ASCII or UTF-8"};
  }
  io::TextScanner text(bytes);
  if (io::looks_like_off(text)) return Format::kOff;  // before the look for NULs: may be binary
  if (io::looks_like_ply(text)) return Format::kPly;
  if (stl == io::StlKind::kText) return Format::kStl;
  text.skip_to_token();
  if (const char* name = name_of_unreadable(raw, text.rest())) {
    return Error{"unsupported-format",
                 sentence::of("this is {}, expected an OBJ, OFF, PLY or STL file", name)};
  }
  const bool is_stl = stl == io::StlKind::kBinaryOfWrongSize || claimed == Format::kStl;
  const std::size_t size = io::without_padding(bytes).size();
  const std::string_view content = size == 0 ? raw : raw.substr(0, size);
  if (const std::size_t nul = content.find('\0'); nul != std::string_view::npos) {
    if (is_stl) return Format::kStl;
    return Error{
        "not-text",
        sentence::of(
            "byte {} is 0, which no text has: this is no OBJ, OFF, PLY or STL file in text form",
            nul)};
  }
  if (io::looks_like_obj(text)) return Format::kObj;
  if (text.token() == "newmtl") {
    return Error{"unsupported-format",
                 "this is an MTL file, the materials of an OBJ file, expected that one"};
  }
  if (claimed) return *claimed;
  if (text.at_end()) {
    return Error{
        "unknown-format",
        "the file has nothing but comments and blanks, expected an OBJ, OFF, PLY or STL file"};
  }
  Error error = io::unexpected(text, "the start of an OBJ, OFF, PLY or STL file");
  error.code = "unknown-format";
  return error;
}

/// Coordinates of maps are of millions, where floats are half a metre apart: what is smaller is
/// lost, though every number is read as well as a float can hold it. Says so if the whole file is
/// only a few thousand such steps wide.
/// cost: a few vertices of most files: a file of half the distance stays near, since whatever is
/// twice as far as all before makes it as wide.
void note_coarse_positions(ParsedFile& file) {
  constexpr float kFarOff = 2048;  // times its own size
  std::array<float, 3> low;
  std::array<float, 3> high;
  low.fill(INFINITY);
  high.fill(-INFINITY);
  float size = 0;
  float farthest = 0;
  const std::span<const float> positions = std::as_const(file.soup.positions);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const float x = positions[i];
    const std::size_t axis = i % 3;
    if (!std::isfinite(x)) continue;
    low[axis] = std::min(low[axis], x);
    high[axis] = std::max(high[axis], x);
    size = std::max(size, high[axis] - low[axis]);
    farthest = std::max(farthest, std::abs(x));
    if (axis == 2 && farthest < kFarOff / 2 * size) return;
  }
  // Faces without any size may be a part that is smaller than a step.
  if (farthest <= kFarOff * size || (size == 0 && file.soup.corners.empty())) return;
  const double step = farthest - std::nextafter(farthest, 0.F);
  file.notes.push_back(sentence::of(
      "the positions are far from the origin for their size: as floats, which are up to {} apart "
      "there, they lose what is finer",
      sentence::number(step)));
}

}  // namespace

Result<ParsedFile> io::read_as(Format format, std::span<const std::uint8_t> bytes,
                               const Request& request) {
  switch (format) {
    case Format::kObj:
      return read_obj(bytes, request);
    case Format::kOff:
      return read_off(bytes, request);
    case Format::kPly:
      return read_ply(bytes, request);
    case Format::kStl:
      return read_stl(bytes, request);
  }
  return Error{"unknown-format", "the format asked for does not exist"};
}

const char* name_of(Format format) {
  switch (format) {
    case Format::kObj:
      return "OBJ";
    case Format::kOff:
      return "OFF";
    case Format::kPly:
      return "PLY";
    case Format::kStl:
      return "STL";
  }
  return "";
}

Result<ParsedFile> parse(std::span<const std::uint8_t> bytes, std::optional<Format> claimed,
                         const ParseOptions& options) {
  Result<Format> format = detect(bytes, claimed);
  if (!format) return format;
  Result<ParsedFile> file = io::read_as(format.value(), bytes, {options});
  if (!file) {
    Error error = file.error();
    if (error.code != "out-of-memory") {
      error.message += sentence::of(" (read as {})", name_of(format.value()));
    }
    return error;
  }
  note_coarse_positions(file.value());
  if (claimed && *claimed != format.value()) {
    file.value().notes.push_back(sentence::of("read as {}, which its content is, and not as {}",
                                              name_of(format.value()), name_of(*claimed)));
  }
  return file;
}

}  // namespace halfedge
