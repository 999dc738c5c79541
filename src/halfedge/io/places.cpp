#include <halfedge/io/parse.h>
#include <halfedge/io/readers.h>
#include <halfedge/sentence.h>
#include <halfedge/sort.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <string_view>

namespace halfedge {
namespace {

using Bytes = std::span<const std::uint8_t>;

/// Where items start, in the order asked for.
class ItemPlaces {
 public:
  explicit ItemPlaces(std::span<const Index> items)
      : order_(items.size()), sorted_(in_order(items)), places_(sorted_) {}

  [[nodiscard]] io::Places& wanted() { return places_; }

  /// The lines, from 1, of those that were found; 0 of others.
  [[nodiscard]] std::vector<std::size_t> lines(Bytes bytes) const {
    std::vector<std::size_t> lines(order_.size(), 0);
    const char* counted = io::TextScanner(bytes).position();
    std::size_t line = 1;
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const char* const position = places_.positions()[i];
      if (position == nullptr) break;
      line += io::TextScanner::lines_between(counted, position);
      counted = position;
      lines[order_[i]] = line;
    }
    return lines;
  }
  /// The bytes, from 0, of those that were found; 0, where no item is, of others.
  [[nodiscard]] std::vector<std::size_t> offsets(Bytes bytes) const {
    std::vector<std::size_t> offsets(order_.size(), 0);
    const char* const begin = reinterpret_cast<const char*>(bytes.data());
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const char* const position = places_.positions()[i];
      if (position != nullptr) offsets[order_[i]] = static_cast<std::size_t>(position - begin);
    }
    return offsets;
  }
  /// Null where the file has no such item.
  [[nodiscard]] const char* position_of(Index item) const {
    const auto found = std::lower_bound(sorted_.begin(), sorted_.end(), item);
    return places_.positions()[static_cast<std::size_t>(found - sorted_.begin())];
  }

 private:
  [[nodiscard]] std::vector<Index> in_order(std::span<const Index> items) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    introsort(order_, [items](std::size_t a, std::size_t b) { return items[a] < items[b]; });
    std::vector<Index> sorted;
    sorted.reserve(items.size());
    for (const std::size_t i : order_) sorted.push_back(items[i]);
    return sorted;
  }

  std::vector<std::size_t> order_;
  std::vector<Index> sorted_;
  io::Places places_;
};

io::Request request_for(const io::WantedPlaces& wanted) {
  return {{.attributes = false, .for_repair = true}, wanted};
}

/// Which corner of a face is none of the vertices: the first. pre: there is one.
std::size_t missing_corner(const PolygonSoup& soup, Index face) {
  std::size_t corner = 3 * std::size_t{face};
  if (!soup.sizes.empty()) {
    corner = std::accumulate(soup.sizes.begin(), soup.sizes.begin() + face, std::size_t{0});
  }
  const std::size_t first = corner;
  while (soup.corners[corner] < soup.positions.size() / 3) ++corner;
  return corner - first;
}

/// What a face does that uses a vertex which is not there, with its number as the file has it.
/// `position`: where the face starts. cost: O(faces + corners of this one)
std::string missing_vertex(Bytes bytes, const PolygonSoup& soup, Index face, const char* position) {
  io::TextScanner text(bytes);
  text.move_to(position);
  const std::size_t corner = missing_corner(soup, face);
  for (std::size_t i = 0; i <= corner; ++i) {  // past the keyword, too
    text.skip_token();
    text.skip_blanks();
  }
  const std::size_t vertices = soup.positions.size() / 3;
  const std::string_view token = text.token();
  const std::string expected = vertices == 0 ? "the file has no vertices"
                               : token.starts_with('-')
                                   ? "fewer come before it"
                                   : sentence::of("vertices have the numbers 1 to {}", vertices);
  return sentence::of("Face {} uses vertex {}, but {}", face, io::quoted(token), expected);
}

const IndexList& located(const Error& problem) {
  const Witness& witness = problem.witness;
  return witness.faces.empty() ? witness.vertices : witness.faces;
}

}  // namespace

std::vector<std::size_t> lines_of_faces(Bytes bytes, Format format, std::span<const Index> faces) {
  ItemPlaces places(faces);
  const Result<ParsedFile> file =
      io::read_as(format, bytes, request_for({.faces = &places.wanted()}));
  if (!file || file.value().binary) return std::vector<std::size_t>(faces.size(), 0);
  return places.lines(bytes);
}

void add_places(std::vector<Error>& problems, Bytes bytes, Format format) {
  std::vector<Index> items[2];  // vertices, faces
  for (const Error& problem : problems) {
    std::vector<Index>& of_kind = items[problem.witness.faces.empty() ? 0 : 1];
    of_kind.insert(of_kind.end(), located(problem).begin(), located(problem).end());
  }
  if (items[0].empty() && items[1].empty()) return;
  ItemPlaces vertices(items[0]);
  ItemPlaces faces(items[1]);
  const Result<ParsedFile> file = io::read_as(
      format, bytes, request_for({.vertices = &vertices.wanted(), .faces = &faces.wanted()}));
  if (!file) return;  // memory was exhausted
  const bool binary = file.value().binary;
  const std::vector<std::size_t> numbers[2] = {
      binary ? vertices.offsets(bytes) : vertices.lines(bytes),
      binary ? faces.offsets(bytes) : faces.lines(bytes)};
  std::size_t at[2] = {0, 0};
  for (Error& problem : problems) {
    const std::size_t kind = problem.witness.faces.empty() ? 0 : 1;
    const char* const position = kind == 1 ? faces.position_of(problem.witness.faces[0]) : nullptr;
    if (position != nullptr && format == Format::kObj && problem.code == "index-out-of-range") {
      constexpr std::string_view kDone = ": it was left out.";  // by a repair
      const bool is_repaired = problem.message.ends_with(kDone);
      problem.message =
          missing_vertex(bytes, file.value().soup, problem.witness.faces[0], position);
      problem.message += is_repaired ? kDone : ".";
    }
    std::string list;
    std::size_t found = 0;
    for (std::size_t i = 0; i < located(problem).size(); ++i) {
      const std::size_t number = numbers[kind][at[kind]++];
      if (number == 0 || ++found > sentence::kListed) continue;
      list += list.empty() ? " " : ", ";
      list += std::to_string(number);
    }
    if (list.empty()) continue;
    if (found > sentence::kListed) list += " and others";
    const char* const plural = list.find(',') == std::string::npos ? "" : "s";
    problem.message += sentence::of(" ({}{}{})", binary ? "Byte" : "Line", plural, list);
  }
}

}  // namespace halfedge
