#pragma once

#include <halfedge/attributes/attributes.h>
#include <halfedge/connectivity/circulators.h>
#include <halfedge/connectivity/handle.h>
#include <halfedge/connectivity/links.h>
#include <halfedge/connectivity/lone_fans.h>
#include <halfedge/connectivity/storage.h>
#include <halfedge/history/journal.h>
#include <halfedge/inlining.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <string_view>
#include <utility>

namespace halfedge {

/// What the compiler says of a call that needs a link that isn't stored.
#define HALFEDGE_NEEDS_FACES \
  "this call needs the face of a halfedge, which this mesh type does not store (Storage::face)"
#define HALFEDGE_NEEDS_FACE_HALFEDGES                                            \
  "this call needs the halfedge of a face, which this mesh type does not store " \
  "(Storage::face_halfedge); the form of a circulator with a start halfedge does without"
#define HALFEDGE_NEEDS_ANCHORS                                                     \
  "this call needs the halfedge of a vertex, which this mesh type does not store " \
  "(Storage::vertex_halfedge); the form of a circulator with a start halfedge does without"

/// Vertices, halfedges, edges and faces, and how they are joined; no geometry: usable alone, as for
/// a planar map. `Connectivity` stores all links; others leave some out. Invariants (the
/// codes of `validate` name them):
///   1. opposite is an involution without fixed points; next and prev are inverse permutations.
///   2. from(next(h)) == to(h).
///   3. face(next(h)) == face(h); face_halfedge(f) lies in the loop of f; each loop closes.
///   4. from(anchor(v)) == v.
///   5. The anchor of a boundary vertex is a boundary halfedge: "is v on the boundary?" is O(1).
///   6. Every halfedge that leaves v is reached from anchor(v) by rotating.
///   7. No live item refers to a deleted one.
///
/// Navigation is O(1) and unchecked in release builds: passing an empty, deleted or foreign handle
/// is a caller's bug. In debug builds `assert` catches one that is in no slot at once, and that of
/// a deleted item where a link that it gives is followed: such links lead out of all arrays.
///
/// The class in the order in which to read it: what is stored and how much of it, navigation and
/// queries, memory, low-level changes; then what goes along with each change and can be left aside
/// at first, attributes and history. The circulators come from the base class. What isn't written
/// here is in connectivity_impl.h, link_writers.h, connectivity_attributes.h and
/// connectivity_history.h.
template <Storage kStored>
class BasicConnectivity : public Circulators<BasicConnectivity<kStored>> {
 public:
  static constexpr Storage kStorage = kStored;
  static_assert(!(kStorage.prev && kStorage.prev_at_run_time),
                "this storage has prev both by its type and at run time: take kPrevAtRunTime, or "
                "prev = false with prev_at_run_time");

  BasicConnectivity() = default;
  /// Moving leaves `other` empty. It counts as a change of both. Generations come along; items have
  /// new ones where generations were enabled here before, as with `assign`.
  BasicConnectivity(BasicConnectivity&& other) noexcept { *this = std::move(other); }
  BasicConnectivity& operator=(BasicConnectivity&& other) noexcept;
  BasicConnectivity(const BasicConnectivity&) = delete;  // a copy can fail: use assign()
  BasicConnectivity& operator=(const BasicConnectivity&) = delete;
  ~BasicConnectivity() = default;

  // ---- storage ------------------------------------------------------------------------------

  /// Whether prev is stored; else it is found by walking. Known when the mesh is compiled, but for
  /// kPrevAtRunTime, where it is unless chosen otherwise.
  [[nodiscard]] constexpr bool stores_prev() const {
    if constexpr (kStorage.prev_at_run_time) return prev_is_stored_;
    return kStorage.prev;
  }
  /// What is stored, as chosen.
  [[nodiscard]] constexpr Storage storage() const {
    Storage stored = kStorage;
    stored.prev = stores_prev();
    return stored;
  }
  /// Whether `prev` is stored from now on. History forgets all steps if that is a change.
  /// pre: the mesh has no halfedge slots
  void choose_prev(bool is_stored) {
    static_assert(kStorage.prev_at_run_time, "this mesh type has chosen already (see Storage)");
    assert(halfedge_slots() == 0);
    if (prev_is_stored_ != is_stored) forget_history();
    prev_is_stored_ = is_stored;
  }

