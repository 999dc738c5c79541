#include <algorithm>
#include <cmath>
#include <tuple>

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

  void centre() override {
    double sum[3] = {};
    for (std::size_t x = 0; x < positions_.size(); x += 3) {
      for (std::size_t i = 0; i < 3; ++i) sum[i] += double(positions_[x + i]);
    }
    float mean[3];
    for (int i = 0; i < 3; ++i) mean[i] = float(sum[i] / double(vertex_halfedge_.size()));
    for (std::size_t x = 0; x < positions_.size(); x += 3) {
      for (std::size_t i = 0; i < 3; ++i) positions_[x + i] -= mean[i];
    }
  }

  void compute_normals() override {
    of_faces_.resize(3 * face_halfedge_.size());
    of_vertices_.resize(positions_.size());
    for (std::size_t f = 0; f < face_halfedge_.size(); ++f) {
      const std::uint32_t h = face_halfedge_[f];
      const float* p = &positions_[3 * std::size_t{to_[h ^ 1U]}];
      const float* q = &positions_[3 * std::size_t{to_[h]}];
      const float* r = &positions_[3 * std::size_t{to_[next_[h]]}];
      const float a[3] = {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
      const float b[3] = {r[0] - p[0], r[1] - p[1], r[2] - p[2]};
      const float normal[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                               a[0] * b[1] - a[1] * b[0]};
      store_unit(normal, &of_faces_[3 * f]);
    }
    for (std::size_t v = 0; v < vertex_halfedge_.size(); ++v) {
      float sum[3] = {};
      std::uint32_t h = vertex_halfedge_[v];
      do {
        const float* n = &of_faces_[3 * std::size_t{face_[h]}];
        sum[0] += n[0], sum[1] += n[1], sum[2] += n[2];
        h = next_[h ^ 1U];
      } while (h != vertex_halfedge_[v]);
      store_unit(sum, &of_vertices_[3 * v]);
    }
  }

  void smooth() override {
    for (std::size_t v = 0; v < vertex_halfedge_.size(); ++v) {
      if (face_[vertex_halfedge_[v]] == kNone) continue;
      float sum[3] = {};
      float valence = 0;
      std::uint32_t h = vertex_halfedge_[v];
      do {
        const float* p = &positions_[3 * std::size_t{to_[h]}];
        sum[0] += p[0], sum[1] += p[1], sum[2] += p[2];
        ++valence;
        h = next_[h ^ 1U];
      } while (h != vertex_halfedge_[v]);
      for (std::size_t i = 0; i < 3; ++i) positions_[3 * v + i] = sum[i] / valence;
    }
  }

  std::vector<float> geometry() override {
    std::vector<float> all = positions_;
    all.insert(all.end(), of_vertices_.begin(), of_vertices_.end());
    return all;
  }

  void keep() override { kept_ = links_of_this(); }
  void restore() override {
    std::tie(positions_, next_, prev_, to_, face_, vertex_halfedge_, face_halfedge_) = kept_;
    marks_.assign(vertex_halfedge_.size() + face_halfedge_.size(), kNone);
  }

  void subdivide() override {
    const auto vertices = static_cast<std::uint32_t>(vertex_halfedge_.size());
    const auto faces = static_cast<std::uint32_t>(face_halfedge_.size());
    const auto halfedges = static_cast<std::uint32_t>(next_.size());
    std::vector<float> moved(positions_.size());
    for (std::uint32_t v = 0; v < vertices; ++v) {
      float sum[3] = {};
      unsigned valence = 0;
      std::uint32_t h = vertex_halfedge_[v];
      do {
        const float* p = &positions_[3 * std::size_t{to_[h]}];
        sum[0] += p[0], sum[1] += p[1], sum[2] += p[2];
        ++valence;
        h = next_[h ^ 1U];
      } while (h != vertex_halfedge_[v]);
      const float weight = sqrt3_weight(valence);
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t x = 3 * std::size_t{v} + i;
        moved[x] = (1 - weight) * positions_[x] + weight / float(valence) * sum[i];
      }
    }
    split_all(faces);
    std::copy(moved.begin(), moved.end(), positions_.begin());
    for (std::uint32_t h = 0; h < halfedges; h += 2) flip(h);
  }

  void split_and_collapse() override {
    const auto vertices = static_cast<std::uint32_t>(vertex_halfedge_.size());
    const auto faces = static_cast<std::uint32_t>(face_halfedge_.size());
    split_all(faces);
    for (std::uint32_t v = vertices; v < vertices + faces; ++v) collapse(vertex_halfedge_[v]);
  }

  void compact() override {
    std::vector<std::uint32_t> vertex(vertex_halfedge_.size(), kNone);
    std::vector<std::uint32_t> edge(next_.size() / 2, kNone);
    std::vector<std::uint32_t> face(face_halfedge_.size(), kNone);
    std::uint32_t vertices = 0;
    std::uint32_t edges = 0;
    std::uint32_t faces = 0;
    for (std::size_t v = 0; v < vertex.size(); ++v) {
      if (vertex_halfedge_[v] != kNone) vertex[v] = vertices++;
    }
    for (std::size_t e = 0; e < edge.size(); ++e) {
      if (next_[2 * e] != kNone) edge[e] = edges++;
    }
    for (std::size_t f = 0; f < face.size(); ++f) {
      if (face_halfedge_[f] != kNone) face[f] = faces++;
    }
    const auto halfedge = [&](std::uint32_t h) { return 2 * edge[h >> 1U] + (h & 1U); };
    for (std::size_t v = 0; v < vertex.size(); ++v) {
      if (vertex[v] == kNone) continue;
      vertex_halfedge_[vertex[v]] = halfedge(vertex_halfedge_[v]);
      std::copy_n(&positions_[3 * v], 3, &positions_[3 * std::size_t{vertex[v]}]);
    }
    for (std::size_t f = 0; f < face.size(); ++f) {
      if (face[f] != kNone) face_halfedge_[face[f]] = halfedge(face_halfedge_[f]);
    }
    for (std::uint32_t h = 0; h < next_.size(); ++h) {
      if (edge[h >> 1U] == kNone) continue;
      const std::uint32_t moved = halfedge(h);
      next_[moved] = halfedge(next_[h]);
      prev_[moved] = halfedge(prev_[h]);
      to_[moved] = vertex[to_[h]];
      face_[moved] = face[face_[h]];
    }
    resize(vertices, edges, faces);
  }

  std::uint64_t valence_sum() override {
    std::uint64_t sum = 0;
    for (std::size_t h = 0; h < next_.size(); h += 2) sum += next_[h] != kNone ? 1 : 0;
    for (const std::uint32_t first : face_halfedge_) sum += first != kNone ? 1 : 0;
    for (const std::uint32_t first : vertex_halfedge_) {
      if (first == kNone) continue;
      std::uint64_t valence = 0;
      std::uint32_t h = first;
      do {
        ++valence;
        h = next_[h ^ 1U];
      } while (h != first);
      sum += valence * valence;
    }
    return sum;
  }

 private:
  using Arrays =
      std::tuple<std::vector<float>, std::vector<std::uint32_t>, std::vector<std::uint32_t>,
                 std::vector<std::uint32_t>, std::vector<std::uint32_t>, std::vector<std::uint32_t>,
                 std::vector<std::uint32_t>>;

  [[nodiscard]] Arrays links_of_this() const {
    return {positions_, next_, prev_, to_, face_, vertex_halfedge_, face_halfedge_};
  }

  static void store_unit(const float (&v)[3], float* out) {
    const float scale = 1 / std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int i = 0; i < 3; ++i) out[i] = scale * v[i];
  }

  void resize(std::size_t vertices, std::size_t edges, std::size_t faces) {
    positions_.resize(3 * vertices);
    vertex_halfedge_.resize(vertices);
    face_halfedge_.resize(faces);
    for (auto* array : {&next_, &prev_, &to_, &face_}) array->resize(2 * edges);
  }

  void link(std::uint32_t h, std::uint32_t n) {
    next_[h] = n;
    prev_[n] = h;
  }

  void make_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t f) {
    link(a, b), link(b, c), link(c, a);
    face_[a] = face_[b] = face_[c] = f;
    face_halfedge_[f] = a;
  }

  void split_all(std::uint32_t faces) {
    std::size_t v = vertex_halfedge_.size();
    std::size_t h = next_.size();
    std::size_t f = face_halfedge_.size();
    resize(v + faces, h / 2 + 3 * std::size_t{faces}, f + 2 * std::size_t{faces});
    for (std::uint32_t old = 0; old < faces; ++old, ++v, h += 6, f += 2) {
      split(old, std::uint32_t(v), std::uint32_t(h), std::uint32_t(f));
    }
  }

  void split(std::uint32_t old, std::uint32_t v, std::uint32_t first, std::uint32_t f) {
    const std::uint32_t side[3] = {face_halfedge_[old], next_[face_halfedge_[old]],
                                   prev_[face_halfedge_[old]]};
    for (std::uint32_t i = 0; i < 3; ++i) {  // spoke i: from the end of side i to v
      to_[first + 2 * i] = v;
      to_[first + 2 * i + 1] = to_[side[i]];
    }
    for (std::size_t x = 0; x < 3; ++x) {
      positions_[3 * std::size_t{v} + x] = (positions_[3 * std::size_t{to_[side[0]]} + x] +
                                            positions_[3 * std::size_t{to_[side[1]]} + x] +
                                            positions_[3 * std::size_t{to_[side[2]]} + x]) /
                                           3;
    }
    vertex_halfedge_[v] = first + 1;
    for (std::uint32_t i = 0; i < 3; ++i) {
      make_triangle(side[i], first + 2 * i, first + 2 * ((i + 2) % 3) + 1,
                    i == 0 ? old : f + i - 1);
    }
  }

  void flip(std::uint32_t h) {
    const std::uint32_t o = h ^ 1U;
    const std::uint32_t h1 = next_[h], h2 = prev_[h], o1 = next_[o], o2 = prev_[o];
    const std::uint32_t a = to_[h1], b = to_[o1];
    std::uint32_t at_a = h2;  // leaves a
    do {
      if (to_[at_a] == b) return;  // joined already
      at_a = next_[at_a ^ 1U];
    } while (at_a != h2);
    if (vertex_halfedge_[to_[o]] == h) vertex_halfedge_[to_[o]] = o1;
    if (vertex_halfedge_[to_[h]] == o) vertex_halfedge_[to_[h]] = h1;
    to_[h] = a;
    to_[o] = b;
    const std::uint32_t f = face_[h], g = face_[o];
    make_triangle(h, h2, o1, f);
    make_triangle(o, o2, h1, g);
  }

  // `instead` takes the place of `outer` in its face.
  void replace(std::uint32_t outer, std::uint32_t instead) {
    const std::uint32_t before = prev_[outer];
    link(instead, next_[outer]);
    link(before, instead);
    face_[instead] = face_[outer];
    face_halfedge_[face_[outer]] = instead;
  }

  // from(h) disappears into to(h), if their only common neighbours are those of their triangles.
  void collapse(std::uint32_t h) {
    const std::uint32_t o = h ^ 1U;
    const std::uint32_t gone = to_[o], kept = to_[h];
    std::uint32_t around = vertex_halfedge_[kept];
    do {
      marks_[to_[around]] = gone;
      around = next_[around ^ 1U];
    } while (around != vertex_halfedge_[kept]);
    int common = 0;
    around = h;
    do {
      common += marks_[to_[around]] == gone ? 1 : 0;
      around = next_[around ^ 1U];
    } while (around != h);
    if (common != 2) return;

    around = h;
    do {
      to_[around ^ 1U] = kept;
      around = next_[around ^ 1U];
    } while (around != h);
    const std::uint32_t stays_h = next_[h], stays_o = prev_[o];  // kept -> a, b -> kept
    const std::uint32_t out_h = prev_[h], out_o = next_[o];      // a -> gone, gone -> b
    const std::uint32_t a = to_[stays_h], b = to_[out_o];
    face_halfedge_[face_[h]] = face_halfedge_[face_[o]] = kNone;
    replace(out_h ^ 1U, stays_h);
    replace(out_o ^ 1U, stays_o);
    if (vertex_halfedge_[a] == out_h) vertex_halfedge_[a] = stays_h ^ 1U;
    if (vertex_halfedge_[b] == (out_o ^ 1U)) vertex_halfedge_[b] = stays_o;
    if (vertex_halfedge_[kept] == o) vertex_halfedge_[kept] = stays_h;
    for (const std::uint32_t side : {out_h, out_o}) next_[side] = next_[side ^ 1U] = kNone;
    next_[h] = next_[o] = kNone;
    vertex_halfedge_[gone] = kNone;
  }

  std::vector<float> positions_;
  std::vector<std::uint32_t> next_, prev_, to_, face_, vertex_halfedge_, face_halfedge_;
  std::vector<std::uint32_t> marks_;
  std::vector<float> of_faces_, of_vertices_;  // normals
  Arrays kept_;
  std::vector<std::uint32_t> leaving_begin_, fill_, leaving_, halfedge_of_corner_;
};

}  // namespace

std::unique_ptr<Contender> make_flat() { return std::make_unique<Flat>(); }
