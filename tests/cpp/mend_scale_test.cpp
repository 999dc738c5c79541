// Repairs of large inputs that are chosen to be slow: each takes about linear time.

#include <gtest/gtest.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/operations/append.h>

#include <cmath>
#include <initializer_list>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "support/mending.h"
#include "support/scaling.h"

namespace halfedge::test {
namespace {

using Lists = std::vector<std::vector<Index>>;

/// That the repair does so much, which its summary says, and nothing else.
void expect_summary(const Result<mend::Report>& report, const std::string& summary) {
  ASSERT_TRUE(report);
  EXPECT_EQ(report.value().summary, summary);
}

// A strip of quads whose upper vertices coincide.
TEST(MendScale, APoleThatIsNotMerged) {
  const auto strip = [](Index n) {
    std::vector<Point> points(n + 1, Point{0, 1, 0});
    Lists faces;
    for (Index i = 0; i < n; ++i) faces.push_back({n + 1 + i, n + 2 + i, i + 1, i});
    for (Index i = 0; i <= n; ++i) {
      const double angle = 6.0 * i / n;
      points.push_back({float(std::cos(angle)), 0, float(std::sin(angle))});
    }
    return mesh_of(points, faces);
  };
  expect_no_quadratic_step(20'000, strip, [](Mesh& mesh) {
    const std::string edges = std::to_string(mesh.face_count());
    expect_summary(mend::remove_degenerate_faces(mesh), edges + " edges collapsed.");
  });
}

// Triangles around one centre, of which no two share a vertex.
TEST(MendScale, AFanInPieces) {
  const auto fan = [](Index n) {
    std::vector<Point> points;
    Lists faces;
    const auto on_circle = [&](Index i) {
      const double angle = 2 * std::numbers::pi * (i % n) / n;
      return Point{float(std::cos(angle)), float(std::sin(angle)), 0};
    };
    for (Index i = 0; i < n; ++i) {
      points.insert(points.end(), {Point{0, 0, 0}, on_circle(i), on_circle(i + 1)});
      faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return mesh_of(points, faces);
  };
  expect_no_quadratic_step(30'000, fan, [](Mesh& mesh) {
    const std::string edges = std::to_string(mesh.face_count());
    expect_summary(mend::stitch_boundaries(mesh), edges + " edges stitched.");
    EXPECT_EQ(mesh.vertex_count(), mesh.face_count() + 1);
  });
}

// The caps of a cylinder and the quads between them, or two polygons back to back, of which no two
// share a vertex.
TEST(MendScale, HugePolygonsInPieces) {
  for (const bool has_quads : {true, false}) {
    SCOPED_TRACE(has_quads);
    const auto cylinder = [&](Index n) {
      const auto on_circle = [&](Index i, float height) {
        const double angle = 2 * std::numbers::pi * (i % n) / n;
        return Point{float(std::cos(angle)), float(std::sin(angle)), height};
      };
      std::vector<Point> points;
      Lists faces;
      const auto add = [&](const std::vector<Point>& corners) {
        faces.emplace_back();
        for (const Point p : corners) {
          faces.back().push_back(Index(points.size()));
          points.push_back(p);
        }
      };
      const float height = has_quads ? 1 : 0;
      std::vector<Point> low;
      std::vector<Point> high;
      for (Index i = 0; i < n; ++i) {
        low.push_back(on_circle(n - i, 0));
        high.push_back(on_circle(i, height));
      }
      add(low);
      add(high);
      for (Index i = 0; has_quads && i < n; ++i) {
        add({on_circle(i, 0), on_circle(i + 1, 0), on_circle(i + 1, 1), on_circle(i, 1)});
      }
      return mesh_of(points, faces);
    };
    expect_no_quadratic_step(20'000, cylinder, [&](Mesh& mesh) {
      const Index edges = has_quads ? 3 * (mesh.face_count() - 2) : mesh.edge_count() / 2;
      expect_summary(mend::stitch_boundaries(mesh), std::to_string(edges) + " edges stitched.");
      EXPECT_EQ(boundary_loops(mesh).value().size(), 0U);
    });
  }
}