  // ---- counts -------------------------------------------------------------------------------

  /// Live items.
  [[nodiscard]] Index vertex_count() const { return vertex_slots() - free_vertices_.count; }
  [[nodiscard]] Index halfedge_count() const { return 2 * edge_count(); }
  [[nodiscard]] Index edge_count() const { return edge_slots() - free_edges_.count; }
  [[nodiscard]] Index face_count() const { return face_slots() - free_faces_.count; }

  /// Live and deleted items: the range of indices.
  [[nodiscard]] Index vertex_slots() const {
    if constexpr (!kStorage.vertex_halfedge) return bare_vertices_;
    return Index(links_.vertex_halfedge.size());
  }
  [[nodiscard]] Index halfedge_slots() const { return Index(links_.next.size()); }
  [[nodiscard]] Index edge_slots() const { return halfedge_slots() / 2; }
  [[nodiscard]] Index face_slots() const {
    if constexpr (!kStorage.face_halfedge) return bare_faces_;
    return Index(links_.face_halfedge.size());
  }

  /// The same, chosen by the type of the handle; for code that is generic over the kind of item.
  [[nodiscard]] Index slots(Vertex) const { return vertex_slots(); }
  [[nodiscard]] Index slots(Halfedge) const { return halfedge_slots(); }
  [[nodiscard]] Index slots(Edge) const { return edge_slots(); }
  [[nodiscard]] Index slots(Face) const { return face_slots(); }
  [[nodiscard]] Index slots(ItemKind kind) const {
    if (kind == ItemKind::kVertex) return vertex_slots();
    if (kind == ItemKind::kHalfedge) return halfedge_slots();
    return kind == ItemKind::kEdge ? edge_slots() : face_slots();
  }

  /// How many slots of a kind there is room for in all arrays.
  [[nodiscard]] std::size_t capacity(ItemKind kind) const {
    if (kind == ItemKind::kVertex) {
      return std::max<std::size_t>(vertex_slots(), links_.vertex_halfedge.capacity());
    }
    if (kind == ItemKind::kFace) {
      return std::max<std::size_t>(face_slots(), links_.face_halfedge.capacity());
    }
    std::size_t room = std::min(links_.next.capacity(), links_.to_vertex.capacity());
    if (stores_prev()) room = std::min(room, links_.prev.capacity());
    if constexpr (kStorage.face) room = std::min(room, links_.face.capacity());
    return kind == ItemKind::kEdge ? room / 2 : room;
  }

  /// Vertices and faces can be deleted where they store a halfedge.
  [[nodiscard]] bool is_deleted([[maybe_unused]] Vertex v) const {
    if constexpr (!kStorage.vertex_halfedge) return false;
    return is_deleted_link(links_.vertex_halfedge[v.index()]);
  }
  [[nodiscard]] bool is_deleted(Halfedge h) const {
    return is_deleted_link(links_.next[h.index()]);
  }
  [[nodiscard]] bool is_deleted(Edge e) const { return is_deleted(edge_halfedge(e)); }
  [[nodiscard]] bool is_deleted([[maybe_unused]] Face f) const {
    if constexpr (!kStorage.face_halfedge) return false;
    return is_deleted_link(links_.face_halfedge[f.index()]);
  }

  /// Whether any item of this kind is deleted: without a look at the slots.
  [[nodiscard]] bool has_deleted(Vertex) const { return free_vertices_.count > 0; }
  [[nodiscard]] bool has_deleted(Halfedge) const { return free_edges_.count > 0; }
  [[nodiscard]] bool has_deleted(Edge) const { return free_edges_.count > 0; }
  [[nodiscard]] bool has_deleted(Face) const { return free_faces_.count > 0; }

  /// Whether the handle is not empty, in range and not deleted.
  template <class Item>
  [[nodiscard]] bool is_live(Item item) const {
    return item.index() < slots(Item{}) && !is_deleted(item);
  }

  /// Changes with every change of connectivity.
  [[nodiscard]] std::uint64_t version() const { return version_; }

