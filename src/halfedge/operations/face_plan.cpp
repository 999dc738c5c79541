#include <halfedge/decorator/refusal.h>
#include <halfedge/operations/face_plan.h>
#include <halfedge/operations/surgery_refusals.h>
#include <halfedge/sort.h>

#include <algorithm>
#include <utility>

namespace halfedge::operations::internal {

namespace {

constexpr std::uint64_t kEmpty = ~std::uint64_t{0};

std::uint64_t key_of(Vertex a, Vertex b) {
  const Vertex low = std::min(a, b);
  const Vertex high = std::max(a, b);
  return std::uint64_t{low.index()} << 32U | high.index();
}

// Each bit of the result depends on all of `h`.
std::uint64_t mix(std::uint64_t h) {
  h *= 0x9E37'79B9'7F4A'7C15U;
  h = (h ^ (h >> 32U)) * 0xD6E8'FEB8'6659'FD93U;
  return h ^ (h >> 32U);
}

}  // namespace

std::size_t PlannedEdges::slot_of(std::uint64_t key) {
  const std::size_t mask = slots_.size() - 1;
  std::size_t i = std::size_t(mix(key ^ seed_)) & mask;
  while (slots_[i] != kEmpty && slots_[i] != key) {
    i = (i + 1) & mask;
    ++steps_;
  }
  return i;
}

bool PlannedEdges::contains(Vertex a, Vertex b) {
  return count_ > 0 && slots_[slot_of(key_of(a, b))] != kEmpty;
}

bool PlannedEdges::insert(Vertex a, Vertex b) {
  if (2 * count_ >= slots_.size()) {
    if (!rebuild(std::max<std::size_t>(64, 2 * slots_.size()))) return false;
  } else if (steps_ > 8 * slots_.size()) {  // that many have paid for a new table
    seed_ = mix(seed_ + reinterpret_cast<std::uintptr_t>(slots_.data()));  // which no file knows
    if (!rebuild(slots_.size())) return false;
  }
  const std::uint64_t key = key_of(a, b);
  slots_[slot_of(key)] = key;
  ++count_;
  return true;
}

bool PlannedEdges::rebuild(std::size_t slots) {
  Array<std::uint64_t> old = std::move(slots_);
  slots_ = {};
  if (!slots_.resize(slots, kEmpty)) return false;
  for (const std::uint64_t key : old) {
    if (key != kEmpty) slots_[slot_of(key)] = key;
  }
  steps_ = 0;
  return true;
}

// Around both in step, so that a vertex of high valence costs no more than the other one.
Edge find_edge(const Links& links, Vertex a, Vertex b) {
  const Index first_of_a = links.vertex_halfedge[a.index()];
  const Index first_of_b = links.vertex_halfedge[b.index()];
  Index from_a = first_of_a;
  Index from_b = first_of_b;
  do {
    if (links.to_vertex[from_a] == b.index()) return Edge(from_a / 2);
    if (links.to_vertex[from_b] == a.index()) return Edge(from_b / 2);
    from_a = links.next[from_a ^ 1U];
    from_b = links.next[from_b ^ 1U];
  } while (from_a != first_of_a && from_b != first_of_b);
  return {};
}

// The diagonals along which the last face is cut: those from ears_[begin] on.
void FacePlan::list_diagonals(std::size_t begin) {
  const std::size_t n = corners_.size();
  for (std::size_t i = 0; i < n; ++i) {
    next_[i] = Index(i + 1 == n ? 0 : i + 1);
    prev_[i] = Index(i == 0 ? n - 1 : i - 1);
  }
  diagonals_.clear();
  for (std::size_t i = begin; i < ears_.size(); ++i) {
    const Index a = prev_[ears_[i]];
    const Index b = next_[ears_[i]];
    next_[a] = b;
    prev_[b] = a;
    (void)diagonals_.push_back({std::min(a, b), std::max(a, b)});  // there is room
  }
}

// Puts those that join what is joined already on the list of the forbidden. False when memory is
// exhausted.
bool FacePlan::forbid_existing(const Links& links) {
  for (const Diagonal& diagonal : diagonals_) {
    const Vertex a = corners_[diagonal.a];
    const Vertex b = corners_[diagonal.b];
    if (!find_edge(links, a, b).valid() && !planned_.contains(a, b)) continue;
    if (!forbidden_.push_back(diagonal)) return false;
  }
  introsort(forbidden_.begin(), forbidden_.end());
  return true;
}

Result<void> FacePlan::add(const Links& links, std::span<const float> positions, Halfedge first,
                           bool has_others) {
  const auto no_memory = [] { return decorator::internal::no_memory("the triangles"); };
  corners_.clear();
  points_.clear();
  forbidden_.clear();
  Index h = first.index();
  do {
    const Index v = links.to_vertex[h];
    const std::size_t at = 3 * std::size_t{v};
    const Point point =
        positions.empty() ? Point{} : Point{positions[at], positions[at + 1], positions[at + 2]};
    if (!corners_.push_back(Vertex(v)) || !points_.push_back(point)) return no_memory();
    h = links.next[h];
  } while (h != first.index());
  const std::size_t n = corners_.size();
  largest_ = std::max(largest_, n);
  if (n <= 3) return {};  // degenerate complexes have faces of fewer corners
  if (!next_.resize(n) || !prev_.resize(n) || !diagonals_.reserve(n)) return no_memory();

  const std::size_t begin = ears_.size();
  for (;;) {
    const PolygonTriangulator::Outcome outcome =
        triangulator_.run(points_.span(), forbidden_.span(), ears_);
    if (outcome == PolygonTriangulator::Outcome::kOutOfMemory) return no_memory();
    if (outcome == PolygonTriangulator::Outcome::kBlocked) {
      const Vertex a = corners_[triangulator_.blocked().a];
      const Vertex b = corners_[triangulator_.blocked().b];
      return no_triangulation(Face(links.face[first.index()]), a, b, find_edge(links, a, b));
    }
    list_diagonals(begin);
    const std::size_t known = forbidden_.size();
    if (!forbid_existing(links)) return no_memory();
    if (forbidden_.size() == known) break;
    (void)ears_.resize(begin);
  }
  if (!has_others) return {};
  for (const Diagonal& diagonal : diagonals_) {
    if (!planned_.insert(corners_[diagonal.a], corners_[diagonal.b])) return no_memory();
  }
  return {};
}

}  // namespace halfedge::operations::internal
