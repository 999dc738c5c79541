#include <algorithm>

#include "contender.h"

namespace {

constexpr std::uint32_t kNone = 0xFFFF'FFFF;

/// The baseline: what an expert writes by hand in an afternoon for one program. Flat arrays,
/// opposite(h) = h ^ 1, edges numbered as the faces come, opposites found through a table of the
/// corners that leave each vertex. It takes a closed oriented manifold for granted and checks
/// nothing.
class Flat final : public Contender {
 public:
  void build(const TriangleMesh& input) override {
    const std::size_t corner_count = input.corners.size();
    const std::uint32_t* vertex = input.corners.data();
    positions_ = input.positions;
    leaving_begin_.assign(input.vertex_count() + 1, 0);
    for (std::size_t c = 0; c < corner_count; ++c) ++leaving_begin_[vertex[c] + 1];
    for (std::size_t v = 0; v < input.vertex_count(); ++v) {
      leaving_begin_[v + 1] += leaving_begin_[v];
    }
    fill_ = leaving_begin_;
    leaving_.resize(corner_count);
    for (std::size_t c = 0; c < corner_count; ++c) {
      leaving_[fill_[vertex[c]]++] = static_cast<std::uint32_t>(c);
    }

    const auto following = [](std::uint32_t c) { return c % 3 == 2 ? c - 2 : c + 1; };
    halfedge_of_corner_.assign(corner_count, kNone);
    to_.resize(corner_count);
    next_.resize(corner_count);
    prev_.resize(corner_count);
    face_.resize(corner_count);
    std::uint32_t halfedges = 0;
    for (std::uint32_t c = 0; c < corner_count; ++c) {
      if (halfedge_of_corner_[c] != kNone) continue;
      const std::uint32_t from = vertex[c];
      const std::uint32_t to = vertex[following(c)];
      halfedge_of_corner_[c] = halfedges;
      to_[halfedges] = to;
      to_[halfedges + 1] = from;
      for (std::uint32_t i = leaving_begin_[to]; i < leaving_begin_[to + 1]; ++i) {
        const std::uint32_t d = leaving_[i];
        if (vertex[following(d)] != from) continue;
        halfedge_of_corner_[d] = halfedges + 1;
        break;
      }
      halfedges += 2;
    }

    vertex_halfedge_.resize(input.vertex_count());
    face_halfedge_.resize(input.face_count());
    for (std::uint32_t f = 0; f < input.face_count(); ++f) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t h = halfedge_of_corner_[3 * f + i];
        const std::uint32_t n = halfedge_of_corner_[3 * f + (i + 1) % 3];
        next_[h] = n;
        prev_[n] = h;
        face_[h] = f;
        vertex_halfedge_[vertex[3 * f + i]] = h;
      }
      face_halfedge_[f] = halfedge_of_corner_[3 * f + 2];
    }
  }

  std::int64_t circulate() override {
    std::int64_t counter = 0;
    for (const std::uint32_t first : vertex_halfedge_) {
      std::uint32_t h = first;
      do {
        if (face_[h] != kNone) ++counter;
        h = next_[h ^ 1U];
      } while (h != first);
    }
    for (const std::uint32_t first : face_halfedge_) {
      std::uint32_t h = first;
      do {
        --counter;
        h = next_[h];
      } while (h != first);
    }
    return counter;
  }

  std::uint64_t one_ring_sum() override {
    std::uint64_t sum = 0;
    for (const std::uint32_t first : vertex_halfedge_) {
      std::uint32_t h = first;
      do {
        sum += to_[h];
        h = next_[h ^ 1U];
      } while (h != first);
    }
    return sum;
  }

 private:
  std::vector<float> positions_;
  std::vector<std::uint32_t> next_, prev_, to_, face_, vertex_halfedge_, face_halfedge_;
  std::vector<std::uint32_t> leaving_begin_, fill_, leaving_, halfedge_of_corner_;
};

}  // namespace

std::unique_ptr<Contender> make_flat() { return std::make_unique<Flat>(); }