  // ---- navigation: the links, O(1) ------------------------------------------------------------
  // Numbered as in docs/structure-rows.md.

  /// (1) One halfedge that leaves `v`, its anchor; empty for an isolated vertex.
  [[nodiscard]] Halfedge vertex_halfedge(Vertex v) const {
    static_assert(kStorage.vertex_halfedge, HALFEDGE_NEEDS_ANCHORS);
    return Halfedge(links_.vertex_halfedge[v.index()]);
  }
  /// (2) One halfedge of `f`.
  [[nodiscard]] Halfedge face_halfedge(Face f) const {
    static_assert(kStorage.face_halfedge, HALFEDGE_NEEDS_FACE_HALFEDGES);
    return Halfedge(links_.face_halfedge[f.index()]);
  }
  /// (3) The vertex that `h` leads to.
  [[nodiscard]] Vertex to_vertex(Halfedge h) const { return Vertex(links_.to_vertex[h.index()]); }
  /// (4) The face on the left of `h`; empty for a boundary halfedge.
  [[nodiscard]] Face face(Halfedge h) const {
    static_assert(kStorage.face, HALFEDGE_NEEDS_FACES);
    return Face(links_.face[h.index()]);
  }
  /// (5) The halfedge after `h` in its face loop or boundary loop.
  [[nodiscard]] Halfedge next(Halfedge h) const { return Halfedge(links_.next[h.index()]); }
  /// (6) The other halfedge of the same edge.
  [[nodiscard]] static constexpr Halfedge opposite(Halfedge h) { return Halfedge(h.index() ^ 1U); }
  /// (7) The halfedge before `h` in its face loop or boundary loop. Where it isn't stored it is
  /// found by walking `next`, O(min(degree of the loop, valence of from_vertex(h))).
  [[nodiscard]] Halfedge prev(Halfedge h) const {
    if (!stores_prev()) return find_prev(h);
    return Halfedge(links_.prev[h.index()]);
  }

  [[nodiscard]] Vertex from_vertex(Halfedge h) const { return to_vertex(opposite(h)); }
  [[nodiscard]] static constexpr Edge edge(Halfedge h) { return Edge(h.index() >> 1U); }
  /// The halfedge on `side` 0 or 1 of `e`.
  [[nodiscard]] static constexpr Halfedge edge_halfedge(Edge e, Index side = 0) {
    return Halfedge(2 * e.index() + side);
  }

  /// The next outgoing halfedge of from_vertex(h), clockwise and counter-clockwise.
  [[nodiscard]] Halfedge rotate_cw(Halfedge h) const { return next(opposite(h)); }
  [[nodiscard]] Halfedge rotate_ccw(Halfedge h) const { return opposite(prev(h)); }
  /// The next incoming halfedge of to_vertex(h), clockwise and counter-clockwise.
  [[nodiscard]] Halfedge next_on_vertex(Halfedge h) const { return opposite(next(h)); }
  [[nodiscard]] Halfedge prev_on_vertex(Halfedge h) const { return prev(opposite(h)); }

  // ---- queries ------------------------------------------------------------------------------

  [[nodiscard]] bool is_isolated(Vertex v) const { return !vertex_halfedge(v).valid(); }

  /// O(1), by invariant 5. An isolated vertex counts as boundary.
  [[nodiscard]] bool is_boundary(Vertex v) const {
    const Halfedge anchor = vertex_halfedge(v);
    return !anchor.valid() || is_boundary(anchor);
  }
  [[nodiscard]] bool is_boundary(Halfedge h) const { return !face(h).valid(); }
  [[nodiscard]] bool is_boundary(Edge e) const {
    return is_boundary(edge_halfedge(e, 0)) || is_boundary(edge_halfedge(e, 1));
  }
  /// Whether one of its edges is a boundary edge. O(degree).
  [[nodiscard]] bool is_boundary(Face f) const {
    for (const Halfedge h : this->face_halfedges_ccw(f)) {
      if (is_boundary(opposite(h))) return true;
    }
    return false;
  }

  /// The number of corners of `f`. O(degree).
  [[nodiscard]] Index degree(Face f) const {
    Index count = 0;
    for ([[maybe_unused]] const Halfedge h : this->face_halfedges_ccw(f)) ++count;
    return count;
  }

