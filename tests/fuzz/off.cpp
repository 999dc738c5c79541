// Any bytes, read as OFF.

#include <halfedge/io/parse.h>

#include "support/reading.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return halfedge::fuzz::expect_read({data, size}, [](auto bytes, const auto& options) {
    return halfedge::read_off(bytes, options);
  });
}
