// `npm run bench:files`: reading files, ours against three.js's loaders, in Node. CPU time, since it
// must not matter what else the machine does. Prints Markdown. --quick takes a small mesh.

import { argv, cpuUsage, versions } from 'node:process';
import { HalfedgeMesh, init } from 'halfedge';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';
import { grid } from './meshes.mjs';

/** A contender whose first run takes longer has no other. */
const HOPELESS = 4000;
const ROUNDS = argv.includes('--quick') ? 3 : 7;
const side = argv.includes('--quick') ? 64 : 708;

await init();
const { positions, triangles } = grid(side);
const mesh = HalfedgeMesh.fromTriangles(positions, triangles);
const text = (bytes) => new TextDecoder().decode(bytes);

/** Each gets the bytes of a file, and returns the number of its triangles. */
const read = (options) => (bytes) =>
  HalfedgeMesh.parseSoup(bytes, options).faces.corners.length / 3;
const build = (bytes) => {
  const { mesh: built } = HalfedgeMesh.parse(bytes);
  const { faceCount } = built;
  built.dispose();
  return faceCount;
};
const trianglesIn = ({ index, attributes }) => (index ?? attributes.position).count / 3;
const geometryOf = {
  stl: (bytes) => new STLLoader().parse(bytes.buffer),
  ply: (bytes) => new PLYLoader().parse(bytes.buffer),
  obj: (bytes) => new OBJLoader().parse(text(bytes)).children[0].geometry,
};

/** With normals three.js would keep apart what lies on edges: positions are welded by themselves. */
function welded(geometry) {
  for (const name of Object.keys(geometry.attributes)) {
    if (name !== 'position') geometry.deleteAttribute(name);
  }
  return mergeVertices(geometry);
}

const FILES = [
  ['STL, binary', 'stl', 'binary', { weld: false }],
  ['STL, text', 'stl', 'text', { weld: false }],
  ['PLY, binary', 'ply', 'binary', {}],
  ['PLY, text', 'ply', 'text', {}],
  ['OBJ', 'obj', 'text', {}],
  ['OFF, text', 'off', 'text', {}],
  ['OFF, binary', 'off', 'binary', {}],
];

console.log(`Node ${versions.node}; ${mesh.faceCount.toLocaleString('en-GB')} triangles\n`);
console.log(
  '| ms of CPU | MB | read | three.js reads | read and build | three.js reads and welds |',
);
console.log('| --- | ---: | ---: | ---: | ---: | ---: |');
for (const [title, format, encoding, options] of FILES) {
  const written = mesh.write(format, { encoding });
  const bytes = typeof written === 'string' ? new TextEncoder().encode(written) : written.slice();
  const load = geometryOf[format];
  const run = {
    read: read(options),
    ...(load && { load: (file) => trianglesIn(load(file)) }),
    build,
    // Those of PLY share their vertices as they are.
    ...(load && format !== 'ply' && { weld: (file) => trianglesIn(welded(load(file))) }),
  };
  const times = measure(run, bytes);
  const cell = (ours, theirs) =>
    theirs in times ? `${digits(times[theirs])} (${digits(times[theirs] / times[ours])}×)` : '–';
  const cells = [
    ...[title, (bytes.length / 1e6).toFixed(0), digits(times.read), cell('read', 'load')],
    ...[digits(times.build), cell('build', 'weld' in times ? 'weld' : 'load')],
  ];
  console.log(`| ${cells.join(' | ')} |`);
}

/** The median of each, in rounds in which one comes after the other. */
function measure(run, bytes) {
  const times = Object.fromEntries(Object.keys(run).map((who) => [who, []]));
  for (let round = 0; round <= ROUNDS; round++) {
    for (const [who, use] of Object.entries(run)) {
      if (times[who][0] > HOPELESS) continue;
      globalThis.gc?.();
      const begin = cpuUsage();
      const count = use(bytes);
      const { user, system } = cpuUsage(begin);
      if (count !== triangles.length / 3) throw new Error(`${who} found ${count} triangles.`);
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

function digits(value) {
  return value >= 99.5 ? Math.round(value).toLocaleString('en-GB') : value.toPrecision(2);
}
