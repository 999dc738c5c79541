// Any bytes, read as what their content says they are. The first byte is what the name of the file
// claims.

#include <halfedge/io/parse.h>

#include <optional>

#include "support/reading.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using halfedge::Format;
  if (size == 0) return 0;
  constexpr std::optional<Format> kClaims[] = {std::nullopt, Format::kObj, Format::kOff,
                                               Format::kPly, Format::kStl};
  const std::optional<Format> claimed = kClaims[data[0] % 5];
  return halfedge::fuzz::expect_read({data + 1, size - 1},
                                     [claimed](auto bytes, const auto& options) {
                                       return halfedge::parse(bytes, claimed, options);
                                     });
}
