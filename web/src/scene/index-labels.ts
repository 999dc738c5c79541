import type { HalfedgeMesh, ItemKind } from '../api.js';
import { type Item, itemName } from '../teaching/items.js';
import type { Label } from './labels.js';
import type { Anchors } from './marks.js';

/** So many names are tried at most; of these, `Labels` shows those that cover no other. */
const MOST_LABELS = 600;

/** How far the name of an item lies from its anchor, in CSS pixels. */
const LIFT: Record<ItemKind, number> = { vertex: 15, edge: 0, halfedge: 12, face: 0 };

/** What has names: faces with all that they touch, and vertices that no face has. */
export interface Named {
  readonly faces: Iterable<number>;
  readonly vertices: Iterable<number>;
}

/** The names of the items of these faces, and of the boundary halfedges across their edges. */
export function indexLabels(
  mesh: HalfedgeMesh,
  kinds: readonly ItemKind[],
  { faces, vertices }: Named,
  anchors: Anchors,
): Label[] {
  if (kinds.length === 0) return [];
  const labels: Label[] = [];
  const seen = new Set<string>();
  const add = (item: Item) => {
    const text = itemName(item);
    if (labels.length === MOST_LABELS || !kinds.includes(item.kind) || seen.has(text)) return;
    seen.add(text);
    const point = anchors.point(item);
    labels.push({ text, look: 'index', point, side: anchors.side(item), lift: LIFT[item.kind] });
  };
  for (const index of vertices) add({ kind: 'vertex', index });
  const { next, face, toVertex, faceHalfedge } = mesh.connectivity;
  for (const f of faces) {
    if (labels.length === MOST_LABELS) break;
    add({ kind: 'face', index: f });
    let h = faceHalfedge[f];
    do {
      add({ kind: 'vertex', index: toVertex[h] });
      add({ kind: 'halfedge', index: h });
      add({ kind: 'edge', index: h >> 1 });
      if (face[h ^ 1] < 0) add({ kind: 'halfedge', index: h ^ 1 });
      h = next[h];
    } while (h !== faceHalfedge[f]);
  }
  return labels;
}
