#include <halfedge/algorithms/neighbourhood.h>
#include <halfedge/sentence.h>

#include <bit>
#include <cstddef>
#include <string>

namespace halfedge {

namespace {

// A bit for each slot of one kind of item.
class Marks {
 public:
  [[nodiscard]] bool create(Index slots) {
    return words_.resize((std::size_t{slots} + 63) / 64, 0);
  }
  /// pre: there is a slot `i`; returns whether it was not marked before
  bool add(Index i) {
    std::uint64_t& word = words_[i / 64];
    const std::uint64_t bit = std::uint64_t{1} << i % 64;
    const bool is_new = (word & bit) == 0;
    word |= bit;
    return is_new;
  }
  void remove_all(const Marks& others) {
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] &= ~others.words_[i];
  }
  [[nodiscard]] std::size_t count() const {
    std::size_t sum = 0;
    for (const std::uint64_t word : words_) sum += std::size_t(std::popcount(word));
    return sum;
  }
  /// In ascending order, until `visit` returns false; whether it never did.
  template <class Visit>
  bool each(const Visit& visit) const {
    for (std::size_t i = 0; i < words_.size(); ++i) {
      for (std::uint64_t word = words_[i]; word != 0; word &= word - 1) {
        if (!visit(Index(64 * i) + Index(std::countr_zero(word)))) return false;
      }
    }
    return true;
  }

 private:
  Array<std::uint64_t> words_;
};

struct MarkedItems {
  Marks vertices;
  Marks edges;
  Marks faces;

  [[nodiscard]] bool create(const RawLinks& links) {
    return vertices.create(links.slots(Vertex{})) && edges.create(links.slots(Edge{})) &&
           faces.create(links.slots(Face{}));
  }
};

Error no_room_for_items() { return no_memory_for("the items of a neighbourhood"); }

Error corrupt() {
  return {"corrupt-connectivity",
          "The links around these items break the invariants of a mesh: validate names them."};
}

template <class Item>
bool add_live(const RawLinks& links, Item item, Marks& marks) {
  if (!links.is_live(item)) return false;
  marks.add(item.index());
  return true;
}

using AroundVertex = RingOf<Vertex, walk::RotateCw, view::Self>;
using AroundFace = RingOf<Face, walk::LoopCcw, view::Self>;

// Calls `visit` with each halfedge of the ring, until it returns false. False then, and where the
// ring doesn't close in `steps` steps, which it counts down.
template <class Ring, class Visit>
bool walk_halfedges(const RawLinks& links, typename Ring::Centre centre, Index& steps,
                    const Visit& visit) {
  bool is_sound = true;
  const bool closes = walk_ring<Ring>(links, first_of<Ring>(links, centre), steps,
                                      [&](Index h) { is_sound = is_sound && visit(Halfedge(h)); });
  return closes && is_sound;
}

// Adds to `to` the star of what is marked in `from`. False if the links are corrupt.
bool add_star(const RawLinks& links, const MarkedItems& from, MarkedItems& to) {
  const auto add_face = [&](Halfedge h) {
    const Face f = links.face(h);
    return !f.valid() || add_live(links, f, to.faces);
  };
  Index steps = links.halfedge_slots();  // the orbits of all vertices have no more
  return from.vertices.each([&](Index v) {
    to.vertices.add(v);
    return !has_ring(links, Vertex(v)) ||
           walk_halfedges<AroundVertex>(links, Vertex(v), steps, [&](Halfedge h) {
             return add_live(links, links.edge(h), to.edges) && add_face(h);
           });
  }) && from.edges.each([&](Index e) {
    to.edges.add(e);
    return add_face(Halfedge(2 * e)) && add_face(Halfedge(2 * e + 1));
  }) && from.faces.each([&](Index f) {
    to.faces.add(f);
    return true;
  });
}

// Adds to `to` the closure of what is marked in `from`. False if the links are corrupt.
bool add_closure(const RawLinks& links, const MarkedItems& from, MarkedItems& to) {
  Index steps = links.halfedge_slots();
  return from.faces.each([&](Index f) {
    to.faces.add(f);
    return walk_halfedges<AroundFace>(links, Face(f), steps, [&](Halfedge h) {
      return add_live(links, links.edge(h), to.edges) &&
             add_live(links, links.to_vertex(h), to.vertices);
    });
  }) && from.edges.each([&](Index e) {
    to.edges.add(e);
    return add_live(links, links.to_vertex(Halfedge(2 * e)), to.vertices) &&
           add_live(links, links.to_vertex(Halfedge(2 * e + 1)), to.vertices);
  }) && from.vertices.each([&](Index v) {
    to.vertices.add(v);
    return true;
  });
}

template <class Item>
Result<void> check_items(const RawLinks& links, std::span<const Index> items) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (links.is_live(Item(items[i]))) continue;
    const std::string item = sentence::of("{} at position {}", Item(items[i]), i);
    const Index slots = links.slots(Item{});
    if (items[i] < slots)
      return Error{"deleted-item", sentence::complete(sentence::of("{} is deleted", item))};
    return Error{
        "index-out-of-range",
        sentence::complete(sentence::of("{} does not exist, expected less than {}", item, slots))};
  }
  return {};
}

