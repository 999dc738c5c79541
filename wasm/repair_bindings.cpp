// Building from soups. See the design in bindings.cpp.

#include "repair_bindings.h"

#include <optional>
#include <string>
#include <string_view>

namespace {

using namespace halfedge;
using namespace halfedge::bindings;

/// Lines that have a corner and what it is named.
MissingVertices missing_in(std::string_view lines) {
  MissingVertices missing;
  while (!lines.empty()) {
    std::size_t corner = 0;
    std::size_t at = 0;
    for (; lines[at] != ' '; ++at) corner = 10 * corner + static_cast<std::size_t>(lines[at] - '0');
    const std::size_t end = lines.find('\n');
    missing.add(corner, std::string(lines.substr(at + 1, end - at - 1)));
    lines.remove_prefix(end + 1);
  }
  return missing;
}

/// A negative tolerance keeps vertices apart.
val build_soup(Address positions, std::size_t position_count, Address sizes, std::size_t size_count,
               Address corners, std::size_t corner_count, double tolerance, bool drop_isolated,
               bool is_signed, Address names, std::size_t name_count, bool stores_prev) {
  NewMesh mesh(stores_prev);
  if (!mesh) return failure(no_room_for_a_mesh());
  const MissingVertices missing = missing_in({reinterpret_cast<const char*>(names), name_count});
  const Polygons polygons{array_at<float>(positions, position_count),
                          array_at<Index>(sizes, size_count),
                          array_at<Index>(corners, corner_count), is_signed, missing};
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
