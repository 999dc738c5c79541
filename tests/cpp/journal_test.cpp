#include <gtest/gtest.h>
#include <halfedge/history/journal.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <map>
#include <random>
#include <tuple>
#include <vector>

namespace halfedge {
namespace {

// Where notes are of: a field, the column of an attribute, an index.
using Place = std::tuple<Field, Index, Index>;
using Words = std::vector<Index>;

constexpr Index kLastNear = (Index{1} << 27U) - 1;

// Arrays as those of a mesh, with a journal beside them; their indices may be any.
class Arrays {
 public:
  explicit Arrays(HistoryLimits limits = {}) : journal_(limits) {}

  void write(const Place& place, const Words& words) {
    const auto [field, column, index] = place;
    Words& stored = words_at(place, words.size());
    const Index* old = stored.data();
    switch (field) {
      case Field::kPosition:
        journal_.record_position(index, {old[0], old[1], old[2]});
        break;
      case Field::kLoopLinks:
        journal_.record_in_old_slots(field, index, {old[0], old[1], old[2]});
        break;
      case Field::kFreeListOfEdges:
        journal_.record_in_old_slots(field, index, {old[0], old[1]});
        break;
      case Field::kRecycledEdge:
        journal_.record_recycled_edge(
            index, {old[0], old[1], old[2], old[3], old[4], old[5], old[6], old[7]}, false);
        break;
      case Field::kWords:
        journal_.record_words(Field(column), index, old, words.size());
        break;
      case Field::kAttribute:
        journal_.record_attribute(column, index, reinterpret_cast<const std::byte*>(old),
                                  bytes_of(column));
        break;
      case Field::kAttributeRun:
        journal_.record_attribute_run(column, index, reinterpret_cast<const std::byte*>(old),
                                      bytes_of(column));
        break;
      default:
        journal_.record(field, index, old[0]);
    }
    stored = words;
  }

  bool undo() {
    return journal_.undo([this](const Journal::Note& note) { exchange(note); });
  }
  bool redo() {
    return journal_.redo([this](const Journal::Note& note) { exchange(note); });
  }

  [[nodiscard]] Journal& journal() { return journal_; }
  [[nodiscard]] const std::map<Place, Words>& words() const { return words_; }
  [[nodiscard]] static std::size_t bytes_of(Index column) { return 1 + column % 128; }

 private:
  void exchange(const Journal::Note& note) {
    if (note.field == Field::kFiller) return;
    Words& stored = words_.at({note.field, note.column, note.index});
    std::swap_ranges(stored.begin(), stored.end(), note.words);
  }
  Words& words_at(const Place& place, std::size_t count) {
    return words_.try_emplace(place, Words(count)).first->second;
  }

  Journal journal_;
  std::map<Place, Words> words_;
};

class RandomWrites {
 public:
  explicit RandomWrites(std::uint32_t seed) : random_(seed) {}

