// Between meshes and three.js, which is a peer dependency of this entry.

export { ARROWS_FROM, type ArrowSizes, ArrowTracer, arrowSizes } from './arrows.js';
export type { GeometryOptions, NormalOption } from './columns.js';
export { dashCount, placeDashes } from './dashes.js';
export { type DrawnMesh, HalfedgeGlyphs } from './glyphs.js';
export { type HelperOptions, MeshHelper } from './helper.js';
export {
  BoundaryLoopsHelper,
  CirculatorHelper,
  type CirculatorOptions,
  HalfedgesHelper,
  type HalfedgesOptions,
  ProblemsHelper,
  type ProblemsOptions,
} from './helpers.js';
export { IndexLabelsHelper, type LabelsOptions } from './labels-helper.js';
export { LineBuffers, SEGMENT_FLOATS } from './line-buffers.js';
export {
  type DrawnLines,
  ghostOf,
  LineBatch,
  type LineKind,
  lineMaterial,
  lines,
} from './lines.js';
export { type ChangeListener, type GeometryUpdate, MeshGeometry } from './mesh-geometry.js';
export { ARROW_FLOATS, CAP_SHARE, CappedMitre } from './mitre.js';
export { newellNormal, squaredDistanceToSegment } from './polygon.js';
export {
  type FromGeometryOptions,
  fromBufferGeometry,
  type GeometryMaps,
  type GeometryMesh,
} from './read.js';
export { type MeshBuffers, type ToGeometryOptions, toBufferGeometry } from './write.js';
