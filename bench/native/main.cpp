#include <halfedge/build/build.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base_mesh.h"
#include "builders.h"
#include "contender.h"
#include "history.h"
#include "locality_ordered.h"
#include "measure.h"
#include "memory.h"
#include "meshes.h"
#include "table.h"

namespace {

struct Entry {
  const char* name;
  std::unique_ptr<Contender> (*make)();
};
const std::array kEntries = {
    Entry{"halfedge", make_halfedge},
    Entry{"flat baseline", make_flat},
    Entry{openmesh_name(), make_openmesh},
    Entry{"CGAL Surface_mesh", make_cgal},
};

void must_agree(const std::string& what, std::uint64_t ours, std::uint64_t theirs,
                const std::string& name) {
  if (ours == theirs) return;
  std::fprintf(stderr, "%s: %s gives %llu, halfedge %llu\n", what.c_str(), name.c_str(),
               static_cast<unsigned long long>(theirs), static_cast<unsigned long long>(ours));
  std::exit(1);
}

// Sums in another order differ in their last bits, and normals of slivers in more than those: all
// numbers together have to be near.
void must_be_near(const char* what, const std::vector<float>& ours,
                  const std::vector<float>& theirs, const char* name) {
  double size = 0;
  double difference = 0;
  for (std::size_t i = 0; i < std::min(ours.size(), theirs.size()); ++i) {
    size += std::abs(double(ours[i]));
    difference += std::abs(double(ours[i]) - double(theirs[i]));
  }
  if (ours.size() == theirs.size() && difference <= 1e-5 * size) return;
  std::fprintf(stderr, "%s: %s differs from halfedge by %g of %g\n", what, name, difference, size);
  std::exit(1);
}

// ---- libraries

std::string job_name(const char* workload, const Entry& entry) {
  return std::string(workload) + "/" + entry.name;
}

// A row for each workload.
void print_rows(const std::string& label, std::span<const char* const> workloads,
                const std::map<std::string, double>& medians) {
  for (const char* workload : workloads) {
    std::vector<std::string> names;
    std::map<std::string, double> of_workload;
    for (const Entry& entry : kEntries) {
      const std::string name = job_name(workload, entry);
      names.push_back(name);
      if (const auto median = medians.find(name); median != medians.end()) {
        of_workload.insert(*median);
      }
    }
    print_row(label + " | " + workload, names, of_workload);
  }
}

// After each of the operations, and when the mesh is as it was again.
void check_operations(Contender& ours, Contender& theirs, const char* name) {
  const auto compare = [&](const char* what, void (*change)(Contender&)) {
    std::uint64_t sums[2] = {};
    for (const int i : {0, 1}) {
      Contender& contender = i == 0 ? ours : theirs;
      contender.restore();
      change(contender);
      sums[i] = contender.valence_sum();
    }
    must_agree(what, sums[0], sums[1], name);
  };
  compare("sqrt(3) step", [](Contender& contender) { contender.subdivide(); });
  compare("split and collapse", [](Contender& contender) { contender.split_and_collapse(); });
  compare("compaction", [](Contender& contender) {
    contender.split_and_collapse();
    contender.compact();
  });
  compare("the mesh itself", [](Contender&) {});
}

// After all of the geometry, of which each step sees what the ones before left.
std::vector<float> geometry_of(Contender& contender) {
  contender.centre();
  contender.smooth();
  contender.compute_normals();
  return contender.geometry();
}

// With `locality`, `input` is in such an order, and what else the library numbers gets into it,
// too.
std::unique_ptr<Contender> made_by(const Entry& entry, const TriangleMesh& input, bool locality) {
  std::unique_ptr<Contender> contender = entry.make();
  contender->build(input);
  if (locality) contender->reorder();
  return contender;
}

void compare_libraries(const std::string& label, const TriangleMesh& input, bool locality) {
  constexpr std::array kWorkloads = {"build",      "circulator", "one-ring sum",
                                     "barycentre", "normals",    "smoothing"};
  std::vector<std::unique_ptr<Contender>> contenders;
  std::vector<std::unique_ptr<Contender>> built;
  std::vector<float> geometry;
  std::vector<Job> jobs;
  for (const Entry& entry : kEntries) {
    built.push_back(made_by(entry, input, false));
    contenders.push_back(made_by(entry, input, locality));
    Contender& contender = *contenders.back();
    must_agree("circulator", 0, static_cast<std::uint64_t>(contender.circulate()), entry.name);
    must_agree("one-ring sum", contenders[0]->one_ring_sum(), contender.one_ring_sum(), entry.name);
    const std::vector<float> after = geometry_of(contender);
    if (geometry.empty()) geometry = after;
    must_be_near("geometry", geometry, after, entry.name);
    jobs.push_back(
        {job_name(kWorkloads[0], entry), [&mesh = *built.back(), &input] { mesh.build(input); }});
    jobs.push_back({job_name(kWorkloads[1], entry),
                    [&contender] { benchmark::DoNotOptimize(contender.circulate()); }});
    jobs.push_back({job_name(kWorkloads[2], entry),
                    [&contender] { benchmark::DoNotOptimize(contender.one_ring_sum()); }});
    jobs.push_back({job_name(kWorkloads[3], entry), [&contender] { contender.centre(); }});
    jobs.push_back({job_name(kWorkloads[4], entry), [&contender] { contender.compute_normals(); }});
    jobs.push_back({job_name(kWorkloads[5], entry), [&contender] { contender.smooth(); }});
  }
  print_rows(label, kWorkloads, measure(jobs));
}

void compare_operations(const std::string& label, const TriangleMesh& input, bool locality) {
  constexpr std::array kWorkloads = {"sqrt(3) step", "split and collapse", "compaction"};
  std::vector<std::unique_ptr<Contender>> contenders;
  std::vector<Job> jobs;
  for (const Entry& entry : kEntries) {
    contenders.push_back(made_by(entry, input, locality));
    Contender& contender = *contenders.back();
    contender.keep();
    check_operations(*contenders[0], contender, entry.name);
    const auto restore = [&contender] { contender.restore(); };
    jobs.push_back(
        {job_name(kWorkloads[0], entry), [&contender] { contender.subdivide(); }, restore});
    jobs.push_back({job_name(kWorkloads[1], entry),
                    [&contender] { contender.split_and_collapse(); }, restore});
    jobs.push_back({job_name(kWorkloads[2], entry), [&contender] { contender.compact(); },
                    [&contender] {
                      contender.restore();
                      contender.split_and_collapse();
                    }});
  }
  print_rows(label, kWorkloads, measure(jobs));
}

void compare_memory(const std::string& label, const TriangleMesh& input) {
  std::vector<HeapUse> uses;
  for (const Entry& entry : kEntries) uses.push_back(measure_heap(entry.make, input));
  for (const bool peak : {false, true}) {
    std::printf("| %s | %s |", label.c_str(), peak ? "most while building" : "when built");
    for (const HeapUse& use : uses) {
      const std::size_t bytes = peak ? std::max(use.peak, use.in_use) : use.in_use;
      std::printf(" %.1f |", double(bytes) / double(input.vertex_count()));
    }
    std::printf("\n");
  }
}

// ---- builders

std::uint64_t checksum(const halfedge::Mesh& mesh) {
  const auto copy = [](const halfedge::Array<halfedge::Index>& array) {
    return std::vector<std::uint32_t>(array.begin(), array.end());
  };
  const halfedge::Links& links = mesh.links();
  return BareLinks{copy(links.next),
                   copy(links.prev),
                   copy(links.to_vertex),
                   copy(links.face),
                   copy(links.vertex_halfedge),
                   copy(links.face_halfedge)}
      .checksum();
}

void compare_builders(const std::string& label, const TriangleMesh& input, bool has_high_valence) {
  halfedge::Mesh mesh;
  halfedge::BuildReport report;
  const auto build = [&] {
    if (!build_from_polygons(mesh, {input.positions, {}, input.corners}, report)) std::exit(1);
  };
  build();
  const std::uint64_t expected = checksum(mesh);

  std::vector<std::string> names{"halfedge"};
  std::vector<Job> jobs{{names.front(), build}};
  const std::vector<std::unique_ptr<Builder>> builders = other_builders();
  for (const std::unique_ptr<Builder>& builder : builders) {
    names.push_back(builder->name());
    if (has_high_valence && builder->is_quadratic()) continue;
    builder->build(input);
    must_agree(label, expected, builder->links().checksum(), builder->name());
    jobs.push_back({builder->name(), [&builder, &input] { builder->build(input); }});
  }
  print_row(label, names, measure(jobs));
}

// ---- tables, each of which can be asked for alone

void print_libraries(const std::vector<TriangleMesh>& meshes) {
  std::vector<std::string> columns{"faces, order", "workload", "halfedge, ms"};
  for (const Entry& entry : std::span(kEntries).subspan(1)) columns.emplace_back(entry.name);
  print_header(columns);
  for (const TriangleMesh& mesh : meshes) {
    const std::string faces = thousands(mesh.face_count());
    const TriangleMesh mixed = shuffled(mesh, 1);
    const std::string locality = ", locality-ordered";
    for (const auto& [order, ordered] : {std::pair{std::string(", natural"), mesh},
                                         {", shuffled", mixed},
                                         {locality, locality_ordered(mixed)}}) {
      compare_libraries(faces + order, ordered, order == locality);
      compare_operations(faces + order, ordered, order == locality);
    }
  }
}

void print_history(const std::vector<TriangleMesh>& meshes) {
  print_header({"faces, order", "operation", "without history, ms", "with", "undo", "redo"});
  for (const TriangleMesh& mesh : meshes) {
    compare_history(thousands(mesh.face_count()) + ", natural", mesh);
  }
}

void print_memory(const std::vector<TriangleMesh>& meshes) {
  std::vector<std::string> columns{"faces", "bytes a vertex, float positions"};
  for (const Entry& entry : kEntries) columns.emplace_back(entry.name);
  print_header(columns);
  compare_memory(thousands(meshes.back().face_count()), meshes.back());
}

void print_builders(const std::vector<TriangleMesh>& meshes) {
  std::vector<std::string> columns{"faces, order", "halfedge, ms"};
  for (const std::unique_ptr<Builder>& builder : other_builders()) {
    columns.push_back(builder->name());
  }
  print_header(columns);
  for (const TriangleMesh& mesh : meshes) {
    const std::string faces = thousands(mesh.face_count());
    compare_builders(faces + ", natural", mesh, false);
    compare_builders(faces + ", shuffled", shuffled(mesh, 1), false);
  }
  const TriangleMesh hubs = bipyramid(200'000);
  compare_builders("400 k around two vertices, natural", hubs, true);
  compare_builders("400 k around two vertices, shuffled", shuffled(hubs, 1), true);
}

struct Table {
  const char* name;
  void (*print)(const std::vector<TriangleMesh>&);
};
constexpr std::array kTables = {
    Table{"libraries", print_libraries},
    Table{"history", print_history},
    Table{"memory", print_memory},
    Table{"builders", print_builders},
};

// The table of that name, or all of them where none is asked for.
std::span<const Table> tables_named(std::string_view name) {
  if (name.empty()) return kTables;
  for (const Table& table : kTables) {
    if (name == table.name) return {&table, 1};
  }
  std::fprintf(stderr, "No table is named %.*s; expected one of", int(name.size()), name.data());
  for (const Table& table : kTables) std::fprintf(stderr, " %s", table.name);
  std::fprintf(stderr, ".\n");
  std::exit(1);
}

}  // namespace

int main(int argc, char** argv) {
  const bool names_table = argc > 1 && argv[1][0] != '-';
  const std::span<const Table> tables = tables_named(names_table ? argv[1] : "");
  keep_one_heap();
  start_rounds(names_table ? argc - 1 : argc, names_table ? argv + 1 : argv);
  const NamedMesh base = base_mesh();
  std::vector<TriangleMesh> meshes{base.mesh};
  while (meshes.size() < 3) meshes.push_back(subdivided(meshes.back()));
  std::printf(
      "%s, g++ %s; %s. Medians of 9 interleaved rounds of CPU time, memory recycled;\n× = times "
      "slower than ours.\n",
      cpu_name().c_str(), __VERSION__, base.name.c_str());
  for (const Table& table : tables) {
    std::printf("\n");
    table.print(meshes);
  }
  return 0;
}
