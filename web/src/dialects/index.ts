/**
 * Other libraries' names for our meshes: `PolyMesh` has OpenMesh's, `Polyhedron` CGAL's, `HE_mesh`
 * those of McGuire's article. Apart from `halfedge`, so that only who imports them loads them.
 *
 * @module
 */

export {
  type HalfedgeAroundFacetCirculator,
  type HalfedgeAroundVertexCirculator,
  Polyhedron,
  type PolyhedronFacet,
  type PolyhedronHalfedge,
  type PolyhedronVertex,
} from './cgal.js';
export { type HE_edge, type HE_face, HE_mesh, type HE_vert } from './mcguire.js';
export { EdgeHandle, FaceHandle, HalfedgeHandle, PolyMesh, VertexHandle } from './openmesh.js';
export type { ReadableMesh } from './readable.js';
