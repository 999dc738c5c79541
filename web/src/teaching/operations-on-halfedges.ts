import { cycleThrough, gluable, pathThrough } from './edge-paths.js';
import type { Operands, Operation, Refusal } from './operation.js';

/** The operations on a halfedge; most of them take a second one. */
export const onHalfedges: readonly Operation[] = [
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
    meaning: 'from its end to that of another',
    key: 'E',
    returns: 'edge',
    second: { kind: 'halfedge', ask: 'another halfedge of the same face or boundary loop' },
  },
  {
    stem: 'splitVertex',
    on: 'halfedge',
    label: 'Split vertex',
    meaning: 'between two halfedges',
    key: 'S',
    returns: 'vertex',
    grows: true,
    second: { kind: 'halfedge', ask: 'another halfedge that leaves the same vertex' },
  },
  {
    stem: 'fillHole',
    on: 'halfedge',
    label: 'Fill hole',
    meaning: 'one face on its boundary loop',
    key: 'H',
    returns: 'face',
  },
  {
    stem: 'glue',
    on: 'halfedge',
    label: 'Glue',
    meaning: 'two boundary edges become one',
    key: 'G',
    returns: 'edge',
    second: { kind: 'halfedge', ask: 'another boundary halfedge' },
    checkFirst: checkBoundary,
  },
  {
    stem: 'gluePath',
    on: 'halfedge',
    label: 'Glue path',
    meaning: 'boundary edges, as many as fit',
    returns: 'edge',
    second: { kind: 'halfedge', ask: 'another boundary halfedge' },
    checkFirst: checkBoundary,
    arguments: ({ mesh, item, second }) => {
      const g = second?.index ?? item.index;
      return [item.index, g, gluable(mesh, item.index, g)];
    },
  },
  {
    stem: 'cutPath',
    on: 'halfedge',
    label: 'Cut path',
    meaning: 'opens the surface up to another',
    returns: 'halfedge',
    second: { kind: 'halfedge', ask: 'the halfedge where the path ends' },
    arguments: ({ mesh, item, second }) => [
      pathThrough(mesh, item.index, second?.index ?? item.index),
    ],
  },
  {
    stem: 'splitLoop',
    on: 'halfedge',
    label: 'Split loop',
    meaning: 'cuts a handle, caps both ends',
    returns: 'halfedge',
    second: { kind: 'halfedge', ask: 'another halfedge of the cycle' },
    arguments: ({ mesh, item, second }) => [
      cycleThrough(mesh, item.index, second?.index ?? item.index),
    ],
  },
  {
    stem: 'bridge',
    on: 'halfedge',
    label: 'Bridge',
    meaning: 'a tube between two faces or holes',
    key: 'B',
    returns: 'halfedge',
    second: { kind: 'halfedge', ask: 'a halfedge of another face or boundary loop' },
  },
  {
    stem: 'removeBridge',
    on: 'halfedge',
    label: 'Remove bridge',
    meaning: 'takes a ring of quads out',
    key: 'R',
    returns: 'halfedge',
  },
  {
    stem: 'joinLoop',
    on: 'halfedge',
    label: 'Join loops',
    meaning: 'glues two faces or holes',
    key: 'J',
    returns: 'halfedge',
    second: { kind: 'halfedge', ask: 'a halfedge of a loop of the same degree' },
  },
  {
    stem: 'reverseComponent',
    on: 'halfedge',
    label: 'Turn inside out',
    meaning: 'reverses its component',
    key: 'I',
  },
];

/** An interior halfedge can't be glued to any. */
function checkBoundary({ mesh, item: { index } }: Operands): Refusal | null {
  return mesh.isBoundaryHalfedge(index) ? null : mesh.checkGlue(index, index);
}
