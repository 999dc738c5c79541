#include <gtest/gtest.h>
#include <halfedge/halfedge.h>

#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "support/complexes.h"
#include "support/operations.h"
#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

template <class Mesh>
Bytes bytes_of(const Mesh& mesh) {
  const Result<Array<std::uint8_t>> bytes = to_bytes(mesh);
  EXPECT_TRUE(bytes.ok());
  return {bytes.value().begin(), bytes.value().end()};
}

/// A mesh after some operations, with deleted slots in between.
Mesh edited(const Shape& shape, std::uint32_t seed, int operations = 60) {
  Mesh mesh = reference_build(shape);
  RandomCalls random(seed, 30);
  for (int i = 0; i < operations; ++i) (void)apply(mesh, random.next(mesh));
  std::vector<Vertex> lost;
  for (int i = 0; i < 5; ++i) lost.push_back(mesh.new_vertex());
  for (const int i : {3, 0, 4}) mesh.release(lost[std::size_t(i)]);
  return mesh;
}

/// Attributes of several kinds and types, with values and defaults of their own.
void add_attributes(Mesh& mesh, std::mt19937& random) {
  const double defaults[] = {0.1, -3, 1e30, 200};
  const auto add = [&](ItemKind kind, const char* name, AttributeOptions options) {
    options.default_value = {defaults, options.components};
    Attribute* const column = mesh.add_attribute(kind, name, options).value();
    for (std::byte& byte : column->bytes()) byte = std::byte(random());
  };
  add(ItemKind::kVertex, "normal", {.components = 3, .on_split = OnSplit::kNormalize});
  add(ItemKind::kHalfedge, "uv", {.type = Scalar::kFloat64, .components = 2});
  add(ItemKind::kHalfedge, "label", {.type = Scalar::kUint8, .on_split = OnSplit::kCopyCorner});
  add(ItemKind::kEdge, "crease", {.type = Scalar::kInt16, .on_split = OnSplit::kCopy});
  add(ItemKind::kFace, "Größe ✓", {.type = Scalar::kUint8, .components = 4});
  add(ItemKind::kFace, "generation", {.type = Scalar::kUint32, .on_split = OnSplit::kDefault});
}

Error refusal_of(const Bytes& bytes) {
  Mesh mesh = reference_build(tetrahedron());
  const Snapshot before(mesh);
  const Result<void> read = from_bytes(bytes, mesh);
  EXPECT_FALSE(read.ok());
  EXPECT_EQ(Snapshot(mesh), before);
  return read ? Error{} : read.error();
}

void put_word(Bytes& bytes, std::size_t offset, std::uint32_t word) {
  for (std::size_t i = 0; i < 4; ++i) bytes[offset + i] = std::uint8_t(word >> 8 * i);
}

