import { type HalfedgeMesh, NONE } from '../api.js';
import { type Item, verticesOf } from './items.js';
import type { Operands, Operation } from './operation.js';

/**
 * What the picture needs to know of a change to move from the state before to that after: which
 * vertex each vanished one slides into, and which one each new vertex comes out of. The vertices
 * that both maps lead to may themselves be gone, or be new: they stand for a place.
 */
export interface Edit {
  readonly slides: ReadonlyMap<number, number>;
  readonly grows: ReadonlyMap<number, number>;
  /** Whether all items have new indices, so that states cannot be compared item by item. */
  readonly renumbers: boolean;
}

const NOWHERE: ReadonlyMap<number, number> = new Map();

/** The change that closes the gaps of deleted items. */
export const renumbering: Edit = { slides: NOWHERE, grows: NOWHERE, renumbers: true };

/** The same change the other way: what came out of a place slides back into it. */
export function reversed({ slides, grows, renumbers }: Edit): Edit {
  return { slides: grows, grows: slides, renumbers };
}

/** What has to be noted before an operation, to know afterwards how it moved. */
export interface StateBefore {
  readonly vertexHalfedge: Int32Array;
  /** The corners of the item, and where they are. */
  readonly corners: readonly (readonly [vertex: number, x: number, y: number, z: number])[];
  readonly slidesInto: number;
  /** Items beside the one that is operated on: what to select if that one goes. */
  readonly neighbours: readonly Item[];
}

/** What an operation is about to change, as it is. */
export function stateBefore(operation: Operation, operands: Operands): StateBefore {
  const { mesh, item } = operands;
  const onItem = operation.on !== 'mesh' && item.index !== NONE;
  const { positions } = mesh;
  const corners = onItem ? verticesOf(mesh, item) : [];
  return {
    vertexHalfedge: mesh.connectivity.vertexHalfedge.slice(),
    corners: corners.map((v) => [v, positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]]),
    slidesInto: operation.slidesInto?.(operands) ?? NONE,
    neighbours: onItem ? neighboursOf(mesh, item) : [],
  };
}

/** The motion of an operation that was just done. */
export function motionOf(operation: Operation, before: StateBefore, mesh: HalfedgeMesh): Edit {
  const slides = new Map<number, number>();
  const grows = new Map<number, number>();
  const after = mesh.connectivity.vertexHalfedge;
  const slots = Math.max(before.vertexHalfedge.length, after.length);
  for (let v = 0; v < slots; v++) {
    const was = (before.vertexHalfedge[v] ?? NONE - 1) >= NONE;
    const is = (after[v] ?? NONE - 1) >= NONE;
    if (was && !is && before.slidesInto !== NONE) slides.set(v, before.slidesInto);
    if (is && !was && operation.grows) grows.set(v, nearest(before.corners, mesh.positions, v));
  }
  return { slides, grows, renumbers: false };
}

function nearest(corners: StateBefore['corners'], positions: Float32Array, v: number): number {
  let found = v;
  let least = Infinity;
  for (const [corner, x, y, z] of corners) {
    const distance = Math.hypot(
      positions[3 * v] - x,
      positions[3 * v + 1] - y,
      positions[3 * v + 2] - z,
    );
    if (distance < least) {
      least = distance;
      found = corner;
    }
  }
  return found;
}

/** Its vertices, and what lies across an edge of it or around it. */
function neighboursOf(mesh: HalfedgeMesh, item: Item): Item[] {
  const vertices =
    item.kind === 'vertex' ? [...mesh.vertexVertices(item.index)] : verticesOf(mesh, item);
  const faces = item.kind === 'face' ? [...mesh.faceFaces(item.index)] : [];
  return [
    ...faces.map((index) => ({ kind: 'face', index }) as const),
    ...vertices.map((index) => ({ kind: 'vertex', index }) as const),
  ];
}
