import { HalfedgeMesh } from 'halfedge';

// What the package itself has no shape for.

/** 12 pentagons and 20 hexagons: the icosahedron with its corners cut off. */
export function truncatedIcosahedron(): HalfedgeMesh {
  const whole = HalfedgeMesh.icosahedron({ radius: 2 });
  // A vertex on each halfedge, a third of the way, numbered as the halfedges are.
  const positions = [...whole.halfedges()].flatMap((h) => {
    const [from, to] = [whole.position(whole.fromVertex(h)), whole.position(whole.toVertex(h))];
    return from.map((x, k) => (2 * x + to[k]) / 3);
  });
  const hexagons = [...whole.faces()].map((f) =>
    [...whole.faceHalfedges(f)].flatMap((h) => [h, whole.opposite(h)]),
  );
  const pentagons = [...whole.vertices()].map((v) => [...whole.vertexOutgoingHalfedges(v)]);
  whole.dispose();
  return HalfedgeMesh.fromPolygons(positions, [...hexagons, ...pentagons]);
}

/** A gently waving sheet of `size` × `size` quads: one boundary loop. */
export function openGrid(size: number): HalfedgeMesh {
  const mesh = HalfedgeMesh.grid(size, size, { width: 2, height: 2 });
  for (const v of mesh.vertices()) {
    const [x, y] = mesh.position(v);
    mesh.positions.set([x, 0.16 * Math.sin(2.4 * x + 0.6) * Math.cos(2.1 * y), -y], 3 * v);
  }
  return mesh;
}

/** A flat ring of `around` × 2 quads: two boundary loops, Euler characteristic 0. */
export function annulus(around: number): HalfedgeMesh {
  const positions: number[] = [];
  const faces: number[][] = [];
  for (let i = 0; i < around; i++) {
    const angle = (2 * Math.PI * i) / around;
    for (let ring = 0; ring < 3; ring++) {
      const radius = 0.45 + 0.28 * ring;
      positions.push(radius * Math.cos(angle), 0.05 * (ring % 2), -radius * Math.sin(angle));
    }
    const here = 3 * i;
    const next = 3 * ((i + 1) % around);
    for (let ring = 0; ring < 2; ring++) {
      faces.push([here + ring, here + ring + 1, next + ring + 1, next + ring]);
    }
  }
  return HalfedgeMesh.fromPolygons(positions, faces);
}

/** Three fans of triangles that meet in one vertex only: `next` of its boundary joins them. */
export function pinchedVertex(): HalfedgeMesh {
  const positions = [0, 0, 0];
  const faces: number[][] = [];
  for (let fan = 0; fan < 3; fan++) {
    const first = positions.length / 3;
    const spokes = 4;
    for (let i = 0; i <= spokes; i++) {
      const angle = (2 * Math.PI * (fan + 0.62 * (i / spokes))) / 3;
      positions.push(Math.cos(angle), 0.12 * Math.sin(3 * angle), -Math.sin(angle));
      if (i < spokes) faces.push([0, first + i, first + i + 1]);
    }
  }
  return HalfedgeMesh.fromPolygons(positions, faces);
}

/** A prism over a five-pointed star: two concave ten-sided faces and ten quads. */
export function starPrism(): HalfedgeMesh {
  const positions: number[] = [];
  const tips = 5;
  const corners = 2 * tips;
  for (const height of [0.22, -0.22]) {
    for (let i = 0; i < corners; i++) {
      const angle = Math.PI / 2 + (Math.PI * i) / tips;
      const radius = i % 2 === 0 ? 1 : 0.42;
      positions.push(radius * Math.cos(angle), radius * Math.sin(angle), height);
    }
  }
  const front = Array.from({ length: corners }, (_, i) => i);
  const faces = [front, front.map((i) => 2 * corners - 1 - i)];
  for (const i of front) {
    const j = (i + 1) % corners;
    faces.push([j, i, corners + i, corners + j]);
  }
  return HalfedgeMesh.fromPolygons(positions, faces);
}
