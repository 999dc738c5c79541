// What runs in Node: it is sent options, and sends the name of each mesh and then what was measured.

import { HalfedgeMesh, init } from 'halfedge';
import manifoldModule from 'manifold-3d';
import * as three from 'three';
// By their paths: under their names Node finds files that it can't load.
import * as csg from '../../node_modules/three-bvh-csg/build/index.module.js';
import * as threeMeshHalfedge from '../../node_modules/three-mesh-halfedge/build/index.esm.js';
import { runOperations } from './operations.mjs';
import { runSuite } from './suite.mjs';

process.once('message', async (options) => {
  await init();
  const manifold = await manifoldModule();
  manifold.setup();
  const libraries = { HalfedgeMesh, three, threeMeshHalfedge, manifold, csg };
  const say = (name) => process.send({ name });
  const results = await runSuite(libraries, { ...options, say });
  process.send({ results, operations: await runOperations(libraries, options) });
  process.disconnect();
});
