// The benchmark in Node.

import { setFlagsFromString } from 'node:v8';
import { HalfedgeMesh, init } from 'halfedge';
import manifoldModule from 'manifold-3d';
import * as three from 'three';
// By its path: under its name Node finds a CommonJS file without exports.
import * as threeMeshHalfedge from '../../node_modules/three-mesh-halfedge/build/index.esm.js';
import { runOperations } from './operations.mjs';
import { runSuite } from './suite.mjs';

export async function inNode(options) {
  setFlagsFromString('--no-concurrent-recompilation'); // see chromium.mjs
  await init();
  const manifold = await manifoldModule();
  manifold.setup();
  const libraries = { HalfedgeMesh, three, threeMeshHalfedge, manifold };
  return {
    engine: `Node ${process.version.slice(1)}`,
    results: await runSuite(libraries, options),
    operations: await runOperations(libraries, options),
  };
}
