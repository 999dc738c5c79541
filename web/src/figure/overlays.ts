import type { HalfedgeMesh, ItemKind } from '../api.js';
import type { Anchors, Overlay } from '../scene/marks.js';
import type { Palette } from '../scene/palette.js';
import { itemName } from '../teaching/items.js';

/** What a figure can draw over its mesh, by the words of the attribute `overlays`. */
export const OVERLAYS = [
  'halfedges',
  'boundary',
  'links',
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

/** No more labels than these: nobody could read them. */
const MOST_LABELS = 300;

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
  const told = new Set(labels.map(({ text }) => text));
  const kinds: [OverlayName, ItemKind, Iterable<number>][] = [
    ['vertex-labels', 'vertex', mesh.vertices()],
    ['face-labels', 'face', mesh.faces()],
    ['edge-labels', 'edge', mesh.edges()],
    ['halfedge-labels', 'halfedge', mesh.halfedges()],
  ];
  for (const [name, kind, items] of kinds) {
    if (!names.has(name)) continue;
    for (const index of firstOf(items)) {
      const item = { kind, index };
      const text = itemName(item);
      if (labels.length >= MOST_LABELS || told.has(text)) continue;
      labels.push({
        text,
        look: 'index',
        point: anchors.point(item),
        side: anchors.side(item),
        lift: kind === 'vertex' ? 15 : kind === 'halfedge' ? 12 : 0,
      });
    }
  }
}

function firstOf(items: Iterable<number>): number[] {
  const first: number[] = [];
  for (const item of items) {
    if (first.push(item) === MOST_LABELS) break;
  }
  return first;
}
