#pragma once

/// The combinatorial operations on complexes, degenerate ones included, as CGAL's
/// HalfedgeDS_decorator has them. They ask for no more than the invariants of a connectivity: an
/// edge may have the same vertex at both ends or the same face on both sides, faces may have one
/// corner. What they leave is valid at level 3 of `validate` if it was before.
///
///   operation                                   inverse
///   make_loop, make_segment                     erase_connected_component
///   split_face                                  join_face
///   split_vertex                                join_vertex
///   split_edge                                  join_edge
///   insert_tip                                  erase_tip
///   split_loop                                  join_loop
///   create_center_vertex                        erase_center_vertex
///   make_hole                                   fill_hole
///   add_face_to_boundary                        join_face, erase_face
///   add_vertex_and_face_to_boundary             erase_face
///   flip_edge                                   itself, three times
///   inside_out                                  itself
///   normalize_boundary, keep_largest_connected_components
///
/// Each of them is a template over the mesh type, and a `requires` clause or nothing: it works
/// where links are left out (see Storage) if it doesn't need them. The deletion of a vertex or a
/// face needs its link.
///
/// An operation that can't be done returns an error that says why, and has changed nothing; so it
/// is when memory is exhausted. `check_x` tells beforehand, of a const mesh. Live items keep their
/// indices; deleted slots are recycled by the next operations. Links change only where they must,
/// so that an anchor or the halfedge of a face that is still right stays.
#include <halfedge/decorator/boundary.h>
#include <halfedge/decorator/center.h>
#include <halfedge/decorator/complexes.h>
#include <halfedge/decorator/components.h>
#include <halfedge/decorator/faces.h>
#include <halfedge/decorator/flip.h>
#include <halfedge/decorator/loops.h>
#include <halfedge/decorator/order.h>
#include <halfedge/decorator/vertices.h>
