#include <halfedge/algorithms/polygon_cutter.h>

#include <utility>

namespace halfedge {

// ---- planned edges

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

// ---- polygons

PolygonCutter::Outcome PolygonCutter::cut_anyhow(std::span<const Point> points,
                                                 Array<Index>& ears) {
  forbidden_.clear();
  return cut_once(points, ears);
}

bool PolygonCutter::keep_diagonals(std::span<const Vertex> corners) {
  for (const Diagonal& diagonal : diagonals_) {
    const Vertex a = corners[diagonal.a];
    const Vertex b = corners[diagonal.b];
    if (!planned_.contains(a, b) && !planned_.insert(a, b)) return false;
  }
  return true;
}

// Along diagonals that aren't forbidden. Lists them.
PolygonCutter::Outcome PolygonCutter::cut_once(std::span<const Point> points, Array<Index>& ears) {
  const std::size_t n = points.size();
  if (!next_.recreate(n) || !prev_.recreate(n) || !diagonals_.reserve(n)) {
    return Outcome::kOutOfMemory;
  }
  const std::size_t begin = ears.size();
  const Outcome outcome = triangulator_.run(points, forbidden_.span(), ears);
  if (outcome != Outcome::kDone) return outcome;
  diagonals_.clear();
  cut_off(ears.span().subspan(begin), [this](Index before, Index, Index after) {
    (void)diagonals_.push_back({std::min(before, after), std::max(before, after)});  // in the room
  });
  return Outcome::kDone;
}

}  // namespace halfedge
