import type { CirculatorKind, Direction, HalfedgeMesh, ItemKind } from '../api.js';
import type { Item } from './items.js';

/** The methods of `HalfedgeMesh` that circulate around one item. */
export type CirculatorName = CirculatorKind;

/** How a circulator steps from halfedge to halfedge. */
export type Walk = 'rotate' | 'loop' | 'across';
/** What it shows of the halfedge where it stands. */
export type View = 'itself' | 'opposite' | 'toVertex' | 'edge' | 'face' | 'faceAcross';

/** A circulator, and what it is made of: a walk, and a view of where that stands. */
export interface Circulator {
  readonly name: CirculatorName;
  readonly around: ItemKind;
  readonly yields: ItemKind;
  readonly walk: Walk;
  readonly view: View;
  /** A word for a button. */
  readonly label: string;
}

const WALKS: Record<ItemKind, Walk> = {
  vertex: 'rotate',
  halfedge: 'loop',
  edge: 'across',
  face: 'loop',
};

const YIELDS: Record<View, ItemKind> = {
  itself: 'halfedge',
  opposite: 'halfedge',
  toVertex: 'vertex',
  edge: 'edge',
  face: 'face',
  faceAcross: 'face',
};

function circulator(around: ItemKind, name: CirculatorName, view: View, label: string): Circulator {
  return { name, around, yields: YIELDS[view], walk: WALKS[around], view, label };
}

/** All circulators, by what they go around. */
export const circulators: readonly Circulator[] = [
  circulator('vertex', 'vertexVertices', 'toVertex', 'one-ring vertices'),
  circulator('vertex', 'vertexOutgoingHalfedges', 'itself', 'outgoing halfedges'),
  circulator('vertex', 'vertexIncomingHalfedges', 'opposite', 'incoming halfedges'),
  circulator('vertex', 'vertexEdges', 'edge', 'edges'),
  circulator('vertex', 'vertexFaces', 'face', 'faces'),
  circulator('face', 'faceVertices', 'toVertex', 'vertices'),
  circulator('face', 'faceHalfedges', 'itself', 'halfedges'),
  circulator('face', 'faceEdges', 'edge', 'edges'),
  circulator('face', 'faceFaces', 'faceAcross', 'neighbouring faces'),
  circulator('halfedge', 'halfedgeLoop', 'itself', 'loop'),
  circulator('edge', 'edgeVertices', 'toVertex', 'vertices'),
  circulator('edge', 'edgeHalfedges', 'itself', 'halfedges'),
  circulator('edge', 'edgeFaces', 'face', 'faces'),
];

/** One question to the mesh: which circulator, around what, which way, from where. */
export interface Query {
  readonly circulator: Circulator;
  readonly index: number;
  readonly direction: Direction;
  /** A halfedge to begin at, where one is given. */
  readonly start?: number;
}

/** The questions that a selected item offers, in groups with a caption. */
export interface QueryGroup {
  readonly caption: string;
  readonly index: number;
  readonly start?: number;
  readonly circulators: readonly Circulator[];
}

function circulatorsAround(around: ItemKind): readonly Circulator[] {
  return circulators.filter((candidate) => candidate.around === around);
}

/**
 * A halfedge offers its loop, and everything around its vertex and its face with itself as the
 * start; the other items offer what goes around them.
 */
export function queriesFor(mesh: HalfedgeMesh, selected: Item): QueryGroup[] {
  const { kind: around, index } = selected;
  if (around !== 'halfedge') {
    return [
      { caption: `Around ${around} ${index}`, index, circulators: circulatorsAround(around) },
    ];
  }
  const from = mesh.fromVertex(index);
  const groups: QueryGroup[] = [
    {
      caption: mesh.isBoundaryHalfedge(index) ? 'boundary loop' : 'face loop',
      index,
      circulators: circulatorsAround('halfedge'),
    },
    {
      caption: `vertex ${from}`,
      index: from,
      start: index,
      circulators: circulatorsAround('vertex'),
    },
  ];
  const face = mesh.face(index);
  if (face >= 0) {
    groups.push({
      caption: `face ${face}`,
      index: face,
      start: index,
      circulators: circulatorsAround('face'),
    });
  }
  return groups;
}

/** Only circulators that step around something have a direction. */
export function hasDirection(circulator: Circulator): boolean {
  return circulator.walk !== 'across';
}

/** The query as a line of the code that a user of the package would write. */
export function queryCode({ circulator, index, direction, start }: Query): string {
  const args = [String(index)];
  if (hasDirection(circulator)) {
    args.push(`'${direction}'`);
    if (start !== undefined) args.push(String(start));
  }
  return `mesh.${circulator.name}(${args.join(', ')})`;
}
