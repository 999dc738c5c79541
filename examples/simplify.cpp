// Simplifies a mesh to a tenth of its faces, by quadric error metrics (Garland and Heckbert,
// "Surface simplification using quadric error metrics", 1997): again and again, the edge is
// collapsed that moves the surface least.
//
//   example_simplify                       a torus
//   example_simplify scan.ply small.ply

#include <halfedge/halfedge.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <queue>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace halfedge;
using Vector = std::array<double, 3>;

Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector middle(const Vector& a, const Vector& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The sum of w (n·x + d)² over planes, as a polynomial in x, y and z.
struct Quadric {
  std::array<double, 10> terms = {};

  void add_plane(const Vector& point, const Vector& normal, double weight) {
    const double plane[] = {normal[0], normal[1], normal[2], -dot(normal, point)};
    double* term = terms.data();
    for (int i = 0; i < 4; ++i) {
      for (int j = i; j < 4; ++j) *term++ += weight * (i < j ? 2 : 1) * plane[i] * plane[j];
    }
  }
  void add(const Quadric& other) {
    for (std::size_t i = 0; i < terms.size(); ++i) terms[i] += other.terms[i];
  }
  [[nodiscard]] double error(const Vector& point) const {
    const double at[] = {point[0], point[1], point[2], 1};
    const double* term = terms.data();
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
      for (int j = i; j < 4; ++j) sum += *term++ * at[i] * at[j];
    }
    return std::max(0.0, sum);
  }
};

class Simplification {
 public:
  explicit Simplification(Mesh& mesh)
      : mesh_(mesh), quadrics_(mesh.vertex_slots()), costs_(mesh.edge_slots()) {
    for (const Face f : mesh.faces()) add_planes(f);
    for (const Edge e : mesh.edges()) enqueue(e);
  }

  void reduce_to(Index faces) {
    while (mesh_.face_count() > faces && !queue_.empty()) {
      const Candidate cheapest = queue_.top();
      queue_.pop();
      const Edge e = cheapest.edge;
      if (!mesh_.is_live(e) || costs_[e.index()] != cheapest.cost) continue;  // outdated
      const Halfedge h = mesh_.edge_halfedge(e);
      const Vertex a = mesh_.from_vertex(h);
      const Vertex b = mesh_.to_vertex(h);
      const Vector point = meeting(a, b).point;
      if (turns_over(a, b, point) || turns_over(b, a, point)) continue;
      const Point position{float(point[0]), float(point[1]), float(point[2])};
      if (!operations::collapse(mesh_, h, position)) continue;  // refused: a disappears into b
      quadrics_[b.index()].add(quadrics_[a.index()]);
      for (const Edge around : mesh_.vertex_edges_ccw(b)) enqueue(around);
    }
  }

 private:
  struct Candidate {
    double cost = 0;
    Edge edge;
    // A priority queue begins with the largest.
    bool operator<(const Candidate& other) const { return cost > other.cost; }
  };
  struct Meeting {
    Vector point = {};
    double cost = 0;
  };

  [[nodiscard]] Vector at(Vertex v) const {
    const Point p = mesh_.position(v);
    return {p.x, p.y, p.z};
  }

  void add_planes(Face f) {
    const Halfedge h = mesh_.face_halfedge(f);
    const Vector a = at(mesh_.to_vertex(h));
    const Vector to_b = at(mesh_.to_vertex(mesh_.next(h))) - a;
    const Vector to_c = at(mesh_.from_vertex(h)) - a;
    const Vector normal = cross(to_b, to_c);  // as long as twice the area
    const double size = std::sqrt(dot(normal, normal));
    if (size == 0) return;
    for (const Vertex v : mesh_.face_vertices_ccw(f)) {
      quadrics_[v.index()].add_plane(a, normal, 1 / size);
    }
    // What is on the boundary should stay there: a plane through the edge, upright on the face.
    for (const Halfedge side : mesh_.face_halfedges_ccw(f)) {
      if (!mesh_.is_boundary(mesh_.opposite(side))) continue;
      const Vertex from = mesh_.from_vertex(side);
      const Vertex to = mesh_.to_vertex(side);
      const Vector upright = cross(at(to) - at(from), normal);
      for (const Vertex v : {from, to}) {
        quadrics_[v.index()].add_plane(at(v), upright, 10 / (size * size));
      }
    }
  }

