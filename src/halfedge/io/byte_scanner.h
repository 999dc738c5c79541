#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace halfedge::io {

enum class ByteOrder : std::uint8_t { kLittle, kBig };

/// A number of type T from its bytes, which need not be aligned.
template <class T, ByteOrder kOrder>
[[nodiscard]] inline T load(const std::uint8_t* bytes) {
  std::uint8_t raw[sizeof(T)];
  std::memcpy(raw, bytes, sizeof(T));
  constexpr bool kNativeIsBig = __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__;
  if constexpr ((kOrder == ByteOrder::kBig) != kNativeIsBig) std::reverse(raw, raw + sizeof(T));
  T value;
  std::memcpy(&value, raw, sizeof(T));
  return value;
}

/// A cursor over the bytes of a binary file. Offsets count from the start of the file.
class ByteScanner {
 public:
  ByteScanner(std::span<const std::uint8_t> bytes, std::size_t offset)
      : begin_(bytes.data()), at_(begin_ + offset), end_(begin_ + bytes.size()) {}

  [[nodiscard]] std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }
  [[nodiscard]] std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
  [[nodiscard]] const std::uint8_t* position() const { return at_; }
  /// The same, where texts have letters.
  [[nodiscard]] const char* text() const { return reinterpret_cast<const char*>(at_); }
  /// pre: count <= left()
  void skip(std::size_t count) { at_ += count; }

  /// pre: sizeof(T) <= left()
  template <class T, ByteOrder kOrder>
  [[nodiscard]] T take() {
    const T value = load<T, kOrder>(at_);
    at_ += sizeof(T);
    return value;
  }

 private:
  const std::uint8_t* begin_;
  const std::uint8_t* at_;
  const std::uint8_t* end_;
};

}  // namespace halfedge::io
