import { describe, indices, listFrom, type NumberArray, refuseIndex } from './arguments.js';
import { HalfedgeError } from './errors.js';
import { unwatchGrowth, type Viewer, type Watch, watchGrowth } from './growth.js';
import { type ItemKind, NONE as none, PLURALS } from './items.js';
import type { Core } from './loader.js';

// A constant of this module's own: see walks.ts.
const NONE: typeof none = none;

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
const NO_WORDS = new Uint32Array(0);

/**
 * How many words `layout` writes, and how many of them say where arrays lie. Their order is that of
 * `write_layout` in wasm/bindings.h.
 */
const WORDS = 19;
const ADDRESSES = 7;
/** What the views hold beyond the last slot: neither an item nor NONE, as in a deleted slot. */
const BEYOND = -2;

/**
 * The views of the links, those of now, for as long as `version` stays as it is. Then they are empty for good:
 * whatever goes around by them finds nothing any more, and looks why. V8 has less to inline than to compare.
 */
export class Era {
  next: Int32Array = NO_LINKS;
  prev: Int32Array = NO_LINKS;
  toVertex: Int32Array = NO_LINKS;
  face: Int32Array = NO_LINKS;
  isOver = false;

  /** Looks at the memory where `links` do. */
  follow({ next, prev, toVertex, face }: Links): this {
    this.next = next;
    this.prev = prev;
    this.toVertex = toVertex;
    this.face = face;
    return this;
  }

  end(): void {
    this.next = this.prev = this.toVertex = this.face = NO_LINKS;
    this.isOver = true;
  }
}

/** One view, always that of now: growth of the mesh moves arrays, and no version tells of that. */
export interface Latest {
  view: Int32Array;
}

/** Slots of vertices, halfedges and faces. */
type Slots = [vertices: number, halfedges: number, faces: number];

/** Makes each of `slots` at least what is given. */
function raise(slots: Slots, vertices: number, halfedges: number, faces: number): void {
  if (slots[0] < vertices) slots[0] = vertices;
  if (slots[1] < halfedges) slots[1] = halfedges;
  if (slots[2] < faces) slots[2] = faces;
}

/**
 * Live zero-copy views of a mesh's links: index them with the items. Empty links are -1, deleted
 * slots hold other negative values. The links of edges need no array: the opposite of `h` is `h ^ 1`, its edge
 * `h >> 1`, and the halfedges of `e` are `2 * e` and `2 * e + 1`.
 */
export interface ConnectivityViews {
  /** By halfedge: the one after it in its face loop or boundary loop. */
  readonly next: Int32Array;
  /** By halfedge: the one before it. Empty without `storePrev`. */
  readonly prev: Int32Array;
  /** By halfedge: the vertex it points to. */
  readonly toVertex: Int32Array;
  /** By halfedge: the face on its left, -1 for a boundary halfedge. */
  readonly face: Int32Array;
  /** By vertex: one halfedge that leaves it, the anchor; -1 for an isolated vertex. */
  readonly vertexHalfedge: Int32Array;
  /** By face: one halfedge of it. */
  readonly faceHalfedge: Int32Array;
}

/**
 * Live typed-array views of one mesh's links in WebAssembly memory, shared by the mesh and its
 * iterators. This is what makes navigation fast: nothing crosses into WebAssembly per step.
 *
 * Hot code reads a view and looks whether what it gets is the number of an item, in one more view:
 * ```ts
 * const r = links.next[h];
 * return links.next[r] !== undefined ? r : slow(h);
 * ```
 * `undefined` (out of range, a fraction, not a number, or a view that growth of the memory has
 * detached), and what a deleted slot stores (below -1) all number nothing. The slow path calls
 * `checkHalfedge(h)`, which mends detached views or throws the sentence, and reads again. Only
 * `face`, and the anchor of an isolated vertex, are -1 in a sound mesh. Why so, and not `r >= 0`:
 * see laps.ts.
 *
 * Views detach only while WebAssembly allocates, so a loop that calls none of it may keep a view in
 * a local variable. All of them are empty after `dispose`.
 *
 * So that an edit doesn't need new views, they reach over all the room that the arrays have. Beyond
 * the last slot they hold -2, which numbers nothing, either: whoever needs a length asks for the
 * slots. A user gets `exactViews` and `positions`.
 */
export class Links implements Viewer {
  next: Int32Array = NO_LINKS;
  /** Empty where it isn't stored: see `findPrev`. */
  prev: Int32Array = NO_LINKS;
  toVertex: Int32Array = NO_LINKS;
  face: Int32Array = NO_LINKS;
  vertexHalfedge: Int32Array = NO_LINKS;
  faceHalfedge: Int32Array = NO_LINKS;

