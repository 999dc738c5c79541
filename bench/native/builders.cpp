#include "builders.h"

#include <algorithm>
#include <memory>

namespace {

using std::uint32_t;

constexpr uint32_t kNone = 0xFFFF'FFFF;

uint32_t next_corner(uint32_t c) { return c % 3 == 2 ? c - 2 : c + 1; }
uint32_t prev_corner(uint32_t c) { return c % 3 == 0 ? c + 2 : c - 1; }

/// Everything about a face but where its three halfedges come from.
void link_face(BareLinks& links, const uint32_t* v, uint32_t f, const uint32_t (&h)[3]) {
  for (const int i : {0, 1, 2}) {
    const int after = i == 2 ? 0 : i + 1;
    links.next[h[i]] = h[after];
    links.prev[h[after]] = h[i];
    links.face[h[i]] = f;
    links.vertex_halfedge[v[i]] = h[i];
  }
  links.face_halfedge[f] = h[2];
}

/// One pass over the faces; the edges of a vertex to larger ones are a chain.
class ChainBuilder final : public Builder {
 public:
  ChainBuilder() : Builder("chains of edges") {}
  [[nodiscard]] bool is_quadratic() const override { return true; }

 private:
  void connect(const TriangleMesh& input, BareLinks& links) override {
    first_.assign(input.vertex_count(), kNone);
    waiting_.resize(input.corners.size() / 2);
    uint32_t edges = 0;
    const auto halfedge = [&](uint32_t from, uint32_t to) {
      const uint32_t low = std::min(from, to);
      const uint32_t high = std::max(from, to);
      uint32_t e = first_[low];
      while (e != kNone && links.to[2 * e] != high) e = waiting_[e];
      if (e == kNone) {
        e = edges++;
        waiting_[e] = first_[low];
        first_[low] = e;
        links.to[2 * e] = high;
        links.to[2 * e + 1] = low;
      }
      return 2 * e + (from > to ? 1U : 0U);
    };
    for (uint32_t f = 0; f < input.face_count(); ++f) {
      const uint32_t* v = &input.corners[3 * std::size_t{f}];
      link_face(links, v, f, {halfedge(v[0], v[1]), halfedge(v[1], v[2]), halfedge(v[2], v[0])});
    }
  }

  std::vector<uint32_t> first_, waiting_;
};

/// The same with a table instead of chains, whose places are counted first.
class TableBuilder final : public Builder {
 public:
  TableBuilder() : Builder("table of edges") {}
  [[nodiscard]] bool is_quadratic() const override { return true; }

 private:
  struct Entry {
    uint32_t high;
    uint32_t edge;
  };

  void connect(const TriangleMesh& input, BareLinks& links) override {
    const std::vector<uint32_t>& corners = input.corners;
    begin_.assign(input.vertex_count() + 1, 0);
    for (std::size_t c = 0; c < corners.size(); c += 3) {
      const uint32_t* v = &corners[c];
      ++begin_[std::min(v[0], v[1]) + 1];
      ++begin_[std::min(v[1], v[2]) + 1];
      ++begin_[std::min(v[2], v[0]) + 1];
    }
    for (std::size_t v = 1; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
    end_.assign(begin_.begin(), begin_.end() - 1);
    table_.resize(corners.size());
    uint32_t edges = 0;
    const auto halfedge = [&](uint32_t from, uint32_t to) {
      const uint32_t low = std::min(from, to);
      const uint32_t high = std::max(from, to);
      uint32_t i = begin_[low];
      while (i < end_[low] && table_[i].high != high) ++i;
      if (i == end_[low]) {
        ++end_[low];
        table_[i] = {high, edges};
        links.to[2 * edges] = high;
        links.to[2 * edges + 1] = low;
        ++edges;
      }
      return 2 * table_[i].edge + (from > to ? 1U : 0U);
    };
    for (uint32_t f = 0; f < input.face_count(); ++f) {
      const uint32_t* v = &corners[3 * std::size_t{f}];
      link_face(links, v, f, {halfedge(v[0], v[1]), halfedge(v[1], v[2]), halfedge(v[2], v[0])});
    }
  }

  std::vector<uint32_t> begin_, end_;
  std::vector<Entry> table_;
};

/// A table of the corners of each vertex. At a vertex, the edges of its outgoing sides are written
/// down by their other end, where the incoming sides then find them: linear for any valence.
class CornerBuilder final : public Builder {
 public:
  CornerBuilder() : Builder("table of corners") {}

