// Building from soups. See the design in bindings.cpp.

#include "repair_bindings.h"

#include <optional>

namespace {

using namespace halfedge;
using namespace halfedge::bindings;

/// A negative tolerance keeps vertices apart.
val build_soup(Address positions, std::size_t position_count, Address sizes, std::size_t size_count,
               Address corners, std::size_t corner_count, double tolerance, bool drop_isolated,
               bool is_signed, bool stores_prev) {
  NewMesh mesh(stores_prev);
  if (!mesh) return failure(no_room_for_a_mesh());
  const Polygons polygons{array_at<float>(positions, position_count),
                          array_at<Index>(sizes, size_count),
                          array_at<Index>(corners, corner_count), is_signed};
  RepairOptions options;
  if (tolerance >= 0) options.weld = tolerance;
  options.drop_isolated = drop_isolated;
  RepairReport report;
  if (!build_from_soup(*mesh, polygons, options, report)) {
    return failure(report.problems, report.problems.size());
  }
  const RoomForReport room;
  val result = success("mesh", val(mesh.release()));
  add_repair(result, report);
  return result;
}

}  // namespace

EMSCRIPTEN_BINDINGS(repair) { emscripten::function("buildFromSoup", &build_soup); }
