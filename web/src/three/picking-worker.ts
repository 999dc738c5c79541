import type { WorkerLike } from '../connection.js';
import { newWorker } from '../new-worker.js';

/**
 * Starts a worker that builds the search trees of pickers; null where none can be started, such as in Node.
 * In a file of its own, because bundlers that see it include the script of the worker.
 */
export function newPickingWorker(): WorkerLike | null {
  if (typeof Worker === 'undefined') return null;
  try {
    return newWorker(
      'three/picking-thread.js',
      () => new Worker(new URL('./picking-thread.js', import.meta.url), { type: 'module' }),
      'pass { worker }',
    );
  } catch {
    return null;
  }
}
