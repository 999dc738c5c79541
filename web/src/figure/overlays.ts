import type { Color } from 'three';
import type { HalfedgeMesh, ItemKind } from '../api.js';
import type { Mark } from '../scene/highlights.js';

/** What a figure can draw over its mesh, by the words of the attribute `overlays`. */
const OVERLAYS = [
  'halfedges',
  'boundary',
  'links',
  'all-links',
  'vertices',
  'labels',
  'vertex-labels',
  'edge-labels',
  'halfedge-labels',
  'face-labels',
] as const;

export type OverlayName = (typeof OVERLAYS)[number];

/** What is drawn where the attribute is left out. */
export const DEFAULT_OVERLAYS = 'halfedges boundary links';

const KINDS: readonly [OverlayName, ItemKind][] = [
  ['vertex-labels', 'vertex'],
  ['face-labels', 'face'],
  ['edge-labels', 'edge'],
  ['halfedge-labels', 'halfedge'],
];

const MOST_DISCS = 300;

/** Reads the attribute. Throws a sentence for a word that is none of them. */
export function overlaysNamed(text: string): ReadonlySet<OverlayName> {
  const words = text.split(/[\s,]+/).filter(Boolean);
  const wrong = words.find((word) => !OVERLAYS.includes(word as OverlayName));
  if (wrong !== undefined) {
    throw new Error(`overlays has “${wrong}”; expected some of ${OVERLAYS.join(', ')}.`);
  }
  const names = new Set(words as OverlayName[]);
  if (names.delete('labels')) names.add('vertex-labels').add('face-labels');
  return names;
}

/** The kinds of items that have their names beside them. */
export function namedKinds(names: ReadonlySet<OverlayName>): ItemKind[] {
  return KINDS.filter(([name]) => names.has(name)).map(([, kind]) => kind);
}

/** Discs of all vertices, up to a number; to be drawn below all other marks. */
export function vertexDiscs(mesh: HalfedgeMesh, color: Color): Mark[] {
  const marks: Mark[] = [];
  for (const index of mesh.vertices()) {
    marks.push({ item: { kind: 'vertex', index }, color, weight: 'faint' });
    if (marks.length === MOST_DISCS) break;
  }
  return marks;
}
