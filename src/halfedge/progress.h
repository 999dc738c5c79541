#pragma once

#include <cstdint>

namespace halfedge {

/// The parts of making a mesh of a file.
enum class Stage : std::uint8_t { kRead, kRepair, kBuild };

/// Whoever follows a long piece of work, and may cancel it. By default nobody: that costs nothing.
struct Progress {
  /// Gets `context`, and how much of the stage is done, from 0 to 1. False cancels the work. It
  /// must not throw: the library is compiled without exceptions.
  bool (*report)(void* context, Stage stage, double fraction) = nullptr;
  void* context = nullptr;

  /// Reports; false if the work is to be cancelled.
  [[nodiscard]] bool operator()(Stage stage, double fraction) const {
    return report == nullptr || report(context, stage, fraction);
  }
};

}  // namespace halfedge
