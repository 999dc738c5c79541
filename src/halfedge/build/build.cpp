#include <halfedge/build/build.h>
#include <halfedge/build/connect.h>
#include <halfedge/build/strict.h>

namespace halfedge {

namespace {

template <Storage kStored>
ConnectResult connect(BasicMesh<kStored>& mesh, const Polygons& polygons) {
  Links& links = mesh.mutable_links();
  if constexpr (kStored.prev_at_run_time) {
    return mesh.stores_prev() ? connect<true>(polygons, links) : connect<false>(polygons, links);
  }
  return connect<kStored.prev>(polygons, links);
}

template <Storage kStored>
bool build(BasicMesh<kStored>& mesh, const Polygons& polygons, BuildReport& report) {
  report = {};
  mesh.clear();
  ConnectResult result = ConnectResult::kNotManifold;
  if (can_be_connected(polygons)) result = connect(mesh, polygons);
  if (result == ConnectResult::kDone) {
    result = copy_positions(polygons.positions, mesh.mutable_positions());
  }
  if (result == ConnectResult::kDone && !mesh.fit_attributes()) {
    result = ConnectResult::kOutOfMemory;
  }
  if (result != ConnectResult::kDone) mesh.clear();
  return explain(result, polygons, report);
}

}  // namespace

bool build_from_polygons(Mesh& mesh, const Polygons& polygons, BuildReport& report) {
  return build(mesh, polygons, report);
}

bool build_from_polygons(BasicMesh<kWithoutPrev>& mesh, const Polygons& polygons,
                         BuildReport& report) {
  return build(mesh, polygons, report);
}

bool build_from_polygons(BasicMesh<kPrevAtRunTime>& mesh, const Polygons& polygons,
                         BuildReport& report) {
  return build(mesh, polygons, report);
}

}  // namespace halfedge
