// Between meshes and three.js, which is a peer dependency of this entry.

export type { GeometryOptions, NormalOption } from './columns.js';
export { type GeometryUpdate, MeshGeometry } from './mesh-geometry.js';
export {
  type FromGeometryOptions,
  fromBufferGeometry,
  type GeometryMaps,
  type GeometryMesh,
} from './read.js';
export { type MeshBuffers, type ToGeometryOptions, toBufferGeometry } from './write.js';
