#include <halfedge/connectivity/links_view.h>
#include <halfedge/operations/merges.h>
#include <halfedge/operations/refusals.h>
#include <halfedge/operations/surgery_refusals.h>
#include <halfedge/sort.h>

#include <algorithm>
#include <cstddef>

namespace halfedge::operations::internal {

namespace {

class MergeCheck {
 public:
  MergeCheck(const Links& links, std::span<Merge> merges, Face removed_0, Face removed_1)
      : links_(links), merges_(merges), removed_{removed_0, removed_1} {}

  [[nodiscard]] Result<void> run(std::span<Index> scratch) {
    introsort(merges_, [](const Merge& a, const Merge& b) { return a.gone < b.gone; });
    if (const Vertex repeated = find_merged_twice(scratch); repeated.valid()) {
      return repeated_on_seam(repeated);
    }
    by_kept_ = scratch.first(merges_.size());  // sorted by now
    for (const bool of_faces : {false, true}) {
      for (const Merge& merge : merges_) {
        const Halfedge first = links_.halfedge(merge.gone);
        Halfedge h = first;
        do {
          Result<void> can = of_faces ? check_face(merge, h) : check_edge(merge, h);
          if (!can) return can;
          h = links_.rotate_cw(h);
        } while (h != first);
      }
    }
    return {};
  }

 private:
  /// A vertex that is in more than one merge, or empty. pre: merges are sorted
  [[nodiscard]] Vertex find_merged_twice(std::span<Index> scratch) const {
    for (std::size_t i = 0; i < merges_.size(); ++i) {
      scratch[i] = Index(i);
      if (merge_of(merges_[i].kept) != nullptr) return merges_[i].kept;
      if (i > 0 && merges_[i].gone == merges_[i - 1].gone) return merges_[i].gone;
    }
    const auto by_kept = scratch.first(merges_.size());
    introsort(by_kept, [&](Index a, Index b) { return merges_[a].kept < merges_[b].kept; });
    for (std::size_t i = 1; i < by_kept.size(); ++i) {
      const Vertex kept = merges_[by_kept[i]].kept;
      if (kept == merges_[by_kept[i - 1]].kept) return kept;
    }
    return {};
  }

  /// The merge in which `v` goes, or null.
  [[nodiscard]] const Merge* merge_of(Vertex v) const {
    const auto found =
        std::lower_bound(merges_.begin(), merges_.end(), v,
                         [](const Merge& merge, Vertex gone) { return merge.gone < gone; });
    return found != merges_.end() && found->gone == v ? &*found : nullptr;
  }
  /// The merge in which `v` is kept, or null.
  [[nodiscard]] const Merge* merge_into(Vertex v) const {
    const auto found =
        std::lower_bound(by_kept_.begin(), by_kept_.end(), v,
                         [&](Index merge, Vertex kept) { return merges_[merge].kept < kept; });
    return found != by_kept_.end() && merges_[*found].kept == v ? &merges_[*found] : nullptr;
  }

  /// h leaves merge.gone: no edge of merge.kept but the one it is glued to may lead to where it
  /// leads.
  [[nodiscard]] Result<void> check_edge(const Merge& merge, Halfedge h) const {
    const Vertex end = links_.to_vertex(h);
    const Merge* at_end = merge_of(end);
    if (at_end == nullptr) at_end = merge_into(end);
    if (at_end == &merge) return edge_exists(merge.kept, merge.gone, links_.edge(h));
    Edge partner;
    for (const int i : {0, 1}) {
      if (merge.gone_edges[i] == links_.edge(h)) partner = merge.kept_edges[i];
    }
    if (at_end == nullptr) return check_ends(merge.kept, end, end, partner, links_.edge(h));
    // Either of the two vertices that become that end.
    Result<void> can = check_ends(merge.kept, at_end->kept, at_end->kept, partner, links_.edge(h));
    return can ? check_ends(merge.kept, at_end->gone, at_end->kept, partner, links_.edge(h)) : can;
  }

  /// No edge but `partner` may join a and b, which becomes `end`. Around both in step: the smaller
  /// valence ends the search.
  [[nodiscard]] Result<void> check_ends(Vertex a, Vertex b, Vertex end, Edge partner,
                                        Edge other) const {
    const Halfedge first_of_a = links_.halfedge(a);
    const Halfedge first_of_b = links_.halfedge(b);
    Halfedge at_a = first_of_a;
    Halfedge at_b = first_of_b;
    do {
      if (links_.to_vertex(at_a) == b && links_.edge(at_a) != partner) {
        return would_be_duplicate(links_.edge(at_a), other, a, end);
      }
      if (links_.to_vertex(at_b) == a && links_.edge(at_b) != partner) {
        return would_be_duplicate(links_.edge(at_b), other, a, end);
      }
      at_a = links_.rotate_cw(at_a);
      at_b = links_.rotate_cw(at_b);
    } while (at_a != first_of_a && at_b != first_of_b);
    return {};
  }

  /// h leaves merge.gone: its face may not have merge.kept at another corner than the next one,
  /// which check_edge() looks at. Around the face and around merge.kept in step: the smaller of
  /// degree and valence ends the search.
  [[nodiscard]] Result<void> check_face(const Merge& merge, Halfedge h) const {
    const Face f = links_.face(h);
    if (!f.valid() || f == removed_[0] || f == removed_[1]) return {};
    const Halfedge second = links_.next(h);
    const Halfedge first_at_kept = links_.halfedge(merge.kept);
    Halfedge at_kept = first_at_kept;
    Halfedge on_loop = second;
    do {
      const bool leaves_corner = at_kept != second && links_.face(at_kept) == f;
      if (links_.to_vertex(on_loop) == merge.kept || leaves_corner) {
        return would_repeat_vertex(f, merge.kept, merge.gone);
      }
      on_loop = links_.next(on_loop);
      at_kept = links_.rotate_cw(at_kept);
    } while (on_loop != h && at_kept != first_at_kept);
    return {};
  }

  const LinksView links_;
  std::span<Merge> merges_;
  std::span<const Index> by_kept_;  // merges
  Face removed_[2];
};

}  // namespace

Result<void> check_merges(const Links& links, std::span<Merge> merges, std::span<Index> scratch,
                          Face removed_0, Face removed_1) {
  return MergeCheck(links, merges, removed_0, removed_1).run(scratch);
}

}  // namespace halfedge::operations::internal
