#include <halfedge/directed_edges/convert.h>
#include <halfedge/directed_edges/validate.h>
#include <halfedge/sentence.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace halfedge {

namespace {

Error out_of_memory(Index halfedges) {
  return {"out-of-memory",
          sentence::of("There is not enough memory for a mesh of {} halfedges.", halfedges)};
}

// ---- to the full mesh

// The edges of which a vertex is the smaller one, as build_from_polygons numbers them (see
// build/groups.h).
struct EdgeNumbers {
  Index up = 0;      // sides that lead to larger vertices: each has an edge
  Index down = 0;    // sides that come from them
  Index single = 0;  // of these, those that have no other side

  // Once all groups are counted, the numbers of the next edges: of those with a side that runs up;
  // of the others, while there is room; and after that.
  Index next_up = 0;
  Index next_single = 0;
  Index room_end = 0;
  Index next_after = 0;

  [[nodiscard]] Index room() const { return std::max(up, down); }
  Index number_single() { return next_single < room_end ? next_single++ : next_after++; }
};

void begin_groups(Array<EdgeNumbers>& groups) {
  Index begin = 0;
  for (EdgeNumbers& group : groups) {
    group.next_up = begin;
    group.next_single = begin + group.up;
    begin += group.room();
    group.room_end = begin;
  }
  for (EdgeNumbers& group : groups) {
    group.next_after = begin;
    begin += group.up + group.single - group.room();
  }
}

// Gives each halfedge the index that build_from_polygons would give it.
[[nodiscard]] bool number_halfedges(const DirectedLinks& links, Array<Index>& numbers) {
  Array<EdgeNumbers> groups;
  if (!groups.resize(links.vertex_halfedge.size(), {}) ||
      !numbers.recreate(links.opposite.size())) {
    return false;
  }
  const auto visit_sides = [&](const auto& visit) {
    for (Index h = 0; h < links.sides; ++h) {
      const Index from = links.from_vertex(h);
      const Index to = links.to_vertex[h];
      visit(h, groups[std::min(from, to)], from < to, links.is_boundary(links.opposite[h]));
    }
  };
  visit_sides([](Index, EdgeNumbers& group, bool runs_up, bool is_single) {
    (runs_up ? group.up : group.down) += 1;
    group.single += !runs_up && is_single ? 1 : 0;
  });
  begin_groups(groups);
  visit_sides([&](Index h, EdgeNumbers& group, bool runs_up, bool is_single) {
    if (!runs_up && !is_single) return;  // numbered with the side that runs up
    const Index edge = runs_up ? group.next_up++ : group.number_single();
    numbers[h] = 2 * edge + Index{!runs_up};
    numbers[links.opposite[h]] = numbers[h] ^ 1U;
  });
  return true;
}

[[nodiscard]] bool write_links(const DirectedLinks& from, Links& to) {
  Array<Index> numbers;
  const std::size_t halfedges = from.opposite.size();
  if (!number_halfedges(from, numbers) || !to.next.recreate(halfedges) ||
      !to.prev.recreate(halfedges) || !to.to_vertex.recreate(halfedges) ||
      !to.face.recreate(halfedges) || !to.vertex_halfedge.recreate(from.vertex_halfedge.size()) ||
      !to.face_halfedge.recreate(from.sides / 3)) {
    return false;
  }
  for (Index h = 0; h < halfedges; ++h) {
    const Index number = numbers[h];
    to.next[number] = numbers[from.next(h)];
    to.prev[number] = numbers[from.prev(h)];
    to.to_vertex[number] = from.to_vertex[h];
    to.face[number] = from.is_boundary(h) ? kNone : h / 3;
  }
  for (std::size_t v = 0; v < to.vertex_halfedge.size(); ++v) {
    const Index anchor = from.vertex_halfedge[v];
    to.vertex_halfedge[v] = anchor == kNone ? kNone : numbers[anchor];
  }
  for (Index f = 0; f < to.face_halfedge.size(); ++f)
    to.face_halfedge[f] = numbers[3 * std::size_t{f}];
  return true;
}

// ---- from the full mesh

Error corrupt(const std::string& what) {
  return {"corrupt-connectivity",
          sentence::complete(sentence::of("{}: validate tells more", what))};
}

Result<void> check_slots(const Links& links, std::size_t floats) {
  const std::size_t size = links.next.size();
  if (size % 2 != 0 || links.to_vertex.size() != size || links.face.size() != size ||
      floats != 3 * links.vertex_halfedge.size()) {
    return corrupt("the arrays of the mesh differ in length");
  }
  const auto deleted = [](const char* kind, Index index) {
    return Error{
        "deleted-item",
        sentence::of(
            "{} {} is deleted; Directed Edges have no deleted items: compact the mesh first.", kind,
            index)};
  };
  const auto find_deleted = [](const Array<Index>& array, std::size_t stride) {
    std::size_t slot = 0;
    while (slot < array.size() && !is_deleted_link(array[slot])) slot += stride;
    return slot < array.size() ? Index(slot / stride) : kNone;
  };
  const Index face = find_deleted(links.face_halfedge, 1);
  if (face != kNone) return deleted("Face", face);
  const Index edge = find_deleted(links.next, 2);
  if (edge != kNone) return deleted("Edge", edge);
  const Index vertex = find_deleted(links.vertex_halfedge, 1);
  if (vertex != kNone) return deleted("Vertex", vertex);
  return {};
}

// Walks around each face of a mesh whose links may be anything.
class FaceNumbers {
 public:
  FaceNumbers(const Links& links, Array<Index>& numbers) : links_(links), numbers_(numbers) {}

