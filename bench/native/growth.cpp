#include <halfedge/build/build.h>
#include <halfedge/mesh.h>
#include <halfedge/validate/validate.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "contender.h"
#include "memory.h"
#include "meshes.h"

// How the time of whole-mesh passes grows: prints, for a torus of the size that is asked for, the
// least milliseconds of each pass of ours and of the flat baseline as JSON. See
// bench/web/growth.mjs.

namespace {

void require(bool fine) {
  if (fine) return;
  std::fprintf(stderr, "Usage: halfedge_growth <vertices of a side of the torus, 3 to 20000>\n");
  std::exit(1);
}

/// A pass, and the least CPU time that one of its rounds has taken.
struct Pass {
  std::string name;
  std::function<void()> run;
  /// What makes the mesh ready for one run; empty for nothing.
  std::function<void()> prepare = {};
  double least = std::numeric_limits<double>::infinity();
};

// Passes that need no preparation are repeated, so that the clock has something to measure.
void measure(Pass& pass, int repeats) {
  if (pass.prepare) {
    pass.prepare();
    repeats = 1;
  }
  const std::clock_t begin = std::clock();
  for (int i = 0; i < repeats; ++i) pass.run();
  const double time = 1000.0 * double(std::clock() - begin) / CLOCKS_PER_SEC;
  pass.least = std::min(pass.least, time / repeats);
}

std::vector<Pass> passes_of(Contender& mesh, const TriangleMesh& input) {
  mesh.build(input);
  mesh.keep();
  return {{"build", [&] { mesh.build(input); }},
          {"one-rings",
           [&] {
             [[maybe_unused]] static volatile std::uint64_t sum;
             sum = mesh.one_ring_sum();
           }},
          {"compaction", [&] { mesh.compact(); },
           [&] {
             mesh.restore();
             mesh.split_and_collapse();
           }}};
}

void print(const char* name, const std::vector<Pass>& passes) {
  std::printf("\"%s\": {", name);
  for (const Pass& pass : passes) {
    std::printf("%s\"%s\": %.5f", &pass == &passes.front() ? "" : ", ", pass.name.c_str(),
                pass.least);
  }
  std::printf("}");
}

}  // namespace

int main(int argc, char** argv) {
  keep_one_heap();
  const int side = argc == 2 ? std::atoi(argv[1]) : 0;
  require(side >= 3 && side <= 20'000);
  const TriangleMesh input = torus(static_cast<std::uint32_t>(side));

  const std::unique_ptr<Contender> ours = make_halfedge();
  const std::unique_ptr<Contender> flat = make_flat();
  std::vector<Pass> our_passes = passes_of(*ours, input);
  std::vector<Pass> flat_passes = passes_of(*flat, input);
  halfedge::Mesh mesh;
  halfedge::BuildReport report;
  require(build_from_polygons(mesh, {input.positions, {}, input.corners}, report));
  our_passes.push_back({"validate", [&] { require(validate(mesh).empty()); }});

  const auto faces = static_cast<int>(input.face_count());
  const int rounds = std::clamp(3'000'000 / faces, 2, 15);
  const int repeats = std::max(1, 300'000 / faces);
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < our_passes.size(); ++i) {
      measure(our_passes[i], repeats);
      if (i < flat_passes.size()) measure(flat_passes[i], repeats);
    }
  }
  std::printf("{");
  print("native", our_passes);
  std::printf(", ");
  print("flat", flat_passes);
  std::printf("}\n");
  return 0;
}
