#include <halfedge/attributes/attribute.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace halfedge {

namespace {

// Calls `function` with a number of the type.
template <class Function>
auto with_type(Scalar type, const Function& function) {
  switch (type) {
    case Scalar::kFloat64:
      return function(double{});
    case Scalar::kInt8:
      return function(std::int8_t{});
    case Scalar::kUint8:
      return function(std::uint8_t{});
    case Scalar::kInt16:
      return function(std::int16_t{});
    case Scalar::kUint16:
      return function(std::uint16_t{});
    case Scalar::kInt32:
      return function(std::int32_t{});
    case Scalar::kUint32:
      return function(std::uint32_t{});
    case Scalar::kFloat32:
      break;
  }
  return function(float{});
}

// Integers are rounded and kept in their range; not-a-number is 0 then.
template <class T>
T convert_number(double value) {
  if constexpr (std::is_floating_point_v<T>) {
    return T(value);
  } else {
    using Limits = std::numeric_limits<T>;
    if (std::isnan(value)) return 0;
    return T(std::clamp(std::nearbyint(value), double{Limits::lowest()}, double{Limits::max()}));
  }
}

}  // namespace

const char* name_of(Scalar type) {
  constexpr const char* kNames[] = {"float32", "float64", "int8",  "uint8",
                                    "int16",   "uint16",  "int32", "uint32"};
  return kNames[std::size_t(type)];
}

const char* name_of(OnSplit policy) {
  constexpr const char* kNames[] = {"interpolate", "normalize", "copy", "default", "copy-corner"};
  return kNames[std::size_t(policy)];
}

std::size_t size_of(Scalar type) {
  return with_type(type, [](auto number) { return sizeof number; });
}

Attribute::Attribute(std::string name, ItemKind kind, const AttributeOptions& options, Index serial)
    : name_(std::move(name)),
      kind_(kind),
      type_(options.type),
      on_split_(options.on_split),
      is_generation_(options.is_generation),
      components_(options.components),
      serial_(serial),
      stride_(options.components * size_of(options.type)) {
  assert(components_ >= 1 && components_ <= kMaxComponents);
  // One item, made where the values go, holds the default until it is moved to its place.
  if (!default_.resize(stride_, std::byte{}) || options.default_value.empty()) return;
  bytes_ = std::move(default_);
  for (Index i = 0; i < components_; ++i) put(0, i, options.default_value[i]);
  default_ = std::exchange(bytes_, {});
}

double Attribute::get(Index item, Index component) const {
  return number_at(&bytes_[stride_ * item], component);
}

double Attribute::default_value(Index component) const {
  return number_at(default_.data(), component);
}

double Attribute::number_at(const std::byte* item, Index component) const {
  return with_type(type_, [&](auto number) {
    std::memcpy(&number, item + sizeof number * component, sizeof number);
    return double(number);
  });
}

void Attribute::put(Index item, Index component, double value) {
  with_type(type_, [&](auto number) {
    number = convert_number<decltype(number)>(value);
    std::memcpy(&bytes_[stride_ * item + sizeof number * component], &number, sizeof number);
  });
}

bool Attribute::reserve(std::size_t slots) {
  const std::size_t bytes = stride_ * slots;
  return bytes <= bytes_.capacity() || bytes_.reserve_amply(bytes);
}

void Attribute::resize(Index slots) {
  const Index old = slots_;
  (void)bytes_.resize(stride_ * slots);  // in the room made before
  slots_ = slots;
  const bool is_zero =
      std::all_of(default_.begin(), default_.end(), [](std::byte b) { return b == std::byte{}; });
  if (is_zero) {
    if (slots > old) std::memset(&bytes_[stride_ * old], 0, stride_ * (slots - old));
    return;
  }
  for (Index item = old; item < slots; ++item) set_default(item, nullptr);
}

bool Attribute::assign(const Attribute& other) {
  assert(stride_ == other.stride_);
  if (!bytes_.assign(other.bytes_.span()) || !default_.assign(other.default_.span())) return false;
  slots_ = other.slots_;
  return true;
}

