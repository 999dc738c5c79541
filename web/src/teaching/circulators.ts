import type { Direction, HalfedgeMesh, ItemKind } from '../api.js';
import type { Item } from './items.js';

/** The methods of `HalfedgeMesh` that circulate around one item. */
export type CirculatorName =
  | 'vertexVertices'
  | 'vertexOutgoingHalfedges'
  | 'vertexIncomingHalfedges'
  | 'vertexEdges'
  | 'vertexFaces'
  | 'faceVertices'
  | 'faceHalfedges'
  | 'faceEdges'
  | 'faceFaces'
  | 'edgeVertices'
  | 'edgeHalfedges'
  | 'edgeFaces'
  | 'halfedgeLoop';

/** How a circulator steps from halfedge to halfedge. */
export type Walk = 'rotate' | 'loop' | 'across';
/** What it shows of the halfedge where it stands. */
export type View = 'itself' | 'opposite' | 'toVertex' | 'edge' | 'face' | 'faceAcross';

export interface Circulator {
  readonly name: CirculatorName;
  readonly around: ItemKind;
  readonly yields: ItemKind;
  readonly walk: Walk;
  readonly view: View;
  /** A word for a button. */
  readonly label: string;
}

function kind(
  name: CirculatorName,
  around: ItemKind,
  yields: ItemKind,
  walk: Walk,
  view: View,
  label: string,
): Circulator {
  return { name, around, yields, walk, view, label };
}

export const circulators: readonly Circulator[] = [
  kind('vertexVertices', 'vertex', 'vertex', 'rotate', 'toVertex', 'one-ring vertices'),
  kind('vertexOutgoingHalfedges', 'vertex', 'halfedge', 'rotate', 'itself', 'outgoing halfedges'),
  kind('vertexIncomingHalfedges', 'vertex', 'halfedge', 'rotate', 'opposite', 'incoming halfedges'),
  kind('vertexEdges', 'vertex', 'edge', 'rotate', 'edge', 'edges'),
  kind('vertexFaces', 'vertex', 'face', 'rotate', 'face', 'faces'),
  kind('faceVertices', 'face', 'vertex', 'loop', 'toVertex', 'vertices'),
  kind('faceHalfedges', 'face', 'halfedge', 'loop', 'itself', 'halfedges'),
  kind('faceEdges', 'face', 'edge', 'loop', 'edge', 'edges'),
  kind('faceFaces', 'face', 'face', 'loop', 'faceAcross', 'neighbouring faces'),
  kind('halfedgeLoop', 'halfedge', 'halfedge', 'loop', 'itself', 'loop'),
  kind('edgeVertices', 'edge', 'vertex', 'across', 'toVertex', 'vertices'),
  kind('edgeHalfedges', 'edge', 'halfedge', 'across', 'itself', 'halfedges'),
  kind('edgeFaces', 'edge', 'face', 'across', 'face', 'faces'),
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
