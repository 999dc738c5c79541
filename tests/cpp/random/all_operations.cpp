#include "random/operation.h"
#include "random/registry.h"

namespace halfedge::test {

const Operations& all_operations() {
  static const Operations all = [] {
    Operations made;
    add_euler_operations(made);
    add_face_operations(made);
    add_mesh_operations(made);
    add_form_operations(made);
    add_seam_operations(made);
    return made;
  }();
  return all;
}

}  // namespace halfedge::test