void Attribute::note(Index item, Journal* journal) const {
  if (journal != nullptr) {
    journal->record_attribute(serial_, item, &bytes_[stride_ * item], stride_);
  }
}

void Attribute::exchange(const Journal::Note& note) {
  std::size_t size = stride_;
  if (note.field == Field::kAttributeRun) {
    size = std::min(note.count * sizeof(Index), stride_ * (slots_ - note.index));
  }
  std::byte* const stored = &bytes_[stride_ * note.index];
  std::swap_ranges(stored, stored + size, reinterpret_cast<std::byte*>(note.words));
}

void Attribute::set_default(Index item, Journal* journal) {
  note(item, journal);
  std::copy(default_.begin(), default_.end(), &bytes_[stride_ * item]);
}

void Attribute::set_all(Index value) {
  assert(type_ == Scalar::kUint32 && components_ == 1);
  std::memcpy(default_.data(), &value, sizeof value);
  for (Index item = 0; item < slots_; ++item) set_default(item, nullptr);
}

void Attribute::copy(Index to, Index from, Journal* journal) {
  if (on_split_ == OnSplit::kDefault || to == from) return;
  note(to, journal);
  std::copy_n(&bytes_[stride_ * from], stride_, &bytes_[stride_ * to]);
}

void Attribute::swap(Index a, Index b, Journal* journal) {
  if (a == b) return;
  note(a, journal);
  note(b, journal);
  std::byte* const of_a = &bytes_[stride_ * a];
  std::swap_ranges(of_a, of_a + stride_, &bytes_[stride_ * b]);
}

void Attribute::set(Index item, Index component, double value, Journal* journal) {
  note(item, journal);
  put(item, component, value);
}

void Attribute::add(Sum& sum, Index item, double weight) const {
  if (weight == 0) return;  // 0 times infinity is no number
  if (interpolates()) {
    for (Index i = 0; i < components_; ++i) sum.values[i] += weight * get(item, i);
  }
  sum.weight += weight;
  if (sum.heaviest == kNone || weight > sum.largest) {
    sum.largest = weight;
    sum.heaviest = item;
  }
}

void Attribute::store(const Sum& sum, Index to, Journal* journal) {
  if (sum.heaviest == kNone || on_split_ == OnSplit::kDefault) return;
  if (!interpolates()) return copy(to, sum.heaviest, journal);
  double scale = sum.weight;
  if (on_split_ == OnSplit::kNormalize) {
    double squares = 0;
    for (Index i = 0; i < components_; ++i) squares += sum.values[i] * sum.values[i];
    if (!(squares > 0)) return copy(to, sum.heaviest, journal);  // opposite directions
    scale = std::sqrt(squares);
  }
  note(to, journal);
  for (Index i = 0; i < components_; ++i) put(to, i, sum.values[i] / scale);
}

void Attribute::note_all(Journal& journal) const {
  // Notes but for the last end with a word, so that none holds bytes of an item beyond it.
  auto run = Index(Journal::kMostWords * sizeof(Index) / stride_);
  if (stride_ % sizeof(Index) != 0) run -= Index(run % sizeof(Index));
  for (Index item = 0; item < slots_; item += run) {
    const Index count = std::min(run, slots_ - item);
    journal.record_attribute_run(serial_, item, &bytes_[stride_ * item], stride_ * count);
  }
}

void Attribute::compact(const Array<Index>& map, std::size_t width) {
  std::size_t end = 0;
  const std::size_t bytes = width * stride_;
  for (std::size_t old = 0; old < map.size(); ++old) {
    if (map[old] == kNone) continue;
    if (end != old) std::memcpy(&bytes_[bytes * end], &bytes_[bytes * old], bytes);
    ++end;
  }
  slots_ = Index(width * end);
  (void)bytes_.resize(bytes * end);  // no larger than it is
}

}  // namespace halfedge
