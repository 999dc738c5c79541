#include <halfedge/io/byte_scanner.h>
#include <halfedge/io/bytes.h>
#include <halfedge/io/bytes_layout.h>
#include <halfedge/sentence.h>
#include <halfedge/validate/validate.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace halfedge {

namespace {

using namespace bytes_layout;
using io::ByteOrder;
using Bytes = std::span<const std::uint8_t>;

std::uint32_t word_at(Bytes bytes, std::size_t offset) {
  return io::load<std::uint32_t>(&bytes[offset], ByteOrder::kLittle);
}

Error wrong(std::size_t offset, const std::string& what) {
  return {"parse-error", sentence::of("Byte {}: {}.", offset, what)};
}

Error truncated(std::size_t size, const std::string& expected) {
  return {"truncated", sentence::of("The bytes end at {}, expected {}.", size, expected)};
}

struct Header {
  bool stores_prev = true;
  std::array<Index, 3> slots = {};    // vertices, halfedges, faces
  std::array<FreeList, 3> free = {};  // vertices, edges, faces
  std::uint32_t sections = 0;

  [[nodiscard]] Index slots_of(ItemKind kind) const {
    if (kind == ItemKind::kVertex) return slots[0];
    if (kind == ItemKind::kFace) return slots[2];
    return kind == ItemKind::kEdge ? slots[1] / 2 : slots[1];
  }
  // Elements, all of them of four bytes, of one of kTags.
  [[nodiscard]] std::uint64_t elements(std::size_t section) const {
    if (section == kPositions) return 3 * std::uint64_t{slots[0]};
    return section < 4 ? slots[1] : slots[section == 4 ? 0 : 2];
  }
};

Result<Header> read_header(Bytes bytes) {
  const std::size_t known = std::min(bytes.size(), kMagic.size());
  if (!std::equal(kMagic.begin(), kMagic.begin() + std::ptrdiff_t(known), bytes.begin()) ||
      known == 0) {
    return Error{"unknown-format",
                 "The bytes don't begin with \"halfedge\": expected what toBytes has made."};
  }
  if (bytes.size() < kHeaderSize) return truncated(bytes.size(), "a header of 56 bytes");
  Header header;
  if (const std::uint32_t version = word_at(bytes, 8); version != kVersion) {
    return Error{
        "unsupported-version",
        sentence::of("The bytes are of version {} of the format, expected {}.", version, kVersion)};
  }
  if (word_at(bytes, 12) > 1) {
    return wrong(12, sentence::of("the storage is {}, expected 0 or 1", word_at(bytes, 12)));
  }
  header.stores_prev = word_at(bytes, 12) == 1;
  for (std::size_t i = 0; i < 3; ++i) {
    header.slots[i] = word_at(bytes, 16 + 4 * i);
    header.free[i] = {word_at(bytes, 28 + 8 * i), word_at(bytes, 32 + 8 * i)};
    if (header.slots[i] > kMaxSlots || (i == 1 && header.slots[i] % 2 != 0)) {
      return wrong(
          16 + 4 * i,
          sentence::of("there are {} slots, expected at most {}, and an even number of halfedges",
                       header.slots[i], kMaxSlots));
    }
    const Index items = i == 1 ? header.slots[i] / 2 : header.slots[i];
    if (header.free[i].count > items) {  // a chain that runs in a circle would be followed as long
      return wrong(32 + 8 * i, sentence::of("there are {} deleted slots, expected at most all {}",
                                            header.free[i].count, items));
    }
  }
  header.sections = word_at(bytes, 52);
  if (header.sections > kMaxSections) {
    return wrong(52, sentence::of("there are {} sections, expected at most {}", header.sections,
                                  kMaxSections));
  }
  return header;
}

struct Section {
  std::size_t offset = 0;
  Bytes content;
};

struct Sections {
  Section arrays[std::size(kTags)];
  std::vector<Section> attributes;
};

// The section that begins at `offset`, which is moved behind it.
Result<Section> read_section(Bytes bytes, std::size_t& offset, std::string_view& tag) {
  if (bytes.size() - offset < kSectionHeaderSize) {
    return truncated(bytes.size(), sentence::of("the header of a section at {}", offset));
  }
  tag = {reinterpret_cast<const char*>(&bytes[offset]), 4};
  const auto length = io::load<std::uint64_t>(&bytes[offset + 8], ByteOrder::kLittle);
  const std::size_t begin = offset + kSectionHeaderSize;
  const std::size_t left = bytes.size() - begin;
  if (length > left || padded(std::size_t(length)) > left) {
    return truncated(bytes.size(), sentence::of("a section of {} bytes at {}", length, begin));
  }
  offset = begin + padded(std::size_t(length));
  return Section{begin, bytes.subspan(begin, std::size_t(length))};
}

Result<Sections> read_sections(Bytes bytes, const Header& header) {
  Sections sections;
  std::size_t offset = kHeaderSize;
  for (std::uint32_t i = 0; i < header.sections; ++i) {
    const std::size_t begin = offset;
    std::string_view tag;
    Result<Section> section = read_section(bytes, offset, tag);
    if (!section) return section;
    if (tag == kAttributeTag) {
      sections.attributes.push_back(section.value());
      continue;
    }
    const std::size_t which =
        std::size_t(std::find(std::begin(kTags), std::end(kTags), tag) - kTags);
    if (which == std::size(kTags) || (which == kPrev && !header.stores_prev)) {
      return wrong(begin, "the section is of no known kind");
    }
    Section& known = sections.arrays[which];
    if (known.offset != 0) return wrong(begin, "the section is there for the second time");
    const std::uint64_t expected = 4 * header.elements(which);
    if (section.value().content.size() != expected) {
      return wrong(begin, sentence::of("the section has {} bytes, expected {}",
                                       section.value().content.size(), expected));
    }
    known = section.value();
  }
  if (offset != bytes.size()) return wrong(offset, "there is more after the last section");
  for (std::size_t i = 0; i < std::size(kTags); ++i) {
    if (sections.arrays[i].offset == 0 && (i != kPrev || header.stores_prev)) {
      return wrong(offset, sentence::of("the section \"{}\" is missing", kTags[i]));
    }
  }
  return sections;
}

// Marks the slots of a chain as deleted, by deleting them in the order in which that was done once:
// this makes the same chain. `links` is the section that it is threaded through.
template <class Item>
Result<void> release_chain(auto& mesh, const FreeList& chain, const Section& links,
                           std::size_t stride) {
  const Index slots = mesh.slots(Item{});
  Array<Index> deleted;
  Index slot = chain.head;
  while (slot != kNone) {
    const std::size_t at = 4 * stride * slot;
    const Index link = slot < slots ? word_at(links.content, at) : kNone;
    if (!is_deleted_link(link) || deleted.size() == chain.count) {
      return wrong(
          links.offset,
          sentence::of("the chain of deleted {} slots, expected {} of them, leads to slot {}",
                       name_of(kind_of(Item{})), chain.count, slot));
    }
    if (!deleted.push_back(slot)) return no_memory_for_bytes();
    slot = next_free_slot(link);
  }
  if (deleted.size() != chain.count) {
    return wrong(links.offset, sentence::of("the chain of deleted {} slots has {}, expected {}",
                                            name_of(kind_of(Item{})), deleted.size(), chain.count));
  }
  for (std::size_t i = deleted.size(); i-- > 0;) {
    if (!mesh.is_live(Item(deleted[i]))) {
      return wrong(links.offset, sentence::of("the chain of deleted {} slots runs in a circle",
                                              name_of(kind_of(Item{}))));
    }
    mesh.release(Item(deleted[i]));
  }
  return {};
}

Result<void> read_attribute(auto& mesh, const Header& header, const Section& section) {
  const Bytes content = section.content;
  if (content.size() < kAttributeHeaderSize) {
    return wrong(section.offset,
                 sentence::of("the attribute has {} bytes, expected 20 or more", content.size()));
  }
  const std::uint32_t kind = word_at(content, 0);
  const std::uint32_t type = word_at(content, 4);
  const std::uint32_t components = word_at(content, 8);
  const std::uint32_t on_split = word_at(content, 12);
  const std::size_t name_size = word_at(content, 16);
  if (kind > std::uint32_t(ItemKind::kFace) || type > std::uint32_t(Scalar::kUint32) ||
      components < 1 || components > Attribute::kMaxComponents ||
      on_split > std::uint32_t(OnSplit::kCopyCorner)) {
    return wrong(section.offset,
                 sentence::of("the attribute has kind {}, type {}, {} components, on-split {}, "
                              "expected less than 4, 8, 17 (1 or more), 5",
                              kind, type, components, on_split));
  }
  const std::uint64_t slots = header.slots_of(ItemKind(kind));
  const std::size_t width = size_of(Scalar(type));
  const std::size_t stride = width * components;
  const std::size_t default_at = padded(kAttributeHeaderSize + name_size);
  const std::size_t values_at = default_at + padded(stride);
  if (name_size > content.size() || content.size() != values_at + stride * slots) {
    return wrong(section.offset, sentence::of("the attribute has {} bytes, expected {}",
                                              content.size(), values_at + stride * slots));
  }
  AttributeOptions options{
      .type = Scalar(type), .components = components, .on_split = OnSplit(on_split)};
  // A column of one item tells what numbers the default is.
  Attribute one("default", ItemKind(kind), options, 0);
  if (!one.has_default() || !one.reserve(1)) return no_memory_for_bytes();
  one.resize(1);
  copy_little_endian(&content[default_at], one.bytes().data(), stride, width);
  std::array<double, Attribute::kMaxComponents> numbers;
  for (Index i = 0; i < components; ++i) numbers[i] = one.get(0, i);
  options.default_value = {numbers.data(), components};
  const std::string name(reinterpret_cast<const char*>(&content[kAttributeHeaderSize]), name_size);
  Result<Attribute*> added = mesh.add_attribute(ItemKind(kind), name, options);
  if (!added) return added;
  if (slots > 0) {
    copy_little_endian(&content[values_at], added.value()->bytes().data(),
                       std::size_t(stride * slots), width);
  }
  return {};
}

template <Storage kStored>
Result<void> read_all(Bytes bytes, const Header& header, BytesFrom from, BasicMesh<kStored>& mesh) {
  Result<Sections> sections = read_sections(bytes, header);
  if (!sections) return sections;
  const Section* const arrays = sections.value().arrays;
  {
    Links& links = mesh.mutable_links();
    for (std::size_t i = 0; i < kPositions; ++i) {
      const bool is_stored = i != kPrev || mesh.stores_prev();
      if (is_stored && !array_of(links, i).resize(std::size_t(header.elements(i)), kNone)) {
        return no_memory_for_bytes();
      }
    }
  }
  if (!mesh.mutable_positions().resize(std::size_t(header.elements(kPositions))))
    return no_memory_for_bytes();
  Result<void> released = release_chain<Vertex>(mesh, header.free[0], arrays[4], 1);
  if (released) released = release_chain<Edge>(mesh, header.free[1], arrays[0], 2);
  if (released) released = release_chain<Face>(mesh, header.free[2], arrays[5], 1);
  if (!released) return released;
  Links& links = mesh.mutable_links();
  for (std::size_t i = 0; i < kPositions; ++i) {
    if (arrays[i].offset == 0) continue;
    copy_little_endian(arrays[i].content.data(), array_of(links, i).data(),
                       arrays[i].content.size(), sizeof(Index));
  }
  copy_little_endian(arrays[kPositions].content.data(), mesh.mutable_positions().data(),
                     arrays[kPositions].content.size(), sizeof(float));
  for (const Section& attribute : sections.value().attributes) {
    if (Result<void> read = read_attribute(mesh, header, attribute); !read) return read;
  }
  if (from == BytesFrom::kThisProgram) return {};
  const std::vector<Problem> problems = validate(mesh, 2);
  for (const Problem& problem : problems) {
    if (problem.severity != Severity::kError) continue;
    if (problem.code == "out-of-memory") return no_memory_for_bytes();
    return Error{"corrupt-connectivity",
                 sentence::of("The bytes hold links that are none of a mesh. {}", problem.message)};
  }
  return {};
}

}  // namespace

