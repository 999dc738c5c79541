import type { HalfedgeMesh } from '../api.js';
import { PLURALS } from '../items.js';
import type { Item } from './items.js';
import type { Operation } from './operation.js';
import { onHalfedges } from './operations-on-halfedges.js';
import { repairs } from './operations-that-repair.js';

type Maps = ReturnType<HalfedgeMesh['compact']>;

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
    arguments: ({ item }) => [item.index, 0.3],
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
    stem: 'dissolveEdge',
    on: 'edge',
    label: 'Dissolve',
    meaning: 'with ends that only two edges keep',
    key: 'D',
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
    arguments: ({ item }) => [item.index, 0.3],
  },
  {
    stem: 'cut',
    on: 'edge',
    label: 'Cut',
    meaning: 'opens the surface along it',
    key: 'C',
    returns: 'halfedge',
    arguments: ({ mesh, item }) => [mesh.edgeHalfedge(item.index)],
  },
  {
    stem: 'deleteEdge',
    on: 'edge',
    label: 'Delete',
    meaning: 'with its faces',
    key: 'Delete',
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
    arguments: ({ mesh, item }) => [item.index, 0.6 * meanEdge(mesh, item.index)],
  },
  {
    stem: 'insetFace',
    on: 'face',
    label: 'Inset',
    meaning: 'a smaller face inside, in a frame',
    key: 'I',
    returns: 'face',
    grows: true,
    arguments: ({ item }) => [item.index, 0.35],
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
    returns: 'halfedge',
  },
  {
    stem: 'deleteFace',
    on: 'face',
    label: 'Delete',
    meaning: 'with edges that no face needs then',
    key: 'Delete',
  },
  {
    stem: 'deleteComponent',
    on: 'face',
    label: 'Delete component',
    meaning: 'all that is joined to it',
    key: 'X',
    arguments: ({ item }) => ['face', item.index],
  },
];

const onMeshes: readonly Operation[] = [
  {
    stem: 'triangulate',
    on: 'mesh',
    label: 'Triangulate all',
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
    stem: 'dual',
    on: 'mesh',
    label: 'Dual',
    meaning: 'opens it: a vertex for each face',
    key: 'M',
    opens: true,
  },
  {
    stem: 'keepLargestComponents',
    on: 'mesh',
    label: 'Keep the largest',
    meaning: 'deletes the other parts',
    key: 'L',
  },
  {
    stem: 'deleteIsolatedVertices',
    on: 'mesh',
    label: 'Delete isolated',
    meaning: 'vertices without edges',
    key: 'N',
  },
  {
    stem: 'compact',
    on: 'mesh',
    label: 'Compact',
    meaning: 'closes the gaps of deleted items',
    key: 'K',
    renumbers: (maps, { kind, index }) => (maps as Maps)[PLURALS[kind]][index],
  },
];

/** All that the page offers. */
export const operations: readonly Operation[] = [
  ...onVertices,
  ...onEdges,
  ...onHalfedges,
  ...onFaces,
  ...onMeshes,
  ...repairs,
];

/** The mean length of the edges of a face, in the units of the mesh. */
function meanEdge(mesh: HalfedgeMesh, face: number): number {
  const { positions } = mesh;
  let sum = 0;
  for (const h of mesh.faceHalfedges(face)) {
    const [a, b] = [3 * mesh.fromVertex(h), 3 * mesh.toVertex(h)];
    const along = [0, 1, 2].map((k) => positions[a + k] - positions[b + k]);
    sum += Math.hypot(...along);
  }
  return sum / mesh.degree(face);
}

/** The operations on an item, and those on the whole mesh after them. */
export function operationsFor(item: Item | null): Operation[] {
  return operations.filter(({ on }) => on === 'mesh' || on === item?.kind);
}
