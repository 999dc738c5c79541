import type { HalfedgeMesh } from 'halfedge';
import type { Item } from './items.js';
import { isThere, type Operation } from './operation.js';

const onVertices: readonly Operation[] = [
  {
    stem: 'dissolveVertex',
    on: 'vertex',
    label: 'Dissolve',
    meaning: 'its faces become one',
    key: 'D',
    returns: 'face',
  },
  {
    stem: 'removeVertexOnEdge',
    on: 'vertex',
    label: 'Remove from edge',
    meaning: 'its two edges become one',
    key: 'R',
    returns: 'edge',
  },
  {
    stem: 'bevelVertex',
    on: 'vertex',
    label: 'Bevel',
    meaning: 'a face takes its place',
    key: 'B',
    returns: 'face',
    grows: true,
  },
  {
    stem: 'deleteVertex',
    on: 'vertex',
    label: 'Delete',
    meaning: 'with its faces',
    key: 'Delete',
  },
];

const onEdges: readonly Operation[] = [
  {
    stem: 'flipEdge',
    on: 'edge',
    label: 'Flip',
    meaning: 'turns in the quad of its triangles',
    key: 'F',
    returns: 'edge',
  },
  {
    stem: 'splitEdge',
    on: 'edge',
    label: 'Split',
    meaning: 'a vertex in the middle; cuts triangles',
    key: 'S',
    returns: 'vertex',
  },
  {
    stem: 'insertVertexOnEdge',
    on: 'edge',
    label: 'Insert vertex',
    meaning: 'its faces gain a corner',
    key: 'V',
    returns: 'vertex',
  },
  {
    stem: 'removeEdge',
    on: 'edge',
    label: 'Remove',
    meaning: 'joins its two faces',
    key: 'R',
    returns: 'face',
  },
  {
    stem: 'bevelEdge',
    on: 'edge',
    label: 'Bevel',
    meaning: 'a face takes its place',
    key: 'B',
    returns: 'face',
    grows: true,
  },
  {
    stem: 'deleteEdge',
    on: 'edge',
    label: 'Delete',
    meaning: 'with its faces',
    key: 'Delete',
  },
];

const onHalfedges: readonly Operation[] = [
  {
    stem: 'collapse',
    on: 'halfedge',
    label: 'Collapse',
    meaning: 'its start moves into its end',
    key: 'C',
    returns: 'vertex',
    slidesInto: ({ mesh, item }) => mesh.toVertex(item.index),
  },
  {
    stem: 'insertEdge',
    on: 'halfedge',
    label: 'Insert edge',
    meaning: 'from its end to another’s',
    key: 'E',
    returns: 'edge',
    second: { kind: 'halfedge', ask: 'another halfedge of the same face' },
  },
  {
    stem: 'splitVertex',
    on: 'halfedge',
    label: 'Split vertex',
    meaning: 'opens a fan of its start',
    key: 'S',
    returns: 'vertex',
    second: { kind: 'halfedge', ask: 'another halfedge that leaves the same vertex' },
    grows: true,
  },
  {
    stem: 'fillHole',
    on: 'halfedge',
    label: 'Fill hole',
    meaning: 'one face on its boundary loop',
    key: 'H',
    returns: 'face',
  },
];

const onFaces: readonly Operation[] = [
  {
    stem: 'splitFace',
    on: 'face',
    label: 'Poke',
    meaning: 'a vertex in the middle, a fan around it',
    key: 'S',
    returns: 'vertex',
  },
  {
    stem: 'extrudeFace',
    on: 'face',
    label: 'Extrude',
    meaning: 'lifts it, with a wall around',
    key: 'E',
    returns: 'face',
    grows: true,
  },
  {
    stem: 'insetFace',
    on: 'face',
    label: 'Inset',
    meaning: 'a smaller face inside, in a frame',
    key: 'I',
    returns: 'face',
    grows: true,
  },
  {
    stem: 'triangulate',
    on: 'face',
    label: 'Triangulate',
    meaning: 'cuts it into triangles',
    key: 'T',
  },
  {
    stem: 'makeHole',
    on: 'face',
    label: 'Make hole',
    meaning: 'it goes, its edges stay',
    key: 'H',
  },
  {
    stem: 'deleteFace',
    on: 'face',
    label: 'Delete',
    meaning: 'with edges that nothing needs then',
    key: 'Delete',
  },
];

const onMeshes: readonly Operation[] = [
  {
    stem: 'triangulate',
    on: 'mesh',
    label: 'Triangulate',
    meaning: 'cuts every face into triangles',
    key: 'A',
  },
  {
    stem: 'reverse',
    on: 'mesh',
    label: 'Reverse',
    meaning: 'turns every face over',
    key: 'O',
  },
  {
    stem: 'compact',
    on: 'mesh',
    label: 'Compact',
    meaning: 'closes the gaps of deleted items',
    key: 'K',
  },
];

const all: readonly Operation[] = [
  ...onVertices,
  ...onEdges,
  ...onHalfedges,
  ...onFaces,
  ...onMeshes,
];

/** The operations on an item, and those on the whole mesh after them. */
export function operationsFor(mesh: HalfedgeMesh, item: Item | null): Operation[] {
  return all.filter(
    (operation) =>
      (operation.on === 'mesh' || operation.on === item?.kind) && isThere(operation, mesh),
  );
}