  // Where the ends of an edge should meet: at one of them, or in the middle.
  [[nodiscard]] Meeting meeting(Vertex a, Vertex b) const {
    Quadric both = quadrics_[a.index()];
    both.add(quadrics_[b.index()]);
    Meeting best = {at(a), both.error(at(a))};
    for (const Vector& point : {at(b), middle(at(a), at(b))}) {
      const double cost = both.error(point);
      if (cost < best.cost) best = {point, cost};
    }
    return best;
  }

  void enqueue(Edge e) {
    const Halfedge h = mesh_.edge_halfedge(e);
    const double cost = meeting(mesh_.from_vertex(h), mesh_.to_vertex(h)).cost;
    costs_[e.index()] = cost;
    queue_.push({cost, e});
  }

  // Whether a triangle at `v`, which stays, would turn over if `v` moved to the point.
  [[nodiscard]] bool turns_over(Vertex v, Vertex other, const Vector& point) const {
    for (const Halfedge h : mesh_.outgoing_ccw(v)) {
      if (mesh_.is_boundary(h)) continue;
      const Vertex a = mesh_.to_vertex(h);
      const Vertex b = mesh_.to_vertex(mesh_.next(h));
      if (a == other || b == other) continue;
      const Vector side = at(b) - at(a);
      if (dot(cross(side, at(v) - at(a)), cross(side, point - at(a))) <= 0) return true;
    }
    return false;
  }

  Mesh& mesh_;
  std::vector<Quadric> quadrics_;  // by vertex
  std::vector<double> costs_;      // by edge, those that still hold
  std::priority_queue<Candidate> queue_;
};

int fail(const std::string& why) {
  std::fprintf(stderr, "%s\n", why.c_str());
  return 1;
}

void tell(const Mesh& mesh) {
  std::printf("%u vertices, %u triangles, Euler characteristic %lld\n", mesh.vertex_count(),
              mesh.face_count(), static_cast<long long>(euler_characteristic(mesh)));
}

// The polygons of a file, or of a torus.
Result<PolygonSoup> read(const char* path) {
  if (path == nullptr) return shapes::torus(48, 24, shapes::Faces::kTriangles);
  std::ifstream file(path, std::ios::binary);
  if (!file) return Error{"unreadable-file", std::string("can't read ") + path};
  const std::vector<std::uint8_t> bytes(std::istreambuf_iterator<char>(file), {});
  Result<ParsedFile> parsed = parse(bytes);
  if (!parsed) return parsed.error();
  return std::move(parsed.value().soup);
}

}  // namespace

int main(int argc, char** argv) {
  Result<Mesh> made = shapes::mesh_of(read(argc > 1 ? argv[1] : nullptr));
  if (!made) return fail(made.error().message);
  Mesh& mesh = made.value();
  if (const Result<Index> cut = operations::triangulate(mesh); !cut) {
    return fail(cut.error().message);
  }
  tell(mesh);
  Simplification(mesh).reduce_to(mesh.face_count() / 10);
  tell(mesh);
  if (const Result<CompactMaps> maps = compact(mesh); !maps) return fail(maps.error().message);
  const std::vector<Problem> problems = validate(mesh, kGeometryLevel);
  if (problems.empty()) std::printf("valid\n");
  for (const Problem& problem : problems) std::printf("%s\n", problem.message.c_str());
  if (argc > 2) {
    const Result<Array<std::uint8_t>> bytes = write(mesh, Format::kPly);
    if (!bytes) return fail(bytes.error().message);
    std::ofstream file(argv[2], std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.value().data()),
               static_cast<std::streamsize>(bytes.value().size()));
    if (!file) return fail(std::string("can't write ") + argv[2]);
  }
  return 0;
}