  // ---- memory -------------------------------------------------------------------------------

  /// Room for that many slots of each kind. False when memory is exhausted.
  [[nodiscard]] bool reserve(Index vertices, Index edges, Index faces);

  /// No items; keeps the memory.
  void clear();

  /// Becomes a copy of `other`, slot by slot, with its generations; with new ones where generations
  /// were enabled here, which no stamp of what was here has. False when memory is exhausted; then
  /// it is empty.
  [[nodiscard]] bool assign(const BasicConnectivity& other);

  // ---- low-level changes ----------------------------------------------------------------------
  // These keep no invariant by themselves; `validate` tells whether the result holds them. New
  // items take the most recently deleted slot, else a new one at the end; they are empty when
  // memory is exhausted. Each of them invalidates circulators.

  /// An isolated vertex.
  [[nodiscard]] Vertex new_vertex();

  /// Two halfedges without faces that are each other's next and prev; returns from -> to, side 0.
  /// Anchors are left alone.
  [[nodiscard]] Halfedge new_edge(Vertex from, Vertex to);

  /// The same with links that aren't set yet: the caller sets them all, but for to_vertex. For
  /// operations that would write each of them twice.
  [[nodiscard]] Halfedge new_unlinked_edge(Vertex from, Vertex to);

  /// One vertex, or so many edges or faces in a row, in new slots at the end; returns the first.
  /// Deleted slots aren't reused. The caller sets all links. For operations that add several items
  /// at once.
  /// pre: there is room for them
  [[nodiscard]] Vertex append_vertex();
  [[nodiscard]] Edge append_edges(Index count);
  [[nodiscard]] Face append_faces(Index count);

  /// A face with the loop of `h` as its boundary; the halfedges of the loop still need `set_face`.
  /// Where faces store no halfedge `h` isn't looked at.
  [[nodiscard]] Face new_face(Halfedge h);

  /// link and set_*, for those that write many links at once: they count as one change.
  class Writer;  // in link_writers.h, as the next
  [[nodiscard]] Writer writer() { return Writer(*this); }
  /// The same without a look at history, for slots that were appended in this step, which need no
  /// note of what they hold, and for halfedges after note_loop_links.
  class UnnotedWriter;
  [[nodiscard]] UnnotedWriter unnoted_writer() { return UnnotedWriter(*this); }
  /// Notes all links of `h` but its vertex for history: faster and in less memory than one by one.
  void note_loop_links(Halfedge h) {
    if (needs_note(h)) [[unlikely]]
      note_loop_links_at(h.index());
  }
  /// Notes one of them.
  void note_next(Halfedge h) {
    if (needs_note(h)) [[unlikely]]
      journal_->record_in_old_slots(Field::kNext, h.index(), {links_.next[h.index()]});
  }
  void note_prev(Halfedge h) {
    if (stores_prev() && needs_note(h)) [[unlikely]]
      journal_->record_in_old_slots(Field::kPrev, h.index(), {links_.prev[h.index()]});
  }

  /// next(h) = n and prev(n) = h.
  void link(Halfedge h, Halfedge n) {
    write(Field::kNext, links_.next, h.index(), n.index());
    if (stores_prev()) write(Field::kPrev, links_.prev, n.index(), h.index());
    ++version_;
  }
  void set_to_vertex(Halfedge h, Vertex v) {
    write(Field::kToVertex, links_.to_vertex, h.index(), v.index());
    ++version_;
  }
  /// An empty `f` makes `h` a boundary halfedge.
  void set_face(Halfedge h, Face f) {
    static_assert(kStorage.face, HALFEDGE_NEEDS_FACES);
    write(Field::kFace, links_.face, h.index(), f.index());
    ++version_;
  }
  /// Sets the anchor; an empty `h` makes `v` isolated.
  void set_vertex_halfedge(Vertex v, Halfedge h) {
    static_assert(kStorage.vertex_halfedge, HALFEDGE_NEEDS_ANCHORS);
    write(Field::kVertexHalfedge, links_.vertex_halfedge, v.index(), h.index());
    ++version_;
  }
  void set_face_halfedge(Face f, Halfedge h) {
    static_assert(kStorage.face_halfedge, HALFEDGE_NEEDS_FACE_HALFEDGES);
    write(Field::kFaceHalfedge, links_.face_halfedge, f.index(), h.index());
    ++version_;
  }

