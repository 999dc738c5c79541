#include <halfedge/build/diagnose.h>
#include <halfedge/sentence.h>
#include <halfedge/sort.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace halfedge {

namespace {

using sentence::count_of;
using sentence::list_of;
using sentence::number;

void check_array_sizes(const Polygons& polygons, ProblemSink& problems) {
  const auto add = [&](const char* code, const std::string& message) {
    problems.add([&] { return Error{code, message}; });
  };
  const std::size_t numbers = polygons.positions.size();
  const std::size_t corners = polygons.corners.size();
  if (numbers % 3 != 0) {
    add("bad-size",
        sentence::of("The positions array has {}; expected a multiple of 3, three for each vertex.",
                     count_of(numbers, "number")));
  }
  if (polygons.sizes.empty()) {
    if (corners % 3 != 0) {
      add("bad-size",
          sentence::of(
              "The triangles array has {}; expected a multiple of 3, three for each triangle.",
              count_of(corners, "corner")));
    }
  } else {
    std::uint64_t sum = 0;
    for (const Index size : polygons.sizes) sum += size;
    if (sum != corners) {
      add("bad-size", sentence::of("The face sizes add up to {}, but the corners array has {}.",
                                   count_of(sum, "corner"), corners));
    }
  }
  const auto check_count = [&](std::size_t count, const char* noun) {
    if (count <= kMaxSlots) return;
    add("too-large", sentence::of("The input has {}; a mesh can have at most {}.",
                                  count_of(count, noun), kMaxSlots));
  };
  check_count(polygons.vertex_count(), "vertex");
  check_count(corners, "corner");
}

void check_positions(const Polygons& polygons, ProblemSink& problems) {
  for (std::size_t v = 0; v < polygons.vertex_count(); ++v) {
    const float* p = &polygons.positions[3 * v];
    if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])) continue;
    problems.add([&] {
      return Error{"non-finite-position",
                   sentence::of("Vertex {} is at ({}, {}, {}); expected three finite numbers.", v,
                                number(p[0]), number(p[1]), number(p[2])),
                   {.vertices = {Index(v)}}};
    });
  }
}

[[nodiscard]] bool find_faces(const Polygons& polygons, FaceTable& table) {
  table.corners = polygons.corners;
  if (!table.faces.recreate(polygons.face_count())) return false;
  Index first = 0;
  for (std::size_t f = 0; f < table.faces.size(); ++f) {
    const Index size = polygons.sizes.empty() ? 3 : polygons.sizes[f];
    table.faces[f] = {first, size};
    first += size;
  }
  return true;
}

std::string range_of_vertices(std::size_t count) {
  if (count == 0) return "there are no vertices";
  if (count == 1) return "vertex 0 is the only one";
  return sentence::of("the last one is {}", count - 1);
}

// Problems that a face has by itself; it is ignored from then on. `sorted` is scratch.
[[nodiscard]] bool check_face(FaceTable& table, Index f, std::size_t vertex_count,
                              Array<Index>& sorted, ProblemSink& problems) {
  const std::span<const Index> corners = table.corners_of(f);
  const auto refuse = [&](const char* code, const std::vector<Index>& vertices,
                          const auto& describe) {
    table.faces[f].ignored = true;
    problems.add([&] {
      return Error{
          code, sentence::of("Face {}{}", f, describe()), {.vertices = vertices, .faces = {f}}};
    });
  };
  if (corners.size() < 3) {
    refuse("degree-below-three", {corners.begin(), corners.end()}, [&] {
      return sentence::of(" has {}; a face needs at least 3.", count_of(corners.size(), "corner"));
    });
  }
  if (!sorted.assign(corners)) return false;
  introsort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const Index v = sorted[i];
    const std::size_t times =
        std::size_t(std::upper_bound(sorted.begin() + i, sorted.end(), v) - (sorted.begin() + i));
    if (v >= vertex_count) {
      refuse("index-out-of-range", {v}, [&] {
        return sentence::of(" uses vertex {}, but {}.", v, range_of_vertices(vertex_count));
      });
    } else if (times > 1 && corners.size() >= 3) {
      refuse("repeated-vertex", {v}, [&] {
        return sentence::of(
            " uses vertex {} at {} corners (its corners are {}); a face may use a vertex once.", v,
            times, list_of(corners));
      });
    }
    i += times - 1;
  }
  return true;
}

[[nodiscard]] bool diagnose_faces(const Polygons& polygons, ProblemSink& problems) {
  FaceTable table;
  Array<Index> sorted;
  if (!find_faces(polygons, table)) return false;
  for (std::size_t f = 0; f < table.faces.size(); ++f) {
    if (!check_face(table, Index(f), polygons.vertex_count(), sorted, problems)) return false;
  }
  return diagnose_neighbours(table, polygons.vertex_count(), problems);
}

}  // namespace

void diagnose(const Polygons& polygons, BuildReport& report) {
  report = {};
  ProblemSink problems(report);
  check_array_sizes(polygons, problems);
  if (report.problem_count > 0) return;  // the arrays can't be read as polygons
  check_positions(polygons, problems);
  if (!diagnose_faces(polygons, problems)) {
    problems.add([] {
      return Error{"out-of-memory",
                   "The input is not manifold, and there is not enough memory to find out why."};
    });
  }
}

}  // namespace halfedge
