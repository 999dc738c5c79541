#include <halfedge/io/soup_writer.h>

#include <string>
#include <utility>

namespace halfedge::io {

void SoupWriter::report(const void* position) {
  next_report_ = address_of(position) + kReportEvery;
  const auto done = static_cast<double>(address_of(position) - address_of(bytes_.data()));
  if (progress_(Stage::kRead, done / static_cast<double>(bytes_.size()))) return;
  cancelled_ = true;
  out_of_memory_ = true;  // which ends all loops of readers
}

Error error_at(const TextScanner& text, std::string code, const std::string& message) {
  return {std::move(code), "line " + std::to_string(text.line()) + ": " + message};
}

Error unexpected(const TextScanner& text, const std::string& expected) {
  return error_at(text, text.at_end() ? "truncated" : "parse-error",
                  "expected " + expected + ", found " + text.found());
}

Error index_error(const TextScanner& text, std::size_t corner, std::size_t face) {
  Error error = error_at(text, "index-out-of-range",
                         "corner " + std::to_string(corner) + " of face " + std::to_string(face) +
                             " is " + text.found());
  error.witness.faces = {static_cast<Index>(face)};
  return error;
}

Error error_at_byte(std::size_t offset, std::string code, const std::string& message) {
  return {std::move(code), "byte " + std::to_string(offset) + ": " + message};
}

std::optional<Error> check_size(SoupWriter& out) {
  const std::size_t vertices = out.vertex_count();
  const std::size_t faces = out.face_count();
  const std::size_t corners = out.corner_count();
  const bool too_large = std::max({vertices, faces, corners}) > kMaxSlots;
  if (!too_large && !out.out_of_memory()) return std::nullopt;

  out.soup() = {};
  if (out.cancelled()) return Error{"cancelled", "reading was cancelled"};
  const std::string counts = std::to_string(vertices) + " vertices, " + std::to_string(faces) +
                             " faces and " + std::to_string(corners) + " corners of faces";
  if (out.out_of_memory()) {
    return Error{"out-of-memory", "memory was exhausted after " + counts + " had been read"};
  }
  return Error{"too-large", "the file has " + counts + ", expected at most " +
                                std::to_string(kMaxSlots) + " of each"};
}

}  // namespace halfedge::io
