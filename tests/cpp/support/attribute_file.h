#pragma once

#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/io/parse.h>
#include <halfedge/io/write.h>
#include <halfedge/repair/repair.h>
#include <halfedge/repair/transfer.h>

#include <cstring>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "support/text_file.h"

namespace halfedge::test {

/// 3---2   6
/// |   | \ |   a square, a triangle, and a pentagon over the three on the left
/// 0---1---5
inline Mesh sample_mesh() {
  const std::vector<float> positions = {0, 0,    0, 1, 0, 0, 1, 1, 0, 0, 1,
                                        0, 0.5F, 2, 0, 2, 0, 0, 2, 1, 0};
  const std::vector<Index> sizes = {4, 3, 3, 3};
  const std::vector<Index> corners = {0, 1, 2, 3, 3, 2, 4, 1, 5, 2, 5, 6, 2};
  Mesh mesh;
  BuildReport report;
  EXPECT_TRUE(build_from_polygons(mesh, {positions, sizes, corners}, report));
  return mesh;
}

inline Attribute& add(Mesh& mesh, ItemKind kind, const char* name, Scalar type, Index components,
                      OnSplit on_split) {
  return *mesh.add_attribute(kind, name,
                             {.type = type, .components = components, .on_split = on_split})
              .value();
}

/// The mesh of a file with its attributes, or an error.
struct MeshFile {
  Mesh mesh;
  std::vector<std::string> notes;
  std::string error;
  RepairReport report;
};

inline MeshFile read_mesh(std::span<const std::uint8_t> bytes, bool repair = false) {
  MeshFile read;
  Result<ParsedFile> file =
      parse(bytes, std::nullopt, ParseOptions{.attributes = true, .for_repair = repair});
  if (!file) {
    read.error = file.error().message;
    return read;
  }
  const Polygons soup = file.value().soup.view();
  BuildReport strict;
  const bool is_built = repair ? build_from_soup(read.mesh, soup, {}, read.report)
                               : build_from_polygons(read.mesh, soup, strict);
  if (!is_built) {
    read.error = repair ? read.report.problems[0].message : strict.problems[0].message;
    return read;
  }
  const Result<void> added =
      add_attributes(read.mesh, soup, repair ? &read.report : nullptr, file.value().attributes);
  if (!added) read.error = added.error().message;
  read.notes = file.value().notes;
  return read;
}
inline MeshFile read_mesh(const std::string& text, bool repair = false) {
  return read_mesh(bytes_of(text), repair);
}

/// "vertex color uint8 3 interpolate"
inline std::string describe(const Attribute& a) {
  return std::string(name_of(a.kind())) + " " + a.name() + " " + name_of(a.type()) + " " +
         std::to_string(a.components()) + " " + name_of(a.on_split());
}
inline std::vector<std::string> describe_all(const Mesh& mesh) {
  std::vector<std::string> list;
  for (const ItemKind kind :
       {ItemKind::kVertex, ItemKind::kHalfedge, ItemKind::kEdge, ItemKind::kFace}) {
    for (const auto& column : mesh.attributes().of(kind)) list.push_back(describe(*column));
  }
  return list;
}

/// All values of an attribute as numbers; of halfedges, those at the corners of each face in turn.
inline std::vector<double> values_of(const Mesh& mesh, ItemKind kind, const char* name) {
  std::vector<double> values;
  const Attribute* const column = mesh.attributes().find(kind, name);
  if (column == nullptr) return values;
  const auto add = [&](Index item) {
    for (Index i = 0; i < column->components(); ++i) values.push_back(column->get(item, i));
  };
  if (kind == ItemKind::kHalfedge) {
    for (Index f = 0; f < mesh.face_slots(); ++f) {
      const Halfedge first = mesh.face_halfedge(Face(f));
      Halfedge h = first;
      do {
        add(h.index());
        h = mesh.next(h);
      } while (h != first);
    }
  } else {
    for (Index item = 0; item < column->slots(); ++item) add(item);
  }
  return values;
}

/// Writes, with these notes, reads, and compares the attributes.
inline void expect_round_trip(const Mesh& mesh, Format format, Encoding encoding,
                              const std::vector<std::string>& expected_notes = {}) {
  SCOPED_TRACE(std::string(name_of(format)) + " " + std::to_string(int(encoding)));
  std::vector<std::string> notes;
  const auto bytes = write(mesh, format, {.encoding = encoding, .notes = &notes});
  ASSERT_TRUE(bytes) << bytes.error().message;
  EXPECT_EQ(notes, expected_notes);
  const test::MeshFile read = read_mesh(bytes.value().span());
  ASSERT_EQ(read.error, "");
  EXPECT_EQ(read.notes, std::vector<std::string>());
  EXPECT_EQ(describe_all(read.mesh), describe_all(mesh));
  for (const ItemKind kind : {ItemKind::kVertex, ItemKind::kHalfedge, ItemKind::kFace}) {
    for (const auto& column : mesh.attributes().of(kind)) {
      const char* const name = column->name().c_str();
      const std::vector<double> before = values_of(mesh, kind, name);
      const std::vector<double> after = values_of(read.mesh, kind, name);
      ASSERT_EQ(before.size(), after.size()) << name;
      EXPECT_EQ(std::memcmp(before.data(), after.data(), 8 * before.size()), 0) << name;
    }
  }
}

/// Fills an attribute with bits of all kinds that are numbers.
inline void randomize(Attribute& column, std::mt19937& random) {
  for (Index item = 0; item < column.slots(); ++item) {
    for (Index i = 0; i < column.components(); ++i) {
      const double any = double(std::int64_t(random()) << 20U) - double(random()) * 1e3;
      const bool is_real = column.type() <= Scalar::kFloat64;
      double value = is_real ? any * 1e-12 : any * 1e-5;
      if (random() % 8 == 0) value = random() % 2 == 0 ? -0.0 : 1.0;
      column.set(item, i, value, nullptr);
    }
  }
}

/// The same of all attributes.
inline void randomize(Mesh& mesh, std::mt19937& random) {
  for (const ItemKind kind :
       {ItemKind::kVertex, ItemKind::kHalfedge, ItemKind::kEdge, ItemKind::kFace}) {
    for (Attributes::Column& column : mesh.columns(kind)) randomize(*column, random);
  }
}

}  // namespace halfedge::test
