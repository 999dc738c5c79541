#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace halfedge::fuzz {

/// The bytes of an input as numbers, one byte each; zeros once they are used up.
class Input {
 public:
  explicit Input(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  [[nodiscard]] bool used_up() const { return bytes_.empty(); }
  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const std::uint8_t first = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return first;
  }
  bool flag() { return byte() % 2 == 1; }
  /// One of few places, some of which are close together, or one of the numbers that are none.
  float coordinate() {
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    constexpr std::array<float, 8> kOdd = {kNone,  kInfinity, -kInfinity, -0.0F,
                                           1e-45F, 3e38F,     -3e38F,     16777216};
    const std::uint8_t drawn = byte();
    if (drawn >= 256 - kOdd.size()) return kOdd[255U - drawn];
    return float(drawn % 16) + 0.01F * float(drawn / 16);
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

}  // namespace halfedge::fuzz
