#include <halfedge/directed_edges/directed_edges.h>
#include <halfedge/mesh.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "base_mesh.h"
#include "contender.h"
#include "measure.h"
#include "memory.h"
#include "meshes.h"
#include "table.h"
#include "variant.h"

// The variants of our own beside each other: what leaving links out costs and saves.

namespace {

using namespace halfedge;

struct Entry {
  const char* name;
  std::unique_ptr<Variant> (*make)();
};
template <class AnyMesh>
std::unique_ptr<Variant> make() {
  return std::make_unique<VariantOf<AnyMesh>>();
}
constexpr std::array kEntries = {
    Entry{"everything", make<Mesh>},
    Entry{"without prev", make<BasicMesh<kWithoutPrev>>},
    Entry{"Directed Edges", make<DirectedEdgesMesh>},
};

struct Workload {
  const char* name;
  std::uint64_t (*run)(Variant&, const TriangleMesh&);
};
constexpr std::array kWorkloads = {
    Workload{"build", [](Variant& v,
                         const TriangleMesh& input) { return v.build(input), std::uint64_t{0}; }},
    Workload{
        "circulator",
        [](Variant& v, const TriangleMesh&) { return static_cast<std::uint64_t>(v.circulate()); }},
    Workload{"one-ring sum, cw", [](Variant& v, const TriangleMesh&) { return v.one_ring_sum(); }},
    Workload{"one-ring sum, ccw",
             [](Variant& v, const TriangleMesh&) { return v.one_ring_sum_ccw(); }},
};

void compare_times(const std::string& label, const TriangleMesh& input) {
  std::vector<std::unique_ptr<Variant>> variants;
  for (const Entry& entry : kEntries) {
    variants.push_back(entry.make());
    variants.back()->build(input);
  }
  for (const Workload& workload : kWorkloads) {
    std::vector<std::string> names;
    std::vector<Job> jobs;
    for (std::size_t i = 0; i < kEntries.size(); ++i) {
      Variant& variant = *variants[i];
      if (workload.run(variant, input) != workload.run(*variants[0], input)) {
        std::fprintf(stderr, "%s: %s differs\n", workload.name, kEntries[i].name);
        std::exit(1);
      }
      names.emplace_back(kEntries[i].name);
      jobs.push_back({names.back(), [&workload, &variant, &input] {
                        benchmark::DoNotOptimize(workload.run(variant, input));
                      }});
    }
    print_row(label + " | " + workload.name, names, measure(jobs));
  }
}

void compare_memory(const std::string& label, const TriangleMesh& input) {
  std::vector<HeapUse> uses;
  for (const Entry& entry : kEntries) {
    uses.push_back(measure_heap([&] { return std::unique_ptr<Circulated>(entry.make()); }, input));
  }
  for (const bool peak : {false, true}) {
    std::printf("| %s | bytes a vertex, %s |", label.c_str(),
                peak ? "most while building" : "when built");
    for (const HeapUse& use : uses) {
      const std::size_t bytes = peak ? std::max(use.peak, use.in_use) : use.in_use;
      std::printf(" %.1f |", double(bytes) / double(input.vertex_count()));
    }
    std::printf("\n");
  }
}

}  // namespace

int main(int argc, char** argv) {
  keep_one_heap();
  start_rounds(argc, argv);
  const NamedMesh base = base_mesh();
  const TriangleMesh fine = subdivided(subdivided(base.mesh));
  std::printf("%s, g++ %s; %s.\n\n", cpu_name().c_str(), __VERSION__, base.name.c_str());
  std::vector<std::string> columns{"faces, order", "", "everything, ms"};
  for (std::size_t i = 1; i < kEntries.size(); ++i) columns.emplace_back(kEntries[i].name);
  print_header(columns);
  const std::string faces = thousands(fine.face_count());
  compare_memory(faces, fine);
  compare_times(faces + ", natural", fine);
  compare_times(faces + ", shuffled", shuffled(fine, 1));
  return 0;
}
