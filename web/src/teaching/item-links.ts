import type { HalfedgeMesh } from '../api.js';
import { type Item, item } from './items.js';

/** A link of an item, with its number in the figure of the halfedge structure where it has one. */
export interface Link {
  /** (1) vertex → halfedge, (2) face → halfedge, (3)–(7) the links of a halfedge. */
  readonly number?: 1 | 2 | 3 | 4 | 5 | 6 | 7;
  /** The name in the API. */
  readonly name: string;
  /** What it leads to, in words. */
  readonly hint: string;
  readonly target: Item | null;
  /** The key that walks along it. */
  readonly key: WalkKey;
  /** Which colour of the palette it has in the picture. */
  readonly role: LinkRole;
}

/** Which link it is: a role has one colour, whatever the link begins at. */
export type LinkRole = 'next' | 'prev' | 'opposite' | 'vertex' | 'edge' | 'face' | 'halfedge';
/** The key of the explorer that follows a link. */
export type WalkKey = 'n' | 'p' | 'o' | 'v' | 'e' | 'f' | 'h' | 'u';

/** All links of an item, in the order of the figure. */
export function linksOf(mesh: HalfedgeMesh, of: Item): Link[] {
  const i = of.index;
  switch (of.kind) {
    case 'vertex':
      return [
        {
          number: 1,
          name: 'vertexHalfedge',
          hint: anchorHint(mesh, i),
          target: item('halfedge', mesh.vertexHalfedge(i)),
          key: 'h',
          role: 'halfedge',
        },
      ];
    case 'face':
      return [
        {
          number: 2,
          name: 'faceHalfedge',
          hint: 'one around it',
          target: item('halfedge', mesh.faceHalfedge(i)),
          key: 'h',
          role: 'halfedge',
        },
      ];
    case 'edge':
      return ([0, 1] as const).map((side) => ({
        name: `edgeHalfedge, side ${side}`,
        hint: side === 0 ? 'even number' : 'odd number',
        target: item('halfedge', mesh.edgeHalfedge(i, side)),
        key: side === 0 ? 'h' : 'o',
        role: side === 0 ? 'halfedge' : 'opposite',
      }));
    case 'halfedge':
      return linksOfHalfedge(mesh, i);
  }
}

function anchorHint(mesh: HalfedgeMesh, v: number): string {
  if (mesh.isIsolatedVertex(v)) return 'none: an isolated vertex';
  return mesh.isBoundaryVertex(v) ? 'a boundary one' : 'an outgoing one';
}

function linksOfHalfedge(mesh: HalfedgeMesh, h: number): Link[] {
  const face = item('face', mesh.face(h));
  const around = face ? 'in the face' : 'along the boundary';
  return [
    {
      number: 3,
      name: 'toVertex',
      hint: 'the vertex it points to',
      target: item('vertex', mesh.toVertex(h)),
      key: 'v',
      role: 'vertex',
    },
    {
      number: 4,
      name: 'face',
      hint: face ? 'the face on its left' : 'none: a boundary halfedge',
      target: face,
      key: 'f',
      role: 'face',
    },
    {
      number: 5,
      name: 'next',
      hint: `the next one ${around}`,
      target: item('halfedge', mesh.next(h)),
      key: 'n',
      role: 'next',
    },
    {
      number: 6,
      name: 'opposite',
      hint: 'the other side of its edge',
      target: item('halfedge', mesh.opposite(h)),
      key: 'o',
      role: 'opposite',
    },
    {
      number: 7,
      name: 'prev',
      hint: `the previous one ${around}`,
      target: item('halfedge', mesh.prev(h)),
      key: 'p',
      role: 'prev',
    },
    {
      name: 'fromVertex',
      hint: 'the vertex it leaves',
      target: item('vertex', mesh.fromVertex(h)),
      key: 'u',
      role: 'vertex',
    },
    {
      name: 'edge',
      hint: 'both sides together',
      target: item('edge', mesh.edge(h)),
      key: 'e',
      role: 'edge',
    },
  ];
}