  // Gives the halfedges of face f the indices 3f to 3f + 2. pre: all numbers are kNone.
  Result<void> give() {
    for (Index f = 0; f < links_.face_halfedge.size(); ++f) {
      const Index first = links_.face_halfedge[f];
      Index h = first;
      for (Index i = 0; i < 3; ++i) {
        if (!is_free_side(h, f)) return corrupt(sentence::of("face {} has no loop", f));
        numbers_[h] = 3 * f + i;
        h = links_.next[h];
        if (h == first && i < 2) return other_degree(f, i + 1);
      }
      if (h != first) return other_degree(f, degree_from(h, first));
    }
    return {};
  }

 private:
  [[nodiscard]] bool is_free_side(Index h, Index f) const {
    return h < numbers_.size() && numbers_[h] == kNone && links_.face[h] == f;
  }

  // pre: `h` is the fourth halfedge of a loop through `first`.
  [[nodiscard]] Index degree_from(Index h, Index first) const {
    Index degree = 3;
    for (; h != first && h < numbers_.size() && degree < numbers_.size(); ++degree) {
      h = links_.next[h];
    }
    return degree;
  }

  static Error other_degree(Index f, Index degree) {
    return {"not-a-triangle",
            sentence::of("Face {} has {}{}; Directed Edges hold triangles only.", f, degree,
                         degree == 1 ? " corner" : " corners"),
            {.faces = {f}}};
  }

