import type { Ray } from 'three';
import { checkCallback } from '../checks.js';
import type { WorkerLike } from '../connection.js';
import { checkOptions, type OptionNames } from '../options.js';
import { TreeGrowth } from './tree-growth.js';
import {
  distanceToTriangle,
  type TriangleHit,
  type Triangles,
  TriangleTree,
} from './triangle-tree.js';

/** With more faces than these beside the tree, it is grown anew. */
const MOST_LOOSE = 3000;
/** A tree that has followed its triangles so many times is grown anew. */
const MOST_MOVES = 100;
/** Over fewer triangles, a tree is grown at once; over more, by a worker. */
const SMALL = 50_000;

/** The triangles that show the faces of a mesh, as they are now. */
export interface ShownFaces {
  /** xyz by vertex. */
  readonly points: Float32Array;
  /** In new arrays. */
  allTriangles(): Triangles;
  /** Three vertices for each triangle of a face; none if there is no such face. */
  triangleVertices(face: number): ArrayLike<number>;
}

/** How to build a search tree. */
export interface FaceTreeOptions {
  /**
   * Makes the worker that builds trees over many triangles, such as `newPickingWorker`: a worker that runs
   * `halfedge/three/picking-thread`, or null for none. Without a worker, trees are built at once.
   */
  worker?: (() => WorkerLike | null) | undefined;
  /** Fulfilled when the worker may begin, for example once a first picture is drawn. Default: at once. */
  begin?: (() => Promise<void>) | undefined;
}

export const FACE_TREE_OPTIONS: OptionNames<FaceTreeOptions> = { worker: true, begin: true };

/**
 * Finds the face that a ray hits first. After an edit, the triangles of changed faces are taken out of the
 * tree, and their new triangles are kept loose beside it. So an edit costs what it touched, whatever the size
 * of the mesh. Where most faces have changed, as at each step of an animation, nothing is done until the next
 * ray; if the faces have only moved, the tree then follows them, in a tenth of the time of building another.
 * Until a worker has built a first tree over many triangles, each ray is tested against all of them, which
 * takes some 15 ms for a million.
 */
export class FaceTree {
  readonly #makeWorker: () => WorkerLike | null;
  readonly #begin: (() => Promise<void>) | undefined;
  #tree: TriangleTree;
  /** By face that changed since: nine coordinates of each of its triangles. */
  readonly #loose = new Map<number, Float32Array>();
  /** The one that is growing. */
  #young: TreeGrowth | null = null;
  #shown: ShownFaces;
  /** Whether most faces have changed since the tree was as they are: the next ray takes them up. */
  #isBehind = false;
  /** How often the tree has followed its triangles since it was grown. */
  #moves = 0;
  #ready: Promise<void> = Promise.resolve();

  constructor(shown: ShownFaces, options: FaceTreeOptions = {}) {
    const { worker = () => null, begin } = checkOptions(options, FACE_TREE_OPTIONS);
    checkCallback('options.worker', worker, 'a function that makes a worker');
    checkCallback('options.begin', begin);
    this.#makeWorker = worker;
    this.#begin = begin;
    this.#shown = shown;
    this.#tree = new TriangleTree(shown.allTriangles());
    this.#grow(this.#tree);
  }

  /** Whether there is a tree already; if not, `cast` takes a while if there are many triangles. */
  get isGrown(): boolean {
    return this.#tree.isGrown;
  }

  /** Fulfilled when no tree is being built. */
  get ready(): Promise<void> {
    this.#catchUp();
    return this.#ready;
  }

  /** Takes over faces that now look different; null means all of them. */
  update(faces: Iterable<number> | null, shown: ShownFaces): void {
    this.#shown = shown;
    if (faces === null) {
      this.#fallBehind();
      this.#catchUp(); // at once, as there may be other triangles, over which a tree has to grow
      return;
    }
    if (this.#isBehind) return;
    const changed = Array.isArray(faces) ? (faces as readonly number[]) : [...faces];
    if (changed.length > MOST_LOOSE && 4 * changed.length > this.#tree.size) {
      this.#fallBehind();
      return;
    }
    for (const face of changed) {
      this.#tree.remove(face);
      this.#young?.tree.remove(face);
      this.#young?.changed.add(face);
      const vertices = shown.triangleVertices(face);
      if (vertices.length === 0) this.#loose.delete(face);
      else this.#loose.set(face, coordinates(shown.points, vertices));
    }
    if (this.#loose.size > MOST_LOOSE && this.#young === null) {
      this.#grow(new TriangleTree(shown.allTriangles()));
    }
  }

  /** The face that a ray hits first, from either side. */
  cast(ray: Ray): TriangleHit | null {
    this.#catchUp();
    let found = this.#tree.cast(ray);
    let least = found?.distance ?? Infinity;
    for (const [face, corners] of this.#loose) {
      for (let i = 0; i < corners.length; i += 9) {
        const distance = distanceToTriangle(ray, corners, i, i + 3, i + 6);
        if (distance >= least) continue;
        least = distance;
        found = { face, distance };
      }
    }
    return found;
  }

  /** Ends the worker, if one is running. None is started any more, and faces stay where rays last saw them. */
  dispose(): void {
    this.#isBehind = false;
    this.#young?.giveUp();
  }

  #fallBehind(): void {
    this.#isBehind = true;
    if (this.#young) this.#young.isBehind = true;
  }

  /** Takes over all faces as they are shown, if that was put off. */
  #catchUp(): void {
    if (!this.#isBehind) return;
    const triangles = this.#shown.allTriangles();
    this.#isBehind = false;
    this.#loose.clear();
    if (!this.#tree.follow(triangles)) {
      this.#tree = new TriangleTree(triangles);
      this.#grow(this.#tree);
      return;
    }
    this.#moves += 1;
    // Boxes grow where neighbours part.
    if (this.#moves >= MOST_MOVES && this.#young === null) this.#grow(new TriangleTree(triangles));
  }

  #grow(tree: TriangleTree): void {
    this.#young?.giveUp();
    this.#moves = 0;
    const young = new TreeGrowth(tree, () => this.#settle());
    this.#young = young;
    const worker = tree.size > SMALL ? this.#makeWorker() : null;
    if (worker === null) young.growHere();
    else this.#ready = young.growBy(worker, this.#begin);
  }

  /** The tree that has grown takes the place of the one before; loose are the faces that changed since. */
  #settle(): void {
    if (this.#young === null) return;
    const { tree, changed, isBehind } = this.#young;
    this.#young = null;
    this.#tree = tree;
    this.#isBehind ||= isBehind;
    for (const face of [...this.#loose.keys()]) if (!changed.has(face)) this.#loose.delete(face);
  }
}

function coordinates(points: Float32Array, vertices: ArrayLike<number>): Float32Array {
  const xyz = new Float32Array(3 * vertices.length);
  for (let i = 0; i < vertices.length; i++) {
    for (let k = 0; k < 3; k++) xyz[3 * i + k] = points[3 * vertices[i] + k];
  }
  return xyz;
}
