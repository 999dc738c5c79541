import type { HalfedgeMesh, ItemKind } from '../api.js';
import { indexLabels } from '../scene/index-labels.js';
import type { Anchors, Overlay } from '../scene/marks.js';
import type { Palette } from '../scene/palette.js';

/** What a figure can draw over its mesh, by the words of the attribute `overlays`. */
export const OVERLAYS = [
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

/** No more discs and names than these. */
const MOST_VERTICES = 300;

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

/** Adds the discs and the names of items to what is drawn. */
export function addItems(
  { marks, labels }: Overlay,
  names: ReadonlySet<OverlayName>,
  mesh: HalfedgeMesh,
  palette: Palette,
  anchors: Anchors,
): void {
  if (names.has('vertices')) {
    for (const index of firstOf(mesh.vertices())) {
      // Before all others, so that those lie over it.
      marks.unshift({ item: { kind: 'vertex', index }, color: palette.arrow, weight: 'faint' });
    }
  }
  const kinds = KINDS.filter(([name]) => names.has(name)).map(([, kind]) => kind);
  if (kinds.length === 0) return;
  const told = new Set(labels.map(({ text }) => text));
  const named = indexLabels(mesh, kinds, mesh.faces(), anchors);
  if (kinds.includes('vertex')) {
    // No face has these.
    for (const index of firstOf(mesh.vertices())) {
      if (!mesh.isIsolatedVertex(index)) continue;
      const point = anchors.point({ kind: 'vertex', index });
      named.push({ text: `v${index}`, look: 'index', point, lift: 15 });
    }
  }
  labels.push(...named.filter(({ text }) => !told.has(text)));
}

function firstOf(items: Iterable<number>): number[] {
  const first: number[] = [];
  for (const item of items) {
    if (first.push(item) === MOST_VERTICES) break;
  }
  return first;
}