TEST(Bytes, HoldTheMeshToTheLastWord) {
  std::uint32_t seed = 0;
  for (const Shape& shape : all_shapes()) {
    SCOPED_TRACE(shape.name + ", seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Mesh mesh = edited(shape, seed++);
    add_attributes(mesh, random);
    for (const Vertex v : mesh.vertices()) {
      mesh.set_position(v, {float(random()), -0.0F, std::numeric_limits<float>::infinity()});
    }
    Mesh again = reference_build(cube());
    const Result<void> read = from_bytes(bytes_of(mesh), again);
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(Snapshot(again), Snapshot(mesh));
    EXPECT_EQ(bytes_of(again), bytes_of(mesh));
    // The chains too: both go on with the same slots.
    RandomCalls calls(seed, 60);
    RandomCalls same(seed, 60);
    for (int i = 0; i < 40; ++i) {
      (void)apply(mesh, calls.next(mesh));
      (void)apply(again, same.next(again));
    }
    EXPECT_EQ(Snapshot(again), Snapshot(mesh));
    for (const ItemKind kind :
         {ItemKind::kVertex, ItemKind::kHalfedge, ItemKind::kEdge, ItemKind::kFace}) {
      for (const auto& column : mesh.attributes().of(kind)) {
        const Attribute* const other = again.attributes().find(kind, column->name());
        ASSERT_NE(other, nullptr);
        EXPECT_EQ(other->type(), column->type());
        EXPECT_EQ(other->on_split(), column->on_split());
        EXPECT_FALSE(other->is_generation());
        EXPECT_TRUE(std::equal(column->default_value().begin(), column->default_value().end(),
                               other->default_value().begin()));
      }
    }
  }
}

TEST(Bytes, OfAMeshWithoutPrevSaySo) {
  BasicMesh<kWithoutPrev> lean;
  Mesh whole = edited(torus(4, 3), 1);
  const Bytes of_whole = bytes_of(whole);
  ASSERT_TRUE(convert(std::move(whole), lean).ok());
  const Bytes of_lean = bytes_of(lean);
  EXPECT_TRUE(stores_prev(of_whole).value());
  EXPECT_FALSE(stores_prev(of_lean).value());
  EXPECT_EQ(of_whole.size() - of_lean.size(), 16 + 4 * lean.halfedge_slots());
  BasicMesh<kWithoutPrev> again;
  ASSERT_TRUE(from_bytes(of_lean, again).ok());
  EXPECT_EQ(bytes_of(again), of_lean);
  EXPECT_EQ(from_bytes(of_whole, again).error().code, "storage-mismatch");
  EXPECT_EQ(refusal_of(of_lean).code, "storage-mismatch");
}

TEST(Bytes, LeaveGenerationsOut) {
  Mesh mesh = reference_build(cube());
  const Bytes bytes = bytes_of(mesh);
  ASSERT_TRUE(mesh.enable_generations().ok());
  EXPECT_EQ(bytes_of(mesh), bytes);
}

TEST(Bytes, AreRefusedAtEveryLengthButTheirOwn) {
  Mesh mesh = edited(cube(), 2);
  std::mt19937 random(2);
  add_attributes(mesh, random);
  Bytes bytes = bytes_of(mesh);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const Error error = refusal_of({bytes.begin(), bytes.begin() + std::ptrdiff_t(size)});
    EXPECT_EQ(error.code, size == 0 ? "unknown-format" : "truncated") << size;
  }
  bytes.push_back(0);
  EXPECT_EQ(refusal_of(bytes).message,
            "Byte " + std::to_string(bytes.size() - 1) + ": there is more after the last section.");
}

