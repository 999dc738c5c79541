// Where memory ends, a repair says so; what it has done by then is valid, and can be undone.

#include <gtest/gtest.h>
#include <halfedge/mend/mend.h>
#include <halfedge/operations/append.h>
#include <halfedge/operations/cut.h>
#include <halfedge/operations/deletion.h>
#include <halfedge/operations/orientation.h>
#include <halfedge/shapes/shapes.h>
#include <halfedge/validate/validate.h>

#include <cstddef>
#include <cstdlib>
#include <string>

#include "support/complexes.h"
#include "support/limited_memory.h"

namespace halfedge::test {
namespace {

#if defined(HALFEDGE_CAN_LIMIT_MEMORY)

constexpr int kRepairs = 6;

Result<mend::Report> repair(Mesh& mesh, int which) {
  switch (which) {
    case 0:
      return mend::split_pinched_vertices(mesh);
    case 1:
      return mend::stitch_boundaries(mesh, {.tolerance = 1e-6});
    case 2:
      return mend::remove_degenerate_faces(mesh, {.tolerance = 0.2});
    case 3:
      return mend::drop_small_components(mesh, {.faces = 5});
    case 4:
      return mend::fill_holes(mesh);
    default:
      return mend::orient_outward(mesh, {.nested = true});
  }
}

/// With something for every repair: `size` by `size` quads of which every other one is missing, or
/// all the triangles of a sheet apart, or tetrahedra inside of each other.
Mesh damaged(int which, Index size) {
  Mesh mesh;
  if (which == 0 || which == 4) {
    mesh = shapes::mesh_of(shapes::torus(size, size)).value();
    for (Index f = 0; f < mesh.face_slots(); ++f) {
      if ((f / size + f % size) % 2 == 1 && (which == 0 || f % 3 == 0)) {
        (void)operations::delete_face(mesh, Face(f));
      }
    }
  } else if (which == 1 || which == 2) {
    mesh = shapes::mesh_of(
               shapes::grid(size, size, shapes::Faces::kTriangles, float(size), float(size)))
               .value();
    for (Index e = 0; which == 1 && e < mesh.edge_slots(); e += 2) {
      (void)operations::cut(mesh, mesh.edge_halfedge(Edge(e)));
    }
    for (Index v = 0; which == 2 && v < mesh.vertex_slots(); v += 3) {
      Point p = mesh.position(Vertex(v));
      p.x += v % 2 == 0 ? 0.9F : 0.5F;
      mesh.set_position(Vertex(v), p);
    }
  } else {
    for (Index i = 0; i < size * size / 8; ++i) {
      Mesh part = shapes::mesh_of(i % 2 == 0 ? shapes::tetrahedron() : shapes::cube()).value();
      for (const Vertex v : part.vertices()) {
        const Point p = part.position(v);
        part.set_position(v, {p.x + 5 * float(i / 2), p.y, p.z});
      }
      if (i % 3 == 0) (void)operations::reverse(part);
      (void)append(mesh, part);
    }
  }
  return mesh;
}

// These end with 0 if all went well, else with a number that tells what did not.

/// What holds after a repair of `start`, whether memory was enough or not; whether it was undone,
/// which it can't be if there was no memory for the notes.
bool is_undone(Mesh& mesh, const Mesh& start, const Result<mend::Report>& report) {
  if (!limit_address_space(RLIM_INFINITY)) std::_Exit(2);
  if (!report && report.error().code != "out-of-memory") std::_Exit(4);
  if (has_errors(validate(mesh))) std::_Exit(5);
  mesh.end_step();
  if (!mesh.undo()) return false;
  if (!(Snapshot(mesh) == Snapshot(start))) std::_Exit(6);
  return true;
}

Mesh copy_to_repair(const Mesh& start, bool with_history) {
  Mesh mesh = copy_of(start);
  if (with_history && !mesh.enable_history()) std::_Exit(3);
  return mesh;
}

[[noreturn]] void repair_with_more_and_more_memory(int which, bool with_history) {
  const Mesh start = damaged(which, 100);
  constexpr std::size_t kStep = std::size_t{64} << 10U;
  for (std::size_t failures = 0, more = 0;; ++failures, more += kStep * (1 + failures / 8)) {
    Mesh mesh = copy_to_repair(start, with_history);
    PiecesForErrors pieces;
    if (!limit_address_space(address_space_in_use() + more)) std::_Exit(2);
    pieces.give_back();
    const Result<mend::Report> report = repair(mesh, which);
    if (is_undone(mesh, start, report) == with_history && report) {
      std::_Exit(report.value().summary != "Nothing to repair." ? 0 : 7);
    }
  }
}

[[noreturn]] void repair_without_memory(int which, bool with_history) {
  const Mesh start = damaged(which, 200);
  Mesh mesh = copy_to_repair(start, with_history);
  use_up_memory();
  const Result<mend::Report> report = repair(mesh, which);
  if (report) std::_Exit(8);
  (void)is_undone(mesh, start, report);
  leave(true);
}

TEST(MendMemoryDeathTest, WhereverMemoryEndsTheMeshIsValid) {
  for (int which = 0; which < kRepairs; ++which) {
    for (const bool with_history : {false, true}) {
      SCOPED_TRACE(std::to_string(which) + (with_history ? " with history" : ""));
      EXPECT_EXIT(repair_with_more_and_more_memory(which, with_history), testing::ExitedWithCode(0),
                  "");
      EXPECT_EXIT(repair_without_memory(which, with_history), testing::ExitedWithCode(0), "");
    }
  }
}

#else

TEST(MendMemoryDeathTest, WhereverMemoryEndsTheMeshIsValid) {
  GTEST_SKIP() << "memory can be limited on Linux only, and not under AddressSanitizer";
}

#endif

}  // namespace
}  // namespace halfedge::test