  /** Live and deleted items: the range of indices. Right even while the views are detached. */
  vertexSlots = 0;
  halfedgeSlots = 0;
  faceSlots = 0;
  /** Live items. */
  vertexCount = 0;
  edgeCount = 0;
  faceCount = 0;

  /** For whatever goes around: it looks at the era in which it was made. */
  era = new Era();
  /** For whatever keeps `vertexHalfedge`, `faceHalfedge` or `next`. */
  readonly vertexAnchors: Latest = { view: NO_LINKS };
  readonly faceAnchors: Latest = { view: NO_LINKS };
  readonly nextLinks: Latest = { view: NO_LINKS };
  disposed = false;
  /** Whether the mesh has the array prev. */
  storesPrev = true;

  /** Called whenever the views were replaced: for whoever keeps them elsewhere. */
  onRefresh: (() => void) | undefined;

  /** How deep in groups of history the mesh is: the next edit ends no step where that is not 0. */
  groups = 0;

  /** Another number after each call that may have changed or moved something. */
  changes = 0;

  /**
   * The most slots that there were between the edits of the last group, and in any group that had fewer
   * both before and after.
   */
  #most: Slots = [0, 0, 0];
  readonly #passed: Slots = [0, 0, 0];
  #atStart: Slots = [0, 0, 0];

  readonly #core: Core;
  readonly #address: number;
  readonly #watch: Watch;
  #version = 0;
  /** What `layout` wrote, in place; and the addresses and rooms among it for which the views were made. */
  #words = NO_WORDS;
  #wordsAt = 0;
  readonly #taken = new Uint32Array(ADDRESSES);
  readonly #rooms = { vertices: 0, halfedges: 0, faces: 0 };
  #exact: ConnectivityViews | undefined;
  #positions = NO_POSITIONS;

  /** Takes over the mesh at `address`, and frees it when disposed of or when garbage collected. */
  constructor(core: Core, address: number) {
    this.#core = core;
    this.#address = address;
    this.#watch = watchGrowth(this);
    forgotten.register(this, { core, address }, this);
    this.refresh();
  }

