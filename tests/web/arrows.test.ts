import { ARROW_FLOATS, ArrowTracer, arrowSizes } from 'halfedge/three';

type Point = readonly [number, number];
type Segment = readonly [Point, Point];

/** A small seeded generator (mulberry32), so that a failure names the seed that repeats it. */
function random(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

const side = (a: Point, b: Point, c: Point) =>
  (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);

/** Whether two segments have a point in common in their interiors. */
function cross([a, b]: Segment, [c, d]: Segment): boolean {
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

function inside(point: Point, polygon: readonly Point[]): boolean {
  let odd = false;
  polygon.forEach((a, i) => {
    const b = polygon[(i + 1) % polygon.length];
    if (a[1] > point[1] === b[1] > point[1]) return;
    if (point[0] < a[0] + ((point[1] - a[1]) / (b[1] - a[1])) * (b[0] - a[0])) odd = !odd;
  });
  return odd;
}

/** The shaft and the barb of each arrow of a flat polygon, with one pixel `pixel` long. */
function arrowsOf(polygon: readonly Point[], pixel: number): { shaft: Segment; barb: Segment }[] {
  const corners = polygon.flatMap(([x, y]) => [x, y, 0]);
  const out = new Float32Array(polygon.length * ARROW_FLOATS);
  new ArrowTracer().traceFace(corners, polygon.length, arrowSizes(pixel), out, 0);
  return polygon.map((_, i) => {
    const at = (k: number): Point => [
      out[i * ARROW_FLOATS + 3 * k],
      out[i * ARROW_FLOATS + 3 * k + 1],
    ];
    return { shaft: [at(0), at(1)], barb: [at(1), at(2)] };
  });
}

/** Says what is wrong with the arrows of a polygon; an empty list if nothing is. */
function faults(polygon: readonly Point[], pixel: number): string[] {
  const arrows = arrowsOf(polygon, pixel);
  const found: string[] = [];
  const edges = polygon.map((p, i): Segment => [p, polygon[(i + 1) % polygon.length]]);
  arrows.forEach((arrow, i) => {
    for (const point of [...arrow.shaft, arrow.barb[1]]) {
      if (!inside(point, polygon)) found.push(`arrow ${i} leaves the face at ${point}`);
    }
    for (const edge of edges) {
      for (const part of [arrow.shaft, arrow.barb]) {
        if (cross(part, edge)) found.push(`arrow ${i} crosses an edge`);
      }
    }
    for (let j = i + 1; j < arrows.length; j++) {
      for (const mine of [arrow.shaft, arrow.barb]) {
        for (const other of [arrows[j].shaft, arrows[j].barb]) {
          if (cross(mine, other)) found.push(`arrows ${i} and ${j} cross`);
        }
      }
    }
    const [[x0, y0], [x1, y1]] = arrow.shaft;
    const [a, b] = edges[i];
    if ((x1 - x0) * (b[0] - a[0]) + (y1 - y0) * (b[1] - a[1]) <= 0) {
      found.push(`arrow ${i} does not run along its edge`);
    }
  });
  return found;
}

/** A triangle with unit base whose apex angle is `degrees`; `lean` moves the apex sideways. */
function sliver(degrees: number, lean: number): Point[] {
  const height = 0.5 / Math.tan((degrees * Math.PI) / 360);
  return [
    [0, 0],
    [1, 0],
    [0.5 + lean * height, height],
  ];
}

/** A polygon that is star-shaped around the origin, with reflex corners of every sharpness. */
function star(corners: number, next: () => number): Point[] {
  return Array.from({ length: corners }, (_, i): Point => {
    const angle = (2 * Math.PI * (i + 0.8 * next())) / corners;
    const radius = 0.1 + 0.9 * next();
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  });
}

const pixels = [1e-5, 1e-3, 0.01, 0.05, 1];

describe('arrows of a face', () => {
  for (const degrees of [2, 3, 5, 8, 20, 60, 120, 170]) {
    test(`stay inside and apart in triangles with an angle of ${degrees}°`, () => {
      for (const lean of [0, 0.3, 2, -5]) {
        for (const pixel of pixels) {
          expect(faults(sliver(degrees, lean), pixel)).toEqual([]);
        }
      }
    });
  }

  test('stay inside and apart in random triangles', () => {
    const seed = 7;
    const next = random(seed);
    for (let run = 0; run < 3000; run++) {
      const p = Array.from({ length: 3 }, (): Point => [next(), next()]);
      const triangle = side(p[0], p[1], p[2]) > 0 ? p : [p[0], p[2], p[1]];
      if (Math.abs(side(p[0], p[1], p[2])) < 1e-4) continue;
      expect({ seed, run, found: faults(triangle, 0.02) }).toEqual({ seed, run, found: [] });
    }
  });

  test('stay inside and apart in random concave polygons', () => {
    const seed = 11;
    const next = random(seed);
    for (let run = 0; run < 2000; run++) {
      const polygon = star(4 + Math.floor(next() * 9), next);
      for (const pixel of [0.002, 0.05]) {
        expect({ seed, run, found: faults(polygon, pixel) }).toEqual({ seed, run, found: [] });
      }
    }
  });

  test('stay inside and apart where a reflex corner nearly touches the edge across', () => {
    const gap = 0.01;
    const spike: Point[] = [
      [0, 0],
      [4, 0],
      [4, 2],
      [2.1, 2],
      [2, gap],
      [1.9, 2],
      [0, 2],
    ];
    for (const pixel of pixels) expect(faults(spike, pixel)).toEqual([]);
  });

  test('keep 6.5 px from the edge where there is room', () => {
    const square: Point[] = [
      [0, 0],
      [10, 0],
      [10, 10],
      [0, 10],
    ];
    const [first] = arrowsOf(square, 0.1);
    expect(first.shaft[0][1]).toBeCloseTo(0.65);
    expect(first.shaft[1][1]).toBeCloseTo(0.65);
    expect(first.shaft[0][0]).toBeCloseTo(0.65 + 0.25);
    expect(first.shaft[1][0]).toBeCloseTo(10 - 0.65 - 0.25);
  });

  test('have their barb on the face side, behind the tip', () => {
    for (const { shaft, barb } of arrowsOf(sliver(40, 0.1), 0.01)) {
      expect(side(shaft[0], shaft[1], barb[1])).toBeGreaterThan(0);
      const back =
        (barb[1][0] - barb[0][0]) * (shaft[1][0] - shaft[0][0]) +
        (barb[1][1] - barb[0][1]) * (shaft[1][1] - shaft[0][1]);
      expect(back).toBeLessThan(0);
    }
  });

  test('shrink to the edges of a face without area, and stay finite', () => {
    const corners = [0, 0, 0, 1, 0, 0, 2, 0, 0, 1, 0, 0];
    const out = new Float32Array(4 * ARROW_FLOATS);
    new ArrowTracer().traceFace(corners, 4, arrowSizes(0.01), out, 0);
    expect(Array.from(out).every(Number.isFinite)).toBe(true);
  });

  test('have the inradius of a triangle as their cap', () => {
    const out = new Float32Array(3 * ARROW_FLOATS);
    const cap = new ArrowTracer().traceFace([0, 0, 0, 4, 0, 0, 0, 3, 0], 3, arrowSizes(1), out, 0);
    expect(cap).toBeCloseTo(1);
  });
});

describe('the arrow of a boundary halfedge', () => {
  // A unit square face, counter-clockwise: its boundary loop runs clockwise around it.
  const loop: Point[] = [
    [0, 0],
    [0, 1],
    [1, 1],
    [1, 0],
  ];
  const up = [0, 0, 1];

  function boundaryArrow(points: readonly Point[], i: number, pixel: number): Segment[] {
    const path = [i - 1, i, i + 1, i + 2].flatMap((k) => {
      const [x, y] = points[(k + points.length) % points.length];
      return [x, y, 0];
    });
    const out = new Float32Array(ARROW_FLOATS);
    new ArrowTracer().traceBoundary(path, up, arrowSizes(pixel), out, 0);
    const at = (k: number): Point => [out[3 * k], out[3 * k + 1]];
    return [
      [at(0), at(1)],
      [at(1), at(2)],
    ];
  }

  test('lies outside the surface, along its edge', () => {
    for (let i = 0; i < 4; i++) {
      const [shaft, barb] = boundaryArrow(loop, i, 0.01);
      for (const point of [...shaft, barb[1]]) expect(inside(point, loop)).toBe(false);
      const a = loop[i];
      const b = loop[(i + 1) % 4];
      const along =
        (shaft[1][0] - shaft[0][0]) * (b[0] - a[0]) + (shaft[1][1] - shaft[0][1]) * (b[1] - a[1]);
      expect(along).toBeGreaterThan(0.8);
    }
  });

  test('stays near an edge that is short on the screen', () => {
    const [shaft] = boundaryArrow(loop, 0, 1);
    expect(Math.abs(shaft[0][0])).toBeLessThanOrEqual(0.3501);
    expect(shaft[1][1]).toBeGreaterThan(shaft[0][1]);
  });

  test('does not cross its neighbours in a loop around a slit', () => {
    // Seen from the hole these corners are sharp: the loop is the sliver, counter-clockwise.
    for (const degrees of [2, 5, 8, 30]) {
      for (const pixel of [0.05, 1]) {
        const slit = sliver(degrees, 0.2);
        const arrows = slit.map((_, i) => boundaryArrow(slit, i, pixel));
        arrows.forEach((mine, i) => {
          for (const other of arrows.slice(i + 1)) {
            for (const a of mine) for (const b of other) expect(cross(a, b)).toBe(false);
          }
        });
      }
    }
  });
});
