// Repairs of any mesh, one after the other with any options: each state is valid, each report fits,
// and all can be taken back.
//
// An input is: number of repairs, two bytes for each, and a soup as in soup.cpp, whose repair is
// the mesh.

#include <gtest/gtest.h>
#include <halfedge/mend/mend.h>
#include <halfedge/repair/repair.h>

#include <cmath>
#include <limits>
#include <vector>

#include "support/complexes.h"
#include "support/invariants.h"
#include "support/mending.h"
#include "support/reading.h"
#include "support/repairing.h"
#include "support/soup.h"

namespace halfedge::fuzz {
namespace {

void expect_sound(const Mesh& mesh) {
  const std::vector<Problem> errors = test::errors_of(mesh);
  ASSERT_TRUE(errors.empty()) << errors[0].message;
  EXPECT_TRUE(test::Invariants(mesh).hold());
  for (const Vertex v : mesh.vertices()) {
    const Point p = mesh.position(v);
    EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  }
}

}  // namespace
}  // namespace halfedge::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace halfedge;
  using namespace halfedge::fuzz;
  stop_at_failures();
  Input input({data, size});
  std::vector<std::uint8_t> repairs(2 * (input.byte() % 8U));
  for (std::uint8_t& byte : repairs) byte = input.byte();
  const Soup soup = soup_of(input, 0);
  test::Repaired start(soup.view());
  Mesh mesh = test::copy_of(start.mesh);
  test::add_attributes_of_all_kinds(mesh);
  EXPECT_TRUE(mesh.enable_history());
  std::vector<test::Snapshot> states{test::Snapshot(mesh)};
  for (std::size_t i = 0; i < repairs.size(); i += 2) {
    SCOPED_TRACE("repair " + std::to_string(repairs[i] % 6));
    const Result<mend::Report> report = mend_one(mesh, repairs[i], repairs[i + 1]);
    EXPECT_TRUE(report) << report.error().message;
    mesh.end_step();
    expect_sound(mesh);
    const test::Snapshot now(mesh);
    if (!(now == states.back())) states.push_back(now);
  }
  for (std::size_t step = states.size() - 1; step > 0; --step) {
    EXPECT_TRUE(mesh.undo());
    EXPECT_TRUE(test::Snapshot(mesh) == states[step - 1]);
  }
  EXPECT_FALSE(mesh.undo());
  return 0;
}
