// `npm run bench:directed-edges`: what goes around the items of Directed Edges in Node, against loops by hand over the
// same views. Prints Markdown.

import { DirectedEdgesMesh, init } from 'halfedge';
import { grid, icosphere, shuffled } from './meshes.mjs';

const ROUNDS = 31;

// By hand: what each of these shows of halfedge h, if it shows anything, and the lap that it is shown in.
const SHOWN = {
  vertexVertices: 'sum += toVertex[h];',
  vertexFaces: 'if (h < sides) sum += (h / 3) | 0;',
  vertexEdges: 'sum += Math.min(h, opposite[h]);',
  faceFaces: 'if (opposite[h] < sides) sum += (opposite[h] / 3) | 0;',
};
const LAPS = {
  vertex: [
    'vertexHalfedge[i]',
    'opposite[h < sides ? (h % 3 === 0 ? h + 2 : h - 1) : boundaryPrev[h - sides]]',
  ],
  face: ['3 * i', 'h % 3 === 2 ? h - 2 : h + 1'],
};

/** The loops over all items of one kind, each of which returns the sum of what it shows. */
function loopsOver(kind) {
  const [begin, step] = LAPS[kind.startsWith('face') ? 'face' : 'vertex'];
  const around = (lap) => `let sum = 0; for (let i = 0; i < count; i++) { ${lap} } return sum;`;
  const go = `const first = c.halfedge; do { sum += c.current; c.next(); } while (c.halfedge !== first);`;
  const texts = {
    hand: `const { opposite, toVertex, vertexHalfedge, boundaryPrev } = mesh.connectivity;
      const sides = 3 * mesh.faceCount;
      ${around(`const first = ${begin}; let h = first; do { ${SHOWN[kind]} h = ${step}; } while (h !== first);`)}`,
    circulator: around(`const c = mesh.circulate('${kind}', i); ${go}`),
    moved: `const c = mesh.circulate('${kind}', 0); ${around(`c.moveTo(i); ${go}`)}`,
    'for...of': around(`for (const item of mesh.${kind}(i)) sum += item;`),
    into: around(`for (let n = mesh.${kind}(i).into(buffer) - 1; n >= 0; n--) sum += buffer[n];`),
  };
  // Texts of their own, because V8 keeps its notes by the text of a function.
  return Object.entries(texts).map(([form, text]) => [
    form,
    new Function('mesh', 'count', 'buffer', text),
  ]);
}

await init();
const [open, sphere] = [grid(256), icosphere(6)];
const inputs = {
  'open grid': open,
  'open grid, shuffled': shuffled(open),
  sphere,
  'sphere, shuffled': shuffled(sphere),
};
console.log('| mesh | around | by hand, ms | circulator | moved | `for...of` | `into` |');
console.log('| --- | --- | ---: | ---: | ---: | ---: | ---: |');
for (const [name, { positions, triangles }] of Object.entries(inputs)) {
  const mesh = DirectedEdgesMesh.fromTriangles(positions, triangles);
  for (const kind of Object.keys(SHOWN)) console.log(`| ${name} | ${row(mesh, kind)} |`);
  mesh.dispose();
}

/** Medians of rounds in which one form comes after the other. */
function row(mesh, kind) {
  const count = kind.startsWith('face') ? mesh.faceCount : mesh.vertexCount;
  const buffer = new Int32Array(64);
  const forms = loopsOver(kind);
  const times = forms.map(() => []);
  const sums = new Set();
  for (let round = 0; round < ROUNDS; round++) {
    for (const [i, [, run]] of forms.entries()) {
      const begin = performance.now();
      sums.add(run(mesh, count, buffer));
      times[i].push(performance.now() - begin);
    }
  }
  if (sums.size > 1) throw new Error(`${kind}: the forms disagree: ${[...sums].join(', ')}.`);
  const [hand, ...others] = times.map((list) => list.sort((a, b) => a - b)[ROUNDS >> 1]);
  const ratios = others.map((time) => `${(time / hand).toFixed(2)}×`);
  return [kind, hand.toFixed(2), ...ratios].join(' | ');
}
