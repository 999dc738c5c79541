#pragma once

#include <halfedge/attributes/attribute.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/handle.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace halfedge {

/// What a column beside a soup has values for.
enum class SoupItem : std::uint8_t { kVertex, kCorner, kFace };

/// A named column of numbers beside polygons, as files carry them: normals, colours, texture
/// coordinates. `add_attributes` makes it an attribute of the mesh that is built of the polygons;
/// one of corners becomes one of halfedges, by the convention of Attribute.
struct SoupAttribute {
  std::string name;
  SoupItem item = SoupItem::kVertex;
  Scalar type = Scalar::kFloat32;
  /// 1 to Attribute::kMaxComponents.
  Index components = 1;
  OnSplit on_split = OnSplit::kInterpolate;
  /// Rows of numbers, as they lie in memory.
  Array<std::byte> values;
  /// By item: its row, kNone for none. Left empty, row i is that of item i. Items after the last of
  /// these have none.
  Array<Index> rows;

  /// Of a row, in bytes.
  [[nodiscard]] std::size_t stride() const { return components * size_of(type); }
};

/// Words for the numbers of an attribute of faces: number i stands for names[i], 0 for none.
struct SoupNames {
  std::string attribute;
  std::vector<std::string> names;
};

}  // namespace halfedge
