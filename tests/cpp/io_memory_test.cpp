#include <gtest/gtest.h>
#include <halfedge/io/parse.h>

#include <cstddef>
#include <cstdlib>
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
  const std::size_t in_use = address_space_in_use();
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

#else

TEST(ParseMemoryDeathTest, WhereverMemoryEndsReadingEndsInAnError) {
  GTEST_SKIP() << "memory can be limited on Linux only, and not under AddressSanitizer";
}

#endif

}  // namespace
}  // namespace halfedge::test
