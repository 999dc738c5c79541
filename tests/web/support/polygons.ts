export type Point = readonly [number, number];
export type Segment = readonly [Point, Point];
export type Polygon = readonly Point[];

/** Positive where c lies to the left of the way from a to b. */
export const side = (a: Point, b: Point, c: Point) =>
  (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);

/** Whether two segments have a point in common in their interiors. */
export function cross([a, b]: Segment, [c, d]: Segment): boolean {
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

export const edgesOf = (polygon: Polygon): Segment[] =>
  polygon.map((p, i) => [p, polygon[(i + 1) % polygon.length]]);

export function inside(point: Point, polygon: Polygon): boolean {
  let odd = false;
  for (const [a, b] of edgesOf(polygon)) {
    if (a[1] > point[1] === b[1] > point[1]) continue;
    if (point[0] < a[0] + ((point[1] - a[1]) / (b[1] - a[1])) * (b[0] - a[0])) odd = !odd;
  }
  return odd;
}

/** A triangle with unit base whose apex angle is `degrees` if `lean` is 0, which moves the apex aside. */
export function leaningSliver(degrees: number, lean: number): Point[] {
  const height = 0.5 / Math.tan((degrees * Math.PI) / 360);
  return [
    [0, 0],
    [1, 0],
    [0.5 + lean * height, height],
  ];
}

/** A triangle with an angle of 2 to 8 degrees, any other angles, any size and turned anyhow. */
export function randomSliver(next: () => number): Point[] {
  const radians = (degrees: number) => (degrees * Math.PI) / 180;
  const sharp = radians(2 + 6 * next());
  const other = radians(1) + (Math.PI - sharp - radians(2)) * next();
  const size = 10 ** (2 * next() - 1);
  // Along the two sides of the sharp corner, by the law of sines.
  const [b, c] = [Math.sin(other), Math.sin(sharp + other)].map((sine) => size * sine);
  const turn = 2 * Math.PI * next();
  const at = (length: number, angle: number): Point => [
    length * Math.cos(turn + angle),
    length * Math.sin(turn + angle),
  ];
  const corners = [at(0, 0), at(c, 0), at(b, sharp)];
  const first = Math.floor(3 * next());
  return corners.map((_, i) => corners[(i + first) % 3]);
}

/** A polygon that is star-shaped around the origin, with reflex corners of every sharpness. */
export function randomStar(corners: number, next: () => number): Point[] {
  return Array.from({ length: corners }, (_, i): Point => {
    const angle = (2 * Math.PI * (i + 0.8 * next())) / corners;
    const radius = 0.1 + 0.9 * next();
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  });
}

/** Any simple polygon: a tour of random points, untangled where it crosses itself. */
export function randomSimplePolygon(corners: number, next: () => number): Point[] {
  for (;;) {
    const tour = Array.from({ length: corners }, (): Point => [next(), next()]);
    while (untangle(tour));
    if (clearance(tour) < 2e-3) continue;
    return area(tour) > 0 ? tour : tour.reverse();
  }
}

/** An L whose arms are `width` wide. */
export function ell(width: number): Point[] {
  return [
    [0, 0],
    [1, 0],
    [1, width],
    [width, width],
    [width, 1],
    [0, 1],
  ];
}

/** A comb: teeth that are `tooth` wide, with gaps of `gap` between them. */
export function comb(teeth: number, tooth: number, gap: number): Point[] {
  const width = teeth * tooth + (teeth - 1) * gap;
  const tips: Point[] = [];
  for (let i = teeth - 1; i >= 0; i--) {
    const left = i * (tooth + gap);
    tips.push([left + tooth, 0.2], [left + tooth, 1], [left, 1], [left, 0.2]);
  }
  // The outer teeth go on straight into the back.
  return [[0, 0], [width, 0], ...tips.slice(1, -1)];
}

/** A star with `points` equal tips, whose inner corners are at `inner` of the radius. */
export function regularStar(points: number, inner: number): Point[] {
  return Array.from({ length: 2 * points }, (_, i): Point => {
    const radius = i % 2 === 0 ? 1 : inner;
    return [radius * Math.cos((Math.PI * i) / points), radius * Math.sin((Math.PI * i) / points)];
  });
}

/** Turns round one stretch of the tour so that two edges no longer cross; false if none do. */
function untangle(tour: Point[]): boolean {
  for (let i = 0; i < tour.length; i++) {
    for (let j = i + 2; j < tour.length; j++) {
      const closing: Segment = [tour[j], tour[(j + 1) % tour.length]];
      if (!cross([tour[i], tour[i + 1]], closing)) continue;
      const stretch = tour.slice(i + 1, j + 1).reverse();
      tour.splice(i + 1, stretch.length, ...stretch);
      return true;
    }
  }
  return false;
}

const area = (polygon: Polygon) =>
  edgesOf(polygon).reduce((sum, [a, b]) => sum + a[0] * b[1] - b[0] * a[1], 0) / 2;

/** The least distance from a corner to an edge that it is not on. */
function clearance(polygon: Polygon): number {
  let least = Infinity;
  for (const [a, b] of edgesOf(polygon)) {
    for (const p of polygon) {
      if (p !== a && p !== b) least = Math.min(least, distance(p, a, b));
    }
  }
  return least;
}

function distance(p: Point, a: Point, b: Point): number {
  const [x, y] = [b[0] - a[0], b[1] - a[1]];
  const along = ((p[0] - a[0]) * x + (p[1] - a[1]) * y) / (x * x + y * y);
  const t = Math.min(1, Math.max(0, along));
  return Math.hypot(p[0] - a[0] - t * x, p[1] - a[1] - t * y);
}