template <class Item>
Result<void> mark_items(const RawLinks& links, ItemSpan<Item> items, Marks& marks) {
  Result<void> checked = check_items<Item>(links, items.indices());
  if (!checked) return checked;
  for (const Index item : items.indices()) marks.add(item);
  return {};
}

bool list_marked(const Marks& marks, Array<Index>& list) {
  if (!list.reserve(marks.count())) return false;
  return marks.each([&](Index item) { return list.push_back(item); });
}

}  // namespace

Result<Adjacency> k_ring(const RawLinks& links, std::span<const Index> vertices, Index k) {
  if (Result<void> checked = check_items<Vertex>(links, vertices); !checked) {
    return checked;
  }
  Adjacency rows;
  Marks seen;
  if (!seen.create(links.slots(Vertex{}))) return no_room_for_items();
  Array<Index>& items = rows.items;  // the queue of a search in breadth at the same time
  for (const Index v : vertices) {
    if (seen.add(v) && !items.push_back(v)) return no_room_for_items();
  }
  if (!rows.offsets.push_back(0)) return no_room_for_items();
  Index steps = links.halfedge_slots();
  for (std::size_t begin = 0; begin < items.size();) {
    const std::size_t end = items.size();
    if (!rows.offsets.push_back(Index(end))) return no_room_for_items();
    if (k-- == 0) break;
    for (; begin < end; ++begin) {
      const Vertex v(items[begin]);
      if (!has_ring(links, v)) continue;
      bool fits = true;
      const bool is_sound = walk_halfedges<AroundVertex>(links, v, steps, [&](Halfedge h) {
        const Vertex w = links.to_vertex(h);
        if (!links.is_live(w)) return false;
        if (seen.add(w.index())) fits = fits && items.push_back(w.index());
        return true;
      });
      if (!is_sound) return corrupt();
      if (!fits) return no_room_for_items();
    }
  }
  return rows;
}

Result<ItemSet> surroundings(const RawLinks& links, Surroundings which, const Items& items) {
  MarkedItems given;
  MarkedItems found;
  if (!given.create(links) || !found.create(links)) return no_room_for_items();
  for (const Result<void>& marked :
       {mark_items(links, items.vertices, given.vertices),
        mark_items(links, items.edges, given.edges), mark_items(links, items.faces, given.faces)}) {
    if (!marked) return marked.error();
  }
  bool is_sound = true;
  if (which == Surroundings::kStar) {
    is_sound = add_star(links, given, found);
  } else if (which == Surroundings::kClosure) {
    is_sound = add_closure(links, given, found);
  } else {
    MarkedItems star;
    MarkedItems closure;
    MarkedItems star_of_closure;
    if (!star.create(links) || !closure.create(links) || !star_of_closure.create(links)) {
      return no_room_for_items();
    }
    is_sound = add_star(links, given, star) && add_closure(links, star, found) &&
               add_closure(links, given, closure) && add_star(links, closure, star_of_closure);
    found.vertices.remove_all(star_of_closure.vertices);
    found.edges.remove_all(star_of_closure.edges);
    found.faces.remove_all(star_of_closure.faces);
  }
  if (!is_sound) return corrupt();
  ItemSet set;
  if (!list_marked(found.vertices, set.vertices) || !list_marked(found.edges, set.edges) ||
      !list_marked(found.faces, set.faces)) {
    return no_room_for_items();
  }
  return set;
}

}  // namespace halfedge
