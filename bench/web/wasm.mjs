// `npm run bench:wasm`: whole-mesh passes as WebAssembly in Node against the same C++ compiled
// natively, which is the program named by the argument. CPU time, since it must not matter what else
// the machine does. Prints Markdown.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { argv, cpuUsage } from 'node:process';
import { HalfedgeMesh, init } from 'halfedge';
import { linksOf } from '../../dist/navigation.js';
import { RING_KINDS } from '../../dist/rings.js';
import { grid, icosphere, shuffled } from './meshes.mjs';

const ROUNDS = 15;
/** How often the two take turns. */
const TURNS = 9;

await init();
const [, , program] = argv;
const folder = mkdtempSync(join(tmpdir(), 'halfedge-bench-'));
try {
  console.log('| mesh | pass | native, ms | WebAssembly, ms | × | × of the fastest turns |');
  console.log('| --- | --- | ---: | ---: | ---: | ---: |');
  const [open, sphere] = [grid(512), icosphere(7)];
  compare('open grid', open);
  compare('open grid, shuffled', shuffled(open));
  compare('sphere', sphere);
  compare('sphere, shuffled', shuffled(sphere));
} finally {
  rmSync(folder, { recursive: true });
}

function compare(name, input) {
  const file = join(folder, 'mesh.off');
  writeFileSync(file, asOff(input));
  const turns = Array.from({ length: TURNS }, () => ({
    native: JSON.parse(execFileSync(program, [file], { encoding: 'utf8' })),
    wasm: passes(input),
  }));
  for (const pass of Object.keys(turns[0].wasm)) {
    const native = turns.map((turn) => turn.native[pass.split(',')[0]]).sort((a, b) => a - b);
    const wasm = turns.map((turn) => turn.wasm[pass]).sort((a, b) => a - b);
    const [of, middle] = [(i) => `${(wasm[i] / native[i]).toFixed(2)}×`, TURNS >> 1];
    const cells = [native[middle].toFixed(2), wasm[middle].toFixed(2), of(middle), of(0)];
    console.log(`| ${[name, pass, ...cells].join(' | ')} |`);
  }
}

/** The passes of bench/native/passes.cpp. */
function passes({ positions, triangles }) {
  const mesh = HalfedgeMesh.fromTriangles(positions, triangles);
  const times = {
    build: millisecondsOf(() => HalfedgeMesh.fromTriangles(positions, triangles).dispose()),
    'rings of vertices': millisecondsOf(() => ringsInTheCore(mesh, 'vertexVertices')),
    'rings of vertices, copied out': millisecondsOf(() => mesh.allVertexVertices()),
    'rings of faces': millisecondsOf(() => ringsInTheCore(mesh, 'faceFaces')),
    validate: millisecondsOf(() => mesh.validate()),
  };
  mesh.dispose();
  return times;
}

/** What a method such as allVertexVertices does before it copies the rows into arrays of their own. */
function ringsInTheCore(mesh, kind) {
  const { core, address } = linksOf(mesh);
  const rows = core.allRings(address, RING_KINDS.indexOf(kind), 0);
  for (const words of [rows.offsets, rows.items]) core.free(words.address);
}

function millisecondsOf(run) {
  const times = Array.from({ length: ROUNDS }, () => {
    const before = cpuUsage();
    run();
    const { user, system } = cpuUsage(before);
    return (user + system) / 1000;
  });
  return median(times);
}

function median(numbers) {
  return numbers.sort((a, b) => a - b)[numbers.length >> 1];
}

function asOff({ positions, triangles }) {
  const lines = [`OFF\n${positions.length / 3} ${triangles.length / 3} 0`];
  for (let i = 0; i < positions.length; i += 3) lines.push(positions.slice(i, i + 3).join(' '));
  for (let i = 0; i < triangles.length; i += 3) {
    lines.push(`3 ${triangles.slice(i, i + 3).join(' ')}`);
  }
  return lines.join('\n');
}
