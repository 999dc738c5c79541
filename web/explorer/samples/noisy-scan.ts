import { HalfedgeMesh } from 'halfedge';
import { toStl } from './polygons.js';

/** The same numbers from 0 to 1 every time (mulberry32). */
function random(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** Bumps of a few sizes, and a grain. */
function relief([x, y, z]: readonly number[], grain: number): number {
  const bumps = Math.sin(3 * x + 1) * Math.sin(3.4 * y) * Math.sin(2.6 * z + 2);
  const ripples = Math.sin(11 * x + 4 * y) * Math.sin(9 * z - 5 * y);
  return 1 + 0.22 * bumps + 0.025 * ripples + 0.004 * (grain - 0.5);
}

/** A binary STL file of about `triangles` triangles, such as a scanner leaves it. */
export function noisyScan(triangles: number): Uint8Array {
  const cells = Math.round(Math.sqrt(triangles / 12));
  const draw = random(2024);
  const out: number[] = [];
  const add = (corners: readonly (readonly number[])[]) => {
    for (const corner of corners) out.push(...corner);
  };
  for (const [a, b, c] of onCube(cells, draw)) {
    const lot = draw();
    if (lot < 0.0006) continue;
    add(lot < 0.004 ? [a, c, b] : [a, b, c]);
    if (lot > 0.998) add([b, c, a]);
    if (lot > 0.9972 && lot < 0.998) {
      const tip = [0, 1, 2].map((k) => 0.5 * 1.05 * (a[k] + b[k]) + 0.01 * (draw() - 0.5));
      add([a, b, tip]);
    }
  }
  return toStl(new Float32Array(out));
}

type Triangle = readonly [readonly number[], readonly number[], readonly number[]];

/** The six sides of a cube, blown up to a sphere with a relief. */
function onCube(cells: number, draw: () => number): Triangle[] {
  const soup: Triangle[] = [];
  const places = new Map<string, number[]>();
  const place = (cube: readonly number[]): number[] => {
    const key = cube.join(' ');
    const found = places.get(key);
    if (found) return found;
    const length = Math.hypot(...cube);
    const onSphere = cube.map((x) => x / length);
    const height = relief(onSphere, draw());
    // As single precision has it, so that the triangles of a place agree on it.
    const made = onSphere.map((x) => Math.fround(x * height));
    places.set(key, made);
    return made;
  };
  const sides = HalfedgeMesh.cube({ size: 2 });
  for (const f of sides.faces()) {
    const [p, q, , s] = [...sides.faceVertices(f)].map((v) => [...sides.position(v)]);
    const at = (i: number, j: number) =>
      place(p.map((x, k) => Math.round(cells * x + i * (q[k] - x) + j * (s[k] - x))));
    for (let i = 0; i < cells; i++) {
      for (let j = 0; j < cells; j++) {
        const [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        soup.push([a, b, c], [a, c, d]);
      }
    }
  }
  sides.dispose();
  return soup;
}
