#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

/// A triangle mesh as every library gets it.
struct TriangleMesh {
  std::vector<float> positions;        // 3 for each vertex
  std::vector<std::uint32_t> corners;  // 3 for each face

  [[nodiscard]] std::size_t vertex_count() const { return positions.size() / 3; }
  [[nodiscard]] std::size_t face_count() const { return corners.size() / 3; }
};

/// A mesh that is built and circulated in. The workloads follow Sieger and Botsch, "Design,
/// Implementation, and Evaluation of the Surface_mesh Data Structure" (2011).
class Circulated {
 public:
  virtual ~Circulated() = default;

  /// Makes the mesh anew, in whatever is the library's fastest documented way.
  virtual void build(const TriangleMesh& input) = 0;

  /// ++ for each face of each vertex, -- for each vertex of each face: 0 for a closed mesh.
  virtual std::int64_t circulate() = 0;

  /// The sum of the indices of the one-ring vertices of all vertices.
  virtual std::uint64_t one_ring_sum() = 0;
};

/// One library in the benchmark, each written the way the library's own documentation writes it:
/// its mesh is edited as well.
class Contender : public Circulated {
 public:
  /// Reorders the mesh for locality, if the library can do that. Vertices and faces keep their
  /// indices: they are in such an order already.
  virtual void reorder() {}

  // ---- geometry ----------------------------------------------------------------------------

  /// Moves the mean of the vertices to the origin.
  virtual void centre() = 0;

  /// Unit normals of the faces, from three vertices; of each vertex the sum of those of its faces,
  /// of unit length. Kept until the next call.
  virtual void compute_normals() = 0;

  /// Each vertex that isn't on the boundary goes to the mean of its one-ring, in place.
  virtual void smooth() = 0;

  /// All positions, and then the normals of all vertices.
  virtual std::vector<float> geometry() = 0;

  // ---- operations, each on the mesh as it was when `keep` was called ------------------------

  /// Keeps a copy of the mesh; `restore` goes back to it.
  virtual void keep() = 0;
  virtual void restore() = 0;

  /// One step of sqrt(3) subdivision: a vertex at the centroid of each face, which is cut in three;
  /// the old edges are flipped where they may be, the old vertices moved.
  virtual void subdivide() = 0;

  /// A vertex in each face, and each of them collapsed away again, with all checks; what was
  /// deleted leaves gaps.
  virtual void split_and_collapse() = 0;

  /// Closes the gaps of deleted items.
  virtual void compact() = 0;

  /// Of live items: edges + faces + the sum of the squares of the valences.
  virtual std::uint64_t valence_sum() = 0;
};

/// The weight of the one-ring in the new position of a vertex, in sqrt(3) subdivision.
inline float sqrt3_weight(unsigned valence) {
  return (4.0F - 2.0F * std::cos(6.2831853F / float(valence))) / 9.0F;
}

std::unique_ptr<Contender> make_halfedge();
std::unique_ptr<Contender> make_flat();
std::unique_ptr<Contender> make_openmesh();
std::unique_ptr<Contender> make_cgal();

/// Which OpenMesh it is: Debian's library, with assertions, or one compiled here, without.
const char* openmesh_name();
