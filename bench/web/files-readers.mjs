// Readers of files, ours and three.js's, and how they are measured.

import { cpuUsage } from 'node:process';
import { HalfedgeMesh } from 'halfedge';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';

/** A contender whose first run takes longer has no other. */
const HOPELESS = 4000;

const text = (bytes) => new TextDecoder().decode(bytes);

/** The geometries that three.js makes of a file. It has no loader of OFF. */
const GEOMETRIES = {
  stl: (bytes) => [new STLLoader().parse(bytes.buffer)],
  ply: (bytes) => [new PLYLoader().parse(bytes.buffer)],
  obj: (bytes) =>
    new OBJLoader()
      .parse(text(bytes))
      .children.flatMap((child) => (child.isMesh ? child.geometry : [])),
};

/**
 * Each takes the bytes of a file, and returns the number of its triangles, or `build` of its faces:
 * `read` and `build` are ours, `load` and `weld` are three.js's.
 */
export function readersOf(format) {
  const load = GEOMETRIES[format];
  return {
    read: readWith(format === 'stl' ? { weld: false } : {}),
    ...(load && { load: (bytes) => sum(load(bytes), trianglesIn) }),
    build,
    // Those of PLY share their vertices as they are.
    ...(load &&
      format !== 'ply' && {
        weld: (bytes) => sum(load(bytes), (geometry) => trianglesIn(welded(geometry))),
      }),
  };
}

function readWith(options) {
  return (bytes) => {
    const { sizes, corners } = HalfedgeMesh.parseSoup(bytes, options).faces;
    return corners.length - 2 * sizes.length;
  };
}

function build(bytes) {
  const { mesh } = HalfedgeMesh.parse(bytes);
  const { faceCount } = mesh;
  mesh.dispose();
  return faceCount;
}

const sum = (list, size) => list.reduce((total, item) => total + size(item), 0);
const trianglesIn = ({ index, attributes }) => (index ?? attributes.position).count / 3;

/** With normals three.js would keep apart what lies on edges: positions are welded by themselves. */
function welded(geometry) {
  for (const name of Object.keys(geometry.attributes)) {
    if (name !== 'position') geometry.deleteAttribute(name);
  }
  return mergeVertices(geometry);
}

/**
 * The median of each for all files together, in rounds in which one comes after the other. All of
 * them must find so many triangles, if that is given.
 */
export function measure(readers, files, rounds, expected) {
  const times = Object.fromEntries(Object.keys(readers).map((who) => [who, []]));
  for (let round = 0; round <= rounds; round++) {
    for (const [who, use] of Object.entries(readers)) {
      if (times[who][0] > HOPELESS) continue;
      globalThis.gc?.();
      const begin = cpuUsage();
      const found = sum(files, use);
      const { user, system } = cpuUsage(begin);
      if (expected !== undefined && found !== expected) {
        throw new Error(`${who} found ${found} triangles, expected ${expected}.`);
      }
      times[who].push((user + system) / 1000);
    }
  }
  return Object.fromEntries(
    Object.entries(times).map(([who, list]) => {
      const warm = list.length > 1 ? list.slice(1) : list;
      return [who, warm.sort((a, b) => a - b)[warm.length >> 1]];
    }),
  );
}

export function digits(value) {
  return value >= 99.5 ? Math.round(value).toLocaleString('en-GB') : value.toPrecision(2);
}
