// The script of a worker: grows trees for `halfedge/three/picking`.

import { grownOver, type TreeSeed } from './triangle-tree.js';

interface Scope {
  postMessage(message: unknown, transfer: readonly object[]): void;
  addEventListener(type: 'message', listener: (event: { data: TreeSeed }) => void): void;
}

const scope = globalThis as unknown as Scope;
scope.addEventListener('message', ({ data }) => {
  const { grown, buffers } = grownOver(data);
  scope.postMessage(grown, buffers);
});
