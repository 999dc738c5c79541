// The benchmark in Node.

import { setFlagsFromString } from 'node:v8';
import { HalfedgeMesh, init } from 'halfedge';
import manifoldModule from 'manifold-3d';
import * as three from 'three';
// By their paths: under their names Node finds files that it can't load.
import * as csg from '../../node_modules/three-bvh-csg/build/index.module.js';
import * as threeMeshHalfedge from '../../node_modules/three-mesh-halfedge/build/index.esm.js';
import { runOperations } from './operations.mjs';
import { runSuite } from './suite.mjs';

export async function inNode(options) {
  setFlagsFromString('--no-concurrent-recompilation'); // see chromium.mjs
  await init();
  const manifold = await manifoldModule();
  manifold.setup();
  const libraries = { HalfedgeMesh, three, threeMeshHalfedge, manifold, csg };
  return {
    engine: `Node ${process.version.slice(1)}`,
    results: await runSuite(libraries, options),
    operations: await runOperations(libraries, options),
  };
}
