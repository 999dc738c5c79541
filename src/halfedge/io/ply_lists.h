#pragma once

#include <halfedge/io/ply_reader.h>

#include <cstddef>
#include <cstdint>

/// How PlyReader reads lists of numbers beside vertices and faces: those that have the same length
/// in all rows become attributes with so many components.
namespace halfedge::io {

template <class Source>
bool PlyReader<Source>::read_list(const PlyElement& element, const PlyProperty& property,
                                  SoupAttribute& column) {
  std::int64_t length = 0;
  if (!read_length(property, length)) return false;
  if (row_ == 0 && length <= Attribute::kMaxComponents) {
    column.components = static_cast<Index>(length);
  }
  if (column.components == kUneven || length != column.components || length == 0) {
    column.components = kUneven;
    column.values.reset();
    return skip_values(element, property, length);
  }
  const std::size_t begin = column.values.size();
  if (!column.values.reserve_more(column.stride())) {
    out_.set_out_of_memory();
    return true;
  }
  column.values.grow_to(begin + column.stride());
  for (std::size_t at = begin; at < column.values.size(); at += size_of(property.type)) {
    if (source_.read(property.type, &column.values[at])) continue;
    return fail(source_.unexpected("a number for " + quoted(property.name) + in_row(element),
                                   property.type));
  }
  return true;
}

}  // namespace halfedge::io
