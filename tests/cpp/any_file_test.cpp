// Any file gives a mesh, or a sentence. The whole way that a user's file goes: parsed as what its
// content says, repaired, validated.

#include <gtest/gtest.h>
#include <halfedge/halfedge.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "support/data_files.h"
#include "support/reference_build.h"
#include "support/repairing.h"
#include "support/shapes.h"
#include "support/text_file.h"

namespace halfedge::test {
namespace {

using namespace std::string_literals;

/// "8 vertices, 6 faces" of the repaired mesh, or the code of the error.
std::string outcome_of(std::string_view bytes) {
  const Result<ParsedFile> file = parse(bytes_of(bytes));
  if (!file) {
    const std::string& message = file.error().message;
    EXPECT_GE(message.size(), 20U) << message;
    EXPECT_LE(message.size(), 1000U) << message;
    for (const char c : message) EXPECT_TRUE(c >= ' ' && c <= '~') << message;
    return std::string(file.error().code);
  }
  const Polygons polygons = file.value().soup.view();
  Mesh strict;
  BuildReport report;
  const bool built = build_from_polygons(strict, polygons, report);
  EXPECT_EQ(built, report.problems.empty());
  const Repaired repaired(polygons);
  const std::vector<Problem> errors = errors_of(repaired.mesh);
  EXPECT_TRUE(errors.empty()) << errors[0].message;
  if (built) {
    EXPECT_TRUE(repaired.report.verdicts.empty()) << repaired.report.summary;
  } else {
    EXPECT_FALSE(repaired.report.problems.empty()) << report.problems[0].message;
  }
  return std::to_string(repaired.mesh.vertex_count()) + " vertices, " +
         std::to_string(repaired.mesh.face_count()) + " faces";
}

std::string repeated(std::string_view text, std::size_t times) {
  std::string all;
  all.reserve(text.size() * times);
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

std::string utf16(std::string_view text, bool big_endian) {
  std::string wide = big_endian ? "\xFE\xFF" : "\xFF\xFE";
  for (const char c : text) wide += big_endian ? "\0"s + c : c + "\0"s;
  return wide;
}

std::string with_cr(std::string text) {
  std::replace(text.begin(), text.end(), '\n', '\r');
  return text;
}

constexpr const char* kBom = "\xEF\xBB\xBF";
const std::string kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string kOff = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string kStl =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
    "endloop\nendfacet\nendsolid a\n";

std::string ply(const std::string& format, const std::string& vertices, const std::string& faces,
                const std::string& list = "uchar int") {
  return "ply\nformat " + format + " 1.0\nelement vertex " + vertices +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
         "\nproperty list " + list + " vertex_indices\nend_header\n";
}
const std::string kPly = ply("ascii", "3", "1") + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

/// `count` triangles around vertex 0, which share their edges or not.
std::string fan(std::size_t count, bool joined) {
  std::string text = "v 0 0 0\n";
  const std::size_t rim = joined ? count : 2 * count;
  for (std::size_t i = 0; i < rim; ++i) {
    const double angle = 6.283185307179586 * double(i) / double(rim);
    text += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\n";
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t a = joined ? i : 2 * i;
    const std::size_t b = (a + 1) % rim;
    text += "f 1 " + std::to_string(a + 2) + " " + std::to_string(b + 2) + "\n";
  }
  return text;
}

/// `count` tetrahedra that share vertex 0 and nothing else.
std::string closed_fans(std::size_t count) {
  std::string text = "v 0 0 0\n";
  for (std::size_t i = 0; i < count; ++i) {
    const std::string z = std::to_string(i);
    text += "v 1 0 " + z + "\nv 0 1 " + z + "\nv 1 1 " + z + "\n";
    const auto corner = [i](std::size_t k) {
      return " " + std::to_string(k == 0 ? 1 : 3 * i + k + 1);
    };
    for (const auto& face : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
      text += "f";
      for (const int k : face) text += corner(std::size_t(k));
      text += "\n";
    }
  }
  return text;
}

struct Case {
  std::string name;
  std::string bytes;
  std::string outcome;
};

const std::string kTriangle = "3 vertices, 1 faces";

std::vector<Case> encodings() {
  std::vector<Case> cases = {
      {"no byte", "", "unknown-format"},
      {"a byte-order mark alone", kBom, "unknown-format"},
      {"NUL", "\0"s, "not-text"},
      {"a megabyte of NULs", std::string(1 << 20, '\0'), "not-text"},
      {"NULs in a text", "v 0 0 0\n\0\0\0\0f 1 1 1\n"s, "not-text"},
      {"a megabyte of 0xFF", std::string(1 << 20, '\xFF'), "unknown-format"},
      {"a megabyte of line ends", std::string(1 << 20, '\n'), "unknown-format"},
      {"a million brackets", std::string(1000000, '{'), "unsupported-format"},
      {"a million tags", repeated("<a>", 1000000), "unsupported-format"},
  };
  const std::pair<const char*, std::string> texts[] = {
      {"OBJ", kObj}, {"OFF", kOff}, {"PLY", kPly}, {"STL", kStl}};
  for (const auto& [name, text] : texts) {
    const auto add = [&cases, name = name](const char* what, const std::string& bytes,
                                           const std::string& outcome) {
      cases.push_back({std::string(name) + " " + what, bytes, outcome});
    };
    add("as it is", text, kTriangle);
    add("in little-endian UTF-16", utf16(text, false), "not-text");
    add("in big-endian UTF-16", utf16(text, true), "not-text");
    add("behind a byte-order mark", kBom + text, kTriangle);
    add("with lines that end in CR", with_cr(text), kTriangle);
    add("with a byte-order mark and CR", kBom + with_cr(text), kTriangle);
    add("without its last line end", text.substr(0, text.size() - 1), kTriangle);
  }
  return cases;
}

std::vector<Case> promises() {
  const std::string most = "4294967295";
  const std::string more = "99999999999999999999999999";
  return {
      {"OFF of so many vertices", "OFF\n" + most + " 1 0\n0 0 0\n", "truncated"},
      {"OFF of so many faces", "OFF\n1 " + most + " 0\n0 0 0\n", "truncated"},
      {"OFF of more than 64 bits of vertices", "OFF\n" + more + " 0 0\n", "truncated"},
      {"OFF with a face of so many corners", "OFF\n1 1 0\n0 0 0\n" + most + " 0 0\n",
       "parse-error"},
      {"OFF of fewer than no vertices", "OFF\n-1 1 0\n0 0 0\n", "parse-error"},
      {"binary OFF of so many", "OFF BINARY\n\x7F\xFF\xFF\xFF\0\0\0\1\0\0\0\0"s, "truncated"},
      {"PLY of so many vertices", ply("ascii", most, "1") + "0 0 0\n", "truncated"},
      {"PLY of so many faces", ply("ascii", "1", most) + "0 0 0\n", "truncated"},
      {"PLY of more than 64 bits", ply("ascii", more, "1") + "0 0 0\n", "truncated"},
      {"binary PLY of so many vertices", ply("binary_little_endian", most, "1") + "0000",
       "truncated"},
      {"binary PLY of so many faces", ply("binary_big_endian", "0", most) + "\1\0\0\0\0"s,
       "truncated"},
      {"PLY with a list of so many",
       ply("binary_little_endian", "0", "1", "uint int") + "\xFF\xFF\xFF\xFF" + "0000",
       "truncated"},
      {"PLY with a list of fewer than none",
       ply("binary_little_endian", "0", "1", "int int") + "\xFF\xFF\xFF\xFF" + "0000",
       "parse-error"},
      {"binary STL of so many triangles",
       std::string(80, ' ') + "\xFF\xFF\xFF\xFF" + std::string(50, '\0'), "unknown-format"},
      {"OBJ with an index of 64 bits", kObj + "f 1 2 18446744073709551617\n", "index-out-of-range"},
      {"OBJ with an index below that", kObj + "f 1 2 -9223372036854775809\n", "index-out-of-range"},
  };
}

std::vector<Case> numbers_that_are_none() {
  const float nan = std::nanf("");
  std::string binary = std::string(80, ' ') + "\1\0\0\0"s + std::string(50, '\0');
  std::memcpy(&binary[84 + 12], &nan, sizeof nan);
  return {
      {"OBJ with nan", "v nan 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n", kTriangle},
      {"OBJ with inf", "v -inf 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n", kTriangle},
      {"OBJ with more than a float", "v 1e39 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
       "2 vertices, 0 faces"},
      {"OFF with nan", "OFF\n3 1 0\nnan 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "2 vertices, 0 faces"},
      {"PLY with infinity", ply("ascii", "3", "1") + "infinity 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
       "2 vertices, 0 faces"},
      {"STL with nan",
       "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 nan 0\nvertex 1 0 0\nvertex 0 1 "
       "0\nendloop\nendfacet\n",
       "non-finite-position"},
      {"binary STL with nan", binary, "non-finite-position"},
      {"OBJ with nan for all", "v nan nan nan\nf 1 1 1\n", "0 vertices, 0 faces"},
  };
}

std::vector<Case> sizes() {
  constexpr std::size_t kLong = std::size_t{2} << 20U;
  std::string properties = "ply\nformat ascii 1.0\nelement vertex 1\n";
  for (int i = 0; i < 20000; ++i) properties += "property float p" + std::to_string(i) + "\n";
  properties += "property float x\nproperty float y\nproperty float z\nend_header\n" +
                repeated("0 ", 20003) + "\n";
  return {
      {"a comment of 2 MiB", "#" + std::string(kLong, 'x') + "\n" + kObj, kTriangle},
      {"2 MiB of blanks", "v" + std::string(kLong, ' ') + "0 0 0\n", "1 vertices, 0 faces"},
      {"a number of 2 MiB", "v 0." + std::string(kLong, '3') + " 0 0\n", "1 vertices, 0 faces"},
      {"an index of 2 MiB", kObj + "f " + std::string(kLong, '1') + " 1 2\n", "index-out-of-range"},
      {"a word of 2 MiB", std::string(kLong, 'x'), "unknown-format"},
      {"a group name of 2 MiB", kObj + "g " + std::string(kLong, 'x') + "\n", kTriangle},
      {"200,000 joined lines",
       "v 0 0 0\nv 1 0 0\nv 0 1 0\nf" + repeated(" \\\n", 200000) + "1 2 3\n", kTriangle},
      {"200,000 corners", "v 0 0 0\nf" + repeated(" 1", 200000) + "\n", "1 vertices, 0 faces"},
      {"200,000 faces without corners", kObj + repeated("f\n", 200000), kTriangle},
      {"200,000 solids", repeated("solid\nendsolid\n", 200000) + kStl, kTriangle},
      {"20,000 properties", properties, "1 vertices, 0 faces"},
      {"a PLY comment of 2 MiB",
       "ply\nformat ascii 1.0\ncomment " + std::string(kLong, 'x') + kPly.substr(20), kTriangle},
      {"valence 5000", fan(5000, true), "5001 vertices, 5000 faces"},
      {"2000 fans at a vertex", fan(2000, false), "4001 vertices, 2000 faces"},
      {"2000 closed fans at a vertex", closed_fans(2000), "8000 vertices, 8000 faces"},
  };
}

void expect_outcomes(const std::vector<Case>& cases) {
  for (const Case& each : cases) {
    SCOPED_TRACE(each.name);
    EXPECT_EQ(outcome_of(each.bytes), each.outcome);
  }
  EXPECT_EQ(outcome_of(kObj), kTriangle) << "afterwards";
}

TEST(AnyFile, InAnyEncoding) { expect_outcomes(encodings()); }
TEST(AnyFile, ThatPromisesMoreThanItHas) { expect_outcomes(promises()); }
TEST(AnyFile, WithNumbersThatAreNone) { expect_outcomes(numbers_that_are_none()); }
TEST(AnyFile, OfAnyLength) { expect_outcomes(sizes()); }

TEST(AnyFile, OfOneByte) {
  for (int byte = 0; byte < 256; ++byte) {
    const std::string outcome = outcome_of(std::string(1, char(byte)));
    const bool markup = byte == '<' || byte == '{';
    EXPECT_EQ(outcome, byte == 0 ? "not-text"
                       : markup  ? "unsupported-format"
                                 : "unknown-format")
        << byte;
  }
}

constexpr std::pair<Format, Encoding> kForms[] = {
    {Format::kObj, Encoding::kText},   {Format::kOff, Encoding::kText},
    {Format::kOff, Encoding::kBinary}, {Format::kPly, Encoding::kText},
    {Format::kPly, Encoding::kBinary}, {Format::kPly, Encoding::kBinaryBigEndian},
    {Format::kStl, Encoding::kText},   {Format::kStl, Encoding::kBinary}};

TEST(AnyFile, CutAtAnyByte) {
  const Mesh mesh = reference_build(cube());
  for (const auto& [format, encoding] : kForms) {
    SCOPED_TRACE(name_of(format) + std::to_string(int(encoding)));
    const Array<std::uint8_t> bytes = std::move(write(mesh, format, {encoding})).value();
    const std::string whole(bytes.begin(), bytes.end());
    for (std::size_t size = 0; size < whole.size(); ++size) {
      SCOPED_TRACE(size);
      const std::string outcome = outcome_of(whole.substr(0, size));
      if (encoding != Encoding::kText) {
        EXPECT_FALSE(outcome.ends_with(" faces")) << outcome;
      }
    }
    EXPECT_TRUE(outcome_of(whole).starts_with("8 vertices, ")) << outcome_of(whole);
  }
}

// Files of the collection, cut and with wrong bytes: so much that others are likely to be the same.
TEST(AnyFile, OfTheCollectionDamaged) {
  HALFEDGE_NEEDS_DATA();
  constexpr std::size_t kLargest = 200000;
  std::size_t meshes = 0;
  std::size_t errors = 0;
  for (const char* folder : {"good", "nasty"}) {
    for (const auto& path : data_files(folder, {".obj", ".off", ".ply", ".stl"})) {
      if (std::filesystem::file_size(path) > kLargest) continue;
      const std::string whole = read_file(path);
      const auto seed = std::uint32_t(whole.size());
      std::mt19937 random(seed);
      for (int i = 0; i < 8 && !whole.empty(); ++i) {
        SCOPED_TRACE(path.filename().string() + ", round " + std::to_string(i));
        std::string damaged = i % 2 == 0 ? whole.substr(0, random() % whole.size()) : whole;
        for (std::size_t flips = i % 2 == 0 ? 0 : 1 + random() % 4; flips > 0; --flips) {
          damaged[random() % damaged.size()] = char(random());
        }
        ++(outcome_of(damaged).ends_with(" faces") ? meshes : errors);
        if (HasFailure()) return;
      }
    }
  }
  EXPECT_GT(meshes, 100U);
  EXPECT_GT(errors, 100U);
}

}  // namespace
}  // namespace halfedge::test
