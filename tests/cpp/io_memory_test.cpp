#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/io/parse.h>
#include <halfedge/io/write.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>

#include "support/limited_memory.h"
#include "support/text_file.h"

namespace halfedge::test {
namespace {

#if defined(HALFEDGE_CAN_LIMIT_MEMORY)

// Parses with ever more memory until there is enough. Exits with 0 if each time before that ended
// in an error with a sentence, there were many of them, and the last outcome is `expected`: "" or
// the code of an error.
[[noreturn]] void parse_with_more_and_more_memory(const std::string& text, const char* expected) {
  constexpr std::size_t kStep = std::size_t{1} << 18U;
  const std::size_t in_use = use_up_memory();
  for (int failures = 0;; ++failures) {
    if (!limit_address_space(in_use + kStep * std::size_t(failures))) std::_Exit(2);
    const Result<ParsedFile> file = parse(bytes_of(text));
    if (!file && file.error().code == "out-of-memory") {
      if (!file.error().message.starts_with("memory was exhausted ")) std::_Exit(3);
      continue;
    }
    if ((file ? "" : file.error().code) != expected) std::_Exit(4);
    std::_Exit(failures > 8 ? 0 : 5);
  }
}

[[noreturn]] void write_with_more_and_more_memory(const Mesh& mesh, Format format) {
  constexpr std::size_t kStep = std::size_t{1} << 18U;
  const std::size_t in_use = use_up_memory();
  for (int failures = 0;; ++failures) {
    if (!limit_address_space(in_use + kStep * std::size_t(failures))) std::_Exit(2);
    const auto bytes = write(mesh, format);
    if (bytes) std::_Exit(failures > 4 ? 0 : 5);
    if (bytes.error().code != "out-of-memory") std::_Exit(3);
    if (bytes.error().message.find("memory") == std::string::npos) std::_Exit(4);
  }
}

// Vertices, triangles, and with the first quad the sizes as well.
std::string large_obj() {
  std::string text;
  for (int i = 0; i < 100000; ++i) text += "v 0 0 0\n";
  for (int i = 0; i < 200000; ++i) text += "f 1 2 3\n";
  return text + "f 1 2 3 4\n";
}

TEST(ParseMemoryDeathTest, WhereverMemoryEndsReadingObjEndsInAnError) {
  const std::string text = large_obj();
  EXPECT_EXIT(parse_with_more_and_more_memory(text, ""), testing::ExitedWithCode(0), "");
  EXPECT_EXIT(parse_with_more_and_more_memory(text + "f 1 2 100001\n", "index-out-of-range"),
              testing::ExitedWithCode(0), "");
}

TEST(ParseMemoryDeathTest, WhereverMemoryEndsReadingOffEndsInAnError) {
  std::string text = "OFF\n100000 200001\n";
  for (int i = 0; i < 100000; ++i) text += "0 0 0\n";
  for (int i = 0; i < 200000; ++i) text += "3 0 1 2\n";
  EXPECT_EXIT(parse_with_more_and_more_memory(text + "4 0 1 2 3\n", ""), testing::ExitedWithCode(0),
              "");
}

TEST(ParseMemoryDeathTest, WhereverMemoryEndsReadingPlyEndsInAnError) {
  std::string text;
  text.reserve(std::size_t{1} << 22U);  // or what it grows out of is there for the reader
  text =
      "ply\nformat binary_little_endian 1.0\nelement vertex 100000\nproperty float x\n"
      "property float y\nproperty float z\nelement face 200001\n"
      "property list uchar int vertex_indices\nend_header\n";
  text.append(1200000, '\0');
  for (int i = 0; i < 200000; ++i) text += '\3' + std::string(12, '\0');
  text += '\4' + std::string(16, '\0');
  EXPECT_EXIT(parse_with_more_and_more_memory(text, ""), testing::ExitedWithCode(0), "");
}

TEST(ParseMemoryDeathTest, WhereverMemoryEndsReadingStlEndsInAnError) {
  constexpr std::uint32_t kTriangles = 100000;
  std::string text(80, ' ');
  text.append(reinterpret_cast<const char*>(&kTriangles), sizeof(kTriangles));
  text.resize(84 + 50 * std::size_t{kTriangles});
  for (std::size_t i = 0; i < 3 * std::size_t{kTriangles}; ++i) {  // no two corners are the same
    const auto x = static_cast<float>(i);
    std::memcpy(&text[84 + 50 * (i / 3) + 12 + 12 * (i % 3)], &x, sizeof(x));
  }
  EXPECT_EXIT(parse_with_more_and_more_memory(text, ""), testing::ExitedWithCode(0), "");
}

TEST(ParseMemoryDeathTest, WhereverMemoryEndsWritingEndsInAnError) {
  std::string text = "OFF\n100000 33333\n";
  for (int i = 0; i < 100000; ++i) text += std::to_string(i) + " 0.5 0\n";
  for (int i = 0; i < 33333; ++i) {
    text += '3';
    for (int c = 0; c < 3; ++c) text += ' ' + std::to_string(3 * i + c);
    text += '\n';
  }
  const Result<ParsedFile> file = parse(bytes_of(text));
  ASSERT_TRUE(file);
  Mesh mesh;
  BuildReport report;
  ASSERT_TRUE(build_from_polygons(mesh, file.value().soup.view(), report));
  for (const Format format : {Format::kObj, Format::kOff, Format::kPly, Format::kStl}) {
    EXPECT_EXIT(write_with_more_and_more_memory(mesh, format), testing::ExitedWithCode(0), "");
  }
}

#else

TEST(ParseMemoryDeathTest, WhereverMemoryEndsReadingEndsInAnError) {
  GTEST_SKIP() << "memory can be limited on Linux only, and not under AddressSanitizer";
}

#endif

}  // namespace
}  // namespace halfedge::test
