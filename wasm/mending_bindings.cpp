// Repairs of a mesh that is there. Each answers with its report, so they go through embind.

#include <halfedge/mend/mend.h>

#include "operation_bindings.h"

namespace {

using namespace halfedge;
using namespace halfedge::bindings;

/// What the report says; its arrays are JavaScript's to free.
val to_report(mend::Report& report) {
  const RoomForReport room;
  val left = val::array();
  for (const Error& problem : report.problems) left.call<void>("push", to_problem(problem));
  val counts = val::object();
  for (std::size_t i = 0; i < mend::kCodeCount; ++i) {
    if (report.counts[i] > 0) {
      counts.set(std::string(name_of(static_cast<mend::Code>(i))), report.counts[i]);
    }
  }
  val result = success("left", left);  // `problems` are those of a failure
  result.set("counts", counts);
  result.set("summary", report.summary);
  result.set("vertices", hand_over(report.vertices));
  result.set("edges", hand_over(report.edges));
  result.set("faces", hand_over(report.faces));
  return result;
}

/// Each reads its options from the three numbers.
Result<mend::Report> run(mend::Surface& surface, int repair, double a, double b, double c) {
  switch (repair) {
    case 0:
      return mend::stitch_boundaries(surface, {.tolerance = a});
    case 1:
      return mend::split_pinched_vertices(surface);
    case 2:
      return mend::orient_outward(surface, {.open = a != 0, .nested = b != 0});
    case 3:
      return mend::drop_small_components(
          surface, {.faces = static_cast<Index>(a), .area = b, .diagonal = c});
    case 4:
      return mend::remove_degenerate_faces(surface, {.tolerance = a});
    default:
      return mend::fill_holes(surface, {.max_edges = static_cast<std::size_t>(a), .max_angle = b});
  }
}

val mend_mesh(Address address, Index mode, int repair, double a, double b, double c) {
  if (!Reserve::take_back()) return failure(no_memory_for("a repair"));
  AnyMesh& mesh = mesh_at(address);
  mend::SurfaceOf<kPrevAtRunTime> surface(mesh);
  Result<mend::Report> done = run(surface, repair, a, b, c);
  if ((mode & kKeepStepOpen) == 0) mesh.end_step();
  write_layout(mesh);
  return done ? to_report(done.value()) : failure(done.error());
}

}  // namespace

EMSCRIPTEN_BINDINGS(halfedge_mending) { emscripten::function("mend", &mend_mesh); }
