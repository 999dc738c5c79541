#pragma once

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <functional>
#include <map>
#include <string>
#include <vector>

/// Something to be timed.
struct Job {
  std::string name;
  std::function<void()> run;
  /// What is done before each run, and not timed; empty for nothing.
  std::function<void()> prepare = {};
};

/// Takes the arguments of the program, those of Google Benchmark, and sets the rounds.
inline void start_rounds(int argc, char** argv) {
  std::vector<char*> arguments(argv, argv + argc);
  char rounds[] = "--benchmark_repetitions=9";
  char interleaved[] = "--benchmark_enable_random_interleaving=true";
  char min_time[] = "--benchmark_min_time=0.02";
  arguments.insert(arguments.begin() + 1, {rounds, interleaved, min_time});
  auto count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) std::exit(1);
}

/// Median milliseconds of CPU time by name. All jobs take turns, in random order, so that whatever
/// else the machine does meets all of them.
inline std::map<std::string, double> measure(const std::vector<Job>& jobs) {
  class Collector final : public benchmark::BenchmarkReporter {
   public:
    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override {
      for (const Run& run : runs) {
        if (run.aggregate_name != "median") continue;
        medians[run.run_name.function_name] = run.GetAdjustedCPUTime();
      }
    }

    std::map<std::string, double> medians;
  };

  for (const Job& job : jobs) {
    auto* registered =
        benchmark::RegisterBenchmark(job.name.c_str(), [job](benchmark::State& state) {
          for (auto _ : state) {
            if (job.prepare) {
              state.PauseTiming();
              job.prepare();
              state.ResumeTiming();
            }
            job.run();
          }
        });
    registered->Unit(benchmark::kMillisecond);
    if (job.prepare) registered->Iterations(1);
  }
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::ClearRegisteredBenchmarks();
  return collector.medians;
}
