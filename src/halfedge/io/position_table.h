#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/handle.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace halfedge::io {

/// Welds: the index of each distinct position, in the order in which they came. Positions are equal
/// if all bits are, but for the sign of zero.
///
/// An open-addressing table of indices, at most half full. Expected O(1) a look-up, also for
/// positions that were chosen to collide: when too many do, others are the ones that do.
class PositionTable {
 public:
  /// Room for so many, so that the table need not grow. False when memory is exhausted.
  [[nodiscard]] bool reserve(std::size_t count) { return grow({}, count); }

  /// Gives each of `count` positions at `xyz` its index in `positions`, to which those are appended
  /// that aren't there yet. False when memory is exhausted. Quickest where there are many at once.
  [[nodiscard]] bool weld(const float* xyz, std::size_t count, Array<float>& positions,
                          Index* indices) {
    const std::size_t before = positions.size() / 3;
    if (2 * (before + count) > slots_.size() && !grow(positions.span(), 2 * (before + count))) {
      return false;
    }
    // That many steps have paid for a new table.
    if (steps_ > 8 * slots_.size()) {
      seed_ = seed_ * 0x9E37'79B9'7F4A'7C15U + Key(xyz).hash(seed_);
      seed_ += reinterpret_cast<std::uintptr_t>(slots_.data());  // which no file knows
      if (!grow(positions.span(), slots_.size() / 2 - 1)) return false;
    }
    if (!positions.reserve_more(3 * count)) return false;
    // Where to look first is computed far ahead of the look, so that memory isn't waited for.
    constexpr std::size_t kAhead = 32;
    std::size_t home[kAhead];
    const auto aim = [&](std::size_t i) {
      home[i % kAhead] = Key(xyz + 3 * i).hash(seed_) & mask();
      __builtin_prefetch(&slots_[home[i % kAhead]]);
    };
    for (std::size_t i = 0; i < std::min(kAhead, count); ++i) aim(i);
    Index end = static_cast<Index>(before);
    float* const known = positions.data();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t slot = home[i % kAhead];
      if (i + kAhead < count) aim(i + kAhead);
      indices[i] = find_or_claim(xyz + 3 * i, slot, known, end);
      if (indices[i] != end) continue;
      std::memcpy(&known[3 * std::size_t{end}], xyz + 3 * i, 3 * sizeof(float));
      ++end;
    }
    positions.grow_to(3 * std::size_t{end});
    return true;
  }

 private:
  struct Key {
    explicit Key(const float* xyz) {
      std::memcpy(bits, xyz, sizeof(bits));
      constexpr std::uint32_t kMinusZero = 0x8000'0000;
      for (std::uint32_t& word : bits) word = word == kMinusZero ? 0 : word;
    }
    [[nodiscard]] std::size_t hash(std::uint64_t seed) const {
      std::uint64_t h = ((std::uint64_t{bits[1]} << 32U | bits[0]) ^ seed) * 0x9E37'79B9'7F4A'7C15U;
      h = (h ^ (h >> 29U) ^ bits[2]) * 0xBF58'476D'1CE4'E5B9U;
      h = (h ^ (h >> 32U)) * 0x94D0'49BB'1331'11EBU;
      return static_cast<std::size_t>(h >> 32U);
    }
    friend bool operator==(const Key& a, const Key& b) {
      return a.bits[0] == b.bits[0] && a.bits[1] == b.bits[1] && a.bits[2] == b.bits[2];
    }
    std::uint32_t bits[3];
  };

  /// The index of `xyz` among the positions `known`, looked for from `slot` on; or `end`, which is
  /// its index from then on.
  [[nodiscard]] Index find_or_claim(const float* xyz, std::size_t slot, const float* known,
                                    Index end) {
    const Key key(xyz);
    for (;; slot = (slot + 1) & mask(), ++steps_) {
      const Index v = slots_[slot];
      if (v == kNone) return slots_[slot] = end;
      if (Key(&known[3 * std::size_t{v}]) == key) return v;
    }
  }
  [[nodiscard]] std::size_t mask() const { return slots_.size() - 1; }
  [[nodiscard]] bool grow(std::span<const float> positions, std::size_t count) {
    std::size_t slots = 1024;
    while (slots < 2 * (count + 1)) slots *= 2;
    if (!slots_.recreate(slots)) return false;
    steps_ = 0;
    std::fill(slots_.begin(), slots_.end(), kNone);
    for (std::size_t v = 0; v < positions.size() / 3; ++v) {
      std::size_t i = Key(&positions[3 * v]).hash(seed_) & mask();
      while (slots_[i] != kNone) i = (i + 1) & mask();
      slots_[i] = static_cast<Index>(v);
    }
    return true;
  }

  Array<Index> slots_;  // a power of two
  std::uint64_t seed_ = 0;
  std::size_t steps_ = 0;  // beyond the first slots looked at, since the table was made
};

}  // namespace halfedge::io
