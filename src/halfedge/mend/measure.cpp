#include <halfedge/mend/measure.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace halfedge::mend {

namespace {

// Sums over the faces of a component, from its first corner as the origin: so that what is small
// and far away isn't lost.
struct Sums {
  Vector origin = {};
  Vector area = {};    // as a vector: 0 if closed
  Vector moment = {};  // of the area
};

// Cuts the face into triangles from one corner. Those that lie outside of a face that isn't convex
// are taken away from its area: their normals point the other way.
void add_face(const Surface& surface, Halfedge first, Extent& extent, Sums& sums) {
  const auto corner = [&](Halfedge h) {
    return point_of(surface, surface.to_vertex(h)) - sums.origin;
  };
  const Vector a = corner(first);
  Vector face = {};                    // its area, as a vector
  std::array<Vector, 3> moments = {};  // of each component of that
  Halfedge h = surface.next(first);
  Vector b = corner(h);
  for (h = surface.next(h); h != first; h = surface.next(h)) {
    const Vector c = corner(h);
    const Vector normal = cross(b - a, c - a);
    extent.volume += dot(a, normal) / 6;
    for (std::size_t i = 0; i < 3; ++i) {
      face[i] += normal[i] / 2;
      for (std::size_t k = 0; k < 3; ++k) moments[k][i] += normal[i] * (a[k] + b[k] + c[k]) / 6;
    }
    b = c;
  }
  const double area = length(face);
  extent.area += area;
  sums.area += face;
  if (!(area > 0)) return;
  for (std::size_t k = 0; k < 3; ++k) sums.moment[k] += dot(moments[k], face) / area;
}

// The halfedge of a face that leads to its smallest vertex. From there polygons are cut into
// triangles, so that a face that isn't flat has the same volume, but for its sign, when turned
// over.
Halfedge smallest_corner(const Surface& surface, Face f) {
  const Halfedge begin = surface.halfedge(f);
  Halfedge smallest = begin;
  for (Halfedge h = surface.next(begin); h != begin; h = surface.next(h)) {
    if (surface.to_vertex(h) < surface.to_vertex(smallest)) smallest = h;
  }
  return smallest;
}

}  // namespace

double length(const Vector& a) { return std::hypot(a[0], a[1], a[2]); }

Vector unit_vector(const Vector& a, double least) {
  const double size = length(a);
  if (!(size > least)) return {};
  return {a[0] / size, a[1] / size, a[2] / size};
}

bool measure(const Surface& surface, const Components& components, Array<Extent>& extents) {
  Array<Sums> all;
  if (!extents.resize(components.list.size(), Extent{}) || !all.resize(extents.size(), Sums{})) {
    return false;
  }
  for (Index f = 0; f < components.of_face.size(); ++f) {
    if (components.of_face[f] == kNone) continue;
    Extent& extent = extents[components.of_face[f]];
    Sums& sums = all[components.of_face[f]];
    const Halfedge first = smallest_corner(surface, Face(f));
    const Vector corner = point_of(surface, surface.to_vertex(first));
    if (extent.first_face == kNone) {
      extent.first_face = f;
      sums.origin = extent.low = extent.high = corner;
    }
    Halfedge h = first;
    do {
      const Vector p = point_of(surface, surface.to_vertex(h));
      for (std::size_t k = 0; k < 3; ++k) {
        extent.low[k] = std::min(extent.low[k], p[k]);
        extent.high[k] = std::max(extent.high[k], p[k]);
      }
      h = surface.next(h);
    } while (h != first);
    add_face(surface, first, extent, sums);
  }
  for (std::size_t c = 0; c < extents.size(); ++c) {
    if (extents[c].area > 0) {
      extents[c].volume -= dot(all[c].moment, all[c].area) / (3 * extents[c].area);
    }
  }
  return true;
}

bool MeasuredComponents::list_chosen_faces(Array<Index>& faces) const {
  for (Index f = 0; f < labels.of_face.size(); ++f) {
    if (chooses(labels.of_face[f]) && !faces.push_back(f)) return false;
  }
  return true;
}

}  // namespace halfedge::mend
