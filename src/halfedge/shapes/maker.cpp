#include <halfedge/sentence.h>
#include <halfedge/shapes/maker.h>

#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

namespace halfedge::shapes {

Maker::Maker(const char* shape, double vertices, double faces, double corners) {
  if (vertices > kMaxSlots || corners > kMaxSlots) {
    error_ = {"too-large",
              sentence::of("{} of {} vertices and {} faces has more items than can be addressed.",
                           shape, sentence::in_full(vertices), sentence::in_full(faces))};
    return;
  }
  const bool all_triangles = corners == 3 * faces;
  if (!soup_.positions.reserve(3 * std::size_t(vertices)) ||
      !soup_.corners.reserve(std::size_t(corners)) ||
      (!all_triangles && !soup_.sizes.reserve(std::size_t(faces)))) {
    error_ = {"out-of-memory", sentence::of("There is not enough memory for the {} faces of {}.",
                                            sentence::in_full(faces), shape)};
  }
}

void Maker::vertex(double x, double y, double z) {
  for (const double coordinate : {x, y, z}) (void)soup_.positions.push_back(float(coordinate));
}

void Maker::face(std::span<const Index> corners) {
  for (const Index corner : corners) (void)soup_.corners.push_back(corner);
  if (soup_.sizes.capacity() > 0) (void)soup_.sizes.push_back(Index(corners.size()));
}

void Maker::quad(Index a, Index b, Index c, Index d, Faces faces) {
  if (faces == Faces::kQuads) return face({a, b, c, d});
  face({a, b, c});
  face({a, c, d});
}

void Maker::polygon(Index first, Index count, bool reverse) {
  for (Index i = 0; i < count; ++i) {
    (void)soup_.corners.push_back(first + (reverse ? (count - i) % count : i));
  }
  if (soup_.sizes.capacity() > 0) (void)soup_.sizes.push_back(count);
}

Result<PolygonSoup> Maker::take() {
  if (!ready()) return std::move(error_);
  return std::move(soup_);
}

Error check_lengths(const char* shape, std::initializer_list<double> lengths) {
  for (const double length : lengths) {
    if (length > 0 && length <= double{std::numeric_limits<float>::max()}) continue;
    return {
        "bad-argument",
        sentence::of("A length of {} is {}, expected a positive number that fits a 32-bit float.",
                     shape, sentence::number(length))};
  }
  return {};
}

Error check_count(const char* shape, const char* what, Index count, Index least) {
  if (count >= least) return {};
  return {"bad-argument", sentence::of("{} has {}, expected {} or more", shape,
                                       sentence::count_of(count, what), least)};
}

bool refused(std::initializer_list<Error> checks, Error& error) {
  for (const Error& check : checks) {
    if (check.code.empty()) continue;
    error = check;
    return true;
  }
  return false;
}

Turn turn(std::uint64_t i, std::uint64_t n) {
  // Mirrored into the first eighth of the circle, where the power series converge fast; that leaves
  // out the sine and cosine of the C library, which are large for WebAssembly.
  const std::uint64_t eighth = 8 * i / n;
  const std::uint64_t rest = 8 * i % n;
  const double angle =
      double(eighth % 2 == 0 ? rest : n - rest) / double(n) * (std::numbers::pi / 4);
  double c = 1;
  double s = angle;
  double power_of_c = 1;
  double power_of_s = angle;
  for (int k = 1; k < 10; ++k) {
    power_of_c *= -angle * angle / ((2 * k - 1) * (2 * k));
    power_of_s *= -angle * angle / ((2 * k) * (2 * k + 1));
    c += power_of_c;
    s += power_of_s;
  }
  if ((eighth + 1) / 2 % 2 == 1) std::swap(c, s);
  if (eighth >= 2 && eighth <= 5) c = -c;
  if (eighth >= 4 && eighth <= 7) s = -s;
  return {c, s};
}

}  // namespace halfedge::shapes
