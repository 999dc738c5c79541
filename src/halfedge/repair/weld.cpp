#include <halfedge/inlining.h>
#include <halfedge/repair/weld.h>
#include <halfedge/sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace halfedge::repair {

namespace {

bool is_finite(const float* p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

std::uint64_t mix(std::uint64_t a, std::uint64_t b) {
  std::uint64_t h = (a ^ 0x9E37'79B9'7F4A'7C15U) * 0xD6E8'FEB8'6659'FD93U;
  h ^= (h >> 32U) ^ b;
  h *= 0xD6E8'FEB8'6659'FD93U;
  return h ^ (h >> 32U);
}

std::uint64_t hash_of(const float* p, std::uint64_t seed) {
  std::array<std::uint32_t, 3> bits{};
  for (std::size_t i = 0; i < 3; ++i) {
    const float normal = p[i] + 0.0F;  // -0 becomes 0
    std::memcpy(&bits[i], &normal, sizeof normal);
  }
  return mix((bits[0] | std::uint64_t{bits[1]} << 32U) ^ seed, bits[2]);
}

// Gives each different position a number, that of its first vertex in order. In linear time also
// for positions that were chosen to collide: when too many do, others are the ones that do.
class ExactWelder {
 public:
  ExactWelder(std::span<const float> positions, Vertices& vertices)
      : positions_(positions), vertices_(vertices) {}

  [[nodiscard]] bool run() {
    if (!slots_.resize(1024, Slot{})) return false;
    for (std::size_t v = 0; v < vertices_.of_input.size(); ++v) {
      const float* p = &positions_[3 * v];
      if (!is_finite(p)) continue;
      Slot& slot = find(p);
      if (slot.vertex == kNone) {
        slot = {{p[0], p[1], p[2]}, Index(vertices_.origin.size())};
        vertices_.of_input[v] = slot.vertex;
        if (!vertices_.origin.push_back(Index(v))) return false;
      } else {
        vertices_.of_input[v] = slot.vertex;
      }
      const bool is_full = 2 * vertices_.origin.size() > slots_.size();
      // That many steps have paid for a new table.
      const bool is_slow = steps_ > 8 * slots_.size();
      if (is_slow) seed_ = mix(seed_ + reinterpret_cast<std::uintptr_t>(slots_.data()), v);
      if ((is_full || is_slow) && !rebuild(is_full ? 2 * slots_.size() : slots_.size())) {
        return false;
      }
    }
    return true;
  }

 private:
  // With the position: one line of memory to wait for, not three.
  struct Slot {
    std::array<float, 3> position = {};
    Index vertex = kNone;
  };

  [[nodiscard]] Slot& find(const float* p) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = std::size_t(hash_of(p, seed_)) & mask;
    while (slots_[i].vertex != kNone) {
      const std::array<float, 3>& q = slots_[i].position;
      if (p[0] == q[0] && p[1] == q[1] && p[2] == q[2]) break;
      i = (i + 1) & mask;
      ++steps_;
    }
    return slots_[i];
  }

  [[nodiscard]] bool rebuild(std::size_t size) {
    slots_.reset();
    if (!slots_.resize(size, Slot{})) return false;
    for (Index i = 0; i < vertices_.origin.size(); ++i) {
      const float* p = &positions_[3 * std::size_t{vertices_.origin[i]}];
      find(p) = {{p[0], p[1], p[2]}, i};
    }
    steps_ = 0;
    return true;
  }

  std::span<const float> positions_;
  Vertices& vertices_;
  Array<Slot> slots_;
  std::uint64_t seed_ = 0;
  std::size_t steps_ = 0;  // beyond the first slots looked at, since the table was made
};

// Joins different positions that are closer than a tolerance, in groups around leaders, which are
// hashed by cells of a grid. A cell is twice as wide as the tolerance, so what is near a position
// lies in its cell and in those on its nearer sides, eight in all. Positions that were chosen to
// collide cost no more: when too many do, others are the ones that do.
class NearWelder {
 public:
  NearWelder(std::span<const float> positions, double tolerance, Vertices& vertices)
      : positions_(positions),
        square_(tolerance * tolerance),
        cell_(2.000002 * tolerance),  // no rounding may hide a neighbour
        vertices_(vertices) {}

  [[nodiscard]] bool run() {
    const std::size_t count = vertices_.size();
    Array<Index> order;
    std::size_t slots = 64;
    while (slots < count) slots *= 2;
    if (!order.recreate(count) || !leader_of_.recreate(count) ||
        !next_in_group_.resize(count, kNone) || !slots_.recreate(slots)) {
      return false;
    }
    fill_slots();
    for (Index i = 0; i < count; ++i) order[i] = i;
    introsort(order.begin(), order.end(), [this](Index a, Index b) {
      const float* p = at(a);
      const float* q = at(b);
      return std::lexicographical_compare(p, p + 3, q, q + 3);
    });
    for (const Index i : order) {
      if (!place(i)) return false;
    }
    return renumber();
  }

 private:
  struct Leader {
    Index vertex;
    Index next_in_slot;
    Index members;
    std::array<float, 3> low;
    std::array<float, 3> high;
  };
  using Cell = std::array<double, 3>;

  // A group that has become larger is known by its box alone, and a position meets so many leaders:
  // tolerances far too large cost time in proportion.
  static constexpr Index kCompared = 32;
  static constexpr int kMet = 256;

  [[nodiscard]] const float* at(Index i) const {
    return &positions_[3 * std::size_t{vertices_.origin[i]}];
  }
  [[nodiscard]] static double square_distance(const float* p, const float* q) {
    const double x = double{p[0]} - double{q[0]};
    const double y = double{p[1]} - double{q[1]};
    const double z = double{p[2]} - double{q[2]};
    return x * x + y * y + z * z;
  }

  [[nodiscard]] Cell cell_of(const float* p) const {
    Cell cell{};
    for (std::size_t k = 0; k < 3; ++k) cell[k] = std::floor(double{p[k]} / cell_);
    return cell;
  }
  [[nodiscard]] std::size_t slot_of(const Cell& cell) const {
    std::array<std::uint64_t, 3> bits{};
    for (std::size_t i = 0; i < 3; ++i) {
      const double normal = cell[i] + 0.0;
      std::memcpy(&bits[i], &normal, sizeof normal);
    }
    return std::size_t(mix(mix(bits[0] ^ seed_, bits[1]), bits[2])) & (slots_.size() - 1);
  }

  [[nodiscard]] bool place(Index i) {
    const float* p = at(i);
    const Cell own = cell_of(p);
    Cell near{};
    for (std::size_t k = 0; k < 3; ++k) {
      near[k] = own[k] + (double{p[k]} - own[k] * cell_ < cell_ / 2 ? -1 : 1);
    }
    Index best = kNone;
    double nearest = square_;
    int met = 0;
    for (unsigned corner = 0; corner < 8; ++corner) {
      const Cell cell = {(corner & 1U) != 0 ? near[0] : own[0],
                         (corner & 2U) != 0 ? near[1] : own[1],
                         (corner & 4U) != 0 ? near[2] : own[2]};
      Index next = slots_[slot_of(cell)];
      while (next != kNone && met < kMet) {
        const Index l = next;
        const Leader& leader = leaders_[l];
        next = leader.next_in_slot;
        if (cell_of(at(leader.vertex)) != cell) {
          ++steps_;
          continue;
        }
        ++met;
        const double square = square_distance(p, at(leader.vertex));
        const bool is_better = square < nearest || (square == nearest && l < best);
        if (square < square_ && is_better && fits(p, leader)) best = l, nearest = square;
      }
    }
    if (best != kNone) {
      join(i, best);
      return true;
    }
    // That many steps have paid for new places.
    if (steps_ > 8 * slots_.size()) {
      seed_ = mix(seed_ + reinterpret_cast<std::uintptr_t>(slots_.data()), i);
      fill_slots();
    }
    leader_of_[i] = i;
    Index& head = slots_[slot_of(own)];
    const Leader leader{i, head, 1, {p[0], p[1], p[2]}, {p[0], p[1], p[2]}};
    head = Index(leaders_.size());
    return leaders_.push_back(leader);
  }

  // Those of a cell stay in their order, the last one first.
  void fill_slots() {
    std::fill(slots_.begin(), slots_.end(), kNone);
    for (Index l = 0; l < leaders_.size(); ++l) {
      Index& head = slots_[slot_of(cell_of(at(leaders_[l].vertex)))];
      leaders_[l].next_in_slot = head;
      head = l;
    }
    steps_ = 0;
  }

  // Whether p is closer than the tolerance to all of a group.
  [[nodiscard]] bool fits(const float* p, const Leader& leader) const {
    if (leader.members <= kCompared) {
      Index member = next_in_group_[leader.vertex];
      while (member != kNone && square_distance(p, at(member)) < square_) {
        member = next_in_group_[member];
      }
      return member == kNone;
    }
    std::array<float, 3> farthest{};
    for (std::size_t k = 0; k < 3; ++k) {
      const bool is_low =
          double{p[k]} - double{leader.low[k]} > double{leader.high[k]} - double{p[k]};
      farthest[k] = is_low ? leader.low[k] : leader.high[k];
    }
    return square_distance(p, farthest.data()) < square_;
  }

  void join(Index i, Index l) {
    Leader& leader = leaders_[l];
    leader_of_[i] = leader.vertex;
    next_in_group_[i] = next_in_group_[leader.vertex];
    next_in_group_[leader.vertex] = i;
    ++leader.members;
    const float* p = at(i);
    for (std::size_t k = 0; k < 3; ++k) {
      leader.low[k] = std::min(leader.low[k], p[k]);
      leader.high[k] = std::max(leader.high[k], p[k]);
    }
  }

  // Groups in the order of their first vertices, each at the position of its leader.
  [[nodiscard]] bool renumber() {
    Array<Index> origin;
    Array<Index> number;
    if (!origin.reserve(leaders_.size()) || !number.resize(vertices_.size(), kNone)) return false;
    for (Index& own : vertices_.of_input) {
      if (own == kNone) continue;
      const Index leader = leader_of_[own];
      if (number[leader] == kNone) {
        number[leader] = Index(origin.size());
        (void)origin.push_back(vertices_.origin[leader]);  // reserved above
      }
      own = number[leader];
    }
    vertices_.origin = std::move(origin);
    return true;
  }

  std::span<const float> positions_;
  double square_;
  double cell_;
  Vertices& vertices_;
  Array<Index> slots_;
  Array<Leader> leaders_;
  Array<Index> leader_of_;
  Array<Index> next_in_group_;
  std::uint64_t seed_ = 0;
  std::size_t steps_ = 0;  // past leaders of other cells, since the slots were filled
};

[[nodiscard]] bool keep_apart(std::span<const float> positions, Vertices& out) {
  if (!out.origin.reserve(out.of_input.size())) return false;
  for (std::size_t v = 0; v < out.of_input.size(); ++v) {
    if (!is_finite(&positions[3 * v])) continue;
    out.of_input[v] = Index(out.origin.size());
    (void)out.origin.push_back(Index(v));  // reserved above
  }
  return true;
}

}  // namespace

HALFEDGE_NOINLINE bool weld(std::span<const float> positions, std::optional<double> tolerance,
                            Vertices& out) {
  if (!out.of_input.resize(positions.size() / 3, kNone)) return false;
  if (!tolerance) return keep_apart(positions, out);
  if (!ExactWelder(positions, out).run()) return false;
  // No two different floats are closer than this.
  if (*tolerance <= double{std::numeric_limits<float>::denorm_min()}) return true;
  return NearWelder(positions, *tolerance, out).run();
}

}  // namespace halfedge::repair
