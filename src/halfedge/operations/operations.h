#pragma once

/// The operations on polygon meshes. What holds level 4 of `validate` before, holds it afterwards:
/// a mesh can't be broken by them.
///
/// The contract of each:
/// - `check_x(mesh, ...)`, on a const mesh, tells whether `x` can be done: nothing, or the refusal,
///   with a code, a sentence, and the items that make it impossible as its witness.
/// - `x(mesh, ...)` checks, makes room, and only then changes something; if it returns an error,
///   one of memory included, nothing at all has changed.
/// - Live items keep their indices. Deleted slots are taken by the next new items.
/// - New items have defined positions and attributes ("attributes:" says which).
/// - The inverse is named. With history on, everything can be undone; `Mesh::end_step` divides the
///   changes into steps.
///
/// These ask for more than the decorator of the combinatorial layer (halfedge/decorator), which
/// allows degenerate complexes, and by which most of them are done.
#include <halfedge/operations/add_face.h>
#include <halfedge/operations/bevel.h>
#include <halfedge/operations/collapse.h>
#include <halfedge/operations/components.h>
#include <halfedge/operations/cut.h>
#include <halfedge/operations/deletion.h>
#include <halfedge/operations/dissolve.h>
#include <halfedge/operations/extrude.h>
#include <halfedge/operations/flip.h>
#include <halfedge/operations/for_each.h>
#include <halfedge/operations/glue.h>
#include <halfedge/operations/holes.h>
#include <halfedge/operations/insert_edge.h>
#include <halfedge/operations/loops.h>
#include <halfedge/operations/orientation.h>
#include <halfedge/operations/split_edge.h>
#include <halfedge/operations/split_face.h>
#include <halfedge/operations/split_vertex.h>
#include <halfedge/operations/triangulate.h>
