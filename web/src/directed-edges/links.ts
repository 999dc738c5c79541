import { unwatchGrowth, type Viewer, type Watch, watchGrowth } from '../growth.js';
import { type Halfedge, NONE as none } from '../items.js';
import { checkIndex, corrupt, wasDisposed } from '../links.js';
import type { Core } from '../loader.js';
import { after } from './walks.js';

// A constant of this module's own: see ../walks.ts.
const NONE: typeof none = none;

/** Frees what was forgotten rather than disposed of; see links.ts. */
const forgotten = new FinalizationRegistry<{ core: Core; address: number }>(({ core, address }) =>
  core.destroyDirectedEdges(address),
);
/** From each live view to the links whose memory it looks at: keeping a view keeps the memory. */
const owners = new WeakMap<object, DirectedLinks>();

const NO_LINKS = new Int32Array(0);
const NO_POSITIONS = new Float32Array(0);

/**
 * Live typed-array views of Directed Edges in WebAssembly memory; what `Links` is to a full mesh,
 * and apart from it, so that the code that reads either of them meets one kind of object only.
 *
 * Where a view was detached by growth of the memory, or where links are corrupt, the views, and what walks.ts
 * reads from them, give undefined or something negative, and never throw. Whoever gets that calls `revive()` or
 * `checkHalfedge(h)` and reads again.
 */
export class DirectedLinks implements Viewer {
  opposite: Int32Array = NO_LINKS;
  toVertex: Int32Array = NO_LINKS;
  boundaryNext: Int32Array = NO_LINKS;
  boundaryPrev: Int32Array = NO_LINKS;
  vertexHalfedge: Int32Array = NO_LINKS;
  positions: Float32Array = NO_POSITIONS;

  vertices = 0;
  halfedges = 0;
  /** Three for each face: halfedges from here on are boundary halfedges. */
  sides = 0;

  disposed = false;

  /** Called whenever the views were replaced: for whoever keeps them elsewhere. */
  onRefresh: (() => void) | undefined;

  readonly #core: Core;
  readonly #address: number;
  readonly #watch: Watch;
  /** Where the views lie. */
  readonly #addresses = new Uint32Array(6);

  /** Takes over the mesh at `address`, and frees it when disposed of or when garbage collected. */
  constructor(core: Core, address: number) {
    this.#core = core;
    this.#address = address;
    this.#watch = watchGrowth(this);
    forgotten.register(this, { core, address }, this);
    this.refresh();
  }

  /** Makes fresh views. Throws if disposed. */
  refresh(): void {
    this.checkAlive();
    const at = this.#core.directedEdgesLayout(this.#address) >>> 0;
    const words = new Uint32Array(this.#core.memory.buffer, at, this.#addresses.length + 3);
    this.#addresses.set(words.subarray(0, this.#addresses.length));
    [this.vertices, this.halfedges, this.sides] = words.subarray(this.#addresses.length);
    this.renewViews();
  }

  renewViews(): void {
    const { buffer } = this.#core.memory;
    const { vertices, halfedges, sides } = this;
    const addresses = this.#addresses;
    const owned = <View extends object>(view: View): View => {
      owners.set(view, this);
      return view;
    };
    const view = (field: number, length: number) =>
      length === 0 ? NO_LINKS : owned(new Int32Array(buffer, addresses[field], length));
    this.opposite = view(0, halfedges);
    this.toVertex = view(1, halfedges);
    this.boundaryNext = view(2, halfedges - sides);
    this.boundaryPrev = view(3, halfedges - sides);
    this.vertexHalfedge = view(4, vertices);
    this.positions =
      vertices === 0 ? NO_POSITIONS : owned(new Float32Array(buffer, addresses[5], 3 * vertices));
    this.onRefresh?.();
  }

  /** A view of the part of `toVertex` that is the index buffer of the faces. */
  indices(): Uint32Array {
    const { buffer, byteOffset } = this.toVertex;
    const view = new Uint32Array(buffer, byteOffset, this.sides);
    owners.set(view, this);
    return view;
  }

  /** Whether growth of the memory has detached the views; never true of an empty mesh. */
  get detached(): boolean {
    return this.vertexHalfedge.length !== this.vertices || this.opposite.length !== this.halfedges;
  }

  /** `refresh()` if the views are detached. Throws if the mesh is disposed. */
  revive(): void {
    this.checkAlive();
    if (this.detached) this.refresh();
  }

  /** Frees the memory of the mesh; every later use but this throws. */
  dispose(): void {
    if (this.disposed) return;
    forgotten.unregister(this);
    unwatchGrowth(this.#watch);
    this.#core.destroyDirectedEdges(this.#address);
    this.opposite = this.toVertex = this.boundaryNext = this.boundaryPrev = NO_LINKS;
    this.vertexHalfedge = NO_LINKS;
    this.positions = NO_POSITIONS;
    this.vertices = this.halfedges = this.sides = 0;
    this.disposed = true;
    this.onRefresh?.();
  }

  /** The address of the mesh for calls into the core. Throws if disposed. */
  get address(): number {
    this.checkAlive();
    return this.#address;
  }

  get core(): Core {
    return this.#core;
  }

  /** Throws if the mesh is disposed. */
  checkAlive(): void {
    if (this.disposed) throw wasDisposed();
  }

  // These throw a sentence unless there is such an item, and mend detached views on the way. One look-up tells for
  // numbers, as in ../links.ts.

  checkVertex(v: number, argument = 'v'): void {
    if (typeof v === 'number' && this.vertexHalfedge[v] >= NONE) return;
    this.revive();
    checkIndex('vertex', this.vertices, v, argument);
  }
  checkHalfedge(h: number, argument = 'h'): void {
    if (typeof h === 'number' && this.opposite[h] >= 0) return;
    this.revive();
    checkIndex('halfedge', this.halfedges, h, argument);
  }
  checkFace(f: number, argument = 'f'): void {
    if (typeof f === 'number' && (f | 0) === f && this.opposite[3 * f] >= 0 && 3 * f < this.sides)
      return;
    this.revive();
    checkIndex('face', this.sides / 3, f, argument);
  }
  checkEdge(e: number, argument = 'e'): void {
    if (typeof e === 'number' && this.opposite[e] > e) return;
    this.revive();
    checkIndex('edge', this.sides, e, argument);
    const opposite = this.opposite[e];
    if (opposite >= 0 && opposite < e) {
      throw new RangeError(
        `${argument} is ${e}, which is no edge; expected the smaller of its two halfedges, ${opposite}.`,
      );
    }
  }
}

/** One halfedge of each boundary loop, in ascending order. */
export function boundaryLoopsOf(links: DirectedLinks): Halfedge[] {
  links.revive();
  const { sides, halfedges } = links;
  const seen = new Uint8Array(halfedges - sides);
  const firsts: Halfedge[] = [];
  for (let first = sides; first < halfedges; first++) {
    if (seen[first - sides] === 1) continue;
    firsts.push(first as Halfedge);
    for (let h = first; seen[h - sides] !== 1; h = after(links, h)) {
      if (!(h >= sides && h < halfedges)) {
        throw corrupt(`The loop of halfedge ${first} does not close`);
      }
      seen[h - sides] = 1;
    }
  }
  return firsts;
}
