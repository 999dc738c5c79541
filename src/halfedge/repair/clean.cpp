#include <halfedge/repair/soup.h>
#include <halfedge/sentence.h>
#include <halfedge/sort.h>

#include <algorithm>
#include <string>

namespace halfedge::repair {

namespace {

using sentence::count_of;
using sentence::number;
using std::to_string;

class Cleaner {
 public:
  Cleaner(const Polygons& input, const Vertices& vertices, Log& log, Faces& out)
      : input_(input), vertices_(vertices), log_(log), out_(out) {}

  [[nodiscard]] bool run() {
    const std::size_t faces = input_.face_count();
    if (!out_.first.reserve(faces + 1) || !out_.source.reserve(faces) ||
        !out_.corners.reserve(input_.corners.size()) ||
        !last_face_.resize(input_.sizes.empty() ? 0 : vertices_.size(), kNone)) {
      return false;
    }
    report_positions();
    (void)out_.first.push_back(0);  // reserved above
    std::size_t begin = 0;
    for (std::size_t f = 0; f < faces; ++f) {
      const std::size_t size = input_.sizes.empty() ? 3 : input_.sizes[f];
      if (!take(Index(f), input_.corners.subspan(begin, size))) return false;
      begin += size;
    }
    return out_.doubled.empty() || out_.doubled.resize(out_.corners.size(), false);
  }

 private:
  // The vertex of a corner of the input as it was written.
  [[nodiscard]] std::string name_of(const Index& corner) const {
    const auto at = std::size_t(&corner - input_.corners.data());
    const auto named =
        std::lower_bound(input_.missing.begin(), input_.missing.end(), at,
                         [](const MissingVertex& a, std::size_t b) { return a.corner < b; });
    if (named != input_.missing.end() && named->corner == at) return named->name;
    return input_.has_negative ? to_string(std::int32_t(corner)) : to_string(corner);
  }

  void report_positions() {
    for (std::size_t v = 0; v < input_.vertex_count(); ++v) {
      if (vertices_.of_input[v] != kNone) continue;
      const float* p = &input_.positions[3 * v];
      log_.add(RepairCode::kNonFinitePosition, [&] {
        return Error{{},
                     sentence::of("Vertex {} is at ({}, {}, {}), which is no position: it was left "
                                  "out, with its faces.",
                                  v, number(p[0]), number(p[1]), number(p[2])),
                     {.vertices = {Index(v)}}};
      });
    }
  }

  [[nodiscard]] bool take(Index f, std::span<const Index> corners) {
    if (!check_indices(f, corners)) return true;
    if (corners.size() < 3) {
      drop(f, RepairCode::kDegreeBelowThree, {corners.begin(), corners.end()}, [&] {
        return sentence::of(" has {}; a face needs at least 3: it was left out.",
                            count_of(corners.size(), "corner"));
      });
      return true;
    }
    if (corners.size() == 3) {
      const Index a = vertices_.of_input[corners[0]];
      const Index b = vertices_.of_input[corners[1]];
      const Index c = vertices_.of_input[corners[2]];
      if (a != b && b != c && c != a) {
        for (const Index v : {a, b, c}) (void)out_.corners.push_back(v);  // reserved
        end_face(f);
        return true;
      }
    }
    if (!without_spikes(corners)) return false;
    const std::span<const Index> rest = loop_.span().subspan(loop_begin_);
    const std::size_t left = rest.size();
    bool is_doubled = false;
    if (left >= 3) {
      for (const Index v : rest) (void)out_.corners.push_back(v);  // reserved
      if (!find_doubled(f, rest, is_doubled)) return false;
      end_face(f);
    }
    if (left == corners.size() && !is_doubled) return true;
    log_.mark(f, RepairCode::kRepeatedVertex);
    log_.add(RepairCode::kRepeatedVertex, [&] {
      if (left < 3) return repeated(f, corners, ", and encloses nothing: it was left out.");
      if (is_doubled) return repeated(f, corners, ": that vertex was doubled.");
      return repeated(
          f, corners,
          sentence::of(": {} of it {} left out.", count_of(corners.size() - left, "corner"),
                       (corners.size() - left == 1 ? "was" : "were")));
    });
    return true;
  }

  void end_face(Index f) {
    (void)out_.source.push_back(f);  // reserved, as is the next
    (void)out_.first.push_back(Index(out_.corners.size()));
  }

  template <class Describe>
  void drop(Index f, RepairCode code, const std::vector<Index>& vertices,
            const Describe& describe) {
    log_.mark(f, code);
    log_.add(code, [&] {
      return Error{
          {}, sentence::of("Face {}{}", f, describe()), {.vertices = vertices, .faces = {f}}};
    });
  }

  [[nodiscard]] bool check_indices(Index f, std::span<const Index> corners) {
    for (const Index& v : corners) {
      if (v >= input_.vertex_count()) {
        drop(f, RepairCode::kIndexOutOfRange, {v}, [&] {
          const std::size_t count = input_.vertex_count();
          return sentence::of(
              " uses vertex {}, but {}: it was left out.", name_of(v),
              (count == 0 ? "there are no vertices" : "the last one is " + to_string(count - 1)));
        });
        return false;
      }
      if (vertices_.of_input[v] == kNone) {
        log_.mark(f, RepairCode::kNonFinitePosition);  // said of the vertex
        return false;
      }
    }
    return true;
  }

