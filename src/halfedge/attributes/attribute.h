#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/handle.h>
#include <halfedge/history/journal.h>

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

namespace halfedge {

/// The type of the numbers of an attribute.
enum class Scalar : std::uint8_t {
  kFloat32,
  kFloat64,
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32
};

/// "float32"
[[nodiscard]] const char* name_of(Scalar type);
/// In bytes.
[[nodiscard]] std::size_t size_of(Scalar type);

/// The value that an operation gives to an item that it makes out of others.
enum class OnSplit : std::uint8_t {
  kInterpolate,  ///< the weighted mean of what it is made of; integers are rounded
  kNormalize,    ///< the same, brought to length 1: for normals
  kCopy,         ///< that of the item that has the most weight in it
  kDefault,      ///< the default of the attribute
  kCopyCorner    ///< as kCopy, for halfedges, whose values are those of corners: labels with seams
};

/// "interpolate"
[[nodiscard]] const char* name_of(OnSplit policy);

/// What is said of an attribute when it is added.
struct AttributeOptions {
  Scalar type = Scalar::kFloat32;
  /// Numbers for each item, 1 to kMaxComponents.
  Index components = 1;
  OnSplit on_split = OnSplit::kInterpolate;
  /// One number for each component, or none: zeros.
  std::span<const double> default_value = {};
  /// Not values that the user gives: stamps that tell apart the items which had the same slot. An
  /// item that is deleted leaves another stamp behind. Only for enable_generations, which adds such
  /// columns: of one uint32, and without a name.
  bool is_generation = false;
};

/// A named column: for each slot of one kind of item some numbers of one type, in a row.
///
/// With the policies kInterpolate, kNormalize and kCopyCorner a value of a halfedge is that of the
/// *corner* where it ends, in its face (texture coordinates with seams); with the others it is the
/// halfedge's own.
class Attribute {
 public:
  static constexpr Index kMaxComponents = 16;

  /// pre: 1 <= options.components <= kMaxComponents, default_value has as many numbers or none
  Attribute(std::string name, ItemKind kind, const AttributeOptions& options, Index serial);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] ItemKind kind() const { return kind_; }
  [[nodiscard]] Scalar type() const { return type_; }
  [[nodiscard]] Index components() const { return components_; }
  [[nodiscard]] OnSplit on_split() const { return on_split_; }
  /// Tells this column from all others that the mesh ever had.
  [[nodiscard]] Index serial() const { return serial_; }
  [[nodiscard]] bool is_generation() const { return is_generation_; }
  /// Of one item, in bytes.
  [[nodiscard]] std::size_t stride() const { return stride_; }
  /// Items, live and deleted.
  [[nodiscard]] Index slots() const { return slots_; }

  /// All values. Writes through them are not part of history. Growth of the mesh invalidates them.
  [[nodiscard]] std::span<const std::byte> bytes() const {
    return {bytes_.data(), stride_ * slots_};
  }
  [[nodiscard]] std::span<std::byte> bytes() { return {bytes_.data(), stride_ * slots_}; }
  /// The same as numbers. pre: T is the type of the attribute
  template <class T>
  [[nodiscard]] std::span<T> values() {
    assert(sizeof(T) == size_of(type_) && std::is_floating_point_v<T> == is_float());
    return {reinterpret_cast<T*>(bytes_.data()), components_ * std::size_t{slots_}};
  }
  template <class T>
  [[nodiscard]] std::span<const T> values() const {
    return const_cast<Attribute*>(this)->values<T>();
  }

  /// False if there was no memory for the default: then the column is of no use.
  [[nodiscard]] bool has_default() const { return default_.size() == stride_; }
  /// The value of new items, in bytes.
  [[nodiscard]] std::span<const std::byte> default_value() const { return default_.span(); }
  /// One component of it, as a number.
  [[nodiscard]] double default_value(Index component) const;

  /// One component of one item, as a number.
  [[nodiscard]] double get(Index item, Index component) const;

  // ---- what the mesh and its operations do --------------------------------------------------
  // Writes are noted in the journal, if there is one.

  /// Room for so many slots. False when memory is exhausted.
  [[nodiscard]] bool reserve(std::size_t slots);
  /// pre: there is room for them. New slots get the default.
  void resize(Index slots);
  /// Takes over the values of all slots, as they lie in memory.
  /// pre: values.size() == bytes().size()
  void adopt(Array<std::byte>&& values) { bytes_ = std::move(values); }
  /// Takes over the values of `other`, a column like this one. False when memory is exhausted.
  [[nodiscard]] bool assign(const Attribute& other);

  void set_default(Index item, Journal* journal);
  /// All items, and those to come. pre: one number of type uint32 each
  void set_all(Index value);
  /// Unless the policy is kDefault.
  void copy(Index to, Index from, Journal* journal);
  void swap(Index a, Index b, Journal* journal);
  /// Sets one component. Integers are rounded and kept in their range.
  void set(Index item, Index component, double value, Journal* journal);

  /// A mean underway.
  struct Sum {
    std::array<double, kMaxComponents> values = {};
    double weight = 0;
    double largest = 0;  // weight of one item
    Index heaviest = kNone;
  };
  void add(Sum& sum, Index item, double weight) const;
  /// Gives `to` what the policy makes of the items that were added. With no weight at all nothing
  /// changes.
  void store(const Sum& sum, Index to, Journal* journal);

  /// The bytes of one item.
  using Value = std::array<std::byte, kMaxComponents * sizeof(double)>;
  [[nodiscard]] Value value(Index item) const {
    Value copy = {};
    std::memcpy(copy.data(), &bytes_[stride_ * item], stride_);
    return copy;
  }

  [[nodiscard]] bool interpolates() const {
    return on_split_ == OnSplit::kInterpolate || on_split_ == OnSplit::kNormalize;
  }
  /// Whether values of halfedges are those of corners.
  [[nodiscard]] bool belongs_to_corners() const {
    return interpolates() || on_split_ == OnSplit::kCopyCorner;
  }

  /// Notes all values, as before a write of all of them.
  void note_all(Journal& journal) const;
  /// Moves values down to where `map` says, kNone for none; `width` slots for an entry of it.
  void compact(const Array<Index>& map, std::size_t width);
  /// Exchanges what an item has with what is noted.
  void exchange(const Journal::Note& note);

 private:
  [[nodiscard]] bool is_float() const { return type_ <= Scalar::kFloat64; }
  void note(Index item, Journal* journal) const;
  void put(Index item, Index component, double value);
  [[nodiscard]] double number_at(const std::byte* item, Index component) const;

  std::string name_;
  ItemKind kind_;
  Scalar type_;
  OnSplit on_split_;
  bool is_generation_;
  Index components_;
  Index serial_;
  std::size_t stride_;
  Index slots_ = 0;
  Array<std::byte> default_;
  Array<std::byte> bytes_;
};

}  // namespace halfedge
