#pragma once

#include <halfedge/connectivity/handle.h>
#include <halfedge/inlining.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>

namespace halfedge {

/// Some vertices whose faces form a single fan, which is open, and the boundary halfedge in which
/// that ends, clockwise. Otherwise only who has walked round all of a fan knows that it is the only
/// one: so the faces around a vertex, added one by one, would take the square of their number. What
/// is known is true of one version of the connectivity, and good as long as that is the current
/// one.
class LoneFans {
 public:
  /// A walk over no more faces than this is not worth an entry.
  static constexpr std::uint32_t kShort = 32;

  /// Forgets all but what is true of this version.
  void start_at(std::uint64_t version) {
    if (known_ != nullptr && known_->version != version) known_->added = 0;
  }
  /// All that is known is true of this version.
  void keep_at(std::uint64_t version) {
    if (known_ != nullptr) known_->version = version;
  }
  /// What is true of this version is true of the next.
  void carry_over(std::uint64_t version) {
    if (known_ != nullptr && known_->version == version) ++known_->version;
  }

  /// Where the only fan of `v` ends; empty if it isn't known to be the only one.
  [[nodiscard]] Halfedge end_at(Vertex v) const {
    const Fan* const fan = find(v);
    return fan == nullptr ? Halfedge{} : fan->end;
  }
  /// Of the last few. Not if memory is exhausted.
  HALFEDGE_NOINLINE void add(Vertex v, Halfedge end) {
    if (known_ == nullptr) known_.reset(new (std::nothrow) Known);
    if (known_ != nullptr) known_->fans[known_->added++ % known_->fans.size()] = {v, end};
  }
  /// If the fan of `v` is known, it ends there now; with an empty `end` it isn't known any more.
  void change(Vertex v, Halfedge end) {
    if (Fan* const fan = find(v)) *fan = {end.valid() ? v : Vertex{}, end};
  }

 private:
  struct Fan {
    Vertex vertex;
    Halfedge end;
  };
  struct Known {
    std::array<Fan, 4> fans;
    std::size_t added = 0;
    std::uint64_t version = 0;
  };

  [[nodiscard]] Fan* find(Vertex v) const { return known_ == nullptr ? nullptr : search(v); }
  [[nodiscard]] HALFEDGE_NOINLINE Fan* search(Vertex v) const {
    for (std::size_t i = 0; i < std::min(known_->added, known_->fans.size()); ++i) {
      if (known_->fans[i].vertex == v) return &known_->fans[i];
    }
    return nullptr;
  }

  std::unique_ptr<Known> known_;  // few meshes have such vertices
};

}  // namespace halfedge