  /// Restores invariant 5 at `v` after low-level edits: moves the anchor to a boundary halfedge if
  /// one is reached by rotating clockwise from it. O(valence).
  void adjust_anchor(Vertex v);

  /// What add_face remembers from one call to the next.
  [[nodiscard]] LoneFans& lone_fans() { return lone_fans_; }

  /// Give a slot back. Nothing else is changed: links of other items that lead to it must be
  /// mended by the caller. A vertex and a face need their link, which marks the slot as free.
  void release(Vertex v);
  void release(Edge e);
  void release(Face f);

  /// The arrays themselves, for bulk code: readers never need the mutable form.
  [[nodiscard]] const Links& links() const { return links_; }
  /// For code that writes whole arrays (builder, bindings). Counts as a change of connectivity, and
  /// history is forgotten.
  [[nodiscard]] Links& mutable_links() {
    forget_history();
    ++version_;
    return links_;
  }

  [[nodiscard]] const FreeList& free_vertices() const { return free_vertices_; }
  [[nodiscard]] const FreeList& free_edges() const { return free_edges_; }
  [[nodiscard]] const FreeList& free_faces() const { return free_faces_; }

  // ---- attributes ---------------------------------------------------------------------------
  // Named columns that grow and shrink with the mesh. Operations give new items the values that the
  // policy of each column asks for; the low-level changes above give them its default.

  /// A column of one value, the default, for each slot. The pointer is good until it is removed.
  /// errors: attribute-exists, bad-attribute, out-of-memory
  [[nodiscard]] Result<Attribute*> add_attribute(ItemKind kind, std::string_view name,
                                                 const AttributeOptions& options = {});
  bool remove_attribute(ItemKind kind, std::string_view name) {
    return attributes_.remove(kind, name);
  }
  /// Null if there is none of that name.
  [[nodiscard]] Attribute* find_attribute(ItemKind kind, std::string_view name) {
    return attributes_.find(kind, name);
  }
  [[nodiscard]] const Attribute* find_attribute(ItemKind kind, std::string_view name) const {
    return attributes_.find(kind, name);
  }
  [[nodiscard]] const Attributes& attributes() const { return attributes_; }
  /// Those of a kind, to be written to; not part of history.
  [[nodiscard]] std::span<Attributes::Column> columns(ItemKind kind) {
    return attributes_.of(kind);
  }

