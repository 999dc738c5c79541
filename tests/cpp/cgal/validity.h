#pragma once

// clang-format off: CGAL's headers are first, as complex.h says.
#include "cgal/complex.h"
// clang-format on

#include <halfedge/validate/validate.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace halfedge::test {

/// The links that can be wrong in both structures; opposite can't in ours.
enum class LinkKind { kNext, kPrev, kToVertex, kFace, kAnchor, kFaceHalfedge };
inline constexpr int kLinkKinds = int(LinkKind::kFaceHalfedge) + 1;

/// How many links of a kind there are, and how many items they may lead to. pre: nothing is deleted
inline Index link_count(const Mesh& mesh, LinkKind kind) {
  if (kind == LinkKind::kAnchor) return mesh.vertex_count();
  return kind == LinkKind::kFaceHalfedge ? mesh.face_count() : mesh.halfedge_count();
}
inline Index target_count(const Mesh& mesh, LinkKind kind) {
  if (kind == LinkKind::kToVertex) return mesh.vertex_count();
  return kind == LinkKind::kFace ? mesh.face_count() : mesh.halfedge_count();
}

/// Makes the link of `item` lead to `target`, or to nothing (kNone), in our mesh and in theirs.
inline void set_link(Mesh& mesh, Mirror& mirror, LinkKind kind, Index item, Index target) {
  const auto halfedge = [&](Index h) {
    return h == kNone ? TheirHalfedge() : mirror.halfedges.at(h);
  };
  const auto vertex = [&] { return target == kNone ? TheirVertex() : mirror.vertices.at(target); };
  const auto face = [&] { return target == kNone ? TheirFace() : mirror.faces.at(target); };
  Links& links = mesh.mutable_links();
  switch (kind) {
    case LinkKind::kNext:
      links.next[item] = target;
      return halfedge(item)->set_next(halfedge(target));
    case LinkKind::kPrev:
      links.prev[item] = target;
      return halfedge(item)->set_prev(halfedge(target));
    case LinkKind::kToVertex:
      links.to_vertex[item] = target;
      return halfedge(item)->set_vertex(vertex());
    case LinkKind::kFace:
      links.face[item] = target;
      return halfedge(item)->set_face(face());
    case LinkKind::kAnchor:  // theirs arrives
      links.vertex_halfedge[item] = target;
      return mirror.vertices.at(item)->set_halfedge(
          halfedge(target == kNone ? kNone : target ^ 1U));
    case LinkKind::kFaceHalfedge:
      links.face_halfedge[item] = target;
      return mirror.faces.at(item)->set_halfedge(halfedge(target));
  }
}

/// The value of a link.
inline Index link_of(const Mesh& mesh, LinkKind kind, Index item) {
  const Links& links = mesh.links();
  const Array<Index>* arrays[] = {
      &links.next,         &links.prev, &links.to_vertex, &links.face, &links.vertex_halfedge,
      &links.face_halfedge};
  return (*arrays[int(kind)])[item];
}

/// The codes of the errors that `validate` finds.
inline std::set<std::string> error_codes(const Mesh& mesh, int level) {
  std::set<std::string> codes;
  for (const Problem& problem : validate(mesh, level)) {
    if (problem.severity == Severity::kError) codes.insert(std::string(problem.code));
  }
  return codes;
}

/// Where our levels and CGAL's are meant to differ, and nowhere else. docs/internals.md says why.
struct Difference {
  int first_level;
  int last_level;
  std::string code;  // of our error, that isn't one of theirs
};
inline const std::vector<Difference>& intended_differences() {
  static const std::vector<Difference> all = {
      {0, 0, "empty-link"},  // a halfedge without a vertex: they look from level 1 on; or as below
      {1, 2, "empty-link"},  // a face without a halfedge: they look from level 3 on
      {3, 4, "interior-anchor"}, {3, 4, "edge-without-face"},  {4, 4, "degree-below-three"},
      {4, 4, "repeated-vertex"}, {4, 4, "duplicate-halfedge"}, {4, 4, "same-face-twice"},
  };
  return all;
}

/// What there is to say of one level of one complex: "" where both say the same, the codes of
/// intended differences, or "unexplained: ...".
inline std::string compare_validity(const Mesh& mesh, const Mirror& mirror, int level) {
  const std::set<std::string> codes = error_codes(mesh, level);
  const bool theirs = they_accept(mirror.complex, level);
  if (codes.empty() == theirs) return {};
  std::string said = std::to_string(level);
  if (theirs) {
    bool explained = true;
    for (const std::string& code : codes) {
      said += " " + code;
      const auto& all = intended_differences();
      explained = explained && std::any_of(all.begin(), all.end(), [&](const Difference& d) {
                    return d.code == code && d.first_level <= level && level <= d.last_level;
                  });
    }
    return explained ? said : "unexplained: only ours refuses, at level " + said;
  }
  // Level 4 of theirs is level 3 in normal order.
  if (level == 4 && they_accept(mirror.complex, 3)) return said + " not-normalized";
  return "unexplained: only theirs refuses, at level " + said;
}

}  // namespace halfedge::test