  const Links& links_;
  Array<Index>& numbers_;
};

// Numbers what is left, the boundary, in the order of the opposites, as the builder does.
// `by_number` is scratch with an entry for each halfedge.
Result<void> number_boundary(const Links& from, Index sides, Array<Index>& by_number,
                             Array<Index>& numbers) {
  const Index halfedges = Index(numbers.size());
  for (Index h = 0; h < halfedges; ++h) {
    if (numbers[h] != kNone) by_number[numbers[h]] = h;
  }
  Index count = sides;
  for (Index n = 0; n < sides; ++n) {
    const Index o = by_number[n] ^ 1U;
    if (numbers[o] != kNone) continue;
    if (from.face[o] != kNone) {
      return corrupt(sentence::of("halfedge {} is not in the loop of its face", o));
    }
    numbers[o] = count++;
  }
  if (count != halfedges) return corrupt("an edge has no face on either side");
  return {};
}

Result<void> read_halfedges(const Links& from, const Array<Index>& numbers, DirectedLinks& to) {
  const Index halfedges = Index(numbers.size());
  std::fill(to.boundary_prev.begin(), to.boundary_prev.end(), kNone);
  for (Index h = 0; h < halfedges; ++h) {
    const Index n = numbers[h];
    if (from.to_vertex[h] >= from.vertex_halfedge.size() || from.next[h] >= halfedges) {
      return corrupt(sentence::of("a link of halfedge {} leads out of range", h));
    }
    to.opposite[n] = numbers[h ^ 1U];
    to.to_vertex[n] = from.to_vertex[h];
    if (n < to.sides) continue;
    const Index next = numbers[from.next[h]];
    if (next < to.sides) {
      return corrupt(sentence::of("the boundary halfedge {} leads into a face", h));
    }
    to.boundary_next[n - to.sides] = next;
    to.boundary_prev[next - to.sides] = n;
  }
  return {};
}

Result<void> read_anchors(const Links& from, const Array<Index>& numbers, DirectedLinks& to) {
  for (Index v = 0; v < from.vertex_halfedge.size(); ++v) {
    const Index anchor = from.vertex_halfedge[v];
    if (anchor != kNone && anchor >= numbers.size()) {
      return corrupt(sentence::of("the anchor of vertex {} is out of range", v));
    }
    to.vertex_halfedge[v] = anchor == kNone ? kNone : numbers[anchor];
  }
  return {};
}

Result<void> read_links(const Links& from, DirectedLinks& to) {
  const Index halfedges = Index(from.next.size());
  Array<Index> numbers;
  if (!numbers.resize(halfedges, kNone)) return out_of_memory(halfedges);
  if (Result<void> numbered = FaceNumbers(from, numbers).give(); !numbered) return numbered;

  to.sides = Index(3 * from.face_halfedge.size());
  const std::size_t boundary = halfedges - to.sides;
  if (!to.opposite.recreate(halfedges) || !to.to_vertex.recreate(halfedges) ||
      !to.boundary_next.recreate(boundary) || !to.boundary_prev.recreate(boundary) ||
      !to.vertex_halfedge.recreate(from.vertex_halfedge.size())) {
    return out_of_memory(halfedges);
  }
  Result<void> result = number_boundary(from, to.sides, to.opposite, numbers);
  if (result) result = read_halfedges(from, numbers, to);
  if (result) result = read_anchors(from, numbers, to);
  return result;
}

}  // namespace

Result<void> to_mesh(const DirectedEdgesMesh& from, Mesh& to) {
  to.clear();
  const std::vector<Problem> problems = validate(from, 1);
  if (has_errors(problems)) return Error{"corrupt-connectivity", problems.front().message};
  if (write_links(from.links(), to.mutable_links()) &&
      to.mutable_positions().assign(from.positions()) && to.fit_attributes()) {
    return {};
  }
  to.clear();
  return out_of_memory(from.halfedge_count());
}

template <Storage kStored>
requires StoresSurface<BasicMesh<kStored>> Result<void> from_mesh(const BasicMesh<kStored>& from,
                                                                  DirectedEdgesMesh& to) {
  to.clear();
  Result<void> result = check_slots(from.links(), from.positions().size());
  if (result) result = read_links(from.links(), to.mutable_links());
  if (result && !to.mutable_positions().assign(from.positions())) {
    result = out_of_memory(from.halfedge_slots());
  }
  if (!result) to.clear();
  return result;
}

template Result<void> from_mesh(const Mesh&, DirectedEdgesMesh&);
template Result<void> from_mesh(const BasicMesh<kWithoutPrev>&, DirectedEdgesMesh&);
template Result<void> from_mesh(const BasicMesh<kPrevAtRunTime>&, DirectedEdgesMesh&);

}  // namespace halfedge
