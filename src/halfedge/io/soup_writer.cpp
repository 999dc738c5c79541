#include <halfedge/io/soup_writer.h>
#include <halfedge/sentence.h>

#include <string>

namespace halfedge::io {

void Places::found(std::size_t first, std::size_t count, const std::uint8_t* position,
                   std::size_t stride) {
  while (next() - first < count) {
    found(next(), reinterpret_cast<const char*>(position + (next() - first) * stride));
  }
}

void SoupWriter::begin_vertices(std::size_t count, const std::uint8_t* position,
                                std::size_t stride) {
  if (wanted_.vertices == nullptr) return;
  wanted_.vertices->found(vertex_count(), count, position, stride);
  look_for_next_vertex();
}

void SoupWriter::begin_faces(std::size_t count, const std::uint8_t* position, std::size_t stride) {
  if (wanted_.faces == nullptr) return;
  wanted_.faces->found(faces_, count, position, stride);
  look_for_next_face();
}

/// The first of a face, of as many faces as a report may list.
bool SoupWriter::can_name() const {
  constexpr std::size_t kMostNamed = 1000;
  const MissingVertices& missing = soup_.missing;
  return missing.empty() || (missing.size() < kMostNamed && missing.back().corner < face_start_);
}

void SoupWriter::report(const void* position) {
  next_report_ = address_of(position) + kReportEvery;
  const auto done = static_cast<double>(address_of(position) - address_of(bytes_.data()));
  if (progress_(Stage::kRead, done / static_cast<double>(bytes_.size()))) return;
  cancelled_ = true;
  out_of_memory_ = true;  // which ends all loops of readers
}

Error error_at(const TextScanner& text, std::string_view code, const std::string& message) {
  return {code, sentence::of("line {}: {}", text.line(), message)};
}

Error unexpected(const TextScanner& text, const std::string& expected) {
  return error_at(text, text.at_end() ? "truncated" : "parse-error",
                  sentence::of("expected {}, found {}", expected, text.found()));
}

Error index_error(const TextScanner& text, std::size_t corner, std::size_t face) {
  Error error = error_at(text, "index-out-of-range",
                         sentence::of("corner {} of face {} is {}", corner, face, text.found()));
  error.witness.faces = {static_cast<Index>(face)};
  return error;
}

Error error_at_byte(std::size_t offset, std::string_view code, const std::string& message) {
  return {code, sentence::of("byte {}: {}", offset, message)};
}

std::optional<Error> check_size(SoupWriter& out) {
  const std::size_t vertices = out.vertex_count();
  const std::size_t faces = out.face_count();
  const std::size_t corners = out.corner_count();
  const bool too_large = std::max({vertices, faces, corners}) > kMaxSlots;
  if (!too_large && !out.out_of_memory()) return std::nullopt;

  out.soup() = {};
  if (out.cancelled()) return Error{"cancelled", "reading was cancelled"};
  const std::string counts =
      sentence::of("{}, {} and {} of faces", sentence::count_of(vertices, "vertex"),
                   sentence::count_of(faces, "face"), sentence::count_of(corners, "corner"));
  if (out.out_of_memory()) {
    return Error{"out-of-memory",
                 sentence::of("memory was exhausted after {} had been read", counts)};
  }
  return Error{"too-large",
               sentence::of("the file has {}, expected at most {} of each", counts, kMaxSlots)};
}

}  // namespace halfedge::io