// A polygon with a hole all around it, of which every other side has a triangle in between.
TEST(MendScale, AHugePolygonAtTheBoundary) {
  const auto polygon = [](Index n) {
    std::vector<Point> points;
    Lists faces(1);
    for (Index i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n;
      points.push_back({float(std::cos(angle)), float(std::sin(angle)), 0});
      faces[0].push_back(i);
    }
    for (Index i = 0; i < n; i += 2) {
      const double angle = 2 * std::numbers::pi * (i + 0.5) / n;
      faces.push_back({i + 1, i, Index(points.size())});
      points.push_back({float(2 * std::cos(angle)), float(2 * std::sin(angle)), 0});
    }
    return mesh_of(points, faces);
  };
  expect_no_quadratic_step(60'000, polygon, [](Mesh& mesh) {
    expect_summary(mend::fill_holes(mesh), "1 hole left whose filling would fold over.");
  });
}

// Tetrahedra in a row along each axis, and in a cloud, each fourth of them around a small one.
TEST(MendScale, ManyComponentsThatMayBeNested) {
  for (const unsigned axes : {1U, 2U, 4U, 7U}) {
    SCOPED_TRACE(axes);
    const auto dust = [&](Index n) {
      std::mt19937 random(axes);
      std::uniform_real_distribution<float> anywhere(0, 1e4F);
      std::vector<Point> points;
      Lists faces;
      const auto add = [&](Point p, float size) {
        const Index v = Index(points.size());
        points.insert(points.end(), {{p.x - size, p.y - size, p.z - size},
                                     {p.x + 3 * size, p.y - size, p.z - size},
                                     {p.x - size, p.y + 3 * size, p.z - size},
                                     {p.x - size, p.y - size, p.z + 3 * size}});
        faces.insert(
            faces.end(),
            {{v, v + 2, v + 1}, {v, v + 1, v + 3}, {v + 1, v + 2, v + 3}, {v + 2, v, v + 3}});
      };
      for (Index i = 0; i < n; ++i) {
        const Point p = {(axes & 1U) != 0 ? anywhere(random) : 0,
                         (axes & 2U) != 0 ? anywhere(random) : 0,
                         (axes & 4U) != 0 ? anywhere(random) : 0};
        add(p, 0.01F);
        if (i % 4 == 0) add(p, 0.002F);
      }
      return mesh_of(points, faces);
    };
    expect_no_quadratic_step(20'000, dust, [](Mesh& mesh) {
      const Result<mend::Report> report = mend::orient_outward(mesh, {.nested = true});
      ASSERT_TRUE(report);
      const std::size_t turned = report.value().count(mend::Code::kReversedComponent);
      EXPECT_NEAR(double(turned), mesh.face_count() / 20.0, mesh.face_count() / 200.0);
    });
  }
}

TEST(MendScale, ADustOfSingleFaces) {
  const auto dust = [](Index n) {
    std::vector<Point> points;
    Lists faces;
    for (Index i = 0; i < n; ++i) {
      const auto x = float(i);
      faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
      points.insert(points.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}});
    }
    return mesh_of(points, faces);
  };
  expect_no_quadratic_step(100'000, dust, [](Mesh& mesh) {
    const std::string faces = std::to_string(mesh.face_count());
    expect_summary(mend::drop_small_components(mesh, {.faces = 2}), faces + " components dropped.");
  });
}

// A slit that several others lie along: each edge waits for the one beside it.
TEST(MendScale, BoxesAlongALongRowOfEdges) {
  const auto boxes = [](Index n) {
    std::vector<Point> points;
    Lists faces;
    const auto add = [&](std::initializer_list<Point> corners) {
      faces.emplace_back();
      for (const Point& p : corners) {
        faces.back().push_back(Index(points.size()));
        points.push_back(p);
      }
    };
    // Two ridges of two slopes each, which meet along the x axis.
    for (const float side : {1.0F, -1.0F}) {
      for (Index i = 0; i < n; ++i) {
        const float x = float(i);
        add({{x, 0, 0}, {x + 1, 0, 0}, {x + 1, side, side}, {x, side, side}});
        add({{x + 1, 0, 0}, {x, 0, 0}, {x, 2 * side, side}, {x + 1, 2 * side, side}});
      }
      add({{0, 0, 0}, {0, side, side}, {0, 2 * side, side}});
    }
    return mesh_of(points, faces);
  };
  expect_no_quadratic_step(10'000, boxes, [](Mesh& mesh) {
    const Index n = mesh.face_count() / 4;
    const Result<mend::Report> report = mend::stitch_boundaries(mesh);
    ASSERT_TRUE(report);
    EXPECT_EQ(report.value().summary, std::to_string(6 * n) + " edges stitched.");
  });
}

}  // namespace
}  // namespace halfedge::test
