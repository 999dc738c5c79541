#pragma once

#include <cstddef>
#include <cstdio>
#include <fstream>
#include <map>
#include <string>
#include <vector>

// Tables in Markdown.

inline void print_header(const std::vector<std::string>& columns) {
  for (const std::string& column : columns) std::printf("| %s ", column.c_str());
  std::printf("|\n");
  for (std::size_t i = 0; i < columns.size(); ++i) std::printf("|---");
  std::printf("|\n");
}

/// Ours in milliseconds, the others as multiples of it. With --benchmark_filter some are missing,
/// "-": without ours the others are in milliseconds too, and without any there is no row.
inline void print_row(const std::string& label, const std::vector<std::string>& names,
                      const std::map<std::string, double>& medians) {
  if (medians.empty()) return;
  const auto ours = medians.find(names.front());
  std::printf("| %s |", label.c_str());
  for (const std::string& name : names) {
    const auto median = medians.find(name);
    if (median == medians.end()) {
      std::printf(" - |");
    } else if (median == ours || ours == medians.end()) {
      std::printf(" %.2f |", median->second);
    } else {
      std::printf(" %.2f× |", median->second / ours->second);
    }
  }
  std::printf("\n");
  std::fflush(stdout);
}

/// What /proc/cpuinfo calls the processor.
inline std::string cpu_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "unknown processor";
}

inline std::string thousands(std::size_t count) { return std::to_string(count / 1000) + " k"; }
