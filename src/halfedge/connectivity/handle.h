#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace halfedge {

/// Index of an item in its arrays. 32 bits: twice the items per cache line of a pointer.
using Index = std::uint32_t;

/// The empty link: "no face", "no halfedge". Reads as -1 in the Int32Array views of JavaScript.
inline constexpr Index kNone = 0xFFFF'FFFF;

/// The most slots of one kind. More cannot be addressed: the sign bit marks empty and deleted
/// links, and a free list needs two values more than there are slots.
inline constexpr Index kMaxSlots = 0x7FFF'FFFE;

/// A 32-bit index that knows what it points at: a Vertex does not compare with a Face, and neither
/// converts silently from or to a number. A default-constructed handle is empty.
template <class Tag>
class Handle {
 public:
  constexpr Handle() = default;
  constexpr explicit Handle(Index index) : index_(index) {}

  [[nodiscard]] constexpr Index index() const { return index_; }
  [[nodiscard]] constexpr bool valid() const { return index_ != kNone; }
  constexpr explicit operator bool() const { return valid(); }

  friend constexpr auto operator<=>(Handle, Handle) = default;

 private:
  Index index_ = kNone;
};

using Vertex = Handle<struct VertexTag>;
using Halfedge = Handle<struct HalfedgeTag>;
using Edge = Handle<struct EdgeTag>;
using Face = Handle<struct FaceTag>;

/// The kinds of item, for reports and attributes. kMesh stands for the mesh as a whole.
enum class ItemKind : std::uint8_t { kVertex, kHalfedge, kEdge, kFace, kMesh };

/// Those that there can be several of in a mesh.
inline constexpr ItemKind kItemKinds[] = {ItemKind::kVertex, ItemKind::kHalfedge, ItemKind::kEdge,
                                          ItemKind::kFace};

[[nodiscard]] constexpr ItemKind kind_of(Vertex) { return ItemKind::kVertex; }
[[nodiscard]] constexpr ItemKind kind_of(Halfedge) { return ItemKind::kHalfedge; }
[[nodiscard]] constexpr ItemKind kind_of(Edge) { return ItemKind::kEdge; }
[[nodiscard]] constexpr ItemKind kind_of(Face) { return ItemKind::kFace; }

/// The lower-case English name of a kind: "vertex", "halfedge", "edge", "face", "mesh".
[[nodiscard]] constexpr const char* name_of(ItemKind kind) {
  switch (kind) {
    case ItemKind::kVertex:
      return "vertex";
    case ItemKind::kHalfedge:
      return "halfedge";
    case ItemKind::kEdge:
      return "edge";
    case ItemKind::kFace:
      return "face";
    case ItemKind::kMesh:
      return "mesh";
  }
  return "item";
}

}  // namespace halfedge

template <class Tag>
struct std::hash<halfedge::Handle<Tag>> {
  std::size_t operator()(halfedge::Handle<Tag> handle) const noexcept {
    return std::hash<halfedge::Index>{}(handle.index());
  }
};
