// The public names, but for `init`, of which each entry has its own.

export type {
  AttributeInfo,
  AttributeOptions,
  Attributes,
  AttributeType,
  AttributeView,
  OnSplit,
} from './attributes.js';
export type { BuildOptions, FaceOptions, Polygons, StorageOptions } from './build.js';
export type { CirculatorCentre, CirculatorKind } from './circulation.js';
export type { CirculateOptions, Circulator } from './circulator.js';
export type { CompactMaps, DeleteOptions, VertexOrder } from './construction.js';
export type { DirectedCirculator } from './directed-edges/circulators.js';
export { DirectedEdgesMesh } from './directed-edges/mesh.js';
export type { DirectedEdgesViews } from './directed-edges/navigation.js';
export type { DirectedOrbit } from './directed-edges/orbit.js';
export type { DirectedItems } from './directed-edges/ranges.js';
export type { Position, Refusal } from './edit.js';
export { HalfedgeError, type Problem, type Witness } from './errors.js';
export type { CollapseOptions, SplitVertexOptions } from './euler.js';
export type { FileAttribute, FileSoup, FileSoupOptions } from './file-soup.js';
export type { Generations, Reference } from './generations.js';
export type { History, HistoryLimits } from './history.js';
export {
  type Direction,
  type Edge,
  type EdgeLike,
  type Face,
  type FaceLike,
  type Halfedge,
  type HalfedgeLike,
  type ItemKind,
  type ItemLike,
  type ItemList,
  type ItemOf,
  NONE,
  type Vertex,
  type VertexLike,
} from './items.js';
export type { ConnectivityViews } from './links.js';
export type { LiveItems } from './live.js';
export type { Box, Floats, XYZ } from './measures.js';
export type {
  DegenerateOptions,
  DropOptions,
  FillOptions,
  MendCode,
  MendReport,
  OrientOptions,
  StitchOptions,
} from './mending.js';
export { HalfedgeMesh, type MeshPart } from './mesh.js';
export type { ItemSet, Items } from './neighbourhoods.js';
export type { Orbit } from './orbit.js';
export type {
  AttributeNames,
  FileFormat,
  ParseOptions,
  ParseReport,
} from './parse.js';
export type { ParseStage, ProgressOptions } from './progress.js';
export type { FaceVerdict, RepairCode, RepairReport, SoupOptions } from './repair.js';
export type { RingKind, Rows } from './rings.js';
export type {
  Cap,
  ConeOptions,
  CubeOptions,
  CylinderOptions,
  GridOptions,
  PrismOptions,
  QuadOptions,
  SphereOptions,
  TorusOptions,
  UvSphereOptions,
} from './shapes.js';
export type { Component, Computed, LinkLevel, ValidationLevel } from './topology.js';
export type { AppendMaps } from './transfer.js';
export type { FileEncoding, FileEncodings, WriteOptions } from './write.js';
