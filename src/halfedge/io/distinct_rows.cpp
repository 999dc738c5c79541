#include <halfedge/io/distinct_rows.h>

#include <cstdint>
#include <cstring>

namespace halfedge::io {

bool DistinctRows::find_or_add(Index item, Index& number) {
  if (std::size_t{2} * (count_ + 1) > slots_.size() && !grow()) return false;
  Slot* const slot = look_up(item);
  if (slot == nullptr) {
    number = count_++;
    return true;
  }
  if (slot->item == kNone) *slot = {item, count_++};
  number = slot->number;
  return true;
}

std::size_t DistinctRows::hash(Index item) const {
  std::uint64_t h = 0x9E37'79B9'7F4A'7C15U;
  const std::byte* at = value(item);
  for (std::size_t left = column_.stride(); left > 0;) {
    std::uint32_t word = 0;
    const std::size_t size = left < sizeof(word) ? left : sizeof(word);
    std::memcpy(&word, at, size);
    h = (h ^ word) * 0xBF58'476D'1CE4'E5B9U;
    h ^= h >> 29U;
    at += size;
    left -= size;
  }
  return static_cast<std::size_t>(h >> 16U);
}

DistinctRows::Slot* DistinctRows::look_up(Index item) {
  constexpr std::size_t kMostProbes = 64;
  const std::size_t mask = slots_.size() - 1;
  std::size_t i = hash(item) & mask;
  for (std::size_t probes = 0; probes < kMostProbes; ++probes, i = (i + 1) & mask) {
    Slot& slot = slots_[i];
    if (slot.item == kNone) return &slot;
    if (std::memcmp(value(slot.item), value(item), column_.stride()) == 0) return &slot;
  }
  return nullptr;
}

bool DistinctRows::grow() {
  Array<Slot> old = std::move(slots_);
  slots_ = {};
  if (!slots_.resize(old.empty() ? 1024 : 2 * old.size(), Slot{kNone, kNone})) return false;
  for (const Slot& slot : old) {
    if (slot.item == kNone) continue;
    if (Slot* const to = look_up(slot.item); to != nullptr) *to = slot;
  }
  return true;
}

}  // namespace halfedge::io