Result<bool> stores_prev(std::span<const std::uint8_t> bytes) {
  Result<Header> header = read_header(bytes);
  if (!header) return header;
  return header.value().stores_prev;
}

template <Storage kStored>
requires StoresSurface<BasicMesh<kStored>> Result<void> from_bytes(
    std::span<const std::uint8_t> bytes, BasicMesh<kStored>& mesh, BytesFrom from) {
  Result<Header> header = read_header(bytes);
  if (!header) return header;
  BasicMesh<kStored> read;
  if constexpr (kStored.prev_at_run_time) {
    read.choose_prev(header.value().stores_prev);
  } else if (header.value().stores_prev != kStored.prev) {
    return Error{"storage-mismatch", std::string("The bytes are of a mesh ") +
                                         (kStored.prev ? "without prev, expected one with it."
                                                       : "with prev, expected one without it.")};
  }
  if (Result<void> done = read_all(bytes, header.value(), from, read); !done) return done;
  mesh = std::move(read);
  return {};
}

template Result<void> from_bytes(std::span<const std::uint8_t>, BasicMesh<kEverything>&, BytesFrom);
template Result<void> from_bytes(std::span<const std::uint8_t>, BasicMesh<kWithoutPrev>&,
                                 BytesFrom);
template Result<void> from_bytes(std::span<const std::uint8_t>, BasicMesh<kPrevAtRunTime>&,
                                 BytesFrom);

}  // namespace halfedge
