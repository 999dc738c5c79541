// Simplifies a mesh to a tenth of its faces, by quadric error metrics (Garland and Heckbert, "Surface
// simplification using quadric error metrics", 1997): again and again, the edge is collapsed that moves the
// surface least.
//
//   node examples/simplify.mjs                       a torus
//   node examples/simplify.mjs scan.ply small.ply

import { readFile, writeFile } from 'node:fs/promises';
import { HalfedgeMesh, init } from 'halfedge';

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const middle = (a, b) => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** The edges to collapse, the cheapest first: a binary heap of pairs of cost and edge. */
class Queue {
  #heap = [];

  push(cost, e) {
    const heap = this.#heap;
    let at = heap.length;
    while (at > 0) {
      const above = (at - 1) >> 1;
      if (heap[above][0] <= cost) break;
      heap[at] = heap[above];
      at = above;
    }
    heap[at] = [cost, e];
  }

  /** The cheapest, or undefined. */
  pop() {
    const heap = this.#heap;
    const first = heap[0];
    const last = heap.pop();
    if (heap.length === 0) return first;
    let at = 0;
    for (;;) {
      let below = 2 * at + 1;
      if (below + 1 < heap.length && heap[below + 1][0] < heap[below][0]) below += 1;
      if (below >= heap.length || heap[below][0] >= last[0]) break;
      heap[at] = heap[below];
      at = below;
    }
    heap[at] = last;
    return first;
  }
}

/** By vertex, ten numbers: the sum of w (n · x + d)² over planes, as a polynomial in x, y and z. */
class Quadrics {
  #of;

  constructor(vertexSlots) {
    this.#of = new Float64Array(10 * vertexSlots);
  }

  addPlane(v, point, normal, weight) {
    const plane = [...normal, -dot(normal, point)];
    let at = 10 * v;
    for (let i = 0; i < 4; i++)
      for (let j = i; j < 4; j++) this.#of[at++] += weight * (i < j ? 2 : 1) * plane[i] * plane[j];
  }

  add(v, other) {
    for (let i = 0; i < 10; i++) this.#of[10 * v + i] += this.#of[10 * other + i];
  }

  /** The error of the two vertices together, if they were at a point. */
  error(a, b, point) {
    const at = [...point, 1];
    let sum = 0;
    let k = 0;
    for (let i = 0; i < 4; i++)
      for (let j = i; j < 4; j++, k++)
        sum += (this.#of[10 * a + k] + this.#of[10 * b + k]) * at[i] * at[j];
    return Math.max(0, sum);
  }
}

function simplify(mesh, target) {
  const quadrics = new Quadrics(mesh.vertexSlots);
  const at = (v) => mesh.position(v);
  for (const f of mesh.faces()) {
    const normal = mesh.faceNormal(f);
    for (const v of mesh.faceVertices(f)) quadrics.addPlane(v, at(v), normal, mesh.faceArea(f));
    // What is on the boundary should stay there: a plane through the edge, upright on the face.
    for (const h of mesh.faceHalfedges(f)) {
      if (!mesh.isBoundaryHalfedge(mesh.opposite(h))) continue;
      const [from, to] = [mesh.fromVertex(h), mesh.toVertex(h)];
      const upright = cross(minus(at(to), at(from)), normal);
      for (const v of [from, to]) quadrics.addPlane(v, at(v), upright, 5);
    }
  }

  /** Where the ends of an edge should meet: at one of them, or in the middle. */
  const meeting = (a, b) => {
    const [first, ...others] = [at(a), at(b), middle(at(a), at(b))];
    let best = { point: first, cost: quadrics.error(a, b, first) };
    for (const point of others) {
      const cost = quadrics.error(a, b, point);
      if (cost < best.cost) best = { point, cost };
    }
    return best;
  };
  const queue = new Queue();
  const costs = new Float64Array(mesh.edgeSlots); // those that still hold: others in the queue are outdated
  const enqueue = (e) => {
    const { cost } = meeting(...mesh.edgeVertices(e));
    costs[e] = cost;
    queue.push(cost, e);
  };
  /** Whether a triangle at `v`, which stays, would turn over if `v` moved to the point. */
  const turnsOver = (v, other, point) => {
    for (const h of mesh.vertexOutgoingHalfedges(v)) {
      if (mesh.isBoundaryHalfedge(h)) continue;
      const [a, b] = [mesh.toVertex(h), mesh.toVertex(mesh.next(h))];
      if (a === other || b === other) continue;
      const side = minus(at(b), at(a));
      if (dot(cross(side, minus(at(v), at(a))), cross(side, minus(point, at(a)))) <= 0) return true;
    }
    return false;
  };

  for (const e of mesh.edges()) enqueue(e);
  while (mesh.faceCount > target) {
    const cheapest = queue.pop();
    if (cheapest === undefined) return; // nothing more can be collapsed
    const [cost, e] = cheapest;
    if (!mesh.isLiveEdge(e) || costs[e] !== cost) continue;
    const h = mesh.edgeHalfedge(e);
    const [a, b] = [mesh.fromVertex(h), mesh.toVertex(h)];
    const { point } = meeting(a, b);
    if (turnsOver(a, b, point) || turnsOver(b, a, point) || mesh.checkCollapse(h)) continue;
    mesh.collapse(h, point); // a disappears into b
    quadrics.add(b, a);
    for (const around of mesh.vertexEdges(b)) enqueue(around);
  }
}

await init();
const [input, output] = process.argv.slice(2);
const mesh = input
  ? HalfedgeMesh.parse(await readFile(input)).mesh
  : HalfedgeMesh.torus(48, 24, { triangles: true });
mesh.triangulate();
const tell = () =>
  console.log(
    `${mesh.vertexCount} vertices, ${mesh.faceCount} triangles, Euler characteristic ${mesh.eulerCharacteristic()}`,
  );
tell();
simplify(mesh, mesh.faceCount / 10);
tell();
mesh.compact();
const problems = mesh.validate('geometry');
console.log(problems.length === 0 ? 'valid' : problems.map(({ message }) => message).join('\n'));
if (output) await writeFile(output, mesh.write('ply'));
mesh.dispose();
