// The table of docs/names.md for three-mesh-halfedge, row by row, against that library.

import { HalfedgeMesh, init, NONE } from 'halfedge';
import { fromBufferGeometry } from 'halfedge/three';
import * as THREE from 'three';
import type { Halfedge, Vertex } from 'three-mesh-halfedge';
// @ts-expect-error: the types come with the name, which leads to no module that Node can load
import * as threeMeshHalfedge from '../../node_modules/three-mesh-halfedge/build/index.esm.js';

const { HalfedgeDS } = threeMeshHalfedge as typeof import('three-mesh-halfedge');

beforeAll(() => init());

const bent = () => {
  const geometry = new THREE.PlaneGeometry(1, 1, 4, 3);
  const { array } = geometry.attributes.position as THREE.BufferAttribute;
  for (let i = 0; i < array.length; i += 3) array[i + 2] = 0.3 * Math.sin(5 * (array[i] ?? 0));
  return geometry;
};
const geometries = {
  'a box': () => new THREE.BoxGeometry(1, 2, 3, 2, 2, 2),
  'a bent plane': bent,
  'an icosahedron': () => new THREE.IcosahedronGeometry(1, 1),
  'a tube': () => new THREE.CylinderGeometry(1, 1, 1, 6, 2, true),
};

/** The same geometry in both, and their items by ours. */
function both(geometry: THREE.BufferGeometry) {
  const struct = new HalfedgeDS();
  struct.setFromGeometry(geometry, 1e-5);
  const { mesh } = fromBufferGeometry(geometry, { weld: 1e-5 });
  const vertexOf = new Map<Vertex, number>();
  for (const vertex of struct.vertices) {
    const near = [...mesh.vertices()].filter(
      (v) => new THREE.Vector3(...mesh.position(v)).distanceTo(vertex.position) < 1e-4,
    );
    expect(near).toHaveLength(1);
    vertexOf.set(vertex, near[0] as number);
  }
  // As the table has it: h.vertex is where a halfedge begins.
  const halfedgeOf = (h: Halfedge | null) => {
    if (h === null) return NONE;
    const ends = [h.vertex, h.twin.vertex].map((vertex) => vertexOf.get(vertex) as number);
    return mesh.findHalfedge(ends[0] as number, ends[1] as number);
  };
  return { struct, mesh, vertexOf, halfedgeOf };
}

