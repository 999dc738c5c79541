#include <gtest/gtest.h>
#include <halfedge/connectivity/handle.h>
#include <halfedge/sort.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace halfedge {
namespace {

std::vector<int> sorted_by_std(std::vector<int> numbers) {
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

TEST(Introsort, SortsEveryOrderOfAFewItems) {
  for (std::size_t size = 0; size <= 7; ++size) {
    std::vector<int> order(size);
    for (std::size_t i = 0; i < size; ++i) order[i] = int(i / 2);  // with equal ones
    do {
      std::vector<int> numbers = order;
      introsort(numbers);
      ASSERT_EQ(numbers, sorted_by_std(order));
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

TEST(Introsort, SortsManyItemsWhateverTheirOrder) {
  constexpr unsigned kSeed = 20261121;
  std::mt19937 random(kSeed);
  for (const int size : {16, 17, 18, 33, 100, 1000, 20000}) {
    for (const int values : {1, 2, 3, 10, size, 1000 * size}) {
      std::vector<int> numbers(std::size_t(size), 0);
      for (int& number : numbers) number = int(random() % unsigned(values));
      const std::vector<int> expected = sorted_by_std(numbers);
      const std::string trace = std::to_string(size) + " items of " + std::to_string(values) +
                                " values, seed " + std::to_string(kSeed);
      introsort(numbers);
      ASSERT_EQ(numbers, expected) << trace;
      introsort(numbers);
      ASSERT_EQ(numbers, expected) << trace << ", in order before";
      std::reverse(numbers.begin(), numbers.end());
      introsort(numbers.data(), numbers.data() + numbers.size());
      ASSERT_EQ(numbers, expected) << trace << ", in reverse before";
    }
  }
}

TEST(Introsort, FollowsTheOrderThatItIsGiven) {
  std::vector<std::pair<int, int>> pairs;
  for (int i = 0; i < 100; ++i) pairs.emplace_back(i % 7, i);
  introsort(pairs, [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second < b.second;
  });
  ASSERT_TRUE(std::is_sorted(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second < b.second;
  }));
}

// An adversary in the manner of McIlroy, "A Killer Adversary for Quicksort" (1999): it decides how
// items compare only when asked, so that each pivot is as bad as can be.
TEST(Introsort, TakesNLogNComparisonsAtWorst) {
  constexpr int kSize = 20000;
  constexpr int kOpen = kSize;  // "not decided yet" is more than all that is
  std::vector<int> value(kSize, kOpen);
  std::vector<int> items(kSize);
  for (int i = 0; i < kSize; ++i) items[std::size_t(i)] = i;
  int decided = 0;
  int candidate = 0;
  std::size_t comparisons = 0;
  introsort(items, [&](int a, int b) {
    ++comparisons;
    int& of_a = value[std::size_t(a)];
    int& of_b = value[std::size_t(b)];
    if (of_a == kOpen && of_b == kOpen) (a == candidate ? of_a : of_b) = decided++;
    if (of_a == kOpen) {
      candidate = a;
    } else if (of_b == kOpen) {
      candidate = b;
    }
    return of_a < of_b;
  });
  for (std::size_t i = 1; i < items.size(); ++i) {
    ASSERT_LE(value[std::size_t(items[i - 1])], value[std::size_t(items[i])]);
  }
  EXPECT_LT(comparisons, 2'000'000U);  // n^2 / 4 would be 100 million
}

TEST(SortAndFindRepeated, FindsAnItemThatOccursTwiceAndSortsInAnyCase) {
  const std::vector<Vertex> sorted = {Vertex(1), Vertex(2), Vertex(3)};
  std::vector<Vertex> vertices = {Vertex(3), Vertex(1), Vertex(2)};
  EXPECT_FALSE(sort_and_find_repeated(std::span(vertices)).valid());
  EXPECT_EQ(vertices, sorted);

  vertices = {Vertex(3), Vertex(0), Vertex(2), Vertex(3)};
  EXPECT_EQ(sort_and_find_repeated(std::span(vertices)), Vertex(3));
  EXPECT_EQ(vertices.back(), Vertex(3));

  EXPECT_FALSE(sort_and_find_repeated(std::span<Vertex>()).valid());
}

}  // namespace
}  // namespace halfedge
