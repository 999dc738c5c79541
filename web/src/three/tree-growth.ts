import type { SerializedBVH } from 'three-mesh-bvh';
import { connect, type Thread, type WorkerLike } from '../connection.js';
import type { TriangleTree } from './triangle-tree.js';

/** A tree while it grows: at once, or by a worker, which ends when it has. */
export class TreeGrowth {
  readonly tree: TriangleTree;
  /** The faces that have changed since it began. */
  readonly changed = new Set<number>();
  /** Whether most faces have. */
  isBehind = false;
  readonly #settle: () => void;
  /** None before there is a worker, and none once it has ended. */
  #thread: Thread | null = null;
  #resolve = () => {};

  /** Calls `settle` when the tree has grown. */
  constructor(tree: TriangleTree, settle: () => void) {
    this.tree = tree;
    this.#settle = settle;
  }

  /** Grows it at once. */
  growHere(): void {
    this.tree.grow();
    this.#settle();
  }

  /** Has it grown by a worker, once `begin` is fulfilled. Fulfilled when it has, or is given up. */
  growBy(worker: WorkerLike, begin: (() => Promise<void>) | undefined): Promise<void> {
    return new Promise((resolve) => {
      this.#resolve = resolve;
      this.#thread = connect(worker, {
        message: (data) => this.#end(() => this.#adopt(data as SerializedBVH)),
        // From some sites no worker can be started that imports three.js.
        failure: () => this.#fail(),
      });
      this.#thread.keepAlive(true);
      if (begin) {
        void begin().then(
          () => this.#post(),
          () => this.#fail(),
        );
      } else this.#post();
    });
  }

  /** Ends the worker, if one is running: the tree stays as it is. */
  giveUp(): void {
    this.#end(() => {});
  }

  #post(): void {
    if (this.#thread === null) return; // given up in the meantime
    const { seed } = this.tree;
    this.#thread.post(seed, [seed.points.buffer, seed.vertices.buffer]);
  }

  #adopt(grown: SerializedBVH): void {
    try {
      this.tree.adopt(grown);
    } catch {
      this.growHere(); // it has another release of three-mesh-bvh, or another script
      return;
    }
    this.#settle();
  }

  #fail(): void {
    this.#end(() => this.growHere());
  }

  #end(use: () => void): void {
    const thread = this.#thread;
    if (thread === null) return; // a worker of Node tells of its end, too
    this.#thread = null;
    thread.terminate();
    use();
    this.#resolve();
  }
}
