#include <halfedge/io/bytes.h>
#include <halfedge/io/bytes_layout.h>
#include <halfedge/sentence.h>

#include <cstddef>
#include <cstring>
#include <string_view>

namespace halfedge {

namespace {

using namespace bytes_layout;

// Writes where there is room for all of it; counts bytes where there is none yet.
class Pen {
 public:
  explicit Pen(std::uint8_t* out) : out_(out) {}

  [[nodiscard]] std::size_t size() const { return size_; }

  void characters(std::string_view text) { numbers(text.data(), text.size(), 1); }
  void word(std::uint32_t word) { numbers(&word, sizeof word, sizeof word); }
  void numbers(const void* from, std::size_t bytes, std::size_t width) {
    if (out_ != nullptr) copy_little_endian(from, out_ + size_, bytes, width);
    size_ += bytes;
  }
  void pad() {
    if (out_ != nullptr) std::memset(out_ + size_, 0, padded(size_) - size_);
    size_ = padded(size_);
  }
  void section(std::string_view tag, std::uint64_t bytes) {
    characters(tag);
    word(0);
    numbers(&bytes, sizeof bytes, sizeof bytes);
  }

 private:
  std::uint8_t* out_;
  std::size_t size_ = 0;
};

void write_attribute(Pen& pen, const Attribute& column) {
  const std::size_t name = column.name().size();
  pen.section(kAttributeTag, padded(kAttributeHeaderSize + name) + padded(column.stride()) +
                                 column.bytes().size());
  pen.word(std::uint32_t(column.kind()));
  pen.word(std::uint32_t(column.type()));
  pen.word(column.components());
  pen.word(std::uint32_t(column.on_split()));
  pen.word(std::uint32_t(name));
  pen.characters(column.name());
  pen.pad();
  const std::size_t width = size_of(column.type());
  pen.numbers(column.default_value().data(), column.stride(), width);
  pen.pad();
  pen.numbers(column.bytes().data(), column.bytes().size(), width);
  pen.pad();
}

template <class Visit>
void for_columns(const Attributes& attributes, const Visit& visit) {
  for (const ItemKind kind : kItemKinds) {
    for (const Attributes::Column& column : attributes.of(kind)) {
      if (!column->is_generation()) visit(*column);
    }
  }
}

std::uint32_t count_sections(const BytesSource& source) {
  std::uint32_t sections = source.stores_prev ? 7 : 6;
  for_columns(source.attributes, [&](const Attribute&) { ++sections; });
  return sections;
}

void write_all(Pen& pen, const BytesSource& source) {
  const Links& links = source.links;
  pen.characters(kMagic);
  for (const std::uint32_t word :
       {kVersion, std::uint32_t{source.stores_prev}, std::uint32_t(links.vertex_halfedge.size()),
        std::uint32_t(links.next.size()), std::uint32_t(links.face_halfedge.size()),
        source.free[0].head, source.free[0].count, source.free[1].head, source.free[1].count,
        source.free[2].head, source.free[2].count, count_sections(source)}) {
    pen.word(word);
  }
  for (std::size_t i = 0; i < kPositions; ++i) {
    if (i == kPrev && !source.stores_prev) continue;
    const std::span<const Index> words = array_of(links, i).span();
    pen.section(kTags[i], words.size_bytes());
    pen.numbers(words.data(), words.size_bytes(), sizeof(Index));
    pen.pad();
  }
  pen.section(kTags[kPositions], source.positions.size_bytes());
  pen.numbers(source.positions.data(), source.positions.size_bytes(), sizeof(float));
  pen.pad();
  for_columns(source.attributes, [&](const Attribute& column) { write_attribute(pen, column); });
}

}  // namespace

Result<Array<std::uint8_t>> to_bytes(const BytesSource& source) {
  if (const std::uint32_t count = count_sections(source); count > kMaxSections) {
    return Error{
        "too-large",
        sentence::of("A mesh with {} attributes has no room in bytes, expected at most {}.",
                     count - std::size(kTags), kMaxSections - std::size(kTags))};
  }
  Pen counting(nullptr);
  write_all(counting, source);
  Array<std::uint8_t> bytes;
  if (!bytes.resize(counting.size())) return no_memory_for_bytes();
  Pen writing(bytes.data());
  write_all(writing, source);
  return bytes;
}

}  // namespace halfedge
