#include <benchmark/benchmark.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "contender.h"
#include "memory.h"
#include "meshes.h"

namespace {

struct Entry {
  const char* name;
  std::unique_ptr<Contender> (*make)();
};
constexpr std::array kEntries = {
    Entry{"halfedge", make_halfedge},
    Entry{"flat baseline", make_flat},
    Entry{"OpenMesh", make_openmesh},
    Entry{"CGAL Surface_mesh", make_cgal},
};
constexpr std::array kWorkloads = {"build", "circulator", "one-ring sum"};

/// Median milliseconds of CPU time, by "workload/contender".
using Medians = std::map<std::string, double>;

/// Collects the medians instead of printing each run.
class Collector final : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.aggregate_name != "median") continue;
      medians[run.run_name.function_name] = run.GetAdjustedCPUTime();
    }
  }

  Medians medians;
};

void must_agree(const char* what, std::uint64_t ours, std::uint64_t theirs, const char* name) {
  if (ours == theirs) return;
  std::fprintf(stderr, "%s: %s gives %llu, halfedge %llu\n", what, name,
               static_cast<unsigned long long>(theirs), static_cast<unsigned long long>(ours));
  std::exit(1);
}

/// All workloads of all contenders on one mesh, in interleaved rounds.
Medians measure(const TriangleMesh& input) {
  std::vector<std::unique_ptr<Contender>> contenders;
  for (const Entry& entry : kEntries) {
    contenders.push_back(entry.make());
    Contender& contender = *contenders.back();
    contender.build(input);
    must_agree("circulator", 0, static_cast<std::uint64_t>(contender.circulate()), entry.name);
    must_agree("one-ring sum", contenders[0]->one_ring_sum(), contender.one_ring_sum(), entry.name);

    const auto add = [&](const char* workload, auto run) {
      const std::string name = std::string(workload) + "/" + entry.name;
      benchmark::RegisterBenchmark(name.c_str(), [run](benchmark::State& state) {
        for (auto _ : state) run();
      })->Unit(benchmark::kMillisecond);
    };
    add(kWorkloads[0], [&contender, &input] { contender.build(input); });
    add(kWorkloads[1], [&contender] { benchmark::DoNotOptimize(contender.circulate()); });
    add(kWorkloads[2], [&contender] { benchmark::DoNotOptimize(contender.one_ring_sum()); });
  }
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::ClearRegisteredBenchmarks();
  return collector.medians;
}

/// The table to keep: our milliseconds, and how many times slower each other is.
void print_header() {
  std::printf("| faces, order | workload | halfedge, ms |");
  for (std::size_t i = 1; i < kEntries.size(); ++i) std::printf(" %s |", kEntries[i].name);
  std::printf("\n|---|---|---|");
  for (std::size_t i = 1; i < kEntries.size(); ++i) std::printf("---|");
  std::printf("\n");
}

void print_times(const std::string& label, const TriangleMesh& mesh) {
  const Medians medians = measure(mesh);
  for (const char* workload : kWorkloads) {
    const auto median = [&](const Entry& entry) {
      return medians.at(std::string(workload) + "/" + entry.name);
    };
    const double ours = median(kEntries[0]);
    std::printf("| %s | %s | %.2f |", label.c_str(), workload, ours);
    for (std::size_t i = 1; i < kEntries.size(); ++i) {
      std::printf(" %.2f× |", median(kEntries[i]) / ours);
    }
    std::printf("\n");
    std::fflush(stdout);
  }
}

void print_memory(const std::string& label, const TriangleMesh& mesh) {
  const double vertices = static_cast<double>(mesh.vertex_count());
  std::vector<HeapUse> uses;
  for (const Entry& entry : kEntries) uses.push_back(measure_heap(entry.make, mesh));
  for (const bool peak : {false, true}) {
    std::printf("| %s | %s |", label.c_str(),
                peak ? "peak bytes a vertex in build" : "bytes a vertex");
    for (const HeapUse& use : uses) {
      std::printf(" %.0f |", static_cast<double>(peak ? use.peak : use.in_use) / vertices);
    }
    std::printf("\n");
  }
}

std::string cpu_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "unknown processor";
}

}  // namespace

int main(int argc, char** argv) {
  keep_one_heap();
  std::vector<char*> arguments(argv, argv + argc);
  char rounds[] = "--benchmark_repetitions=9";
  char interleaved[] = "--benchmark_enable_random_interleaving=true";
  char min_time[] = "--benchmark_min_time=0.02";
  arguments.insert(arguments.begin() + 1, {rounds, interleaved, min_time});
  auto count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 1;

  std::printf(
      "%s, g++ %s. Medians of 9 interleaved rounds, CPU time; × = times slower than ours.\n\n",
      cpu_name().c_str(), __VERSION__);
  print_header();
  for (const int levels : {6, 7, 8}) {
    const TriangleMesh natural = bumpy_sphere(levels);
    const std::string faces = std::to_string(natural.face_count() / 1000) + " k, ";
    if (levels == 8) print_memory(faces + "natural", natural);
    print_times(faces + "natural", natural);
    print_times(faces + "shuffled", shuffled(natural, 1));
  }
  return 0;
}
