import { describe } from './arguments.js';
import { HalfedgeError } from './errors.js';
import { type ItemKind, NONE } from './items.js';
import type { Core } from './loader.js';

/**
 * Frees the meshes that were forgotten rather than disposed of. Watches the links, not the mesh:
 * iterators and live views keep the links alive, and so the memory under them.
 */
const forgotten = new FinalizationRegistry<{ core: Core; address: number }>(({ core, address }) =>
  core.destroyMesh(address),
);
/** From each live view to the links whose memory it looks at: keeping a view keeps the memory. */
const owners = new WeakMap<object, Links>();

const NO_LINKS = new Int32Array(0);
const NO_POSITIONS = new Float32Array(0);

/**
 * Live typed-array views of one mesh's links in WebAssembly memory, shared by the mesh and its
 * iterators. This is what makes navigation fast: nothing crosses into WebAssembly per step.
 *
 * Hot code reads a view and looks at the sign of what it gets, once:
 * ```ts
 * const r = links.next[h];
 * return r >= 0 ? r : slow(h);
 * ```
 * `undefined` (out of range, a fraction, not a number, or a view that growth of the memory has
 * detached), and what a deleted slot stores (below -1) all fail that one comparison. The slow path
 * calls `checkHalfedge(h)`, which mends detached views or throws the sentence, and reads again. Only
 * `face`, and the anchor of an isolated vertex, are -1 in a sound mesh.
 *
 * Views detach only while WebAssembly allocates, so a loop that calls none of it may keep a view in
 * a local variable. All of them are empty after `dispose`.
 */
export class Links {
  next: Int32Array = NO_LINKS;
  /** Empty where it isn't stored: see `findPrev`. */
  prev: Int32Array = NO_LINKS;
  toVertex: Int32Array = NO_LINKS;
  face: Int32Array = NO_LINKS;
  vertexHalfedge: Int32Array = NO_LINKS;
  faceHalfedge: Int32Array = NO_LINKS;
  positions: Float32Array = NO_POSITIONS;

  /** Live and deleted items: the range of indices. Right even while the views are detached. */
  vertexSlots = 0;
  halfedgeSlots = 0;
  faceSlots = 0;
  /** Live items. */
  vertexCount = 0;
  edgeCount = 0;
  faceCount = 0;

  /** Over as soon as `version` has changed. Circulators ask this: V8 has less to inline than to compare. */
  era = { over: false };
  disposed = false;
  /** Whether the mesh has the array prev. */
  storesPrev = true;

  /** Called whenever the views were replaced: for whoever keeps them elsewhere. */
  onRefresh: (() => void) | undefined;

  readonly #core: Core;
  readonly #address: number;
  #version = 0;

  /** Takes over the mesh at `address`, and frees it when disposed of or when garbage collected. */
  constructor(core: Core, address: number) {
    this.#core = core;
    this.#address = address;
    forgotten.register(this, { core, address }, this);
    this.refresh();
  }

  /** Makes fresh views, after growth of the memory or after a change of the mesh. Throws if disposed. */
  refresh(): void {
    this.checkAlive();
    const { memory } = this.#core;
    const at = this.#core.layout(this.#address) >>> 2;
    const words = new Uint32Array(memory.buffer);
    const [vertices, halfedges, faces] = [words[at + 7], words[at + 8], words[at + 9]];
    const owned = <View extends object>(view: View): View => {
      owners.set(view, this);
      return view;
    };
    const view = (field: number, length: number) =>
      length === 0 ? NO_LINKS : owned(new Int32Array(memory.buffer, words[at + field], length));
    this.next = view(0, halfedges);
    this.storesPrev = words[at + 15] !== 0;
    this.prev = this.storesPrev ? view(1, halfedges) : NO_LINKS;
    this.toVertex = view(2, halfedges);
    this.face = view(3, halfedges);
    this.vertexHalfedge = view(4, vertices);
    this.faceHalfedge = view(5, faces);
    this.positions =
      vertices === 0
        ? NO_POSITIONS
        : owned(new Float32Array(memory.buffer, words[at + 6], 3 * vertices));
    this.vertexSlots = vertices;
    this.halfedgeSlots = halfedges;
    this.faceSlots = faces;
    this.vertexCount = words[at + 10];
    this.edgeCount = words[at + 11];
    this.faceCount = words[at + 12];
    this.version = words[at + 13] + 2 ** 32 * words[at + 14];
    this.onRefresh?.();
  }

  /** Whether growth of the memory has detached the views; never true of an empty mesh. */
  get detached(): boolean {
    return (
      this.vertexHalfedge.length !== this.vertexSlots || this.next.length !== this.halfedgeSlots
    );
  }

