#include <halfedge/io/stl_reader.h>
#include <halfedge/sentence.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

namespace halfedge::io {
namespace {

constexpr std::size_t kCorners = 12;  // behind the normal
constexpr std::size_t kBlock = 256;   // so many triangles are read at once

/// The two bytes behind each triangle, which some programs have colours in.
SoupAttribute face_attribute() {
  SoupAttribute column;
  column.name = "attribute";
  column.item = SoupItem::kFace;
  column.type = Scalar::kUint16;
  column.on_split = OnSplit::kCopy;
  return column;
}
/// Reads those of the triangles `at`, of which the first is `face`. Makes room for all at the first
/// one that isn't 0. False when memory is exhausted.
bool read_values(const std::uint8_t* at, std::size_t face, std::size_t count, std::size_t faces,
                 SoupAttribute& column) {
  for (std::size_t i = 0; i < count; ++i, at += kStlTriangle) {
    const auto value = load<std::uint16_t>(at + 48, ByteOrder::kLittle);
    if (value == 0) continue;
    if (!column.values.resize(sizeof(value) * faces, std::byte{})) return false;
    std::memcpy(&column.values[sizeof(value) * (face + i)], &value, sizeof(value));
  }
  return true;
}

/// pre: one of the triangles, of which the first is `face`, is not finite
Error first_not_finite(std::size_t face, std::span<const float> triangles) {
  while (are_finite(triangles.first(9))) {
    triangles = triangles.subspan(9);
    ++face;
  }
  Error at = error_at_byte(kStlStart + kStlTriangle * face, "non-finite-position", "");
  return not_finite(std::move(at), triangles.first(9), face);
}

/// Programs that write as they go begin with a count of 0 or -1, and some never come back to it:
/// then the size tells.
std::uint64_t triangles_of(std::span<const std::uint8_t> bytes) {
  const std::uint64_t announced = announced_triangles(bytes);
  const std::size_t size = bytes.size() - kStlStart;
  const bool is_placeholder = announced == 0 || announced == UINT32_MAX;
  return is_placeholder && size % kStlTriangle == 0 && has_stl_triangles(bytes)
             ? size / kStlTriangle
             : announced;
}

Error too_short(std::size_t bytes) {
  return {"truncated",
          sentence::of("the file has {}, expected at least the {} bytes that start a binary STL "
                       "file",
                       sentence::count_of(bytes, "byte"), kStlStart)};
}

Error ends_early(std::size_t bytes, std::uint64_t triangles) {
  const std::size_t rest = (bytes - kStlStart) % kStlTriangle;
  return error_at_byte(
      bytes, "truncated",
      sentence::of(
          "the bytes of this binary STL file of {} end after {} of them{}",
          sentence::count_of(triangles, "triangle"), (bytes - kStlStart) / kStlTriangle,
          (rest == 0 ? "" : " and " + sentence::count_of(rest, "byte") + " of the next one")));
}

/// Some programs write a colour for all triangles there.
bool has_color_in_header(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kColor = "COLOR=";
  const auto header = bytes.first(kStlHeader);
  return std::search(header.begin(), header.end(), kColor.begin(), kColor.end()) != header.end();
}

/// What of the header isn't kept, and where it and the size disagree: `count` triangles were read.
void add_notes(std::span<const std::uint8_t> bytes, std::size_t count, ParsedFile& file) {
  if (has_color_in_header(bytes)) file.notes.emplace_back("ignored the colour in the header");
  const std::uint64_t announced = announced_triangles(bytes);
  if (announced != count) {
    file.notes.push_back(
        sentence::of("the header promises {}, but the file has {}, which were read",
                     sentence::count_of(announced, "triangle"), count));
  }
  const std::size_t rest = bytes.size() - kStlStart - count * kStlTriangle;
  if (rest > 0) {
    file.notes.push_back(sentence::of("ignored the {} behind the {} that the header promises",
                                      sentence::count_of(rest, "byte"),
                                      sentence::count_of(count, "triangle")));
  }
}

}  // namespace

bool count_is_text(std::span<const std::uint8_t> bytes) {
  const std::span<const std::uint8_t> count = bytes.subspan(kStlHeader, kStlStart - kStlHeader);
  return std::all_of(count.begin(), count.end(), [](std::uint8_t byte) {
    return (byte >= ' ' && byte <= '~') || (byte >= '\t' && byte <= '\r');
  });
}

bool has_stl_triangles(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kLooked = 16;
  constexpr float kNothing = 1e-30F;
  if (bytes.size() < kStlStart + kStlTriangle || count_is_text(bytes)) return false;
  const std::size_t room = (bytes.size() - kStlStart) / kStlTriangle;
  const std::uint64_t announced = announced_triangles(bytes);
  const std::size_t looked =
      std::min({kLooked, room, announced == 0 ? room : std::size_t(announced)});
  const std::uint8_t* at = bytes.data() + kStlStart;
  bool are_nothing = true;
  for (std::size_t i = 0; i < looked; ++i, at += kStlTriangle) {
    std::array<float, 12> numbers;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      numbers[k] = load<float>(at + 4 * k, ByteOrder::kLittle);
    }
    if (!are_finite(numbers)) return false;
    are_nothing &=
        std::all_of(numbers.begin(), numbers.end(), [](float x) { return std::abs(x) < kNothing; });
    const float length = std::hypot(numbers[0], numbers[1], numbers[2]);
    if (length > 0.01F && std::abs(length - 1) > 0.01F) return false;
  }
  return !are_nothing;
}

Result<ParsedFile> read_stl_binary(std::span<const std::uint8_t> bytes, const Request& request) {
  const ParseOptions& options = request.options;
  if (bytes.size() < kStlStart) return too_short(bytes.size());
  const std::uint64_t count = triangles_of(bytes);
  if (count > (bytes.size() - kStlStart) / kStlTriangle) return ends_early(bytes.size(), count);
  const auto faces = static_cast<std::size_t>(count);

  TriangleWriter writer(bytes, request);
  SoupWriter& out = writer.out();
  writer.reserve(faces);
  const std::uint8_t* at = bytes.data() + kStlStart;
  SoupAttribute attribute = face_attribute();
  std::array<float, 9 * kBlock> numbers;
  for (std::size_t face = 0; face < faces && !out.out_of_memory(); face += kBlock) {
    out.reached(at);
    const std::size_t block = std::min(kBlock, faces - face);
    for (std::size_t i = 0; i < block; ++i) {
      for (std::size_t k = 0; k < 9; ++k) {
        numbers[9 * i + k] =
            load<float>(at + kStlTriangle * i + kCorners + 4 * k, ByteOrder::kLittle);
      }
    }
    const std::span<const float> read = std::span(numbers).first(9 * block);
    if (!options.for_repair && !are_finite(read)) return first_not_finite(face, read);
    out.begin_faces(block, at, kStlTriangle);
    writer.add(read);
    if (options.attributes && !read_values(at, face, block, faces, attribute)) {
      out.set_out_of_memory();
    }
    at += kStlTriangle * block;
  }
  if (std::optional<Error> error = check_size(out)) return *std::move(error);

  ParsedFile file{Format::kStl, std::move(out.soup()), {}, true};
  if (!attribute.values.empty()) file.attributes.push_back(std::move(attribute));
  add_notes(bytes, faces, file);
  return file;
}

}  // namespace halfedge::io
