#pragma once

#include <gtest/gtest.h>
#include <halfedge/connectivity/handle.h>

#include <algorithm>
#include <ctime>

namespace halfedge::test {

/// A quadratic step takes ten thousand times as long for a hundred times the input. A hundred times
/// as long it may take, and many times more: for the caches, the logarithm, new memory, and other
/// programs that share all of these.
inline constexpr double kFarFromQuadratic = 2000;

/// The seconds of the processor that `run` takes.
template <class Run>
double seconds_of(const Run& run) {
  const std::clock_t start = std::clock();
  run();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// That what `slower` measures takes at most so many times as long as what `faster` measures: by
/// the fastest of two runs of each, and of up to ten as long as it doesn't: whatever else a machine
/// does makes some runs longer and none shorter.
template <class Faster, class Slower>
void expect_at_most(double times, const Faster& faster, const Slower& slower) {
  constexpr double kLeast = 1e-5;  // what the clock can't tell from nothing
  double fast = faster();
  double slow = slower();
  const auto holds = [&] { return slow < times * std::max(fast, kLeast); };
  for (int round = 1; round < 2 || (round < 10 && !holds()); ++round) {
    fast = std::min(fast, faster());
    slow = std::min(slow, slower());
  }
  EXPECT_TRUE(holds()) << slow << " s are more than " << times << " times " << fast << " s";
}

/// That `run`, a function of what `make` makes of a size, has no step that is quadratic.
template <class Make, class Run>
void expect_no_quadratic_step(Index large_size, const Make& make, const Run& run) {
  const auto seconds_at = [&](Index size) {
    auto input = make(size);
    return seconds_of([&] { run(input); });
  };
  expect_at_most(
      kFarFromQuadratic, [&] { return seconds_at(large_size / 100); },
      [&] { return seconds_at(large_size); });
}

}  // namespace halfedge::test