 private:
  void connect(const TriangleMesh& input, BareLinks& links) override {
    const std::vector<uint32_t>& corners = input.corners;
    const auto vertices = static_cast<uint32_t>(input.vertex_count());
    end_.assign(vertices, 0);
    for (const uint32_t v : corners) ++end_[v];
    uint32_t sum = 0;
    for (uint32_t& end : end_) {
      const uint32_t count = end;
      end = sum;
      sum += count;
    }
    corners_of_.resize(corners.size());
    for (uint32_t c = 0; c < corners.size(); ++c) corners_of_[end_[corners[c]]++] = c;

    halfedge_.resize(corners.size());
    edge_to_.resize(vertices);
    uint32_t edges = 0;
    for (uint32_t v = 0; v < vertices; ++v) {
      const uint32_t begin = v == 0 ? 0 : end_[v - 1];
      for (uint32_t i = begin; i < end_[v]; ++i) {
        const uint32_t c = corners_of_[i];
        const uint32_t to = corners[next_corner(c)];
        if (to < v) continue;
        edge_to_[to] = edges;
        halfedge_[c] = 2 * edges;
        links.to[2 * edges] = to;
        links.to[2 * edges + 1] = v;
        ++edges;
      }
      for (uint32_t i = begin; i < end_[v]; ++i) {
        const uint32_t c = prev_corner(corners_of_[i]);
        if (corners[c] > v) halfedge_[c] = 2 * edge_to_[corners[c]] + 1;
      }
    }
    for (uint32_t f = 0; f < input.face_count(); ++f) {
      const std::size_t c = 3 * std::size_t{f};
      link_face(links, &corners[c], f, {halfedge_[c], halfedge_[c + 1], halfedge_[c + 2]});
    }
  }

  std::vector<uint32_t> end_, corners_of_, halfedge_, edge_to_;
};

/// Sides sorted by their two vertices, byte by byte from the last; opposites are neighbours then.
class SortBuilder final : public Builder {
 public:
  SortBuilder() : Builder("radix sort") {}

 private:
  struct Side {
    uint32_t low;
    uint32_t high;
    uint32_t corner;
  };

  void connect(const TriangleMesh& input, BareLinks& links) override {
    const std::vector<uint32_t>& corners = input.corners;
    const std::size_t count = corners.size();
    sides_.resize(count);
    spare_.resize(count);
    for (uint32_t c = 0; c < count; ++c) {
      const uint32_t a = corners[c];
      const uint32_t b = corners[next_corner(c)];
      sides_[c] = {std::min(a, b), std::max(a, b), c};
    }
    sort_by([](const Side& side) { return side.high; }, input.vertex_count());
    sort_by([](const Side& side) { return side.low; }, input.vertex_count());

    halfedge_.resize(count);
    for (uint32_t h = 0; h < count; h += 2) {
      const Side* pair = &sides_[h];
      const bool first_runs_up = corners[pair[0].corner] == pair[0].low;
      halfedge_[pair[first_runs_up ? 0 : 1].corner] = h;
      halfedge_[pair[first_runs_up ? 1 : 0].corner] = h + 1;
      links.to[h] = pair[0].high;
      links.to[h + 1] = pair[0].low;
    }
    for (uint32_t f = 0; f < input.face_count(); ++f) {
      const std::size_t c = 3 * std::size_t{f};
      link_face(links, &corners[c], f, {halfedge_[c], halfedge_[c + 1], halfedge_[c + 2]});
    }
  }

  template <class Key>
  void sort_by(const Key& key, std::size_t vertices) {
    constexpr uint32_t kBits = 11;
    for (uint32_t shift = 0; vertices >> shift > 0; shift += kBits) {
      std::vector<uint32_t> begin((1U << kBits) + 1);
      const auto digit = [&](const Side& side) { return key(side) >> shift & ((1U << kBits) - 1); };
      for (const Side& side : sides_) ++begin[digit(side) + 1];
      for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
      for (const Side& side : sides_) spare_[begin[digit(side)]++] = side;
      sides_.swap(spare_);
    }
  }

  std::vector<Side> sides_, spare_;
  std::vector<uint32_t> halfedge_;
};

}  // namespace

void Builder::build(const TriangleMesh& input) {
  for (std::vector<uint32_t>* array : {&links_.next, &links_.prev, &links_.to, &links_.face}) {
    array->resize(input.corners.size());
  }
  links_.vertex_halfedge.resize(input.vertex_count());
  links_.face_halfedge.resize(input.face_count());
  connect(input, links_);
  positions_ = input.positions;
}

std::uint64_t BareLinks::checksum() const {
  std::uint64_t sum = 0;
  const auto mix = [](std::uint64_t a, std::uint64_t b) {
    return (a * 0x9E37'79B9'7F4A'7C15U ^ b) * 0xBF58'476D'1CE4'E5B9U;
  };
  for (uint32_t f = 0; f < face_halfedge.size(); ++f) {
    uint32_t h = face_halfedge[f];
    for (uint32_t i = 0; i < 3; ++i, h = next[h]) {
      sum += mix(mix(3 * std::uint64_t{f} + i, to[h]), face[h ^ 1U]) + (prev[next[h]] == h ? 1 : 0);
    }
  }
  for (uint32_t v = 0; v < vertex_halfedge.size(); ++v) {
    sum += mix(mix(v, to[vertex_halfedge[v]]), face[vertex_halfedge[v]]);
  }
  return sum;
}

std::vector<std::unique_ptr<Builder>> other_builders() {
  std::vector<std::unique_ptr<Builder>> builders;
  builders.push_back(std::make_unique<ChainBuilder>());
  builders.push_back(std::make_unique<TableBuilder>());
  builders.push_back(std::make_unique<CornerBuilder>());
  builders.push_back(std::make_unique<SortBuilder>());
  return builders;
}
