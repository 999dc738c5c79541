// The script of a worker: grows trees for `halfedge/three/picking`.

import type { SerializedBVH } from 'three-mesh-bvh';
import { openPort } from '../port.js';
import { grownOver, type TreeSeed } from './triangle-tree.js';

const port = openPort<TreeSeed, SerializedBVH>();
port.listen((seed) => {
  const { grown, buffers } = grownOver(seed);
  port.post(grown, buffers);
});
