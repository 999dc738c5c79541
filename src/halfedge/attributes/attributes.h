#pragma once

#include <halfedge/attributes/attribute.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/handle.h>
#include <halfedge/history/journal.h>
#include <halfedge/result.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace halfedge {

/// The attributes of a mesh: for each kind of item the named columns that were added. They have as
/// many slots as the mesh. Without any, which is the rule, they cost one test for each new item.
class Attributes {
 public:
  /// The name of the columns of generations: one that no other column can have.
  static constexpr std::string_view kGenerationName{};

  /// Owns a column, and is as const as that.
  class Column {
   public:
    explicit Column(std::unique_ptr<Attribute> column) : column_(std::move(column)) {}
    [[nodiscard]] Attribute* get() { return column_.get(); }
    [[nodiscard]] const Attribute* get() const { return column_.get(); }
    Attribute& operator*() { return *column_; }
    const Attribute& operator*() const { return *column_; }
    Attribute* operator->() { return column_.get(); }
    const Attribute* operator->() const { return column_.get(); }

   private:
    std::unique_ptr<Attribute> column_;
  };

  Attributes() = default;
  Attributes(Attributes&& other) noexcept { *this = std::move(other); }
  /// Takes the columns of `other`. Their items keep their generations, unless some were given here
  /// before: then they have new ones. `other` goes on counting where it was.
  Attributes& operator=(Attributes&& other) noexcept;
  Attributes(const Attributes&) = delete;  // a copy can fail: use assign()
  Attributes& operator=(const Attributes&) = delete;
  ~Attributes() = default;

  /// A new column of `slots` items. The name must be new among those of its kind, not empty.
  /// errors: attribute-exists, bad-attribute, out-of-memory
  [[nodiscard]] Result<Attribute*> add(ItemKind kind, std::string_view name,
                                       const AttributeOptions& options, Index slots);
  /// Null if there is none of that name.
  [[nodiscard]] Attribute* find(ItemKind kind, std::string_view name);
  [[nodiscard]] const Attribute* find(ItemKind kind, std::string_view name) const;
  /// False if there is none. Notes of its writes in the journal are skipped from then on.
  bool remove(ItemKind kind, std::string_view name);

  /// In the order in which they were added.
  [[nodiscard]] std::span<Column> of(ItemKind kind) { return columns_[std::size_t(kind)]; }
  [[nodiscard]] std::span<const Column> of(ItemKind kind) const {
    return columns_[std::size_t(kind)];
  }
  [[nodiscard]] bool has_any() const { return count_ > 0; }

  // ---- what the mesh does -------------------------------------------------------------------

  [[nodiscard]] bool reserve(ItemKind kind, std::size_t slots) {
    return !has_any() || reserve_columns(kind, slots);
  }
  /// The generations of new items are noted: later ones begin with another, and what is done again
  /// shall have its own. pre: there is room for them
  void resize(ItemKind kind, Index slots, Journal* journal = nullptr) {
    if (has_any()) resize_columns(kind, slots, journal);
  }
  /// Becomes a copy of `other`. Its items have the generations that they have there, unless some
  /// were given here before: then they have new ones. False when memory is exhausted; then it has
  /// no columns.
  [[nodiscard]] bool assign(const Attributes& other);
  /// Of an item that takes the slot of a deleted one. Its generation is that of the slot since, or
  /// another, as undo may have taken away an item that had it.
  void set_default(ItemKind kind, Index item, Journal* journal) {
    if (has_any()) set_defaults(kind, item, journal);
  }
  /// Of an item that is deleted: gives it a generation that no item had before.
  void end_generation(ItemKind kind, Index item, Journal* journal) {
    if (has_any()) change_generation(kind, item, journal);
  }
  /// Of all items, and of those to come.
  void end_all_generations();
  void note_all(Journal& journal) const;
  void compact(ItemKind kind, const Array<Index>& map);
  /// Exchanges what was noted, if its column still exists.
  void exchange(const Journal::Note& note);

