// What an edit costs, called one by one from JavaScript; the same in Node and in a browser.

import { flatFlip, flatLinks } from './flat-edits.mjs';
import { grid } from './meshes.mjs';

/**
 * Each row is a pass of edits over one mesh, which leaves it as it was or is done with it afterwards:
 * `run(mesh)` returns how many there were. `flat` does the same on the arrays of `flatLinks`.
 */
const ROWS = [
  {
    title: '`flipEdge`, four times each',
    run: (mesh, { diagonals }) => {
      for (let lap = 0; lap < 4; lap++) for (const e of diagonals) mesh.flipEdge(e);
      return 4 * diagonals.length;
    },
    flat: (links, { diagonals }) => {
      for (let lap = 0; lap < 4; lap++) for (const e of diagonals) flatFlip(links, e);
      return 4 * diagonals.length;
    },
  },
  {
    title: '`checkFlipEdge`',
    run: (mesh, { diagonals }) => {
      let count = 0;
      for (const e of diagonals) count += mesh.checkFlipEdge(e) === null ? 1 : 0;
      if (count !== diagonals.length) throw new Error('A diagonal cannot be flipped.');
      return count;
    },
  },
  {
    title: '`checkFlipEdge`, refused',
    run: (mesh, { boundary }) => {
      let count = 0;
      for (let lap = 0; lap < 20; lap++) {
        for (const e of boundary) count += mesh.checkFlipEdge(e) === null ? 0 : 1;
      }
      if (count !== 20 * boundary.length)
        throw new Error('An edge of the boundary can be flipped.');
      return count;
    },
  },
  {
    title: '`splitEdge`, then `collapse`',
    run: (mesh, { diagonals }) => {
      for (const e of diagonals) mesh.collapse(mesh.vertexHalfedge(mesh.splitEdge(e)));
      return 2 * diagonals.length;
    },
  },
  {
    title: '`splitEdge`',
    run: (mesh, { diagonals }) => {
      for (const e of diagonals) mesh.splitEdge(e);
      return diagonals.length;
    },
  },
  {
    title: '`splitFace`',
    run: (mesh, { faces }) => {
      for (let f = 0; f < faces; f++) mesh.splitFace(f);
      return faces;
    },
  },
  {
    title: '`collapse`',
    run: (mesh, { diagonals }) => {
      for (const e of diagonals) mesh.collapse(2 * e);
      return diagonals.length;
    },
  },
  {
    title: '`setPosition`',
    run: (mesh, { points }) => {
      for (let v = 0; v < points.length; v++) mesh.setPosition(v, points[v]);
      return points.length;
    },
  },
  {
    title: '`addVertex` and `addFace`, from an empty mesh',
    run: (mesh, { points, corners }) => {
      mesh.clear();
      for (const point of points) mesh.addVertex(point);
      for (const triangle of corners) mesh.addFace(triangle);
      return points.length + corners.length;
    },
  },
];

/**
 * Nanoseconds an edit, the least of a few passes: `{ vertices, rows: [{ title, times }] }`. In `times`, undo and
 * redo are those of the whole pass, step by step.
 */
export async function runOperations({ HalfedgeMesh }, { sizes = [320], rounds = 5 } = {}) {
  const side = Math.min(sizes[0], 320);
  const { positions, triangles } = grid(side);
  const given = itemsOf(HalfedgeMesh, positions, triangles);
  const rows = [];
  for (const { title, run, flat } of ROWS) {
    const times = {};
    const note = (who, begin, count) => {
      const time = (1e6 * (performance.now() - begin)) / count;
      times[who] = Math.min(times[who] ?? Infinity, time);
    };
    for (let round = 0; round < rounds; round++) {
      for (const history of [false, true]) {
        const mesh = HalfedgeMesh.fromTriangles(positions, triangles);
        mesh.history.enabled = history;
        const begin = performance.now();
        const count = run(mesh, given);
        note(history ? 'history' : 'halfedge', begin, count);
        for (const way of mesh.history.canUndo ? ['undo', 'redo'] : []) {
          const begin = performance.now();
          travel(mesh, way);
          note(way, begin, count);
        }
        mesh.dispose();
      }
      if (flat !== undefined) {
        const links = flatLinks(given.mesh);
        const begin = performance.now();
        note('flat', begin, flat(links, given));
      }
      await new Promise((resolve) => setTimeout(resolve, 1));
    }
    rows.push({ title, times });
  }
  given.mesh.dispose();
  return { vertices: positions.length / 3, rows };
}

/** Undoes or redoes all steps. */
function travel(mesh, way) {
  const { history } = mesh;
  while (history[way]());
}

/** Among them the diagonals of every fourth square, which don't touch each other's triangles. */
function itemsOf(HalfedgeMesh, positions, triangles) {
  const mesh = HalfedgeMesh.fromTriangles(positions, triangles);
  const side = Math.sqrt(positions.length / 3);
  const diagonals = [];
  for (let y = 1; y + 2 < side; y += 2) {
    for (let x = 1; x + 2 < side; x += 2) {
      const [a, b] = [y * side + x, (y + 1) * side + x + 1];
      const e = mesh.findEdge(a, b);
      diagonals.push(e >= 0 ? e : mesh.findEdge(a + 1, b - 1));
    }
  }
  const points = Array.from({ length: positions.length / 3 }, (_, v) =>
    Array.from(positions.subarray(3 * v, 3 * v + 3)),
  );
  const corners = Array.from({ length: triangles.length / 3 }, (_, f) =>
    Array.from(triangles.subarray(3 * f, 3 * f + 3)),
  );
  const [outside] = mesh.boundaryLoops();
  const boundary = Array.from(mesh.halfedgeLoop(outside), (h) => mesh.edge(h));
  return { mesh, diagonals, boundary, points, corners, faces: corners.length };
}

/** The results as Markdown. */
export function operationTable({ vertices, rows }) {
  const number = (value) => Math.round(value).toLocaleString('en-GB');
  const head = `open grid: ${vertices.toLocaleString('en-GB')} vertices; ns an edit`;
  const lines = [
    [head, 'halfedge', 'with history', 'undo', 'redo', 'flat'],
    ['---', '---:', '---:', '---:', '---:', '---:'],
    ...rows.map(({ title, times: { halfedge, history, undo, redo, flat } }) => {
      const besideOurs = (time) =>
        time === undefined ? '–' : `${number(time)} (${(time / halfedge).toPrecision(2)}×)`;
      return [title, number(halfedge), ...[history, undo, redo, flat].map(besideOurs)];
    }),
  ];
  return lines.map((cells) => `| ${cells.join(' | ')} |`).join('\n');
}