  void write(Arrays& arrays) {
    constexpr std::array kFields{
        Field::kNext,         Field::kPosition,        Field::kFace,
        Field::kLoopLinks,    Field::kFreeListOfEdges, Field::kRecycledEdge,
        Field::kRecycledFace, Field::kWords,           Field::kAttribute,
        Field::kAttributeRun};
    // Of three places each: near, the last near ones and the first far ones, and the last of all.
    constexpr std::array<Index, 5> kIndices{0, 70'000, kLastNear, kLastNear + 1, kNone - 1};
    const Field field = kFields[below(kFields.size())];
    const bool is_list = field == Field::kFreeListOfEdges;
    const Index index = is_list ? 0 : kIndices[below(kIndices.size())];
    constexpr std::array<Index, 4> kColumns{0, 3, 127, Journal::kMostColumns - 2};
    const bool is_of_column = field == Field::kAttribute || field == Field::kAttributeRun;
    const Index column = is_of_column             ? kColumns[below(kColumns.size())]
                         : field == Field::kWords ? Index(Field::kFace)
                                                  : 0;
    Words words(count_of(field, column, index));
    for (Index& word : words) word = Index(random_());
    // Of the last word of an attribute only the bytes that there are.
    if (is_of_column) {
      const std::size_t bytes = Arrays::bytes_of(column);
      std::memset(reinterpret_cast<std::byte*>(words.data()) + bytes, 0,
                  words.size() * sizeof(Index) - bytes);
    }
    arrays.write({field, column, index}, words);
  }
  [[nodiscard]] std::size_t below(std::size_t count) { return random_() % count; }

 private:
  static std::size_t count_of(Field field, Index column, Index index) {
    switch (field) {
      case Field::kPosition:
      case Field::kLoopLinks:
        return 3;
      case Field::kFreeListOfEdges:
        return 2;
      case Field::kRecycledEdge:
        return 8;
      case Field::kWords:
        return 1 + index % Journal::kMostWords;
      case Field::kAttribute:
      case Field::kAttributeRun:
        return (Arrays::bytes_of(column) + 3) / 4;
      default:
        return 1;
    }
  }

  std::mt19937 random_;
};

TEST(Journal, GoesBackAndForthThroughNotesOfAllKinds) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    RandomWrites random(seed);
    Arrays arrays;
    // So many that the notes of a step lie in several chunks.
    std::vector<std::map<Place, Words>> states(1);
    for (int step = 0; step < 12; ++step) {
      for (std::size_t i = random.below(900); i-- > 0;) random.write(arrays);
      arrays.journal().end_step();
      if (arrays.journal().undo_count() == states.size()) states.push_back(arrays.words());
    }
    // A place that no state knows yet has zeros there.
    const auto is_at = [&](std::size_t state) {
      return std::ranges::all_of(arrays.words(), [&](const auto& entry) {
        const auto known = states[state].find(entry.first);
        if (known != states[state].end()) return known->second == entry.second;
        return std::ranges::all_of(entry.second, [](Index word) { return word == 0; });
      });
    };
    std::size_t at = states.size() - 1;
    for (int turn = 0; turn < 60; ++turn) {
      const bool is_back = random.below(2) == 0;
      if (is_back ? arrays.undo() : arrays.redo()) at += is_back ? std::size_t(-1) : 1;
      ASSERT_TRUE(is_at(at)) << "after turn " << turn;
    }
    while (arrays.undo()) --at;
    ASSERT_EQ(at, 0U);
    ASSERT_TRUE(is_at(0));
  }
}

TEST(Journal, TakesFourBytesAWordAndFourForWhatItIsOf) {
  const auto bytes_of = [](const Place& place, std::size_t words) {
    Arrays arrays;
    arrays.write(place, Words(words, 7));
    return arrays.journal().bytes();
  };
  EXPECT_EQ(bytes_of({Field::kNext, 0, 5}, 1), 8U);
  EXPECT_EQ(bytes_of({Field::kNext, 0, kLastNear}, 1), 8U);
  EXPECT_EQ(bytes_of({Field::kNext, 0, kLastNear + 1}, 1), 12U);
  EXPECT_EQ(bytes_of({Field::kPosition, 0, 5}, 3), 16U);
  EXPECT_EQ(bytes_of({Field::kRecycledEdge, 0, 5}, 8), 36U);
  EXPECT_EQ(bytes_of({Field::kWords, Index(Field::kNext), 5}, 63), 260U);
  EXPECT_EQ(bytes_of({Field::kAttribute, 2, 5}, 1), 12U);    // three bytes of an item
  EXPECT_EQ(bytes_of({Field::kAttribute, 63, 5}, 16), 72U);  // sixteen floats
}

TEST(Journal, ForgetsOldStepsWhereverTheirNotesEnd) {
  for (const std::size_t bytes : {std::size_t{1}, std::size_t{20'000}, std::size_t{100'000}}) {
    Arrays arrays({.bytes = bytes});
    RandomWrites random(99);
    std::vector<std::map<Place, Words>> states;
    for (int step = 0; step < 300; ++step) {
      for (int i = 0; i < 60; ++i) random.write(arrays);
      arrays.journal().end_step();
      states.push_back(arrays.words());
    }
    ASSERT_GE(arrays.journal().undo_count(), 1U);
    if (arrays.journal().undo_count() > 1) {
      EXPECT_LE(arrays.journal().bytes(), bytes);
    }
    std::size_t at = states.size() - 1;
    while (arrays.journal().undo_count() > 1) {
      ASSERT_TRUE(arrays.undo());
      ASSERT_EQ(arrays.words(), states[--at]);
    }
  }
}

}  // namespace
}  // namespace halfedge