  /** Makes fresh views, when arrays have moved or grown. Throws if disposed. */
  refresh(): void {
    this.checkAlive();
    this.#wordsAt = this.#core.layout(this.#address) >>> 0;
    const words = new Uint32Array(this.#core.memory.buffer, this.#wordsAt, WORDS);
    this.#taken.set(words.subarray(0, ADDRESSES));
    [this.#rooms.vertices, this.#rooms.halfedges, this.#rooms.faces] = words.subarray(16, 19);
    this.storesPrev = words[15] !== 0;
    this.#takeCounts(words);
    this.renewViews();
    const { vertices, halfedges, faces } = this.#rooms;
    this.#emptyBeyond(vertices, halfedges, faces);
  }

  renewViews(): void {
    const { buffer } = this.#core.memory;
    const { vertices, halfedges, faces } = this.#rooms;
    const view = (field: number, room: number) =>
      room === 0 ? NO_LINKS : this.own(new Int32Array(buffer, this.#taken[field], room));
    this.#words = new Uint32Array(buffer, this.#wordsAt, WORDS);
    this.next = view(0, halfedges);
    this.prev = view(1, this.storesPrev ? halfedges : 0);
    this.toVertex = view(2, halfedges);
    this.face = view(3, halfedges);
    this.vertexHalfedge = view(4, vertices);
    this.faceHalfedge = view(5, faces);
    this.era.follow(this);
    this.vertexAnchors.view = this.vertexHalfedge;
    this.faceAnchors.view = this.faceHalfedge;
    this.nextLinks.view = this.next;
    this.#exact = undefined;
    this.#positions = NO_POSITIONS;
    this.changes += 1;
    this.onRefresh?.();
  }

  /**
   * Takes up what a call into the core has changed, which has left the words of `layout` behind. It
   * costs next to nothing unless arrays have moved.
   */
  update(): void {
    if (this.groups > 0) raise(this.#most, this.vertexSlots, this.halfedgeSlots, this.faceSlots);
    const words = this.#words;
    if (this.#haveMoved(words)) {
      this.refresh();
      return;
    }
    this.changes += 1;
    const { vertexSlots, halfedgeSlots, faceSlots } = this;
    this.#takeCounts(words);
    if (this.detached) this.refresh(); // arrays that have grown where they were
    this.#emptyBeyond(vertexSlots, halfedgeSlots, faceSlots);
  }

  /** Begins a group of edits that are one step of history, or one within it. */
  beginGroup(): void {
    if (this.groups === 0) {
      this.#atStart = [this.vertexSlots, this.halfedgeSlots, this.faceSlots];
      this.#most = [0, 0, 0];
    }
    this.groups += 1;
  }

  /** Ends what `beginGroup` has begun. */
  endGroup(): void {
    this.groups -= 1;
    if (this.groups > 0) return;
    const ends = this.#atStart;
    raise(ends, this.vertexSlots, this.halfedgeSlots, this.faceSlots);
    const [vertices, halfedges, faces] = this.#most.map((most, i) => (most > ends[i] ? most : 0));
    raise(this.#passed, vertices, halfedges, faces);
  }

  /**
   * As `update`, after a step of history was undone or done again. If it is a group that has added items
   * and then closed gaps, that went through more slots than there are now, and left what they held.
   */
  updateAfterTravel(): void {
    this.update();
    const [vertices, halfedges, faces] = this.#passed;
    this.#emptyBeyond(vertices, halfedges, faces);
  }

  /** Empties what lies beyond the slots that there are, up to so many: not all the room, which may be large. */
  #emptyBeyond(vertices: number, halfedges: number, faces: number): void {
    const { vertexSlots, halfedgeSlots, faceSlots } = this;
    if (vertices > vertexSlots) this.vertexHalfedge.fill(BEYOND, vertexSlots, vertices);
    if (faces > faceSlots) this.faceHalfedge.fill(BEYOND, faceSlots, faces);
    if (halfedges <= halfedgeSlots) return;
    for (const links of [this.next, this.prev, this.toVertex, this.face]) {
      links.fill(BEYOND, halfedgeSlots, halfedges);
    }
  }

  /** Also true if the memory has grown, which has detached the words. */
  #haveMoved(words: Uint32Array): boolean {
    const taken = this.#taken;
    for (let i = 0; i < ADDRESSES; i++) if (words[i] !== taken[i]) return true;
    return false;
  }

  #takeCounts(words: Uint32Array): void {
    this.vertexSlots = words[7];
    this.halfedgeSlots = words[8];
    this.faceSlots = words[9];
    this.vertexCount = words[10];
    this.edgeCount = words[11];
    this.faceCount = words[12];
    this.version = words[13] + 2 ** 32 * words[14];
  }

  /** Whether growth of the memory has detached the views; never true of an empty mesh. */
  get detached(): boolean {
    return (
      this.vertexHalfedge.length < this.vertexSlots ||
      this.next.length < this.halfedgeSlots ||
      this.faceHalfedge.length < this.faceSlots
    );
  }

  /** `refresh()` if the views are detached. Throws if the mesh is disposed. */
  revive(): void {
    this.checkAlive();
    if (this.detached) this.refresh();
  }

  /** The views for a user; the same object as long as they are good. */
  get exactViews(): ConnectivityViews {
    this.revive();
    const { vertexSlots, halfedgeSlots, faceSlots } = this;
    const kept = this.#exact;
    if (
      kept !== undefined &&
      kept.vertexHalfedge.length === vertexSlots &&
      kept.next.length === halfedgeSlots &&
      kept.faceHalfedge.length === faceSlots
    ) {
      return kept;
    }
    const exact = (links: Int32Array, slots: number) =>
      links.length <= slots ? links : this.own(links.subarray(0, slots));
    this.#exact = Object.freeze({
      next: exact(this.next, halfedgeSlots),
      prev: exact(this.prev, halfedgeSlots),
      toVertex: exact(this.toVertex, halfedgeSlots),
      face: exact(this.face, halfedgeSlots),
      vertexHalfedge: exact(this.vertexHalfedge, vertexSlots),
      faceHalfedge: exact(this.faceHalfedge, faceSlots),
    });
    return this.#exact;
  }

  /** The positions of exactly the slots that there are; the same view as long as it is good. */
  get positions(): Float32Array {
    const kept = this.#positions;
    if (kept.length !== 0 && kept.length === 3 * this.vertexSlots) return kept;
    this.revive();
    if (this.vertexSlots === 0) return NO_POSITIONS;
    this.#positions = this.own(
      new Float32Array(this.#core.memory.buffer, this.#taken[6], 3 * this.vertexSlots),
    );
    return this.#positions;
  }

  /** Keeps the memory of the mesh alive as long as there is `view`, which is returned. */
  own<View extends object>(view: View): View {
    owners.set(view, this);
    return view;
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

  /** What `use` makes with it. Frees the memory of the mesh if that throws. */
  orDispose<T>(use: (links: this) => T): T {
    try {
      return use(this);
    } catch (error) {
      this.dispose();
      throw error;
    }
  }

  /** Frees the memory of the mesh; every later use but this throws. */
  dispose(): void {
    if (this.disposed) return;
    forgotten.unregister(this);
    unwatchGrowth(this.#watch);
    this.#core.destroyMesh(this.#address);
    this.next = this.prev = this.toVertex = this.face = NO_LINKS;
    this.vertexHalfedge = this.faceHalfedge = NO_LINKS;
    this.vertexAnchors.view = this.faceAnchors.view = this.nextLinks.view = NO_LINKS;
    this.#positions = NO_POSITIONS;
    this.#words = NO_WORDS;
    this.#exact = undefined;
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
    this.era.end();
    this.era = new Era().follow(this);
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

  // Each look-up tells what is live, for numbers: detached views have nothing, nor have others at what is no index, and
  // what is beyond the last slot is as little live as what was deleted. The rest is for sentences.

  /** Throws a sentence unless `v` is a live vertex; mends detached views on the way. */
  checkVertex(v: number, argument = 'v'): void {
    if (typeof v === 'number' && this.vertexHalfedge[v] >= NONE) return;
    this.#check('vertex', this.vertexSlots, v, argument);
    if (this.vertexHalfedge[v] < -1) throw deleted('vertex', v, argument);
  }

  /** Throws a sentence unless `h` is a live halfedge; mends detached views on the way. */
  checkHalfedge(h: number, argument = 'h'): void {
    if (typeof h === 'number' && this.next[h] >= 0) return;
    this.#check('halfedge', this.halfedgeSlots, h, argument);
    if (this.next[h] < -1) throw deleted('halfedge', h, argument);
  }

  /** Throws a sentence unless `e` is a live edge; mends detached views on the way. */
  checkEdge(e: number, argument = 'e'): void {
    if (typeof e === 'number' && (e | 0) === e && this.next[2 * e] >= 0) return;
    this.#check('edge', this.halfedgeSlots / 2, e, argument);
    if (this.next[2 * e] < -1) throw deleted('edge', e, argument);
  }

  /** Throws a sentence unless `f` is a live face; mends detached views on the way. */
  checkFace(f: number, argument = 'f'): void {
    if (typeof f === 'number' && this.faceHalfedge[f] >= 0) return;
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
export function wasDisposed(mesh = 'This mesh'): HalfedgeError {
  return new HalfedgeError(
    'disposed',
    `${mesh} was disposed: its memory is freed, and nothing can be asked of it any more.`,
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

/** Live and deleted items of a kind: the range of their indices. */
export function slotCount(links: Links, kind: ItemKind): number {
  if (kind === 'vertex') return links.vertexSlots;
  if (kind === 'face') return links.faceSlots;
  return kind === 'edge' ? links.halfedgeSlots / 2 : links.halfedgeSlots;
}

/** Throws a sentence unless `item` is a live item of the kind. */
export function checkItem(links: Links, kind: ItemKind, item: number, argument = 'item'): void {
  if (kind === 'vertex') links.checkVertex(item, argument);
  else if (kind === 'halfedge') links.checkHalfedge(item, argument);
  else if (kind === 'edge') links.checkEdge(item, argument);
  else links.checkFace(item, argument);
}

/** The list of items that an argument is. Throws a sentence for the first that is no live item of the kind. */
export function listOfItems(
  links: Links,
  kind: 'vertex' | 'edge' | 'face',
  argument: string,
  value: unknown,
): NumberArray {
  const refuseItem = (name: string, i: number, item: unknown): never => {
    checkItem(links, kind, item as number, `${name}[${i}]`);
    return refuseIndex(name, i, item);
  };
  const list = indices(argument, listFrom(value), refuseItem, `an array of ${PLURALS[kind]}`);
  links.revive();
  const starts = { vertex: links.vertexHalfedge, edge: links.next, face: links.faceHalfedge }[kind];
  const stride = kind === 'edge' ? 2 : 1;
  for (let i = 0; i < list.length; i++) {
    if (!(starts[stride * list[i]] >= NONE)) checkItem(links, kind, list[i], `${argument}[${i}]`);
  }
  return list;
}

/** Whether there is such an item, and it was not deleted. Mends detached views on the way. */
export function isLive(links: Links, kind: ItemKind, index: number): boolean {
  links.revive();
  if (!Number.isInteger(index)) return false;
  if (kind === 'vertex') return links.vertexHalfedge[index] >= NONE;
  if (kind === 'face') return links.faceHalfedge[index] >= NONE;
  return links.next[kind === 'edge' ? 2 * index : index] >= NONE;
}
