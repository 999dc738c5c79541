// Smooths meshes by subdivision, made of operations: triangles by the scheme of Loop ("Smooth
// subdivision surfaces based on triangles", 1987), polygons by that of Catmull and Clark
// ("Recursively generated B-spline surfaces on arbitrary topological meshes", 1978).
//
//   example_subdivide                       an icosahedron, a cube, and an open pyramid by both
//   example_subdivide model.obj smooth.ply  twice: by Loop's scheme if all faces are triangles

#include <halfedge/halfedge.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace halfedge;

// The value, or the end of the program.
template <class T>
T take(Result<T> result) {
  if (result) return std::move(result.value());
  std::fprintf(stderr, "%s\n", result.error().message.c_str());
  std::exit(1);
}

// A sum of points, each with a weight.
struct Sum {
  double x = 0;
  double y = 0;
  double z = 0;

  void add(double weight, const Point& point) {
    x += weight * double{point.x};
    y += weight * double{point.y};
    z += weight * double{point.z};
  }
  void add(double weight, const Sum& other) {
    x += weight * other.x;
    y += weight * other.y;
    z += weight * other.z;
  }
  [[nodiscard]] Point point() const { return {float(x), float(y), float(z)}; }
};

Sum centroid(const Mesh& mesh, Face f) {
  const double weight = 1.0 / mesh.degree(f);
  Sum sum;
  for (const Vertex v : mesh.face_vertices_ccw(f)) sum.add(weight, mesh.position(v));
  return sum;
}

Sum midpoint(const Mesh& mesh, Edge e) {
  Sum sum;
  for (const Vertex v : mesh.edge_vertices(e)) sum.add(0.5, mesh.position(v));
  return sum;
}

// Of a vertex on the boundary: three quarters of itself, an eighth of either neighbour there. One
// without edges, which counts as such, stays.
Sum boundary_point(const Mesh& mesh, Vertex v) {
  const Halfedge leaving = mesh.vertex_halfedge(v);  // without a face, as the anchor is there
  Sum sum;
  if (!leaving.valid()) {
    sum.add(1, mesh.position(v));
    return sum;
  }
  sum.add(3.0 / 4, mesh.position(v));
  sum.add(1.0 / 8, mesh.position(mesh.from_vertex(mesh.prev(leaving))));
  sum.add(1.0 / 8, mesh.position(mesh.to_vertex(leaving)));
  return sum;
}

void move_vertices(Mesh& mesh, const std::vector<Point>& points) {
  for (Index v = 0; v < points.size(); ++v) mesh.set_position(Vertex(v), points[v]);
}

// ---- Loop -----------------------------------------------------------------------------------

Sum loop_vertex_point(const Mesh& mesh, Vertex v) {
  if (mesh.is_boundary(v)) return boundary_point(mesh, v);
  Sum sum;
  const double n = mesh.valence(v);
  const double part = 3.0 / 8 + std::cos(2 * std::numbers::pi / n) / 4;
  const double weight = (5.0 / 8 - part * part) / n;
  sum.add(1 - n * weight, mesh.position(v));
  for (const Vertex w : mesh.vertex_vertices_ccw(v)) sum.add(weight, mesh.position(w));
  return sum;
}

Sum loop_edge_point(const Mesh& mesh, Edge e) {
  if (mesh.is_boundary(e)) return midpoint(mesh, e);
  Sum sum;
  for (const Vertex v : mesh.edge_vertices(e)) sum.add(3.0 / 8, mesh.position(v));
  for (const Halfedge h : mesh.edge_halfedges(e)) {
    sum.add(1.0 / 8, mesh.position(mesh.to_vertex(mesh.next(h))));
  }
  return sum;
}

// Each triangle becomes four: a vertex on each edge, and a triangle between those on its three
// edges. pre: there are no gaps
void loop_step(Mesh& mesh) {
  const Index old_vertices = mesh.vertex_slots();
  std::vector<Point> vertex_points;
  std::vector<Point> edge_points;
  for (const Vertex v : mesh.vertices())
    vertex_points.push_back(loop_vertex_point(mesh, v).point());
  for (const Edge e : mesh.edges()) edge_points.push_back(loop_edge_point(mesh, e).point());

  // Splitting an edge also cuts the triangles beside it, from the new vertex to the corner
  // opposite. Where that corner is an old one, the cut is turned, and joins the new vertices of the
  // other two sides.
  std::vector<Edge> cuts;
  for (Index i = 0; i < edge_points.size(); ++i) {
    const Halfedge h = mesh.edge_halfedge(Edge(i));
    const Vertex ends[] = {mesh.from_vertex(h), mesh.to_vertex(h)};
    const Vertex middle = take(operations::split_edge(mesh, Edge(i), edge_points[i]));
    for (const Halfedge leaving : mesh.outgoing_ccw(middle)) {
      const Vertex corner = mesh.to_vertex(leaving);
      const bool is_end = corner == ends[0] || corner == ends[1];
      if (corner.index() < old_vertices && !is_end) cuts.push_back(Mesh::edge(leaving));
    }
  }
  for (const Edge e : cuts) take(operations::flip_edge(mesh, e));
  move_vertices(mesh, vertex_points);
}

// ---- Catmull and Clark ----------------------------------------------------------------------

