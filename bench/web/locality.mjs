// `npm run bench:locality`: what `reorder` costs and gains on meshes in random order. The first two
// arguments are the program bench/native/locality.cpp, compiled natively and to WebAssembly; the same
// passes from JavaScript follow. CPU time, since it must not matter what else the machine does. Prints
// Markdown.

import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { argv, cpuUsage, env, execPath } from 'node:process';
import { fileURLToPath } from 'node:url';
import { HalfedgeMesh, init } from 'halfedge';
import { icosphere, shuffled, subdivided } from './meshes.mjs';

const ROUNDS = 5;
const PASSES = ['circulator', 'one-ring sum', 'normals', 'smoothing', 'sqrt(3) step'];

const [, , native, wasm] = argv;
const data = env.HALFEDGE_DATA ?? fileURLToPath(new URL('../../../shared/data', import.meta.url));
const file = `${data}/good/bunny_pmp.off`;

await init();
console.log(`| faces | | ${['reorder', ...PASSES].join(' | ')} |`);
console.log(`| --- | --- | ${['reorder', ...PASSES].map(() => '---:').join(' | ')} |`);
const sizes = [linesOf(native, [file]), linesOf(execPath, [wasm, file]), inJavaScript()];
for (const i of [0, 1]) {
  printRows('C++, native', sizes[0][i]);
  printRows('C++, WebAssembly', sizes[1][i]);
  printRows('JavaScript', sizes[2][i]);
}

/** Before, and after with how many times as fast. */
function printRows(where, times) {
  const faces = `${Math.round(times.faces / 1000)} k`;
  const before = PASSES.map((pass) => times[`${pass}, shuffled`]);
  console.log(`| ${faces} | ${where}, shuffled | | ${before.map(ms).join(' | ')} |`);
  for (const [order, reorder] of [
    ['reordered', times.reorder],
    ['breadth-first', times.reorder_breadth_first],
  ]) {
    const after = PASSES.map((pass, i) => {
      const time = times[`${pass}, ${order}`];
      return `${ms(time)} (${(before[i] / time).toFixed(1)}×)`;
    });
    console.log(`| ${faces} | ${where}, ${order} | ${ms(reorder)} | ${after.join(' | ')} |`);
  }
}

function ms(time) {
  return time < 10 ? time.toFixed(2) : time.toFixed(0);
}

function linesOf(program, list) {
  const output = execFileSync(program, list, { encoding: 'utf8' });
  return output.trim().split('\n').map(JSON.parse);
}

/** The same, one mesh after the other: passes written as a user of the package writes them. */
function inJavaScript() {
  let base = icosphere(6);
  if (existsSync(file)) {
    const { mesh } = HalfedgeMesh.parse(readFileSync(file));
    base = { positions: mesh.positions.slice(), triangles: trianglesOf(mesh) };
    mesh.dispose();
  }
  return [base, subdivided(subdivided(base))].map((mesh) => measure(shuffled(mesh)));
}

function trianglesOf(mesh) {
  return Uint32Array.from(
    mesh
      .faces()
      .toArray()
      .flatMap((f) => mesh.faceVertices(f).toArray()),
  );
}

function measure({ positions, triangles }) {
  const times = { faces: triangles.length / 3 };
  const add = (name, run) => {
    const before = cpuUsage();
    run();
    const { user, system } = cpuUsage(before);
    times[name] ??= [];
    times[name].push((user + system) / 1000);
  };
  for (let round = 0; round < ROUNDS; round++) {
    for (const order of ['shuffled', 'reordered', 'breadth-first']) {
      const mesh = HalfedgeMesh.fromTriangles(positions, triangles);
      if (order === 'reordered') add('reorder', () => mesh.reorder());
      if (order === 'breadth-first')
        add('reorder_breadth_first', () => mesh.reorder('breadth-first'));
      add(`circulator, ${order}`, () => circulate(mesh));
      add(`one-ring sum, ${order}`, () => oneRingSum(mesh));
      add(`normals, ${order}`, () => normals(mesh));
      add(`smoothing, ${order}`, () => smooth(mesh));
      add(`sqrt(3) step, ${order}`, () => subdivide(mesh));
      mesh.dispose();
    }
  }
  for (const [name, list] of Object.entries(times)) {
    if (Array.isArray(list)) times[name] = list.sort((a, b) => a - b)[ROUNDS >> 1];
  }
  return times;
}

