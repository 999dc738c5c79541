#pragma once

// What the bindings of operations share. An operation is called per item, a million times in a
// loop, so it is a plain exported function, which costs a few nanoseconds where embind takes 80:
// numbers in, a number out. JavaScript names it with an underscore: `core._flip_edge(mesh, ...)`.
//
// Each function takes the address of a mesh, a mode (a sum of bits), and the arguments. It returns
// the index of what was made, which may be none, -1, or 0 where nothing is; kRefused, and
// `last_refusal` tells why; or kNoRoom, if memory is exhausted to the last bytes. When it has
// changed something, or tried to, `layout_words` are those of the mesh.

#include <emscripten/em_macros.h>
#include <halfedge/result.h>

#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "bindings.h"

namespace halfedge::bindings {

/// Bits of a mode, as in web/src/edit.ts.
inline constexpr Index kCheckOnly = 1;     ///< tell whether it can be done
inline constexpr Index kKeepStepOpen = 2;  ///< more changes belong to the same step of history
inline constexpr Index kAt = 4;            ///< a position is given
inline constexpr Index kOption = 8;        ///< what the operation itself gives the choice of

inline constexpr int kRefused = -2;
inline constexpr int kNoRoom = -3;

/// Why the last call that returned kRefused did so, until it is forgotten.
inline Failure refusal;

HALFEDGE_COLD inline int refuse(Failure&& failure) {
  refusal = std::move(failure);
  return kRefused;
}

inline int answer(Result<void>&& result) {
  return result ? 0 : refuse(std::move(result).failure());
}
template <class Item>
int answer(Result<Item>&& result) {
  if (!result) return refuse(std::move(result).failure());
  if constexpr (std::is_integral_v<Item>) {
    return static_cast<int>(result.value());  // a number of items
  } else {
    return static_cast<int>(result.value().index());
  }
}

/// Does something to a mesh that may fail, and closes the step of history.
template <class Apply>
int apply(Address address, Index mode, const Apply& apply) {
  if (!Reserve::take_back()) return kNoRoom;
  AnyMesh& mesh = mesh_at(address);
  const int result = answer(apply(mesh));
  if ((mode & kKeepStepOpen) == 0) mesh.end_step();
  write_layout(mesh);
  return result;
}

/// An operation: checks, or does it.
template <class Check, class Apply>
int operate(Address address, Index mode, const Check& check, const Apply& apply) {
  if ((mode & kCheckOnly) == 0) return bindings::apply(address, mode, apply);
  if (!Reserve::take_back()) return kNoRoom;
  return answer(check(mesh_at(address)));
}

/// Items that JavaScript has listed.
template <class Item>
std::span<const Item> items_at(Address address, std::size_t count) {
  static_assert(sizeof(Item) == sizeof(Index) && std::is_trivially_copyable_v<Item>);
  return {reinterpret_cast<const Item*>(address), count};
}

inline std::optional<Point> position_if_given(Index mode, double x, double y, double z) {
  if ((mode & kAt) == 0) return std::nullopt;
  return Point{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

}  // namespace halfedge::bindings

/// A function for JavaScript, called without embind.
#define HALFEDGE_EXPORT extern "C" EMSCRIPTEN_KEEPALIVE

/// Checks or does the operation of this name, whose check has the same arguments.
#define HALFEDGE_OPERATE(operation, ...)                                                      \
  halfedge::bindings::operate(                                                                \
      mesh, mode,                                                                             \
      [&](const auto& m) { return halfedge::operations::check_##operation(m, __VA_ARGS__); }, \
      [&](auto& m) { return halfedge::operations::operation(m, __VA_ARGS__); })
