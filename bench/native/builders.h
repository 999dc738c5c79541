#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "contender.h"

/// The links of a closed triangle mesh, edges in any order.
struct BareLinks {
  std::vector<std::uint32_t> next, prev, to, face, vertex_halfedge, face_halfedge;

  /// A number that tells two meshes apart but not two numberings of their edges.
  [[nodiscard]] std::uint64_t checksum() const;
};

/// Another way to find the opposites of a closed triangle mesh. These are as short as they can be:
/// they fill all links, copy the positions, reuse their memory, and check nothing.
class Builder {
 public:
  explicit Builder(std::string name) : name_(std::move(name)) {}
  virtual ~Builder() = default;

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const BareLinks& links() const { return links_; }

  void build(const TriangleMesh& input);

  /// Whether a vertex of high valence takes the square of its valence.
  [[nodiscard]] virtual bool is_quadratic() const { return false; }

 private:
  /// Calls links for each face; sets `to` and the two halfedges of each edge.
  virtual void connect(const TriangleMesh& input, BareLinks& links) = 0;

  std::string name_;
  BareLinks links_;
  std::vector<float> positions_;
};

/// The fastest ones known: a chain of edges for each smaller vertex, in one pass; a table of the
/// edges of each smaller vertex, counted first; a table of the corners of each vertex; sorting.
[[nodiscard]] std::vector<std::unique_ptr<Builder>> other_builders();
