// `npm run bench:growth`: how the time of whole-mesh passes grows from ten thousand to ten million faces,
// natively, as WebAssembly in Node, and with the flat baseline. The argument names the native program.
// CPU time, the least of several rounds. Prints Markdown.
//   --quick   only up to a hundred thousand faces
//   --write   keeps the table in bench/README.md and draws bench/growth.svg

import { execFileSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { argv, cpuUsage } from 'node:process';
import { HalfedgeMesh, init } from 'halfedge';
import { oneRingsByAccessors } from './contenders.mjs';
import { drawGrowth } from './growth-plot.mjs';
import { torus } from './meshes.mjs';
import { keepReport } from './readme.mjs';

const PASSES = ['build', 'one-rings', 'validate', 'compaction'];
/** How often native and WebAssembly take turns; once where that takes minutes. */
const turnsFor = (faces) => (faces > 2e6 ? 1 : 3);
/** Vertices of a side of a torus: steps of √10 in faces. */
const SIDES = [71, 126, 224, 397, 707, 1257, 2236];

await init();
const [, , program, ...options] = argv;
const sides = options.includes('--quick') ? SIDES.slice(0, 3) : SIDES;
const rows = sides.map(measure);
const report = `${cpus()[0].model.trim()}, ${cpus().length} processors.\n\n${table()}`;
console.log(report);
if (options.includes('--write')) {
  keepReport('npm run bench:growth', report);
  writeFileSync(new URL('../growth.svg', import.meta.url), drawGrowth(PASSES, rows));
}

/** Nanoseconds a face: `{ faces, native, flat, wasm }`, by pass. */
function measure(side) {
  const faces = 2 * side ** 2;
  const row = { faces, native: {}, flat: {}, wasm: {} };
  for (let turn = 0; turn < turnsFor(faces); turn++) {
    const natively = JSON.parse(execFileSync(program, [String(side)], { encoding: 'utf8' }));
    const measured = { ...natively, wasm: inWebAssembly(side) };
    for (const [who, times] of Object.entries(measured)) {
      for (const [pass, ms] of Object.entries(times)) {
        row[who][pass] = Math.min(row[who][pass] ?? Infinity, (1e6 * ms) / faces);
      }
    }
  }
  console.error(`  ${faces} faces`);
  return row;
}

/** The passes of bench/native/growth.cpp, called from JavaScript; the one-rings by accessors. */
function inWebAssembly(side) {
  const { positions, triangles } = torus(side);
  const faces = triangles.length / 3;
  const rounds = Math.min(15, Math.max(2, Math.floor(3e6 / faces)));
  const repeats = Math.max(1, Math.floor(3e5 / faces));
  const least = {};
  const time = (pass, run, times = repeats) => {
    const before = cpuUsage();
    for (let i = 0; i < times; i++) run();
    const { user, system } = cpuUsage(before);
    least[pass] = Math.min(least[pass] ?? Infinity, (user + system) / 1000 / times);
  };
  const build = () => HalfedgeMesh.fromTriangles(positions, triangles);
  for (let round = 0; round < rounds; round++) {
    time('build', () => build().dispose());
    const mesh = build();
    time('one-rings', () => oneRingsByAccessors(mesh));
    time('validate', () => mesh.validate());
    splitAndCollapse(mesh);
    time('compaction', () => mesh.compact(), 1);
    mesh.dispose();
  }
  return least;
}

/** A vertex in each face, and all of them collapsed away again: two thirds of the faces are gaps then. */
function splitAndCollapse(mesh) {
  const { vertexSlots, edgeSlots, faceSlots } = mesh;
  mesh.reserve(vertexSlots + faceSlots, edgeSlots + 3 * faceSlots, 3 * faceSlots);
  for (let f = 0; f < faceSlots; f++) mesh.splitFace(f);
  for (let i = 0; i < faceSlots; i++) mesh.collapse(mesh.vertexHalfedge(vertexSlots + i));
}

function table() {
  const who = { native: 'native', wasm: 'WebAssembly', flat: 'flat baseline' };
  const columns = PASSES.flatMap((pass) =>
    Object.keys(who)
      .filter((key) => pass in rows[0][key])
      .map((key) => [pass, key]),
  );
  const lines = [
    ['faces; ns a face', ...columns.map(([pass, key]) => `${pass}: ${who[key]}`)],
    ['---:', ...columns.map(() => '---:')],
    ...rows.map((row) => [
      row.faces.toLocaleString('en-GB'),
      ...columns.map(([pass, key]) => row[key][pass].toPrecision(3)),
    ]),
  ];
  return lines.map((cells) => `| ${cells.join(' | ')} |`).join('\n');
}