describe.each(Object.entries(geometries))('three-mesh-halfedge, of %s,', (_, geometry) => {
  test('has the links that the table of names says', () => {
    const { struct, mesh, vertexOf, halfedgeOf } = both(geometry());
    using _mesh = mesh;
    expect(struct.halfedges).toHaveLength(mesh.halfedgeCount);
    for (const theirs of struct.halfedges) {
      const h = halfedgeOf(theirs);
      expect(mesh.fromVertex(h)).toBe(vertexOf.get(theirs.vertex));
      expect(mesh.toVertex(h)).toBe(vertexOf.get(theirs.twin.vertex));
      expect(mesh.next(h)).toBe(halfedgeOf(theirs.next));
      expect(mesh.prev(h)).toBe(halfedgeOf(theirs.prev));
      expect(mesh.opposite(h)).toBe(halfedgeOf(theirs.twin));
      expect(mesh.face(h)).toBe(theirs.face === null ? NONE : struct.faces.indexOf(theirs.face));
      expect(mesh.isBoundaryHalfedge(h)).toBe(theirs.isFree());
      expect(mesh.isBoundaryHalfedge(h)).toBe(theirs.isBoundary());
      expect([...mesh.halfedgeLoop(h)]).toEqual([...theirs.nextLoop()].map(halfedgeOf));
      expect([...theirs.prevLoop()]).toEqual([...theirs.nextLoop()]); // as the page warns
      const bend = mesh.dihedralAngle(mesh.edge(h));
      if (!mesh.isBoundaryEdge(mesh.edge(h)) && Math.abs(bend) > 1e-3) {
        expect(theirs.isConcave).toBe(bend < 0);
      }
    }
    for (const [f, theirs] of struct.faces.entries()) {
      expect(mesh.next(mesh.faceHalfedge(f))).toBe(halfedgeOf(theirs.halfedge));
      const normal = new THREE.Vector3();
      theirs.getNormal(normal);
      expect(normal.distanceTo(new THREE.Vector3(...mesh.faceNormal(f)))).toBeLessThan(1e-5);
    }
    expect(struct.loops()).toHaveLength(mesh.faceCount + mesh.boundaryLoops().length);
  });

  test('goes around vertices as the table of names says', () => {
    const { struct, mesh, vertexOf, halfedgeOf } = both(geometry());
    using _mesh = mesh;
    for (const theirs of struct.vertices) {
      const v = vertexOf.get(theirs) as number;
      const start = halfedgeOf(theirs.halfedge);
      expect(mesh.fromVertex(start)).toBe(v);
      expect([...mesh.vertexOutgoingHalfedges(v, 'cw', start)]).toEqual(
        [...theirs.loopCW()].map(halfedgeOf),
      );
      expect([...mesh.vertexOutgoingHalfedges(v, 'ccw', start)]).toEqual(
        [...theirs.loopCCW()].map(halfedgeOf),
      );
      expect(mesh.isBoundaryVertex(v)).toBe(theirs.isFree());
      for (const other of struct.vertices) {
        const found = mesh.findHalfedge(v, vertexOf.get(other) as number);
        expect(found).toBe(halfedgeOf(theirs.getHalfedgeToVertex(other)));
      }
    }
  });
});

test('three-mesh-halfedge cuts, joins and splits as the operations of the table of names', () => {
  const facesOf = (mesh: HalfedgeMesh) =>
    [...mesh.faces()].map((f) => [...mesh.faceVertices(f)].sort().join()).sort();
  const { struct, mesh, vertexOf, halfedgeOf } = both(bent());
  using _mesh = mesh;
  const theirFaces = () =>
    struct.faces
      .map((f) => [...f.halfedge.nextLoop()].map((h) => vertexOf.get(h.vertex) as number))
      .map((corners) => corners.sort().join())
      .sort();
  expect(facesOf(mesh)).toEqual(theirFaces());

  // Two triangles become a quad, which is cut along its other diagonal.
  const inner = struct.halfedges.find((h) => h.face !== null && h.twin.face !== null) as Halfedge;
  const [a, b] = [inner.next.twin.vertex, inner.twin.next.twin.vertex];
  mesh.removeEdge(mesh.edge(halfedgeOf(inner)));
  struct.removeEdge(inner);
  expect(facesOf(mesh)).toEqual(theirFaces());
  const face = inner.face as NonNullable<typeof inner.face>;
  const f = mesh.face(halfedgeOf(face.halfedge));
  const endingAt = (vertex: Vertex) =>
    [...mesh.faceHalfedges(f)].find((h) => mesh.toVertex(h) === vertexOf.get(vertex)) as number;
  mesh.insertEdge(endingAt(a), endingAt(b));
  struct.cutFace(face, a, b);
  expect(facesOf(mesh)).toEqual(theirFaces());

  // An edge that is removed together with its faces.
  const other = struct.halfedges.find((h) => h.face !== null && h.twin.face !== null) as Halfedge;
  mesh.deleteEdge(mesh.edge(halfedgeOf(other)));
  struct.removeEdge(other, false);
  expect(facesOf(mesh)).toEqual(theirFaces());
});

test('makeHole refuses where removeFace of three-mesh-halfedge leaves edges without faces', () => {
  using mesh = HalfedgeMesh.fromFaces([[0, 1, 2]]);
  expect(mesh.checkMakeHole(0)?.code).toBe('edge-without-face');
  mesh.deleteFace(0);
  expect(mesh.edgeCount).toBe(0);
});
