#include <halfedge/mend/partners.h>
#include <halfedge/refusals.h>
#include <halfedge/repair/weld.h>
#include <halfedge/sentence.h>
#include <halfedge/sort.h>

#include <algorithm>

namespace halfedge::mend {

namespace {

using refusals::refusal;

Failure runs_the_same_way(Edge e, Edge other) {
  return refusal(
      "",
      sentence::of("{} and {} lie together but run the same way, expected faces of one orientation",
                   e, other),
      {.edges = {e.index(), other.index()}});
}

}  // namespace

bool Partners::find(double tolerance, Report& report) {
  return list_boundary(tolerance) && match(report);
}

void Partners::forget(Halfedge h, Halfedge g) {
  const Index partner = partner_[h.index()];
  if (partner != kNone && (partner & kGroup) != 0) groups_[partner & ~kGroup] -= 2;
  partner_[h.index()] = partner_[g.index()] = kNone;
}

// Numbers the places where boundary vertices lie. An edge without a face on either side is no
// boundary of anything.
bool Partners::list_boundary(double tolerance) {
  if (!place_of_.resize(surface_.vertex_slots(), kNone)) return false;
  for (Index i = 0; i < surface_.halfedge_slots(); ++i) {
    const Halfedge h(i);
    if (!surface_.is_live(h) || !surface_.is_boundary(h)) continue;
    if (surface_.is_boundary(Surface::opposite(h))) continue;
    if (!boundary_.push_back(h)) return false;
  }
  Array<Vertex> vertices;
  Array<float> positions;
  const auto add = [&](Vertex v) {
    if (place(v) != kNone) return true;  // where a loop goes on, or at a pinched vertex
    place_of_[v.index()] = Index(vertices.size());
    const Point p = surface_.position(v);
    return vertices.push_back(v) && positions.push_back(p.x) && positions.push_back(p.y) &&
           positions.push_back(p.z);
  };
  for (const Halfedge h : boundary_) {
    if (!add(surface_.from_vertex(h))) return false;
  }
  for (const Halfedge h : boundary_) {
    if (!add(surface_.to_vertex(h))) return false;
  }
  repair::Vertices welded;
  if (!repair::weld(positions.span(), tolerance, welded)) return false;
  for (const Vertex v : vertices) place_of_[v.index()] = welded.of_input[place(v)];
  places_ = welded.size();
  return true;
}

// Sorts the edges by their lower place, and then each bucket, which is small, by the other.
bool Partners::match(Report& report) {
  Array<std::size_t> begin;
  Array<Record> records;
  if (!begin.resize(places_ + 2, 0) || !records.resize(boundary_.size()) ||
      !partner_.resize(surface_.halfedge_slots(), kNone)) {
    return false;
  }
  const auto ends = [&](Halfedge h) {
    return std::minmax({place(surface_.from_vertex(h)), place(surface_.to_vertex(h))});
  };
  const auto is_usable = [&](Halfedge h) {
    const auto [lower, higher] = ends(h);
    return lower != higher && higher != kNone;
  };
  for (const Halfedge h : boundary_) {
    if (is_usable(h)) ++begin[std::size_t{ends(h).first} + 2];
  }
  for (std::size_t i = 2; i < begin.size(); ++i) begin[i] += begin[i - 1];
  for (const Halfedge h : boundary_) {
    if (!is_usable(h)) continue;
    const auto [lower, higher] = ends(h);
    records[begin[std::size_t{lower} + 1]++] = {higher, h};
  }
  for (std::size_t bucket = 0; bucket < places_; ++bucket) {
    Record* first = records.begin() + begin[bucket];
    Record* const end = records.begin() + begin[bucket + 1];
    introsort(first, end, [](const Record& a, const Record& b) {
      return a.higher != b.higher ? a.higher < b.higher : a.h < b.h;
    });
    while (first != end) {
      Record* last = first + 1;
      while (last != end && last->higher == first->higher) ++last;
      if (!match_group(first, std::size_t(last - first), report)) return false;
      first = last;
    }
  }
  return true;
}

bool Partners::match_group(const Record* group, std::size_t count, Report& report) {
  if (count == 2) join(group[0].h, group[1].h, report);
  if (count <= 2) return true;
  for (std::size_t i = 0; i < count; ++i) {
    partner_[group[i].h.index()] = kGroup | Index(groups_.size());
  }
  return groups_.push_back(count);
}

bool Partners::pair_up(Array<Pair>& pairs, Report& report) {
  Array<Halfedge> first;  // by group
  if (!first.resize(groups_.size(), Halfedge{})) return false;
  for (const Halfedge h : boundary_) {
    if (group_size(h) != 2) continue;
    const Index group = partner_[h.index()] & ~kGroup;
    if (!first[group].valid()) {
      first[group] = h;
    } else if (join(first[group], h, report) && !pairs.push_back({first[group], h})) {
      return false;
    }
  }
  return true;
}

// Whether they are partners now.
bool Partners::join(Halfedge h, Halfedge g, Report& report) {
  partner_[h.index()] = partner_[g.index()] = kNone;
  if (place(surface_.from_vertex(h)) == place(surface_.from_vertex(g))) {
    report.leave(Code::kOppositeOrientation,
                 [&] { return runs_the_same_way(Surface::edge(h), Surface::edge(g)); });
    return false;
  }
  partner_[h.index()] = g.index();
  partner_[g.index()] = h.index();
  return true;
}

}  // namespace halfedge::mend
