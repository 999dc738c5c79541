// Any bytes, read as those of a mesh: with all links, and without prev. What is read is mended in
// all ways, one after the other.

#include <gtest/gtest.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/io/bytes.h>
#include <halfedge/validate/validate.h>

#include <algorithm>
#include <string>

#include "support/memory.h"
#include "support/mending.h"
#include "support/reading.h"

namespace halfedge::fuzz {
namespace {

constexpr std::size_t kMemoryPerByte = 24;
constexpr std::size_t kMemoryAtLeast = std::size_t{1} << 20U;  // sentences of `validate`

/// Repairs leave a mesh as valid as it was; where they can't work with it, they say so. The bytes
/// choose their options.
template <class Mesh>
void expect_mendable(Mesh& mesh, std::span<const std::uint8_t> bytes) {
  for (std::uint8_t which = 0; which < kRepairs; ++which) {
    SCOPED_TRACE("repair " + std::to_string(which));
    const bool was_valid = !has_errors(validate(mesh));
    const Result<mend::Report> report = mend_one(mesh, which, bytes[bytes.size() - 1U - which]);
    if (!report) {
      expect_sentence(report.error());
      EXPECT_FALSE(was_valid) << report.error().message;
      EXPECT_EQ(report.error().code, "corrupt-connectivity");
    }
    EXPECT_FALSE(has_errors(validate(mesh, was_valid ? 4 : 2)));
  }
}

template <class Mesh>
bool is_read(std::span<const std::uint8_t> bytes) {
  const MemoryMeter meter;
  Mesh mesh;
  const Result<void> read = from_bytes(bytes, mesh);
  EXPECT_LE(meter.peak(), kMemoryPerByte * bytes.size() + kMemoryAtLeast);
  if (!read) {
    expect_sentence(read.error());
    EXPECT_EQ(mesh.vertex_slots() + mesh.halfedge_slots() + mesh.face_slots(), 0U);
    return false;
  }
  EXPECT_FALSE(has_errors(validate(mesh, 2)));
  const Result<Array<std::uint8_t>> written = to_bytes(mesh);
  Mesh again;
  const Result<void> reread = from_bytes(written.value().span(), again);
  EXPECT_TRUE(reread) << reread.error().message;
  const Result<Array<std::uint8_t>> rewritten = to_bytes(again);
  EXPECT_TRUE(std::equal(written.value().begin(), written.value().end(), rewritten.value().begin(),
                         rewritten.value().end()));
  // Whatever it is beyond that, it can be asked about, and added to.
  (void)validate(mesh, kGeometryLevel);
  (void)boundary_loops(mesh);
  expect_mendable(again, bytes);
  const Vertex v = mesh.new_vertex();
  EXPECT_TRUE(mesh.is_live(v));
  EXPECT_FALSE(has_errors(validate(mesh, 2)));
  return true;
}

}  // namespace
}  // namespace halfedge::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace halfedge;
  fuzz::stop_at_failures();
  const bool whole = fuzz::is_read<Mesh>({data, size});
  const bool lean = fuzz::is_read<BasicMesh<kWithoutPrev>>({data, size});
  EXPECT_FALSE(whole && lean);
  const Result<bool> with_prev = stores_prev({data, size});
  if (whole || lean) {
    EXPECT_TRUE(with_prev && with_prev.value() == whole);
  }
  return 0;
}