TEST(Bytes, SayWhatIsWrong) {
  const Bytes bytes = bytes_of(edited(cube(), 2));
  const auto with_word = [&](std::size_t offset, std::uint32_t word) {
    Bytes changed = bytes;
    put_word(changed, offset, word);
    return refusal_of(changed);
  };
  EXPECT_EQ(with_word(0, 0).code, "unknown-format");
  EXPECT_EQ(with_word(8, 2).message, "The bytes are of version 2 of the format, expected 1.");
  EXPECT_EQ(with_word(12, 2).message, "Byte 12: the storage is 2, expected 0 or 1.");
  EXPECT_EQ(with_word(16, 0x4000'0000).code, "parse-error");  // wraps around at 4 GiB
  EXPECT_EQ(with_word(16, kNone).code, "parse-error");
  EXPECT_EQ(with_word(20, 7).code, "parse-error");
  EXPECT_EQ(with_word(52, 3).code, "parse-error");
  EXPECT_EQ(with_word(52, 8).code, "truncated");
  EXPECT_EQ(with_word(52, kNone).message,
            "Byte 52: there are 4294967295 sections, expected at most 4096.");
  EXPECT_EQ(with_word(56, 0x21212121).message, "Byte 56: the section is of no known kind.");
  EXPECT_EQ(with_word(28, 0).code, "parse-error");  // the first deleted vertex
  EXPECT_EQ(with_word(32, 1).code, "parse-error");  // how many
  EXPECT_EQ(with_word(32, 99).code, "parse-error");
  Bytes of_cube = bytes_of(reference_build(cube()));
  put_word(of_cube, 56 + 16, 12345);  // the first next
  EXPECT_EQ(refusal_of(of_cube).message,
            "The bytes hold links that are none of a mesh. The next of halfedge 0 is halfedge "
            "12345, expected less than 24.");
  // The length of a section: as long as can be written down.
  EXPECT_EQ(with_word(56 + 12, kNone).code, "truncated");
}

// Found by fuzzing: a circle was followed, and kept in memory, for as long as the header says.
TEST(Bytes, HaveNoMoreDeletedSlotsThanSlots) {
  Mesh mesh = reference_build(tetrahedron());
  for (int i = 0; i < 2; ++i) (void)mesh.new_vertex();
  for (int i = 4; i < 6; ++i) mesh.release(Vertex(Index(i)));
  Bytes bytes = bytes_of(mesh);
  const std::size_t anchors = 56 + 4 * (16 + 4 * mesh.halfedge_slots()) + 16;
  std::memcpy(&bytes[anchors + 4 * 4], &bytes[anchors + 4 * 5], 4);  // 5 -> 4 -> 4
  EXPECT_EQ(refusal_of(bytes).message,
            "Byte 328: the chain of deleted vertex slots, expected 2 of them, leads to slot 4.");
  put_word(bytes, 32, 7);
  EXPECT_EQ(refusal_of(bytes).message,
            "Byte 32: there are 7 deleted slots, expected at most all 6.");
}

/// Each repair, of whatever mesh: valid at level 2.
void mend_all(const Mesh& mesh) {
  const auto repair = [&](const auto& apply_to) {
    Mesh copy;
    ASSERT_TRUE(copy.assign(mesh));
    const Result<mend::Report> report = apply_to(copy);
    EXPECT_TRUE(report.ok() || report.error().code == "corrupt-connectivity")
        << report.error().message;
    EXPECT_FALSE(has_errors(validate(copy, 2)));
    EXPECT_LE(has_errors(validate(copy)), has_errors(validate(mesh))) << "what is valid stays so";
  };
  repair([](Mesh& m) { return mend::split_pinched_vertices(m); });
  repair([](Mesh& m) { return mend::stitch_boundaries(m, {.tolerance = 0.5}); });
  repair([](Mesh& m) { return mend::remove_degenerate_faces(m, {.tolerance = 0.5}); });
  repair([](Mesh& m) { return mend::drop_small_components(m, {.faces = 3}); });
  repair([](Mesh& m) { return mend::fill_holes(m, {.max_angle = 180}); });
  repair([](Mesh& m) { return mend::orient_outward(m, {.open = true, .nested = true}); });
}

TEST(Bytes, ThatAreFlippedAreRefusedOrGiveAMeshThatIsSafe) {
  std::mt19937 random(3);
  int refused = 0;
  int read_all = 0;
  std::vector<Bytes> sound;
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    Mesh mesh = edited(seed % 2 == 0 ? cube() : pinched(3), seed, 30);
    if (seed % 3 == 0) add_attributes(mesh, random);
    sound.push_back(bytes_of(mesh));
  }
  for (int round = 0; round < 10000; ++round) {
    Bytes bytes = sound[std::size_t(round) % sound.size()];
    const int flips = 1 + int(random() % 3);
    for (int i = 0; i < flips; ++i) {
      const std::size_t at = random() % bytes.size();
      bytes[at] = random() % 2 == 0 ? std::uint8_t(random()) : std::uint8_t(bytes[at] ^ 1U);
    }
    Mesh read;
    const Result<void> done = from_bytes(bytes, read);
    if (!done) {
      EXPECT_FALSE(done.error().message.empty());
      ++refused;
      continue;
    }
    ++read_all;
    ASSERT_FALSE(has_errors(validate(read, 2)));
    // What follows links unchecked must not leave the arrays: the sanitizers watch.
    RandomCalls calls(std::uint32_t(round), 30);
    for (int i = 0; i < 5; ++i) (void)apply(read, calls.next(read));
    mend_all(read);
    (void)read.new_vertex();
    ASSERT_TRUE(compact(read).ok());
  }
  EXPECT_GT(refused, 2000);
  EXPECT_GT(read_all, 500);
}

}  // namespace
}  // namespace halfedge::test