  /// Sets one number, noted by history.
  template <class Item>
  void set_attribute(Attribute& attribute, Item item, Index component, double value) {
    assert(attribute.kind() == kind_of(item) && is_live(item));
    assert(component < attribute.components());
    attribute.set(item.index(), component, value, journal_.get());
  }
  /// The values of an item become those of another, of a mean of two, (1 - t) a + t b, or of the
  /// mean of several (see Attributes).
  template <class Item>
  void copy_attributes(Item to, Item from) {
    attributes_.copy(kind_of(to), to.index(), from.index(), journal_.get());
  }
  template <class Item>
  void blend_attributes(Item to, Item a, Item b, double t) {
    attributes_.blend(kind_of(to), to.index(), a.index(), b.index(), t, journal_.get());
  }
  /// The same of the values that belong to the corner where a halfedge ends: those that
  /// interpolate.
  void copy_corner(Halfedge to, Halfedge from) {
    attributes_.copy_corner(to.index(), from.index(), journal_.get());
  }
  void blend_corners(Halfedge to, Halfedge a, Halfedge b, double t) {
    attributes_.blend_corners(to.index(), a.index(), b.index(), t, journal_.get());
  }
  void swap_corners(Halfedge a, Halfedge b) {
    attributes_.swap_corners(a.index(), b.index(), journal_.get());
  }
  /// The corners at both ends of the edge of `h`, which is contracted to (1 - t) from(h) + t to(h):
  /// see Attributes::move_corners. `before_h`, `before_o` are prev of h and its opposite, `corners`
  /// lists all that end there but h and its opposite, which hold the new values of both sides.
  template <class Corners>
  void contract_corners(Halfedge h, Halfedge before_h, Halfedge before_o, double t,
                        const Corners& corners) {
    const Index o = opposite(h).index();
    const Attributes::EdgeCorners sides[2] = {
        {before_h.index(), h.index(), h.index(), !is_boundary(h)},
        {o, before_o.index(), o, !is_boundary(opposite(h))}};
    attributes_.move_corners(sides, t, corners, journal_.get());
  }
  /// The corners at from(h), which moves to (1 - t) from(h) + t to(h), likewise:
  /// `before_h` and the opposite of h hold the new values of both sides, `corners` lists the
  /// others.
  template <class Corners>
  void move_corners(Halfedge h, Halfedge before_h, Halfedge before_o, double t,
                    const Corners& corners) {
    const Index o = opposite(h).index();
    const Attributes::EdgeCorners sides[2] = {
        {before_h.index(), h.index(), before_h.index(), !is_boundary(h)},
        {o, before_o.index(), o, !is_boundary(opposite(h))}};
    attributes_.move_corners(sides, t, corners, journal_.get());
  }
  /// `items` is called with a function to be called with the index of each item.
  template <class Item, class Items>
  void average_attributes(Item to, const Items& items) {
    attributes_.average(kind_of(to), to.index(), items, journal_.get());
  }
  /// Stamps each vertex, edge and face from now on, with a uint32. An item in the slot of a deleted
  /// one gets another stamp than that had. So who keeps a handle and its stamp can tell whether it
  /// still means the same item. All generations end, which gives live items new stamps, with
  /// `clear`, `assign` and `normalize_boundary`, and with `compact` and `reorder` where they move
  /// something. History forgets what was done before. 4 bytes an item. errors: out-of-memory
  [[nodiscard]] Result<void> enable_generations();
  /// Takes the stamps away, and gives their memory back.
  void disable_generations() {
    for (const ItemKind kind : kItemKinds) remove_attribute(kind, Attributes::kGenerationName);
  }
  [[nodiscard]] bool has_generations() const {
    return attributes_.find(ItemKind::kVertex, Attributes::kGenerationName) != nullptr;
  }
  /// The stamp of an item; that of a halfedge is its edge's. 0 while there are none.
  [[nodiscard]] Index generation(Vertex v) const { return generation_of(v); }
  [[nodiscard]] Index generation(Halfedge h) const { return generation_of(edge(h)); }
  [[nodiscard]] Index generation(Edge e) const { return generation_of(e); }
  [[nodiscard]] Index generation(Face f) const { return generation_of(f); }
  /// Gives all items other stamps than they had, if they have any: for code that renumbers them.
  void end_generations() { attributes_.end_all_generations(); }
  /// Gives the columns as many slots as the mesh has, after code that wrote whole arrays. False
  /// when memory is exhausted.
  [[nodiscard]] bool fit_attributes();

  // ---- history ------------------------------------------------------------------------------
  // Off by default, and then it costs a test for each write. On, every change above is noted and
  // can be taken back, exactly: after undoing all of them, all arrays are as they were. What
  // replaces the whole mesh (assign, clear, mutable_links, a build) forgets history.

  /// False when memory is exhausted. Limits say how far back it reaches.
  [[nodiscard]] bool enable_history(HistoryLimits limits = {}) {
    journal_.reset(new (std::nothrow) Journal(limits));
    return journal_ != nullptr;
  }
  void disable_history() { journal_.reset(); }
  /// Changes how far back it reaches, and forgets what lies beyond, and what was undone.
  void limit_history(HistoryLimits limits) {
    if (journal_ != nullptr) journal_->limit(limits);
  }
  /// Forgets all steps, or those that were undone.
  void forget_history() {
    if (journal_ != nullptr) journal_->forget();
  }
  void forget_redo() {
    if (journal_ != nullptr) journal_->forget_redo();
  }
  /// How many steps there are, and what they take; null while history is off.
  [[nodiscard]] const Journal* history() const { return journal_.get(); }

