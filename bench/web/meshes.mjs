// The inputs of the benchmark: index buffers over shared vertices, in natural and in shuffled order.

/** An open grid of side × side vertices, two triangles to a cell. */
export function grid(side) {
  const positions = new Float32Array(3 * side * side);
  const triangles = new Uint32Array(6 * (side - 1) * (side - 1));
  let p = 0;
  let t = 0;
  for (let y = 0; y < side; y++) {
    for (let x = 0; x < side; x++) {
      positions[p++] = x;
      positions[p++] = y;
      positions[p++] = Math.sin(0.1 * x) * Math.cos(0.07 * y);
      if (x + 1 === side || y + 1 === side) continue;
      const a = y * side + x;
      triangles.set([a, a + 1, a + side + 1, a, a + side + 1, a + side], t);
      t += 6;
    }
  }
  return { positions, triangles, closed: false };
}

/** A torus of side × side vertices, two triangles to a cell: no boundary, and any number of faces. */
export function torus(side) {
  const positions = new Float32Array(3 * side * side);
  const triangles = new Uint32Array(6 * side * side);
  const turn = (2 * Math.PI) / side;
  let p = 0;
  let t = 0;
  for (let y = 0; y < side; y++) {
    const radius = 3 + Math.cos(turn * y);
    const below = side * ((y + 1) % side);
    for (let x = 0; x < side; x++) {
      positions[p++] = radius * Math.cos(turn * x);
      positions[p++] = radius * Math.sin(turn * x);
      positions[p++] = Math.sin(turn * y);
      const right = (x + 1) % side;
      const [a, b, c, d] = [side * y + x, side * y + right, below + right, below + x];
      triangles[t++] = a;
      triangles[t++] = b;
      triangles[t++] = c;
      triangles[t++] = a;
      triangles[t++] = c;
      triangles[t++] = d;
    }
  }
  return { positions, triangles, closed: true };
}

/** A sphere: an icosahedron, each face split in four so many times, 20 * 4^times faces. */
export function icosphere(times) {
  let { points, triangles } = icosahedron();
  for (let i = 0; i < times; i++) ({ points, triangles } = splitInFour(points, triangles));
  return {
    positions: Float32Array.from(points),
    triangles: Uint32Array.from(triangles),
    closed: true,
  };
}

/** Each face split in four at the middles of its edges. */
export function subdivided({ positions, triangles, closed }) {
  const finer = splitInFour(positions, triangles);
  return {
    positions: Float32Array.from(finer.points),
    triangles: Uint32Array.from(finer.triangles),
    closed,
  };
}

function icosahedron() {
  const golden = (1 + Math.sqrt(5)) / 2;
  const corners = [-1, 1].flatMap((a) =>
    [-golden, golden].flatMap((b) => [
      [0, a, b],
      [a, b, 0],
      [b, 0, a],
    ]),
  );
  const near = (i, j) => Math.hypot(...corners[i].map((x, k) => x - corners[j][k])) < 2.1;
  const triangles = [];
  for (let i = 0; i < 12; i++) {
    for (let j = i + 1; j < 12; j++) {
      for (let k = j + 1; k < 12; k++) {
        if (!near(i, j) || !near(j, k) || !near(i, k)) continue;
        triangles.push(i, ...(facesOutward(corners[i], corners[j], corners[k]) ? [j, k] : [k, j]));
      }
    }
  }
  const points = corners.flat();
  ontoSphere(points);
  return { points, triangles };
}

function facesOutward([ax, ay, az], [bx, by, bz], [cx, cy, cz]) {
  return ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx) > 0;
}

function splitInFour(corners, triangles) {
  const points = Array.from(corners);
  const middles = new Map();
  const middle = (a, b) => {
    const key = Math.min(a, b) * 2 ** 26 + Math.max(a, b);
    let m = middles.get(key);
    if (m === undefined) {
      m = points.length / 3;
      middles.set(key, m);
      for (let k = 0; k < 3; k++) points.push((corners[3 * a + k] + corners[3 * b + k]) / 2);
    }
    return m;
  };
  const split = [];
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = triangles.slice(i, i + 3);
    const [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
    split.push(a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca);
  }
  ontoSphere(points);
  return { points, triangles: split };
}

function ontoSphere(points) {
  for (let i = 0; i < points.length; i += 3) {
    const length = Math.hypot(points[i], points[i + 1], points[i + 2]);
    for (let k = i; k < i + 3; k++) points[k] /= length;
  }
}

/** The same mesh with vertices and faces in random order, and each face beginning anywhere. */
export function shuffled({ positions, triangles, closed }, seed = 1) {
  const next = random(seed);
  const vertexCount = positions.length / 3;
  const name = permutation(vertexCount, next);
  const moved = new Float32Array(positions.length);
  for (let v = 0; v < vertexCount; v++) {
    for (let k = 0; k < 3; k++) moved[3 * name[v] + k] = positions[3 * v + k];
  }
  const order = permutation(triangles.length / 3, next);
  const renamed = new Uint32Array(triangles.length);
  order.forEach((f, i) => {
    const turn = Math.floor(3 * next());
    for (let k = 0; k < 3; k++) renamed[3 * i + k] = name[triangles[3 * f + ((k + turn) % 3)]];
  });
  return { positions: moved, triangles: renamed, closed };
}

function permutation(count, next) {
  const list = Uint32Array.from({ length: count }, (_, i) => i);
  for (let i = count - 1; i > 0; i--) {
    const j = Math.floor(next() * (i + 1));
    [list[i], list[j]] = [list[j], list[i]];
  }
  return list;
}

/** A small seeded generator (mulberry32) of numbers in [0, 1). */
function random(seed) {
  let state = seed | 0;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}