function circulate(mesh) {
  let counter = 0;
  for (let v = 0; v < mesh.vertexSlots; v++) {
    const first = mesh.vertexHalfedge(v);
    let h = first;
    do {
      if (mesh.face(h) >= 0) counter += 1;
      h = mesh.rotateCw(h);
    } while (h !== first);
  }
  for (let f = 0; f < mesh.faceSlots; f++) {
    const first = mesh.faceHalfedge(f);
    let h = first;
    do {
      counter -= 1;
      h = mesh.next(h);
    } while (h !== first);
  }
  if (counter !== 0) throw new Error('The corners were counted differently.');
}

function oneRingSum(mesh) {
  let sum = 0;
  for (let v = 0; v < mesh.vertexSlots; v++) {
    const first = mesh.vertexHalfedge(v);
    let h = first;
    do {
      sum += mesh.toVertex(h);
      h = mesh.rotateCw(h);
    } while (h !== first);
  }
  if (sum === 0) throw new Error('There is nothing to sum up.');
}

function normals(mesh) {
  const p = mesh.positions;
  const ofFaces = new Float32Array(3 * mesh.faceSlots);
  const ofVertices = new Float32Array(3 * mesh.vertexSlots);
  for (let f = 0; f < mesh.faceSlots; f++) {
    const h = mesh.faceHalfedge(f);
    const a = 3 * mesh.fromVertex(h);
    const b = 3 * mesh.toVertex(h);
    const c = 3 * mesh.toVertex(mesh.next(h));
    const ux = p[b] - p[a];
    const uy = p[b + 1] - p[a + 1];
    const uz = p[b + 2] - p[a + 2];
    const vx = p[c] - p[a];
    const vy = p[c + 1] - p[a + 1];
    const vz = p[c + 2] - p[a + 2];
    write(ofFaces, f, uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
  }
  for (let v = 0; v < mesh.vertexSlots; v++) {
    let x = 0;
    let y = 0;
    let z = 0;
    const first = mesh.vertexHalfedge(v);
    let h = first;
    do {
      const f = mesh.face(h);
      if (f >= 0) {
        x += ofFaces[3 * f];
        y += ofFaces[3 * f + 1];
        z += ofFaces[3 * f + 2];
      }
      h = mesh.rotateCw(h);
    } while (h !== first);
    write(ofVertices, v, x, y, z);
  }
}

/** Of unit length. */
function write(rows, i, x, y, z) {
  const scale = 1 / Math.sqrt(x * x + y * y + z * z);
  rows[3 * i] = scale * x;
  rows[3 * i + 1] = scale * y;
  rows[3 * i + 2] = scale * z;
}

function smooth(mesh) {
  const p = mesh.positions;
  for (let v = 0; v < mesh.vertexSlots; v++) {
    if (mesh.isBoundaryVertex(v)) continue;
    let x = 0;
    let y = 0;
    let z = 0;
    let valence = 0;
    const first = mesh.vertexHalfedge(v);
    let h = first;
    do {
      const w = 3 * mesh.toVertex(h);
      x += p[w];
      y += p[w + 1];
      z += p[w + 2];
      valence += 1;
      h = mesh.rotateCw(h);
    } while (h !== first);
    p[3 * v] = x / valence;
    p[3 * v + 1] = y / valence;
    p[3 * v + 2] = z / valence;
  }
}

/** Without the move of the old vertices, which is another smoothing. */
function subdivide(mesh) {
  const { edgeSlots, halfedgeSlots } = mesh;
  const faces = [];
  for (let h = 0; h < halfedgeSlots; h++) {
    const f = mesh.face(h);
    if (f >= 0 && mesh.faceHalfedge(f) === h) faces.push(f);
  }
  for (const f of faces) mesh.splitFace(f);
  for (let e = 0; e < edgeSlots; e++) if (!mesh.isBoundaryEdge(e)) mesh.flipEdge(e);
}