  // ---- what operations do -------------------------------------------------------------------

  /// `to` gets the values of `from`, but for columns whose policy is kDefault.
  void copy(ItemKind kind, Index to, Index from, Journal* journal) {
    if (has_any()) copy_values(kind, to, from, journal);
  }
  /// `to` gets what the policies make of (1 - t) a + t b.
  void blend(ItemKind kind, Index to, Index a, Index b, double t, Journal* journal) {
    if (has_any()) blend_values(kind, to, a, b, t, journal);
  }
  /// The same of the columns by halfedge whose values belong to corners: those that interpolate.
  void copy_corner(Index to, Index from, Journal* journal) {
    if (has_any()) copy_corner_values(to, from, journal);
  }
  void blend_corners(Index to, Index a, Index b, double t, Journal* journal) {
    if (has_any()) blend_corner_values(to, a, b, t, journal);
  }
  void swap_corners(Index a, Index b, Journal* journal);
  /// The ends of an edge whose corners move to a point on it.
  enum class EdgeEnd : std::uint8_t { kFrom, kTo };
  /// The corners of one side of an edge, by the halfedges that end there. `result` is one of them.
  struct EdgeCorners {
    Index from = kNone;
    Index to = kNone;
    Index result = kNone;
    bool has_face = false;
  };
  /// Ends of an edge move to the point (1 - t) from + t to, and corners along with the side whose
  /// value they share. `result` of each side gets the blend of its two corners. `corners` is called
  /// with a function to be called with others and their ends: those that have the value which a
  /// side had there get what became of it; others, beyond a seam, keep theirs.
  template <class Corners>
  void move_corners(const EdgeCorners (&sides)[2], double t, const Corners& corners,
                    Journal* journal) {
    for (Column& column : of(ItemKind::kHalfedge)) {
      if (!column->belongs_to_corners()) continue;
      const CornerMove move(*column, sides, t, journal);
      corners([&](Index corner, EdgeEnd end) { move(corner, end); });
    }
  }
  /// `to` gets the mean of all that `items` lists, each with the same weight: `items` is called
  /// with a function to be called with each index. Of halfedges, only the values of corners.
  template <class Items>
  void average(ItemKind kind, Index to, const Items& items, Journal* journal) {
    for (Column& column : of(kind)) {
      if (kind == ItemKind::kHalfedge && !column->belongs_to_corners()) continue;
      Attribute::Sum sum;
      items([&](Index item) { column->add(sum, item, 1); });
      column->store(sum, to, journal);
    }
  }

 private:
  /// Of one column: the values of the four corners beside an edge before they moved.
  class CornerMove {
   public:
    CornerMove(Attribute& column, const EdgeCorners (&sides)[2], double t, Journal* journal);
    void operator()(Index corner, EdgeEnd end) const;

   private:
    struct Side {
      Attribute::Value from = {};
      Attribute::Value to = {};
    };
    Attribute& column_;
    const EdgeCorners (&sides_)[2];
    Journal* journal_;
    std::array<Side, 2> before_;
  };

  // What is done where there are columns.
  [[nodiscard]] bool reserve_columns(ItemKind kind, std::size_t slots);
  void resize_columns(ItemKind kind, Index slots, Journal* journal);
  void set_defaults(ItemKind kind, Index item, Journal* journal);
  void change_generation(ItemKind kind, Index item, Journal* journal);
  void copy_values(ItemKind kind, Index to, Index from, Journal* journal);
  void blend_values(ItemKind kind, Index to, Index a, Index b, double t, Journal* journal);
  void copy_corner_values(Index to, Index from, Journal* journal);
  void blend_corner_values(Index to, Index a, Index b, double t, Journal* journal);
  void drop_all();

  std::array<std::vector<Column>, 5> columns_;  // by kind; a mesh itself has none
  std::size_t count_ = 0;                       // of columns, all kinds together
  Index serials_ = 0;
  Index generations_ = 0;  // so many were given
};

}  // namespace halfedge
