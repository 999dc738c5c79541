// Any operations with any arguments, on a mesh of each topology: each state is valid, a refusal
// changes nothing, and all can be taken back.
//
// An input is: which mesh, how large it is to stay, and what Draw makes of the rest.

#include <gtest/gtest.h>

#include <algorithm>

#include "random/sequence.h"
#include "support/reading.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace halfedge::test;
  if (size < 2) return 0;
  halfedge::fuzz::stop_at_failures();
  const Shape shapes[] = {tetrahedron(), cube(),           torus(3, 3),         annulus(4),
                          pinched(3),    mixed_polygons(), triangle_grid(3, 2), two_components()};
  halfedge::Mesh mesh = copy_with_attributes(reference_build(shapes[data[0] % std::size(shapes)]));
  Sequence sequence(Draw({data + 2, size - 2}), 12U + data[1] % 64U);
  Tally tally;
  run_sequence(mesh, sequence, 100, tally);
  return 0;
}
