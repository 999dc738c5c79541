#include <halfedge/sentence.h>
#include <halfedge/validate/check_geometry.h>
#include <halfedge/validate/checker.h>
#include <halfedge/validate/problem_list.h>
#include <halfedge/validate/validate.h>

#include <algorithm>
#include <cassert>
#include <string>
#include <utility>

namespace halfedge {

namespace {

// Each step needs what the steps before it have checked, and is left out where they failed. Whether
// faces and vertices can be walked around.
template <class Mesh>
bool run(const Mesh& mesh, int level, ProblemList& problems) {
  assert(0 <= level && level <= kGeometryLevel);
  const std::size_t before = problems.error_count();
  const auto clean = [&] { return problems.error_count() == before; };
  ReferenceChecker<Mesh> references(mesh, problems);
  LinkChecker<Mesh> links(mesh, problems);
  OrbitChecker<Mesh> orbits(mesh, problems);

  references.check_array_sizes();
  if (clean()) references.check_references();
  if (clean()) {
    links.check_inverse_links();
    if (level >= 1) links.check_loops_agree();
  }
  const bool can_be_walked = clean();
  if (can_be_walked) {
    if (level >= 2) orbits.check_vertex_orbits();
    if (level >= 3) orbits.check_face_loops();
    if (level >= 3) orbits.check_boundary();
    if (level >= 4) PolygonChecker<Mesh>(mesh, problems).check_polygons();
  }
  return can_be_walked;
}

template <Storage kStored>
std::vector<Problem> run_with_positions(const BasicMesh<kStored>& mesh, int level) {
  ProblemList problems;
  const std::size_t size = mesh.positions().size();
  const std::size_t expected = 3 * mesh.links().vertex_halfedge.size();
  if (size != expected) {
    problems.add(Rule::kArraySize, ItemKind::kMesh, kNone, [&] {
      return sentence::of("positions has {} floats, expected {}: three for each vertex slot", size,
                          expected);
    });
  }
  const bool has_positions = size == expected;
  const bool can_be_walked = run<BasicConnectivity<kStored>>(mesh, level, problems);
  if (level >= kGeometryLevel && has_positions && can_be_walked) {
    check_geometry({mesh.links(), mesh.position_array()}, problems);
  }
  return std::move(problems).take();
}

}  // namespace

std::vector<Problem> validate(const Connectivity& mesh, int level) {
  ProblemList problems;
  (void)run(mesh, level, problems);
  return std::move(problems).take();
}

std::vector<Problem> validate(const Mesh& mesh, int level) {
  return run_with_positions(mesh, level);
}

std::vector<Problem> validate(const BasicMesh<kPrevAtRunTime>& mesh, int level) {
  if (mesh.stores_prev()) return run_with_positions(mesh, level);
  BasicMesh<kPrevAtRunTime> copy;
  BasicMesh<kPrevAtRunTime> whole;
  if (!copy.assign(mesh) || !convert(std::move(copy), whole)) return not_validated();
  return run_with_positions(whole, level);
}

std::vector<Problem> not_validated() {
  ProblemList problems;
  problems.add(Rule::kOutOfMemory, ItemKind::kMesh, kNone,
               [] { return std::string("memory is exhausted, so nothing was checked"); });
  return std::move(problems).take();
}

bool has_errors(std::span<const Problem> problems) {
  return std::any_of(problems.begin(), problems.end(),
                     [](const Problem& p) { return p.severity == Severity::kError; });
}

}  // namespace halfedge
