import { describe } from './arguments.js';
import { HalfedgeError } from './errors.js';
import { type ItemKind, NONE } from './items.js';
import { corrupt, type Links } from './links.js';
import { directionIndex, type RingKind } from './rings.js';

/** The circulators that `circulate` knows: all around one item, by the names of their methods. */
export type CirculatorKind = RingKind | 'halfedgeLoop';

type Centre = 'vertex' | 'face' | 'edge' | 'halfedge';
type View = (links: Links, h: number) => number;

const itself: View = (_, h) => h;
const opposite: View = (_, h) => h ^ 1;
const toVertex: View = (links, h) => links.toVertex[h];
const edge: View = (_, h) => h >> 1;
const face: View = (links, h) => links.face[h];
const faceAcross: View = (links, h) => links.face[h ^ 1];

const KINDS: Record<CirculatorKind, [Centre, View]> = {
  vertexVertices: ['vertex', toVertex],
  vertexOutgoingHalfedges: ['vertex', itself],
  vertexIncomingHalfedges: ['vertex', opposite],
  vertexEdges: ['vertex', edge],
  vertexFaces: ['vertex', face],
  faceVertices: ['face', toVertex],
  faceHalfedges: ['face', itself],
  faceEdges: ['face', edge],
  faceFaces: ['face', faceAcross],
  edgeVertices: ['edge', toVertex],
  edgeHalfedges: ['edge', itself],
  edgeFaces: ['edge', face],
  halfedgeLoop: ['halfedge', itself],
};

/** One step around the centre; undefined or negative where the links are corrupt. */
function step(links: Links, centre: Centre, clockwise: boolean, h: number): number {
  if (centre === 'edge') return h ^ 1;
  if (centre === 'vertex') return clockwise ? links.next[h ^ 1] : links.prev[h] ^ 1;
  return clockwise ? links.prev[h] : links.next[h];
}

/** Where a lap begins: `start`, or in the order of the specification; NONE where there is no lap. */
function firstOf(
  links: Links,
  centre: Centre,
  item: number,
  clockwise: boolean,
  start: number | undefined,
): number {
  if (centre === 'edge') {
    links.checkEdge(item);
    return 2 * item;
  }
  if (centre === 'halfedge') {
    links.checkHalfedge(item);
    return item;
  }
  if (centre === 'vertex') links.checkVertex(item);
  else links.checkFace(item);
  if (start !== undefined) {
    links.checkHalfedge(start, 'start');
    const around = centre === 'vertex' ? links.toVertex[start ^ 1] : links.face[start];
    if (around === item) return start;
    const belongs = centre === 'vertex' ? 'leaves' : 'lies in';
    const itsOwn = around === NONE ? 'no face' : `${centre} ${around}`;
    throw new RangeError(
      `start is halfedge ${describe(start)}, which ${belongs} ${itsOwn}; expected one that ${belongs} ${centre} ${item}.`,
    );
  }
  const first = centre === 'vertex' ? links.vertexHalfedge[item] : links.faceHalfedge[item];
  const reversed = clockwise === (centre !== 'vertex');
  return first >= 0 && reversed ? step(links, centre, clockwise, first) : first;
}

/** What one lap around `item` shows. */
export function lap(
  links: Links,
  kind: CirculatorKind,
  item: number,
  direction: unknown,
  start?: number,
): number[] {
  const [centre, view] = KINDS[kind];
  const clockwise = directionIndex(direction) === 1;
  const first = firstOf(links, centre, item, clockwise, start);
  const shown: number[] = [];
  if (first === NONE) return shown;
  let h = first;
  for (let laps = links.next.length; laps > 0 && h >= 0; laps--) {
    const seen = view(links, h);
    if (seen !== NONE) shown.push(seen);
    h = step(links, centre, clockwise, h);
    if (h === first) return shown;
  }
  throw corrupt(`The halfedges of ${centre} ${item} form no closed orbit`);
}

/** The live items of one kind, in index order. */
export function liveItems(links: Links, kind: ItemKind): number[] {
  links.revive();
  const { vertexHalfedge, faceHalfedge, next } = links;
  const slots = kind === 'vertex' ? vertexHalfedge : kind === 'face' ? faceHalfedge : next;
  const stride = kind === 'edge' ? 2 : 1;
  const live: number[] = [];
  for (let i = 0; i < slots.length; i += stride) if (slots[i] >= NONE) live.push(i / stride);
  return live;
}

/**
 * Endless and bidirectional: it has no end, it stops when you say so. Every use throws after the
 * connectivity has changed under it.
 */
export class Circulator {
  readonly #links: Links;
  readonly #centre: Centre;
  readonly #item: number;
  readonly #view: View;
  readonly #clockwise: boolean;
  readonly #version: number;
  #h: number;

  /** @internal */
  constructor(
    links: Links,
    kind: CirculatorKind,
    item: number,
    direction: unknown,
    start?: number,
  ) {
    if (!Object.hasOwn(KINDS, kind)) {
      const sentence = `kind is ${describe(kind)}; expected one of ${Object.keys(KINDS).join(', ')}.`;
      throw typeof kind === 'string' ? new RangeError(sentence) : new TypeError(sentence);
    }
    [this.#centre, this.#view] = KINDS[kind];
    this.#links = links;
    this.#item = item;
    this.#clockwise = directionIndex(direction) === 1;
    this.#h = firstOf(links, this.#centre, item, this.#clockwise, start);
    this.#version = links.version;
    this.#settle(this.#clockwise);
  }

  /** What it shows where it stands; `NONE` if there is nothing to show. */
  get current(): number {
    this.#check();
    return this.#h === NONE ? NONE : this.#view(this.#links, this.#h);
  }

  /** The halfedge where it stands; `NONE` if there is nothing to show. */
  get halfedge(): number {
    this.#check();
    return this.#h;
  }

  /** Steps on, and returns what it shows there. */
  next(): number {
    return this.#step(this.#clockwise);
  }

  /** Steps back, and returns what it shows there. */
  prev(): number {
    return this.#step(!this.#clockwise);
  }

  #step(clockwise: boolean): number {
    this.#check();
    if (this.#h !== NONE) {
      this.#h = step(this.#links, this.#centre, clockwise, this.#h);
      this.#settle(clockwise);
    }
    return this.current;
  }

  /** Steps over halfedges that show nothing. */
  #settle(clockwise: boolean): void {
    const first = this.#h;
    if (first === NONE) return;
    for (let laps = this.#links.next.length; laps > 0 && this.#h >= 0; laps--) {
      if (this.#view(this.#links, this.#h) !== NONE) return;
      this.#h = step(this.#links, this.#centre, clockwise, this.#h);
      if (this.#h === first) {
        this.#h = NONE;
        return;
      }
    }
    throw corrupt(`The halfedges of ${this.#centre} ${this.#item} form no closed orbit`);
  }

  #check(): void {
    this.#links.revive();
    if (this.#links.version === this.#version) return;
    throw new HalfedgeError(
      'stale-circulator',
      'This circulator was used after the connectivity changed under it; expected a new one.',
    );
  }
}