Sum catmull_clark_edge_point(const Mesh& mesh, Edge e, const std::vector<Sum>& face_points) {
  if (mesh.is_boundary(e)) return midpoint(mesh, e);
  Sum sum;
  for (const Vertex v : mesh.edge_vertices(e)) sum.add(0.25, mesh.position(v));
  for (const Face f : mesh.edge_faces(e)) sum.add(0.25, face_points[f.index()]);
  return sum;
}

Sum catmull_clark_vertex_point(const Mesh& mesh, Vertex v, const std::vector<Sum>& face_points) {
  if (mesh.is_boundary(v)) return boundary_point(mesh, v);
  Sum sum;
  const double n = mesh.valence(v);
  for (const Face f : mesh.vertex_faces_ccw(v)) sum.add(1 / (n * n), face_points[f.index()]);
  for (const Edge e : mesh.vertex_edges_ccw(v)) sum.add(2 / (n * n), midpoint(mesh, e));
  sum.add((n - 3) / n, mesh.position(v));
  return sum;
}

// Each face with n corners becomes n quads: a vertex in it, joined to one on each of its sides.
// pre: there are no gaps
void catmull_clark_step(Mesh& mesh) {
  const Index old_vertices = mesh.vertex_slots();
  std::vector<Sum> face_points;
  std::vector<Point> edge_points;
  std::vector<Point> vertex_points;
  for (const Face f : mesh.faces()) face_points.push_back(centroid(mesh, f));
  for (const Edge e : mesh.edges()) {
    edge_points.push_back(catmull_clark_edge_point(mesh, e, face_points).point());
  }
  for (const Vertex v : mesh.vertices()) {
    vertex_points.push_back(catmull_clark_vertex_point(mesh, v, face_points).point());
  }

  for (Index i = 0; i < edge_points.size(); ++i) {
    take(operations::insert_vertex_on_edge(mesh, Edge(i), edge_points[i]));
  }
  for (Index i = 0; i < face_points.size(); ++i) {
    // Joined to all corners, so also to the old ones.
    const Vertex centre = take(operations::split_face(mesh, Face(i), face_points[i].point()));
    std::vector<Edge> to_old;
    for (const Halfedge leaving : mesh.outgoing_ccw(centre)) {
      if (mesh.to_vertex(leaving).index() < old_vertices) to_old.push_back(Mesh::edge(leaving));
    }
    for (const Edge e : to_old) take(operations::remove_edge(mesh, e));
  }
  move_vertices(mesh, vertex_points);
  take(compact(mesh));
}

// ---- what comes of it -----------------------------------------------------------------------

// How many faces there are, and vertices of each valence: all but a few are regular.
std::string describe(const Mesh& mesh) {
  std::map<Index, Index> valences;
  float reach[3] = {-INFINITY, -INFINITY, -INFINITY};
  for (const Vertex v : mesh.vertices()) {
    if (!mesh.is_boundary(v)) ++valences[mesh.valence(v)];
    const Point p = mesh.position(v);
    const float position[] = {p.x, p.y, p.z};
    for (int axis = 0; axis < 3; ++axis) reach[axis] = std::max(reach[axis], position[axis]);
  }
  std::string inside;
  for (const auto& [valence, count] : valences) {
    if (!inside.empty()) inside += ", ";
    inside += std::to_string(count) + " of valence " + std::to_string(valence);
  }
  char box[100];
  std::snprintf(box, sizeof box, "%.4f %.4f %.4f", double{reach[0]}, double{reach[1]},
                double{reach[2]});
  const std::size_t problems = validate(mesh, kGeometryLevel).size();
  return std::to_string(mesh.face_count()) + " faces; inside " + inside + "; up to " + box + "; " +
         (problems == 0 ? "valid" : std::to_string(problems) + " problems");
}

void show(const char* name, Result<PolygonSoup> polygons, void (*step)(Mesh&)) {
  Mesh mesh = take(shapes::mesh_of(std::move(polygons)));
  std::printf("%s: %s\n", name, describe(mesh).c_str());
  for (const char* times : {"once", "twice"}) {
    step(mesh);
    std::printf("  %s: %s\n", times, describe(mesh).c_str());
  }
}

Result<PolygonSoup> read(const char* path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return Error{"unreadable-file", std::string("can't read ") + path};
  const std::vector<std::uint8_t> bytes(std::istreambuf_iterator<char>(file), {});
  Result<ParsedFile> parsed = parse(bytes);
  if (!parsed) return parsed.error();
  return std::move(parsed.value().soup);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 1) {
    const auto pyramid = [] { return shapes::cone(4, shapes::Caps::kOpen); };
    show("an icosahedron, by Loop", shapes::icosahedron(), loop_step);
    show("an open pyramid, by Loop", pyramid(), loop_step);
    show("a cube, by Catmull and Clark", shapes::cube(), catmull_clark_step);
    show("an open pyramid, by Catmull and Clark", pyramid(), catmull_clark_step);
    return 0;
  }
  Mesh mesh = take(shapes::mesh_of(read(argv[1])));
  const auto step = is_triangle_mesh(mesh) ? loop_step : catmull_clark_step;
  for (int times = 0; times < 2; ++times) step(mesh);
  std::printf("%s\n", describe(mesh).c_str());
  if (argc > 2) {
    const Array<std::uint8_t> bytes = take(write(mesh, Format::kPly));
    std::ofstream file(argv[2], std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    if (!file) {
      std::fprintf(stderr, "can't write %s\n", argv[2]);
      return 1;
    }
  }
  return 0;
}
