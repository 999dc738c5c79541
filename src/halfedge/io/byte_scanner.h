#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace halfedge::io {

enum class ByteOrder : std::uint8_t { kLittle, kBig };

/// Whether numbers in this order are turned round from what they are on this machine.
[[nodiscard]] constexpr bool is_reversed(ByteOrder order) {
  constexpr bool kNativeIsBig = __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__;
  return (order == ByteOrder::kBig) != kNativeIsBig;
}

/// A number of type T from its bytes, which need not be aligned.
template <class T>
[[nodiscard]] inline T load(const std::uint8_t* bytes, ByteOrder order) {
  std::uint8_t raw[sizeof(T)];
  std::memcpy(raw, bytes, sizeof(T));
  if (is_reversed(order)) std::reverse(raw, raw + sizeof(T));
  T value;
  std::memcpy(&value, raw, sizeof(T));
  return value;
}

/// A cursor over the bytes of a binary file. Offsets count from the start of the file.
class ByteScanner {
 public:
  ByteScanner(std::span<const std::uint8_t> bytes, std::size_t offset, ByteOrder order)
      : begin_(bytes.data()), at_(begin_ + offset), end_(begin_ + bytes.size()), order_(order) {}

  [[nodiscard]] ByteOrder order() const { return order_; }
  [[nodiscard]] std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }
  [[nodiscard]] std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
  [[nodiscard]] const std::uint8_t* position() const { return at_; }
  /// The same, where texts have letters.
  [[nodiscard]] const char* text() const { return reinterpret_cast<const char*>(at_); }
  /// pre: count <= left()
  void skip(std::size_t count) { at_ += count; }

  /// pre: sizeof(T) <= left()
  template <class T>
  [[nodiscard]] T take() {
    const T value = load<T>(at_, order_);
    at_ += sizeof(T);
    return value;
  }

 private:
  const std::uint8_t* begin_;
  const std::uint8_t* at_;
  const std::uint8_t* end_;
  ByteOrder order_;
};

}  // namespace halfedge::io
