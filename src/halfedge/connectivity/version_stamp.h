#pragma once

#include <halfedge/connectivity/handle.h>

#include <cassert>
#include <cstdint>
#include <cstdlib>

/// Checked circulators notice that the connectivity changed under them, and ranges of live items
/// that there are more or fewer slots. On in debug builds, where they assert; with
/// HALFEDGE_CHECKED=1 also where asserts are off: there they abort.
#if !defined(HALFEDGE_CHECKED)
#if defined(NDEBUG)
#define HALFEDGE_CHECKED 0
#else
#define HALFEDGE_CHECKED 1
#endif
#endif

/// A namespace within those of the dialects, for the linker: a program that is compiled for
/// debugging may use a library that isn't, and what their functions return differs in size.
#if HALFEDGE_CHECKED
#define HALFEDGE_CHECKS checked
#else
#define HALFEDGE_CHECKS unchecked
#endif

namespace halfedge {

inline constexpr bool kCheckedCirculators = HALFEDGE_CHECKED != 0;

/// What a checked circulator remembers of the mesh; nothing in release builds.
template <bool Checked>
class VersionStamp {
 public:
  VersionStamp() = default;
  explicit VersionStamp(const auto&) {}
  void check(const auto&) const {}
};
template <>
class VersionStamp<true> {
 public:
  VersionStamp() = default;
  explicit VersionStamp(const auto& mesh) : version_(mesh.version()) {}
  void check(const auto& mesh) const {
    const bool is_current = version_ == mesh.version();
    assert(is_current &&
           "a circulator was used after the connectivity changed under it: make a new one");
    if (!is_current) std::abort();
  }

 private:
  std::uint64_t version_ = 0;
};

/// The same of a range of live items: how many slots there were.
template <bool Checked>
class SlotsStamp {
 public:
  SlotsStamp() = default;
  explicit SlotsStamp(Index) {}
  void check(Index) const {}
};
template <>
class SlotsStamp<true> {
 public:
  SlotsStamp() = default;
  explicit SlotsStamp(Index slots) : slots_(slots) {}
  void check(Index slots) const {
    const bool is_current = slots_ == slots;
    assert(is_current &&
           "live items were asked for after there were more or fewer slots: make a new range");
    if (!is_current) std::abort();
  }

 private:
  Index slots_ = 0;
};

}  // namespace halfedge
