/** A point of the canvas, in CSS pixels. */
export interface Place {
  readonly x: number;
  readonly y: number;
}

/** What a label names, as it is seen: a point, or a line from corner to corner. */
export type Trace = readonly Place[];

/** Where a label lies: its middle, and its width. */
export type Box = Place & { readonly width: number };

/** The height of a label with some air, and half of that without. */
const ROW = 19;
const HALF_HEIGHT = 9;

/** What it costs, in pixels away from what it names, to cover what another label names; twice that where it ends. */
const COVERS = 60;
/** And to be nearer to that than to its own. */
const NEARER = 25;
/** And to lie where a name would, which is hidden then. */
const HIDES = 60;
/** And each pixel that it lies from where it would be without others. */
const MOVED = 0.1;

/** Where a label goes: along its line first, then right and left (times its width), and up and down. */
const ALONG = [0.5, 0.35, 0.65, 0.2, 0.8];
const ASIDE: readonly (readonly [number, number])[] = [0, 1, -1, 2, -2].flatMap((rows) =>
  [0, 1, -1, 2, -2].map((columns) => [columns, rows] as const),
);

/** The labels that have their places in a frame: finds places for others that can't be mistaken for theirs. */
export class LabelPlaces {
  readonly #taken: Box[] = [];
  readonly #traces: readonly Trace[];
  readonly #names: readonly Box[];

  /**
   * `traces`: what all labels name, each once, as far as it is a line or a point of its own. `names`: labels that
   * will come later and don't go aside.
   */
  constructor(traces: readonly Trace[], names: readonly Box[] = []) {
    this.#traces = traces;
    this.#names = names;
  }

  take(x: number, y: number, width: number): void {
    this.#taken.push({ x, y, width });
  }

  /** Whether a label there would cover none. */
  isFree({ x, y }: Place, width: number): boolean {
    return !this.#taken.some((other) => overlap(other, { x, y, width }));
  }

  /**
   * The free place where a label is least to be mistaken for that of something else; undefined if none is free.
   * `own` is the trace of what it names, in the middle of which it would lie at `wanted`.
   */
  best(wanted: Place, width: number, own: Trace): Place | undefined {
    const middle = pointOn(own, 0.5);
    const slides = own.length > 1 ? ALONG : [0.5];
    const usual = distance(wanted, own);
    let best: Place | undefined;
    let least = Infinity;
    for (const [columns, rows] of ASIDE) {
      for (const share of columns === 0 && rows === 0 ? slides : [0.5]) {
        const slid = pointOn(own, share);
        const place = {
          x: wanted.x + slid.x - middle.x + columns * (width + 4),
          y: wanted.y + slid.y - middle.y + rows * ROW,
        };
        if (!this.isFree(place, width)) continue;
        const moved = Math.hypot(place.x - wanted.x, place.y - wanted.y);
        const away = Math.max(usual, distance(place, own));
        const cost = away + MOVED * moved + this.#harm(place, width, own);
        if (cost < least) [best, least] = [place, cost];
      }
    }
    return best;
  }

  /** How much a label there would be in the way of what others name, or be taken for theirs. */
  #harm(place: Place, width: number, own: Trace): number {
    const away = distance(place, own);
    let harm = 0;
    for (const name of this.#names) if (overlap(name, { ...place, width })) harm += HIDES;
    for (const trace of this.#traces) {
      if (trace === own) continue;
      if (covers(place, width, trace)) harm += COVERS;
      if (covers(place, width, trace.slice(-1))) harm += COVERS;
      if (distance(place, trace) < away) harm += NEARER;
    }
    return harm;
  }
}

function overlap(a: Box, b: Box): boolean {
  return Math.abs(a.x - b.x) < (a.width + b.width) / 2 && Math.abs(a.y - b.y) < 17;
}

/** The point of a trace at a share of its way. */
function pointOn(trace: Trace, share: number): Place {
  const at = share * (trace.length - 1);
  const i = Math.min(Math.floor(at), Math.max(trace.length - 2, 0));
  const [a, b] = [trace[i], trace[i + 1] ?? trace[i]];
  return { x: a.x + (at - i) * (b.x - a.x), y: a.y + (at - i) * (b.y - a.y) };
}

/** How far a point lies from the nearest one of a trace. */
function distance(place: Place, trace: Trace): number {
  let least = Infinity;
  for (let i = 0; i < Math.max(trace.length - 1, 1); i++) {
    const near = nearest(place, trace[i], trace[i + 1] ?? trace[i]);
    least = Math.min(least, Math.hypot(near.x - place.x, near.y - place.y));
  }
  return least;
}

/** Whether a label there lies over some of a trace. */
function covers({ x, y }: Place, width: number, trace: Trace): boolean {
  // Measured so that the label is the square from -1 to 1.
  const [across, up] = [width / 2, HALF_HEIGHT];
  const scaled = trace.map((corner) => ({ x: (corner.x - x) / across, y: (corner.y - y) / up }));
  for (let i = 0; i < Math.max(scaled.length - 1, 1); i++) {
    if (crosses(scaled[i], scaled[i + 1] ?? scaled[i])) return true;
  }
  return false;
}

/** Whether the line from a to b meets the square from -1 to 1: what is left of it between two walls, and two more. */
function crosses(a: Place, b: Place): boolean {
  let [from, to] = [0, 1];
  for (const axis of ['x', 'y'] as const) {
    const way = b[axis] - a[axis];
    if (way === 0) {
      if (Math.abs(a[axis]) > 1) return false;
      continue;
    }
    const walls = [(-1 - a[axis]) / way, (1 - a[axis]) / way];
    from = Math.max(from, Math.min(...walls));
    to = Math.min(to, Math.max(...walls));
  }
  return from <= to;
}

/** The point of the line from a to b that is nearest to a place. */
function nearest({ x, y }: Place, a: Place, b: Place): Place {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const share = ((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy || 1);
  const t = Math.min(1, Math.max(0, share));
  return { x: a.x + t * dx, y: a.y + t * dy };
}