  // Leaves in loop_, from loop_begin_, the corners without those that only repeat the one before,
  // without those at which the face turns back to where it came from, and one round of them.
  [[nodiscard]] bool without_spikes(std::span<const Index> corners) {
    loop_.clear();
    loop_begin_ = 0;
    if (!loop_.reserve(corners.size())) return false;
    for (const Index corner : corners) {
      const Index v = vertices_.of_input[corner];
      const std::size_t size = loop_.size();
      if (size >= 1 && loop_[size - 1] == v) continue;
      if (size >= 2 && loop_[size - 2] == v) {
        loop_.pop_back();
      } else {
        (void)loop_.push_back(v);  // reserved above
      }
    }
    // The same where the end meets the beginning.
    for (;;) {
      const std::size_t size = loop_.size() - loop_begin_;
      if (size < 2) break;
      const Index front = loop_[loop_begin_];
      if (loop_[loop_.size() - 1] == front || (size > 2 && loop_[loop_.size() - 2] == front)) {
        loop_.pop_back();
      } else if (size > 2 && loop_[loop_.size() - 1] == loop_[loop_begin_ + 1]) {
        ++loop_begin_;
      } else {
        break;
      }
    }
    return keep_one_round();
  }

  // Leaves one round of a face that goes round the same vertices several times.
  [[nodiscard]] bool keep_one_round() {
    const std::span<const Index> loop = loop_.span().subspan(loop_begin_);
    if (loop.size() < 2) return true;
    // The longest proper border of each beginning, as Knuth, Morris and Pratt search a text.
    if (!border_.recreate(loop.size())) return false;
    border_[0] = 0;
    for (Index i = 1; i < loop.size(); ++i) {
      Index length = border_[i - 1];
      while (length > 0 && loop[length] != loop[i]) length = border_[length - 1];
      border_[i] = length + (loop[length] == loop[i] ? 1U : 0U);
    }
    const std::size_t round = loop.size() - border_[loop.size() - 1];
    if (loop.size() % round == 0) (void)loop_.resize(loop_begin_ + round);  // no more than it has
    return true;
  }

  // Marks the corners of vertices that the face still has more than once.
  [[nodiscard]] bool find_doubled(Index f, std::span<const Index> face, bool& is_doubled) {
    if (face.size() == 3) return true;  // two of three can't be the same and apart
    for (const Index v : face) {
      is_doubled |= last_face_[v] == f;
      last_face_[v] = f;
    }
    if (!is_doubled) return true;
    Array<Index> sorted;
    if (!out_.doubled.resize(out_.corners.size(), false) || !sorted.assign(face)) return false;
    introsort(sorted.begin(), sorted.end());
    const std::size_t begin = out_.corners.size() - face.size();
    for (std::size_t i = 0; i < face.size(); ++i) {
      const auto [low, high] = std::equal_range(sorted.begin(), sorted.end(), face[i]);
      out_.doubled[begin + i] = high - low > 1;
    }
    return true;
  }

  // Two corners of a face that are one vertex; it has some.
  struct Repeat {
    Index a = kNone;
    Index b = kNone;
  };
  [[nodiscard]] Repeat find_repeat(std::span<const Index> corners) {
    const auto less = [this](Index a, Index b) {
      return std::pair(vertices_.of_input[a], a) < std::pair(vertices_.of_input[b], b);
    };
    if (!loop_.assign(corners)) return {};
    introsort(loop_.begin(), loop_.end(), less);
    for (std::size_t i = 1; i < loop_.size(); ++i) {
      if (vertices_.of_input[loop_[i - 1]] == vertices_.of_input[loop_[i]]) {
        return {loop_[i - 1], loop_[i]};
      }
    }
    return {};
  }

  // "Face 7 uses vertex 5 more than once", or vertices that were welded; and what became of it.
  [[nodiscard]] Error repeated(Index f, std::span<const Index> corners, const std::string& fate) {
    const Repeat repeat = find_repeat(corners);
    const std::string face = sentence::of("Face {} uses ", f);
    if (repeat.a == repeat.b) {
      return {{},
              sentence::of("{}vertex {} more than once{}", face, repeat.a, fate),
              {.vertices = {repeat.a}, .faces = {f}}};
    }
    return {
        {},
        sentence::of("{}vertices {} and {}, which were welded{}", face, repeat.a, repeat.b, fate),
        {.vertices = {repeat.a, repeat.b}, .faces = {f}}};
  }

  const Polygons& input_;
  const Vertices& vertices_;
  Log& log_;
  Faces& out_;
  Array<Index> loop_;
  std::size_t loop_begin_ = 0;
  Array<Index> border_;
  Array<Index> last_face_;  // by vertex: the last face seen that has it
};

}  // namespace

bool clean(const Polygons& input, const Vertices& vertices, Log& log, Faces& out) {
  return Cleaner(input, vertices, log, out).run();
}

}  // namespace halfedge::repair
