import {
  ARROW_FLOATS,
  ArrowTracer,
  arrowSizes,
  CAP_SHARE,
  CappedMitre,
  LineBatch,
} from 'halfedge/three';
import { Color } from 'three';
import { arrowsOf, faults, randomPlane } from './support/flat-arrows.js';
import {
  comb,
  cross,
  ell,
  inside,
  leaningSliver,
  type Point,
  type Polygon,
  randomSimplePolygon,
  randomSliver,
  randomStar,
  regularStar,
  type Segment,
  side,
} from './support/polygons.js';
import { random } from './support/random.js';

/** Lengths of a pixel, from a face that fills many screens to one that is smaller than an arrow. */
const pixels = [1e-4, 1e-3, 0.01, 0.05, 1];

describe('arrows of a face', () => {
  for (const degrees of [2, 3, 5, 8, 20, 60, 120, 170]) {
    test(`stay inside and apart in triangles with an angle of ${degrees}°`, () => {
      for (const lean of [0, 0.3, 2, -5]) {
        for (const pixel of pixels) {
          expect(faults(leaningSliver(degrees, lean), pixel)).toEqual([]);
        }
      }
    });
  }

  /** Draws polygons from a seed, and expects no fault at any scale; a failure names what to repeat. */
  function expectNoFaults(seed: number, runs: number, draw: (next: () => number) => Polygon) {
    const next = random(seed);
    for (let run = 0; run < runs; run++) {
      const polygon = draw(next);
      for (const pixel of pixels) {
        const found = faults(polygon, pixel);
        if (found.length > 0) expect({ seed, run, pixel, polygon, found }).toEqual({ seed, run });
      }
    }
  }

  test('stay inside and apart in random slivers of 2 to 8 degrees', () => {
    expectNoFaults(3, 1000, randomSliver);
  });

  test('stay inside and apart in random triangles', () => {
    expectNoFaults(7, 600, (next) => {
      for (;;) {
        const [a, b, c] = Array.from({ length: 3 }, (): Point => [next(), next()]);
        if (Math.abs(side(a, b, c)) < 1e-4) continue;
        return side(a, b, c) > 0 ? [a, b, c] : [a, c, b];
      }
    });
  });

  test('stay inside and apart in random star-shaped polygons', () => {
    expectNoFaults(11, 400, (next) => randomStar(4 + Math.floor(next() * 9), next));
  });

  test('stay inside and apart in random simple polygons', () => {
    expectNoFaults(13, 500, (next) => randomSimplePolygon(4 + Math.floor(next() * 12), next));
  });

  test('stay inside and apart in planes that are turned anyhow', () => {
    const seed = 17;
    const next = random(seed);
    for (let run = 0; run < 300; run++) {
      const polygon = run % 2 === 0 ? randomSliver(next) : randomSimplePolygon(9, next);
      const found = faults(polygon, 0.01, randomPlane(next));
      expect({ seed, run, found }).toEqual({ seed, run, found: [] });
    }
  });

  test.each([
    ['an L', ell(0.5)],
    ['an L with thin arms', ell(0.02)],
    ['a comb', comb(5, 0.1, 0.1)],
    ['a comb with thin teeth', comb(7, 0.01, 0.2)],
    ['a comb with thin gaps', comb(7, 0.2, 0.01)],
    ['a star', regularStar(5, 0.4)],
    ['a star with needles', regularStar(12, 0.1)],
    ['a cog', regularStar(40, 0.95)],
  ])('stay inside and apart in %s', (_name, polygon) => {
    for (const pixel of pixels) expect(faults(polygon, pixel)).toEqual([]);
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

  test('keep the distance of the capped mitre, and end on the bisectors, in random slivers', () => {
    const next = random(19);
    for (let run = 0; run < 300; run++) {
      const triangle = randomSliver(next);
      const pixel = 10 ** (-4 * next());
      const trim = arrowSizes(pixel).trim;
      const cots = triangle.map((p, i) => {
        const [before, after] = [triangle[(i + 2) % 3], triangle[(i + 1) % 3]];
        const angle = (q: Point) => Math.atan2(q[1] - p[1], q[0] - p[0]);
        const turn = (angle(before) - angle(after) + 4 * Math.PI) % (2 * Math.PI);
        return 1 / Math.tan(turn / 2);
      });
      const lengths = triangle.map(([x, y], i) => {
        const [u, v] = triangle[(i + 1) % 3];
        return Math.hypot(u - x, v - y);
      });
      const caps = lengths.map((length, i) => length / (cots[i] + cots[(i + 1) % 3]));
      const inset = Math.min(6.5 * pixel, CAP_SHARE * Math.min(...caps));
      arrowsOf(triangle, pixel).forEach(({ shaft }, i) => {
        const [a, b] = [triangle[i], triangle[(i + 1) % 3]];
        const gap = Math.min(trim, 0.12 * lengths[i]);
        const to = (p: Point) => ({
          height: side(a, b, p) / lengths[i],
          along: ((p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1])) / lengths[i],
        });
        const close = (x: number, y: number) =>
          expect(Math.abs(x - y)).toBeLessThan(1e-5 * Math.max(...lengths));
        close(to(shaft[0]).height, inset);
        close(to(shaft[1]).height, inset);
        close(to(shaft[0]).along, cots[i] * inset + gap);
        close(to(shaft[1]).along, lengths[i] - cots[(i + 1) % 3] * inset - gap);
      });
    }
  });

  test('shrink to the edges of a face without area, and stay finite', () => {
    const corners = [0, 0, 0, 1, 0, 0, 2, 0, 0, 1, 0, 0];
    const out = new Float32Array(4 * ARROW_FLOATS);
    new ArrowTracer().traceFace(corners, 4, arrowSizes(0.01), out, 0);
    expect(Array.from(out).every(Number.isFinite)).toBe(true);
  });

  test('of a triangle are those of a polygon of three corners', () => {
    const seed = 23;
    const next = random(seed);
    const mitre = new CappedMitre();
    const placed = (sizes: ReturnType<typeof arrowSizes>) => {
      const out = new Float32Array(3 * ARROW_FLOATS);
      mitre.place(sizes, out, 0);
      return [mitre.degree, mitre.cap, ...out];
    };
    for (let run = 0; run < 300; run++) {
      const { x, y } = randomPlane(next);
      const triangle =
        run % 2 === 0 ? randomSliver(next) : leaningSliver(10 + 100 * next(), next());
      const corners = triangle.flatMap(([u, v]) => x.map((_, k) => u * x[k] + v * y[k]));
      const sizes = arrowSizes(10 ** (-4 * next()));
      mitre.measurePolygon(corners, 3);
      const expected = placed(sizes);
      mitre.measureTriangle([0, ...corners], 1, 4, 7);
      const off = placed(sizes).map((number, i) => Math.abs(number - expected[i]));
      expect({ seed, run, off: Math.max(...off) < 1e-6 }).toEqual({ seed, run, off: true });
    }
  });

  test.each([
    ['on a line', [0, 0, 0, 1, 0, 0, 3, 0, 0]],
    ['two corners of which are one', [0, 0, 0, 1, 0, 0, 1, 0, 0]],
    ['that is a point', [2, 2, 2, 2, 2, 2, 2, 2, 2]],
  ])('shrink to the edges of a triangle %s, and stay finite', (_name, corners) => {
    const out = new Float32Array(3 * ARROW_FLOATS);
    new ArrowTracer().traceFace(corners, 3, arrowSizes(0.01), out, 0);
    const low = [0, 1, 2].map((k) => Math.min(corners[k], corners[3 + k], corners[6 + k]));
    const high = [0, 1, 2].map((k) => Math.max(corners[k], corners[3 + k], corners[6 + k]));
    const beyond = [...out].filter((x, i) => !(x >= low[i % 3] && x <= high[i % 3]));
    expect(beyond).toEqual([]);
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

  function boundaryArrow(points: Polygon, i: number, pixel: number): [Segment, Segment] {
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

  /** Whether it lies outside, along its edge, with the barb away from the surface. */
  function expectOutside(face: Polygon, pixel: number) {
    const clockwise = [...face].reverse();
    clockwise.forEach((a, i) => {
      const b = clockwise[(i + 1) % clockwise.length];
      const [shaft, barb] = boundaryArrow(clockwise, i, pixel);
      for (const point of [...shaft, barb[1]]) expect(inside(point, face)).toBe(false);
      const [x, y] = [shaft[1][0] - shaft[0][0], shaft[1][1] - shaft[0][1]];
      expect(x * (b[0] - a[0]) + y * (b[1] - a[1])).toBeGreaterThan(0);
      expect(side(...shaft, barb[1])).toBeGreaterThan(0);
    });
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

  test('lies outside of slivers, and of concave faces where there is room', () => {
    const next = random(23);
    for (let run = 0; run < 300; run++) {
      for (const pixel of [0.01, 1]) expectOutside(randomSliver(next), pixel);
    }
    for (const face of [ell(0.5), regularStar(5, 0.4), comb(3, 0.2, 0.2)]) {
      expectOutside(face, 0.001);
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
        const slit = leaningSliver(degrees, 0.2);
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

describe('a dotted line', () => {
  const dotted = (length: number, period: number, duty: number) => {
    const batch = new LineBatch();
    batch.addDashed([0, 0, 0, length, 0, 0], 0, 3, new Color(), period, duty);
    const { instanceStart, instanceEnd } = batch.geometry.attributes;
    return Array.from({ length: batch.count }, (_, i) => [
      instanceStart.getX(i),
      instanceEnd.getX(i),
    ]);
  };

  test('has gaps, and reaches from one end to the other', () => {
    const dots = dotted(100, 5, 0.4);
    expect(dots.length).toBeGreaterThan(15);
    expect(dots[0][0]).toBe(0);
    expect(dots.at(-1)?.[1]).toBeCloseTo(100, 4);
    dots.forEach(([from, to], i) => {
      expect(to - from).toBeGreaterThan(1);
      if (i > 0) expect(from - dots[i - 1][1]).toBeGreaterThan(2);
    });
  });

  test('is one stroke where there is room for one only', () => {
    expect(dotted(2, 5, 0.4)).toEqual([[0, 2]]);
  });
});