  /// All changes since the last call are one step: undone and redone together.
  void end_step() {
    if (journal_ != nullptr) journal_->end_step();
  }
  /// Takes back the last step, or does again the one taken back last. False if there is none.
  bool undo() {
    return undo([this](const Journal::Note& note) { exchange(note); });
  }
  bool redo() {
    return redo([this](const Journal::Note& note) { exchange(note); });
  }

 protected:
  /// pre: history is on
  [[nodiscard]] Journal& journal() { return *journal_; }
  /// Notes that a word is about to be replaced.
  void note(Field field, Index index, Index word) {
    if (journal_ != nullptr) [[unlikely]]
      journal_->record(field, index, word);
  }
  /// Exchanges what the mesh holds with what is noted. Classes built on this one add their fields.
  void exchange(const Journal::Note& note);
  /// undo and redo, with the `exchange` of a class built on this one.
  template <class Exchange>
  bool undo(const Exchange& exchange) {
    if (journal_ == nullptr || !journal_->undo(exchange)) return false;
    ++version_;
    return true;
  }
  template <class Exchange>
  bool redo(const Exchange& exchange) {
    if (journal_ == nullptr || !journal_->redo(exchange)) return false;
    ++version_;
    return true;
  }

 private:
  template <Storage kOther>
  friend class BasicConnectivity;
  friend class LinkConversion;
  friend class Compaction;

  void write(Field field, Array<Index>& array, Index i, Index word) {
    if (journal_ != nullptr && array[i] != word) [[unlikely]]
      journal_->record(field, i, array[i]);
    array[i] = word;
  }
  [[nodiscard]] bool needs_note(Halfedge h) const {
    return journal_ != nullptr && !journal_->is_new_halfedge(h.index());
  }
  void note_new(Field field, Index slots) {
    if (journal_ != nullptr) [[unlikely]]
      journal_->record_new(field, slots);
  }
  void note(Field field, const FreeList& list) {
    if (journal_ != nullptr) journal_->record_in_old_slots(field, 0, {list.head, list.count});
  }

  template <class Item>
  [[nodiscard]] Index generation_of(Item item) const;
  [[nodiscard]] Result<Attribute*> add_column(ItemKind kind, std::string_view name,
                                              const AttributeOptions& options);
  [[nodiscard]] Halfedge add_edge_slot();
  void release_slot(Field field, Array<Index>& links, FreeList& list, Index slot);
  void note_loop_links_at(Index h);
  void exchange_loop_links(const Journal::Note& note);
  template <class Visit>
  void for_edge_links(const Visit& visit);
  void note_recycled(Edge e, bool is_taken);
  void exchange_recycled_edge(const Journal::Note& note);
  [[nodiscard]] std::size_t list_arrays(ItemKind kind, std::array<Array<Index>*, 4>& arrays);
  void exchange_slots(ItemKind kind, bool is_new, const Journal::Note& note);
  [[nodiscard]] Index take_free(Field field, Array<Index>& links, FreeList& list, Index link);

  // Round the loop of `h` and round its vertex in step: the shorter of the two ends the search.
  [[nodiscard]] HALFEDGE_NOINLINE Halfedge find_prev(Halfedge h) const {
    Halfedge in_loop = h;
    Halfedge around_vertex = h;
    for (;;) {
      const Halfedge after = next(in_loop);
      if (after == h) return in_loop;
      in_loop = after;
      const Halfedge rotated = rotate_cw(around_vertex);
      if (rotated == h) return opposite(around_vertex);
      around_vertex = rotated;
    }
  }

  Links links_;
  Attributes attributes_;
  FreeList free_vertices_;
  FreeList free_edges_;
  FreeList free_faces_;
  Index bare_vertices_ = 0;  // how many there are, where no array tells
  Index bare_faces_ = 0;
  bool prev_is_stored_ = true;  // where the type leaves it open
  std::uint64_t version_ = 0;
  LoneFans lone_fans_;
  std::unique_ptr<Journal> journal_;  // null while history is off
};

using Connectivity = BasicConnectivity<kEverything>;

}  // namespace halfedge

#include <halfedge/connectivity/connectivity_attributes.h>
#include <halfedge/connectivity/connectivity_history.h>
#include <halfedge/connectivity/connectivity_impl.h>
#include <halfedge/connectivity/link_writers.h>
