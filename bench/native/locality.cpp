#include <halfedge/build/build.h>
#include <halfedge/mesh.h>
#include <halfedge/operations/reorder.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <map>
#include <string>
#include <vector>

#include "base_mesh.h"
#include "meshes.h"
#include "workloads.h"
#ifdef __EMSCRIPTEN__
#include <emscripten.h>
#else
#include "memory.h"
#endif

// What `reorder` costs and gains: passes over meshes in random order, before and after, in rounds
// that take turns. Prints the median milliseconds of CPU time as JSON, one line to a mesh, for
// bench/web/locality.mjs; the same program is compiled to WebAssembly.

namespace {

using namespace halfedge;
using workloads::require;

constexpr int kRounds = 5;

// Of CPU time. Emscripten's std::clock is a clock on the wall.
#ifdef __EMSCRIPTEN__
EM_JS(double, milliseconds, (), {
  const usage = process.cpuUsage();
  return (usage.user + usage.system) / 1000;
})
#else
double milliseconds() { return 1000.0 * double(std::clock()) / CLOCKS_PER_SEC; }
#endif

class Times {
 public:
  template <class Run>
  void add(const std::string& pass, const Run& run) {
    const double begin = milliseconds();
    run();
    times_[pass].push_back(milliseconds() - begin);
  }

  void print(std::size_t faces) {
    std::printf(R"({"faces": %zu)", faces);
    for (auto& [pass, times] : times_) {
      std::nth_element(times.begin(), times.begin() + kRounds / 2, times.end());
      std::printf(R"(, "%s": %.3f)", pass.c_str(), times[kRounds / 2]);
    }
    std::printf("}\n");
    std::fflush(stdout);
  }

 private:
  std::map<std::string, std::vector<double>> times_;
};

struct Passes {
  std::vector<Point> of_faces;
  std::vector<Point> of_vertices;
  Mesh copy;

  void run(const Mesh& mesh, const std::string& order, Times& times) {
    times.add("circulator, " + order, [&] { require(workloads::circulate(mesh) == 0); });
    times.add("one-ring sum, " + order, [&] { require(workloads::one_ring_sum(mesh) > 0); });
    times.add("normals, " + order, [&] { workloads::normals(mesh, of_faces, of_vertices); });
    require(copy.assign(mesh));
    times.add("smoothing, " + order, [&] { workloads::smooth(copy); });
    times.add("sqrt(3) step, " + order, [&] { workloads::subdivide(copy); });
  }
};

void measure(const TriangleMesh& input) {
  Mesh before;
  Mesh after;
  BuildReport report;
  require(build_from_polygons(before, {input.positions, {}, input.corners}, report));
  Times times;
  Passes passes;
  for (int round = 0; round < kRounds; ++round) {
    require(after.assign(before));
    times.add("reorder", [&] { require(bool(reorder(after))); });
    require(after.assign(before));
    times.add("reorder_breadth_first", [&] { require(bool(reorder_breadth_first(after))); });
    passes.run(after, "breadth-first", times);
    require(after.assign(before));
    require(bool(reorder(after)));
    passes.run(before, "shuffled", times);
    passes.run(after, "reordered", times);
  }
  times.print(input.face_count());
}

}  // namespace

int main(int argc, char** argv) {
#ifndef __EMSCRIPTEN__
  keep_one_heap();
#endif
  const NamedMesh base = base_mesh(argc > 1 ? argv[1] : "");
  measure(shuffled(base.mesh, 1));
  measure(shuffled(subdivided(subdivided(base.mesh)), 1));
  return 0;
}
