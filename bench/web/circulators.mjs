// `npm run bench:circulators`: what goes around the items of a mesh in Node, against loops by hand over the same views.
// Prints Markdown. `--alone`: each row in a program of its own, rather than all kinds in one.

import { spawnSync } from 'node:child_process';
import { argv, execPath, stdout } from 'node:process';
import { DirectedEdgesMesh, HalfedgeMesh, init } from 'halfedge';
import { grid, icosphere, shuffled } from './meshes.mjs';

const ROUNDS = 31;

// By hand: what each of these shows of halfedge h, if it shows anything, and the lap that it is shown in.
const BY_HAND = {
  HalfedgeMesh: {
    views:
      'const { next, prev, toVertex, face, vertexHalfedge, faceHalfedge } = mesh.connectivity;',
    shown: {
      vertexVertices: 'sum = (sum + toVertex[h]) | 0;',
      vertexFaces: 'if (face[h] >= 0) sum = (sum + face[h]) | 0;',
      vertexEdges: 'sum = (sum + (h >> 1)) | 0;',
      faceFaces: 'if (face[h ^ 1] >= 0) sum = (sum + face[h ^ 1]) | 0;',
    },
    laps: { vertex: ['vertexHalfedge[i]', 'prev[h] ^ 1'], face: ['faceHalfedge[i]', 'next[h]'] },
  },
  DirectedEdgesMesh: {
    views: `const { opposite, toVertex, vertexHalfedge, boundaryPrev } = mesh.connectivity;
      const sides = 3 * mesh.faceCount;`,
    shown: {
      vertexVertices: 'sum = (sum + toVertex[h]) | 0;',
      vertexFaces: 'if (h < sides) sum = (sum + ((h / 3) | 0)) | 0;',
      vertexEdges: 'sum = (sum + Math.min(h, opposite[h])) | 0;',
      faceFaces: 'if (opposite[h] < sides) sum = (sum + ((opposite[h] / 3) | 0)) | 0;',
    },
    laps: {
      vertex: [
        'vertexHalfedge[i]',
        'opposite[h < sides ? (h % 3 === 0 ? h + 2 : h - 1) : boundaryPrev[h - sides]]',
      ],
      face: ['3 * i', 'h % 3 === 2 ? h - 2 : h + 1'],
    },
  },
};
const CLASSES = { HalfedgeMesh, DirectedEdgesMesh };
const INPUTS = {
  'open grid': () => grid(256),
  'open grid, shuffled': () => shuffled(grid(256)),
  sphere: () => icosphere(6),
  'sphere, shuffled': () => shuffled(icosphere(6)),
};

const [, program, ...given] = argv;
if (given.length > 1) {
  const [whose, name, kind] = given;
  stdout.write(await rows(whose, name, [kind]));
} else {
  const alone = given.includes('--alone');
  for (const whose of Object.keys(CLASSES)) {
    console.log(
      `\n| ${whose} | around | by hand, ms | circulator | moved | \`for...of\` | \`into\` |`,
    );
    console.log('| --- | --- | ---: | ---: | ---: | ---: | ---: |');
    for (const name of Object.keys(INPUTS)) {
      const kinds = Object.keys(BY_HAND[whose].shown);
      if (!alone) stdout.write(await rows(whose, name, kinds));
      else for (const kind of kinds) runAlone(whose, name, kind);
    }
  }
}

function runAlone(...row) {
  const { status } = spawnSync(execPath, [program, ...row], { stdio: 'inherit' });
  if (status !== 0) throw new Error(`${program} ${row.join(' ')} ended with ${status}.`);
}

/** The rows of one mesh, as Markdown. */
async function rows(whose, name, kinds) {
  await init();
  const { positions, triangles } = INPUTS[name]();
  const mesh = CLASSES[whose].fromTriangles(positions, triangles);
  const table = kinds.map((kind) => `| ${name} | ${row(whose, mesh, kind)} |\n`).join('');
  mesh.dispose();
  return table;
}

/** Medians of rounds in which one form comes after the other. */
function row(whose, mesh, kind) {
  const count = kind.startsWith('face') ? mesh.faceCount : mesh.vertexCount;
  const buffer = new Int32Array(64);
  const forms = loopsOver(whose, kind);
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

/** The loops over all items of one kind, each of which returns the sum of what it shows. */
function loopsOver(whose, kind) {
  const { views, shown, laps } = BY_HAND[whose];
  const [begin, step] = laps[kind.startsWith('face') ? 'face' : 'vertex'];
  const around = (lap) => `let sum = 0; for (let i = 0; i < count; i++) { ${lap} } return sum;`;
  const go =
    'const first = c.halfedge; do { sum = (sum + c.current) | 0; c.next(); } while (c.halfedge !== first);';
  const texts = {
    hand: `${views} ${around(`const first = ${begin}; let h = first; do { ${shown[kind]} h = ${step}; } while (h !== first);`)}`,
    circulator: around(`const c = mesh.circulate('${kind}', i); ${go}`),
    moved: `const c = mesh.circulate('${kind}', 0); ${around(`c.moveTo(i); ${go}`)}`,
    'for...of': around(`for (const item of mesh.${kind}(i)) sum = (sum + item) | 0;`),
    into: around(
      `for (let n = mesh.${kind}(i).into(buffer) - 1; n >= 0; n--) sum = (sum + buffer[n]) | 0;`,
    ),
  };
  // Texts of their own, because V8 keeps its notes by the text of a function.
  return Object.entries(texts).map(([form, text]) => [
    form,
    new Function('mesh', 'count', 'buffer', text),
  ]);
}