  /** `refresh()` if the views are detached. Throws if the mesh is disposed. */
  revive(): void {
    this.checkAlive();
    if (this.detached) this.refresh();
  }

  /**
   * prev of `h` where it isn't stored: around the loop of `h` and around its vertex in step, the shorter
   * of the two ends the search. NONE where the links are corrupt.
   */
  findPrev(h: number): number {
    const { next } = this;
    let inLoop = h;
    let atVertex = h;
    for (let left = next.length; left > 0; left--) {
      const after = next[inLoop];
      if (after === h) return inLoop;
      const rotated = next[atVertex ^ 1];
      if (rotated === h) return atVertex ^ 1;
      if (!(after >= 0 && rotated >= 0)) break;
      inLoop = after;
      atVertex = rotated;
    }
    return NONE;
  }

  /** Frees the memory of the mesh; every later use but this throws. */
  dispose(): void {
    if (this.disposed) return;
    forgotten.unregister(this);
    this.#core.destroyMesh(this.#address);
    this.next = this.prev = this.toVertex = this.face = NO_LINKS;
    this.vertexHalfedge = this.faceHalfedge = NO_LINKS;
    this.positions = NO_POSITIONS;
    this.vertexSlots = this.halfedgeSlots = this.faceSlots = 0;
    this.vertexCount = this.edgeCount = this.faceCount = 0;
    this.version += 1;
    this.disposed = true;
    this.onRefresh?.();
  }

  /** Changes with every change of connectivity, and with `dispose`. */
  get version(): number {
    return this.#version;
  }

  set version(version: number) {
    if (version === this.#version) return;
    this.#version = version;
    this.era.over = true;
    this.era = { over: false };
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
    if (this.disposed) throw disposedError();
  }

  /** Throws a sentence unless `v` is a live vertex; mends detached views on the way. */
  checkVertex(v: number, argument = 'v'): void {
    this.#check('vertex', this.vertexSlots, v, argument);
    if (this.vertexHalfedge[v] < -1) throw deleted('vertex', v, argument);
  }

  /** Throws a sentence unless `h` is a live halfedge; mends detached views on the way. */
  checkHalfedge(h: number, argument = 'h'): void {
    this.#check('halfedge', this.halfedgeSlots, h, argument);
    if (this.next[h] < -1) throw deleted('halfedge', h, argument);
  }

  /** Throws a sentence unless `e` is a live edge; mends detached views on the way. */
  checkEdge(e: number, argument = 'e'): void {
    this.#check('edge', this.halfedgeSlots / 2, e, argument);
    if (this.next[2 * e] < -1) throw deleted('edge', e, argument);
  }

  /** Throws a sentence unless `f` is a live face; mends detached views on the way. */
  checkFace(f: number, argument = 'f'): void {
    this.#check('face', this.faceSlots, f, argument);
    if (this.faceHalfedge[f] < -1) throw deleted('face', f, argument);
  }

  #check(kind: ItemKind, slots: number, index: number, argument: string): void {
    this.revive();
    checkIndex(kind, slots, index, argument);
  }
}

/** Throws a sentence unless `index` is an integer from 0 that is less than `slots`. */
export function checkIndex(kind: ItemKind, slots: number, index: number, argument: string): void {
  const article = kind === 'edge' ? 'an' : 'a';
  if (typeof index !== 'number') {
    throw new TypeError(
      `${argument} is ${describe(index)}; expected ${article} ${kind}, which is an integer.`,
    );
  }
  if (Number.isInteger(index) && index >= 0 && index < slots) return;
  const range = slots === 0 ? ', but this mesh has none' : ` from 0 to ${slots - 1}`;
  throw new RangeError(`${argument} is ${describe(index)}; expected ${article} ${kind}${range}.`);
}

/** The error for any use of a mesh after `dispose()`. */
export function disposedError(): HalfedgeError {
  return new HalfedgeError(
    'disposed',
    'This mesh was disposed: its memory is freed, and nothing can be asked of it any more.',
  );
}

function deleted(kind: ItemKind, index: number, argument: string): RangeError {
  return new RangeError(`${argument} is ${kind} ${index}, which was deleted; expected a live one.`);
}

/**
 * The error for links that lead nowhere. It takes writing into the live views, or low-level edits
 * left half done, to get here: the library's own changes keep the links sound.
 */
export function corrupt(what: string): HalfedgeError {
  return new HalfedgeError(
    'corrupt-connectivity',
    `${what}; the links of this mesh are corrupt: were its live views written to? validate() tells more.`,
  );
}
