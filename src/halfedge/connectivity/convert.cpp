#include <halfedge/connectivity/convert.h>
#include <halfedge/sentence.h>

namespace halfedge {

namespace {

bool is_live_halfedge(const Links& links, Index h) {
  return h < links.next.size() && !is_deleted_link(links.next[h]);
}

// An array by halfedge: kNone, and kDeleted where the edge is.
bool make_halfedge_array(const Links& links, Array<Index>& array) {
  if (!array.resize(links.next.size())) return false;
  for (Index h = 0; h < array.size(); ++h) {
    array[h] = is_deleted_link(links.next[h]) ? kDeleted : kNone;
  }
  return true;
}

void derive_prev(const Links& links, Array<Index>& prev) {
  for (Index h = 0; h < links.next.size(); ++h) {
    if (is_live_halfedge(links, h) && links.next[h] < prev.size()) prev[links.next[h]] = h;
  }
}

// Writes `f` to the loop of `h`, up to where it was written before.
void label_loop(const Links& links, Index h, Index f, Array<Index>& face) {
  while (is_live_halfedge(links, h) && face[h] == kNone) {
    face[h] = f;
    h = links.next[h];
  }
}

void label_loops_of_faces(const Links& links, Array<Index>& face) {
  for (Index f = 0; f < links.face_halfedge.size(); ++f) {
    label_loop(links, links.face_halfedge[f], f, face);
  }
}

Index label_all_loops(const Links& links, Array<Index>& face) {
  Index faces = 0;
  for (Index h = 0; h < face.size(); ++h) {
    if (face[h] == kNone) label_loop(links, h, faces++, face);
  }
  return faces;
}

void derive_face_halfedges(const Array<Index>& face, Array<Index>& face_halfedge) {
  for (Index h = Index(face.size()); h-- > 0;) {
    if (face[h] < face_halfedge.size()) face_halfedge[face[h]] = h;
  }
}

// Whether `h` is a better anchor than `other`, by the rule of the builder.
bool is_better_anchor(const Links& links, const Array<Index>& face, Index h, Index other) {
  if (other == kNone) return true;
  if (face.empty()) return false;
  if (face[h] == kNone && face[other] == kNone) return links.to_vertex[h] < links.to_vertex[other];
  return face[h] == kNone || (face[other] != kNone && face[h] > face[other]);
}

void derive_anchors(const Links& links, const Array<Index>& face, Array<Index>& anchors) {
  for (Index h = 0; h < links.next.size(); ++h) {
    if (!is_live_halfedge(links, h)) continue;
    const Index v = links.to_vertex[h ^ 1U];
    if (v < anchors.size() && is_better_anchor(links, face, h, anchors[v])) anchors[v] = h;
  }
}

// Whether the arrays can be read by halfedge; if not there is nothing to derive from them.
bool are_readable(const Links& links, Storage have) {
  const std::size_t size = links.next.size();
  return size % 2 == 0 && links.to_vertex.size() == size &&
         (!have.face || links.face.size() == size);
}

}  // namespace

Result<void> LinkConversion::derive(const Links& links, Storage have, Storage want, Index vertices,
                                    Index& faces, Links& derived) {
  const bool readable = are_readable(links, have);
  if (want.prev && !have.prev) {
    if (!make_halfedge_array(links, derived.prev)) return no_memory_for("the link prev");
    if (readable) derive_prev(links, derived.prev);
  }
  const bool needs_faces = want.face || want.face_halfedge;
  if (needs_faces && !have.face) {
    if (!make_halfedge_array(links, derived.face)) return no_memory_for("the faces of halfedges");
    if (readable && have.face_halfedge) {
      label_loops_of_faces(links, derived.face);
    } else if (readable) {
      faces = label_all_loops(links, derived.face);
    }
  }
  const Array<Index>& face = have.face ? links.face : derived.face;
  if (want.face_halfedge && !have.face_halfedge) {
    if (!derived.face_halfedge.resize(faces, kNone)) return no_memory_for("the link of faces");
    if (readable) derive_face_halfedges(face, derived.face_halfedge);
  }
  if (want.vertex_halfedge && !have.vertex_halfedge) {
    if (!derived.vertex_halfedge.resize(vertices, kNone)) return no_memory_for("the anchors");
    if (readable) derive_anchors(links, face, derived.vertex_halfedge);
  }
  return {};
}

Error LinkConversion::has_deleted(const char* items) {
  return {
      "deleted-item",
      sentence::of(
          "There are deleted {}, which the new type cannot mark as such: compact the mesh first.",
          items)};
}

}  // namespace halfedge
