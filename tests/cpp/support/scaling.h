#pragma once

#include <gtest/gtest.h>
#include <halfedge/connectivity/handle.h>

#include <algorithm>
#include <ctime>

namespace halfedge::test {

/// A quadratic step takes a hundred times as long for ten times the input.
inline constexpr double kFarFromQuadratic = 50;

/// That `run`, a function of what `make` makes of a size, takes no hundred times as long for ten
/// times the size: by the faster of two runs of each.
template <class Make, class Run>
void expect_no_quadratic_step(Index large_size, const Make& make, const Run& run) {
  double fastest[2] = {1e30, 1e30};
  for (int is_large = 0; is_large < 2; ++is_large) {
    for (int round = 0; round < 2; ++round) {
      auto input = make(is_large == 1 ? large_size : large_size / 10);
      const std::clock_t start = std::clock();
      run(input);
      const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
      fastest[is_large] = std::min(fastest[is_large], seconds);
    }
  }
  EXPECT_LT(fastest[1], kFarFromQuadratic * std::max(fastest[0], 1e-4))
      << fastest[0] << " s, " << fastest[1] << " s";
}

}  // namespace halfedge::test
