import { newWorker, type WorkerLike } from '../thread.js';

/**
 * Starts a worker that grows the trees of pickers; null where none can be started, such as in Node. A file of
 * its own: bundlers that see it take the script of the worker along.
 */
export function newPickingWorker(): WorkerLike | null {
  if (typeof Worker === 'undefined') return null;
  try {
    return newWorker(
      'three/picking-thread.js',
      () => new Worker(new URL('./picking-thread.js', import.meta.url), { type: 'module' }),
    );
  } catch {
    return null;
  }
}
