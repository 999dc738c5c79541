#pragma once

#include <halfedge/repair/repair.h>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace halfedge::repair {

/// Collects what a repair does: counts everything, writes the first sentences, marks the faces.
class Log {
 public:
  explicit Log(RepairReport& report) : report_(report) {}

  /// False when memory is exhausted.
  [[nodiscard]] bool begin(std::size_t faces) { return marks_.resize(faces, 0); }

  /// One more of `code`. `describe` makes the Error; it isn't called once there are enough.
  template <class Describe>
  void add(RepairCode code, const Describe& describe) {
    if (report_.counts[std::size_t(code)]++ >= RepairReport::kMaxListed) return;
    Error error = describe();
    error.code = name_of(code);
    report_.problems.push_back(std::move(error));
  }

  /// `face` of the input was touched.
  void mark(Index face, RepairCode code) {
    marks_[face] = std::uint16_t(marks_[face] | 1U << std::uint32_t(code));
  }

  /// As if there were `more` of the code last added.
  void add_more(RepairCode code, std::size_t more) { report_.counts[std::size_t(code)] += more; }

  /// Writes the verdicts and the summary. pre: the maps are filled in. False when memory is
  /// exhausted.
  [[nodiscard]] bool finish(const RepairOptions& options, std::size_t doubled_vertices);

 private:
  RepairReport& report_;
  Array<std::uint16_t> marks_;  // by face of the input
};

}  // namespace halfedge::repair
