#pragma once

#include <halfedge/attributes/attribute.h>
#include <halfedge/connectivity/array.h>

namespace halfedge::io {

/// Numbers the different values of a column from 0, in the order in which they come.
///
/// Equal values may get different numbers where too many of others are in the way, so that no
/// choice of values makes it slow: O(1) each.
class DistinctRows {
 public:
  explicit DistinctRows(const Attribute& column) : column_(column) {}

  /// The number of the value of this item; false when memory is exhausted.
  [[nodiscard]] bool find_or_add(Index item, Index& number);
  [[nodiscard]] Index count() const { return count_; }

 private:
  struct Slot {
    Index item;
    Index number;
  };
  [[nodiscard]] const std::byte* value(Index item) const {
    return column_.bytes().data() + column_.stride() * item;
  }
  [[nodiscard]] std::size_t hash(Index item) const;
  [[nodiscard]] bool grow();
  /// Its slot, or a free one, or null after too many others.
  [[nodiscard]] Slot* look_up(Index item);

  const Attribute& column_;
  Array<Slot> slots_;  // a power of two
  Index count_ = 0;
};

}  // namespace halfedge::io
