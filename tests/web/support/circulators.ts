import type { CirculatorKind, Direction, HalfedgeMesh, Rows } from 'halfedge';

export type Around = 'vertex' | 'face';
export const aroundVertices = [
  'vertexVertices',
  'vertexOutgoingHalfedges',
  'vertexIncomingHalfedges',
  'vertexEdges',
  'vertexFaces',
] as const;
export const aroundFaces = ['faceVertices', 'faceHalfedges', 'faceEdges', 'faceFaces'] as const;
export const aroundEdges = ['edgeVertices', 'edgeHalfedges', 'edgeFaces'] as const;
export const directions: Direction[] = ['ccw', 'cw'];

/** All kinds in one row each: what they circulate around, and how to list them at once. */
export const directed: [
  CirculatorKind,
  Around,
  (mesh: HalfedgeMesh, direction: Direction) => Rows,
][] = [
  ['vertexVertices', 'vertex', (mesh, way) => mesh.allVertexVertices(way)],
  ['vertexOutgoingHalfedges', 'vertex', (mesh, way) => mesh.allVertexOutgoingHalfedges(way)],
  ['vertexIncomingHalfedges', 'vertex', (mesh, way) => mesh.allVertexIncomingHalfedges(way)],
  ['vertexEdges', 'vertex', (mesh, way) => mesh.allVertexEdges(way)],
  ['vertexFaces', 'vertex', (mesh, way) => mesh.allVertexFaces(way)],
  ['faceVertices', 'face', (mesh, way) => mesh.allFaceVertices(way)],
  ['faceHalfedges', 'face', (mesh, way) => mesh.allFaceHalfedges(way)],
  ['faceEdges', 'face', (mesh, way) => mesh.allFaceEdges(way)],
  ['faceFaces', 'face', (mesh, way) => mesh.allFaceFaces(way)],
];

interface Lap extends Iterable<number> {
  into(buffer: Int32Array): number;
}
export type Range = (item: number, direction?: Direction, start?: number) => Lap;
export const range = (mesh: HalfedgeMesh, kind: CirculatorKind): Range =>
  (mesh[kind] as Range).bind(mesh);
