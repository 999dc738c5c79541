import { newArray, typedArrayName } from './arguments.js';
import { indexOfChoice, refuse } from './checks.js';
import type { RawFailure, RawRows, RawWords } from './core.js';
import { type Direction, type ItemList, PLURALS } from './items.js';
import { type Links, listOfItems } from './links.js';
import type { Core } from './loader.js';
import { withInputs } from './memory.js';
import type { ItemSet } from './neighbourhoods.js';
import { unwrap } from './reports.js';

/** The circulators around a vertex, a face and an edge; in the order of the enum Ring in C++. */
export const RING_KINDS = [
  'vertexVertices',
  'vertexOutgoingHalfedges',
  'vertexIncomingHalfedges',
  'vertexEdges',
  'vertexFaces',
  'faceVertices',
  'faceHalfedges',
  'faceEdges',
  'faceFaces',
  'edgeVertices',
  'edgeHalfedges',
  'edgeFaces',
] as const;

/** A kind of ring: what one item is surrounded by. */
export type RingKind = (typeof RING_KINDS)[number];

/** Rows of items, compressed: row i is `items.subarray(offsets[i], offsets[i + 1])`. */
export interface Rows {
  /** One more than there are rows. */
  readonly offsets: Uint32Array;
  readonly items: Uint32Array;
}

/** The rings of one kind around all items, or around `centres`; copies, into the arrays of `into` if they fit. */
export function rings(
  links: Links,
  kind: RingKind,
  direction: Direction,
  centres?: ItemList<number>,
  into?: Rows,
): Rows {
  if (into !== undefined) checkRows(into);
  const { core, address } = links;
  const ring = RING_KINDS.indexOf(kind);
  const way = directionIndex(direction);
  if (centres === undefined) return takeRows(core, core.allRings(address, ring, way), into);
  const centre = kind.startsWith('v') ? 'vertex' : kind.startsWith('f') ? 'face' : 'edge';
  const argument = PLURALS[centre];
  const list = listOfItems(links, centre, argument, centres);
  return withInputs(core, (inputs) => {
    const block = inputs.indices(argument, list);
    const raw = core.someRings(links.address, ring, way, block.address, block.count);
    return takeRows(core, raw, into);
  });
}

/** 0 for 'ccw', 1 for 'cw', as in the enum Direction in C++. Throws a sentence for anything else. */
export function directionIndex(direction: unknown): 0 | 1 {
  return indexOfChoice('direction', direction, ['ccw', 'cw']) as 0 | 1;
}

function checkRows(into: Rows): void {
  const { offsets, items } = (into ?? {}) as Partial<Rows>;
  if (typedArrayName(offsets) !== 'Uint32Array' || typedArrayName(items) !== 'Uint32Array') {
    refuse('into', into, 'rows of an earlier call: offsets and items, both Uint32Arrays');
  }
}

function takeRows(core: Core, raw: RawRows | RawFailure, into?: Rows): Rows {
  const { offsets, items } = unwrap(raw);
  try {
    return {
      offsets: copyOf(core, offsets, into?.offsets),
      items: copyOf(core, items, into?.items),
    };
  } finally {
    core.free(offsets.address);
    core.free(items.address);
  }
}

/** Copies of what the core hands over, which is freed, also if there is no memory for the copies. */
export function take<Blocks extends RawWords[]>(
  core: Core,
  ...blocks: Blocks
): { [I in keyof Blocks]: Uint32Array } {
  try {
    return blocks.map((block) => copyOf(core, block)) as { [I in keyof Blocks]: Uint32Array };
  } finally {
    for (const { address } of blocks) core.free(address);
  }
}

/** As `take`, of items by their kinds. */
export function takeItems(
  core: Core,
  raw: { vertices: RawWords; edges: RawWords; faces: RawWords },
): ItemSet {
  const [vertices, edges, faces] = take(core, raw.vertices, raw.edges, raw.faces);
  return { vertices, edges, faces };
}

/** A copy: in `array`, or the first part of it, if it has room for it. */
function copyOf(core: Core, { address, count }: RawWords, array?: Uint32Array): Uint32Array {
  const hasRoom = array !== undefined && array.length >= count;
  const copy = hasRoom ? array : newArray('the result', Uint32Array, count);
  copy.set(new Uint32Array(core.memory.buffer, address, count));
  return copy.length === count ? copy : copy.subarray(0, count);
}
