#include <halfedge/io/live_mesh.h>
#include <halfedge/io/text_scanner.h>
#include <halfedge/sentence.h>

#include <algorithm>

namespace halfedge::io {

namespace {

std::string name_of_attribute(const Attribute& attribute) {
  return sentence::of("the {} attribute {}", name_of(attribute.kind()), quoted(attribute.name()));
}

}  // namespace

std::optional<Error> LiveMesh::prepare() {
  const std::size_t slots = source_.positions.size() / 3;
  vertex_count_ = static_cast<Index>(slots);
  if (!source_.is_deleted.empty()) {
    if (!numbers_.resize(slots)) return no_memory_for_a_file();
    vertex_count_ = 0;
    for (Index v = 0; v < slots; ++v) numbers_[v] = is_live(v) ? vertex_count_++ : kNone;
  }
  const auto bad = std::find_if(source_.faces.items.begin(), source_.faces.items.end(),
                                [&](Index v) { return v >= slots || !is_live(v); });
  if (bad != source_.faces.items.end()) {
    return Error{
        "corrupt-connectivity",
        sentence::of("a face has the vertex {}, which is no live one: validate names the face",
                     *bad)};
  }
  for_each_face([this](Index, std::span<const Index> corners) {
    const auto degree = static_cast<Index>(corners.size());
    ++face_count_;
    largest_degree_ = std::max(largest_degree_, degree);
    triangle_count_ += degree < 3 ? 0 : degree - 2;
  });
  return std::nullopt;
}

bool LiveMesh::are_joined(Index a, Index b) const {
  const std::size_t rows = source_.neighbours.offsets.size();
  if (std::size_t{std::max(a, b)} + 1 >= rows) return false;
  const std::span<const Index> of_a = row_of(source_.neighbours, a);
  const std::span<const Index> of_b = row_of(source_.neighbours, b);
  const bool from_a = of_a.size() <= of_b.size();
  const std::span<const Index> row = from_a ? of_a : of_b;
  return std::find(row.begin(), row.end(), from_a ? b : a) != row.end();
}

std::vector<const Attribute*> LiveMesh::attributes(ItemKind kind) const {
  std::vector<const Attribute*> list;
  if (source_.attributes == nullptr) return list;
  for (const auto& column : source_.attributes->of(kind)) {
    if (!column->is_generation()) list.push_back(column.get());
  }
  return list;
}

void LiveMesh::leave_out(const Attribute& attribute, const std::string& why) const {
  taken_.push_back(&attribute);
  notes_.push_back(sentence::of("left out {}: {}", name_of_attribute(attribute), why));
}

void LiveMesh::leave_out_rest(const std::string& why) const {
  for (const ItemKind kind : kItemKinds) {
    for (const Attribute* attribute : attributes(kind)) {
      if (std::find(taken_.begin(), taken_.end(), attribute) == taken_.end()) {
        leave_out(*attribute, why);
      }
    }
  }
}

void LiveMesh::note_change(const Attribute& attribute, const std::string& form) const {
  notes_.push_back(sentence::of("wrote {} {}", name_of_attribute(attribute), form));
}

}  // namespace halfedge::io
