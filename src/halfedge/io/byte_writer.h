#pragma once

#include <halfedge/attributes/attribute.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/io/byte_scanner.h>
#include <halfedge/io/copy_numbers.h>
#include <halfedge/io/number_writer.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace halfedge::io {

/// Collects the bytes of a file. Growth is amortised; after a failed allocation, what follows is
/// dropped.
class ByteWriter {
 public:
  [[nodiscard]] bool out_of_memory() const { return out_of_memory_; }
  /// For an allocation of the writer's own.
  void set_out_of_memory() { out_of_memory_ = true; }
  [[nodiscard]] Array<std::uint8_t>& bytes() { return bytes_; }

  void reserve(std::size_t count) { out_of_memory_ |= !bytes_.reserve(count); }

  void text(std::string_view text) {
    if (std::uint8_t* const p = room(text.size())) {
      std::memcpy(p, text.data(), text.size());
      used(text.size());
    }
  }
  /// A character before a number.
  void number(char before, float value) {
    number(before, [value](char* out) { return write_float(out, value); });
  }
  void number(char before, Index value) {
    number(before, [value](char* out) { return write_index(out, value); });
  }
  /// A number of any type.
  void number(char before, Scalar type, const void* value) {
    number(before, [=](char* out) { return write_number(out, type, value); });
  }
  /// `count` numbers of this type in a row, each turned round if `reverse`.
  void binary(Scalar type, const void* values, std::size_t count, bool reverse) {
    const std::size_t size = size_of(type);
    if (std::uint8_t* const p = room(count * size)) {
      copy_numbers({static_cast<const std::uint8_t*>(values), size}, {p, size}, count, size,
                   reverse);
      used(count * size);
    }
  }
  template <ByteOrder kOrder, class T>
  void binary(T value) {
    if (std::uint8_t* const p = room(sizeof(T))) {
      const T ordered = load<T>(reinterpret_cast<const std::uint8_t*>(&value), kOrder);
      std::memcpy(p, &ordered, sizeof(T));
      used(sizeof(T));
    }
  }

 private:
  template <class Write>
  void number(char before, const Write& write) {
    if (std::uint8_t* const p = room(1 + kMaxNumberLength)) {
      char* const start = reinterpret_cast<char*>(p);
      *start = before;
      used(static_cast<std::size_t>(write(start + 1) - start));
    }
  }
  /// Room for so many bytes more, or null.
  [[nodiscard]] std::uint8_t* room(std::size_t count) {
    const std::size_t needed = bytes_.size() + count;
    if (needed > bytes_.capacity() && !bytes_.reserve(needed + needed / 2 + 1024) &&
        !bytes_.reserve(needed + needed / 8)) {
      out_of_memory_ = true;
    }
    return out_of_memory_ ? nullptr : bytes_.data() + bytes_.size();
  }
  void used(std::size_t count) { (void)bytes_.resize(bytes_.size() + count); }

  Array<std::uint8_t> bytes_;
  bool out_of_memory_ = false;
};

}  // namespace halfedge::io
