// What is measured, and how each library does it. Every pass returns a sum over what it visited,
// which does not depend on the order: all contenders of a row must agree on it.

import { buildFlat, flatFaceFaces, flatOneRings } from './flat.mjs';
import { faceNormalsByHand, roughSum, vertexNormalsByHand } from './normals.mjs';

const NONE = -1;

/**
 * The rows: `builds` and `passes`. Each has a function for each contender, timed, and `sum`, which
 * turns what that returned into the number to agree on, not timed. The builds fill `made` with what
 * the passes run over.
 */
export function rowsFor({ HalfedgeMesh, three, threeMeshHalfedge, manifold, csg }, input) {
  const { positions, triangles, closed } = input;
  const made = {};
  const kept = {}; // rows, for the next round
  const views = () => made.halfedge.connectivity;
  const solid = () =>
    new manifold.Manifold(
      new manifold.Mesh({ numProp: 3, vertProperties: positions, triVerts: triangles }),
    );

  const builds = {
    title: 'build',
    run: {
      halfedge: () => HalfedgeMesh.fromTriangles(positions, triangles),
      flat: () => buildFlat(positions.length / 3, triangles),
      tmh: () => buildTmh(three, threeMeshHalfedge, input),
      csg: () => buildCsg(three, csg, input),
      ...(closed && { manifold: solid }),
    },
    /** Keeps what was built, for the passes. */
    keep(who, built) {
      made[who] = who === 'tmh' ? numbered(built, triangles) : built;
    },
    forget(who, built) {
      if (who === 'halfedge') built.dispose();
      if (who === 'manifold') built.delete();
    },
    sum(who) {
      if (who === 'halfedge') return oneRingsByHand(views());
      if (who === 'flat') return flatOneRings(made.flat);
      if (who === 'tmh') return tmhOneRings(made.tmh);
      // It knows neighbours across edges, no vertices.
      if (who === 'csg')
        return csgFaceFaces(made.csg) === faceFacesByHand(views())
          ? oneRingsByHand(views())
          : Number.NaN;
      // It has no adjacency to ask for: its count of triangles must do.
      return made.manifold.numTri() === triangles.length / 3 ? oneRingsByHand(views()) : Number.NaN;
    },
  };

  const passes = [
    {
      title: 'one-rings: `for…of`',
      run: {
        halfedge: () => oneRingsForOf(made.halfedge),
        hand: () => oneRingsByHand(views()),
        flat: () => flatOneRings(made.flat),
        tmh: () => tmhOneRings(made.tmh),
      },
    },
    {
      title: 'one-rings: accessors',
      run: {
        halfedge: () => oneRingsByAccessors(made.halfedge),
        hand: () => oneRingsByHand(views()),
        tmh: () => tmhOneRingsByFields(made.tmh),
      },
    },
    {
      title: 'one-rings: a circulator for each',
      run: {
        halfedge: () => oneRingsByCirculators(made.halfedge),
        hand: () => oneRingsByHand(views()),
      },
    },
    {
      title: 'one-rings: a circulator for each, clockwise',
      run: {
        halfedge: () => oneRingsByCirculatorsCw(made.halfedge),
        hand: () => oneRingsByHandCw(views()),
      },
    },
    {
      title: 'one-rings: one circulator, moved',
      run: {
        halfedge: () => oneRingsByMovedCirculator(made.halfedge),
        hand: () => oneRingsByHand(views()),
      },
    },
    {
      title: 'one-rings: each into a buffer, then read',
      run: {
        halfedge: () => oneRingsInto(made.halfedge),
        hand: () => oneRingsIntoByHand(views()),
      },
    },
    {
      title: 'one-rings: all as rows',
      run: {
        halfedge: () => made.halfedge.allVertexVertices(),
        hand: () => oneRingRowsByHand(views()),
      },
      sum: (_, rows) => sumOfRows(rows),
    },
    {
      title: 'one-rings: all as rows, into the same arrays, then read',
      run: {
        halfedge: () => {
          kept.oneRings = made.halfedge.allVertexVertices('ccw', undefined, kept.oneRings);
          return sumOfRows(kept.oneRings);
        },
        hand: () => oneRingsByHand(views()),
        tmh: () => tmhOneRings(made.tmh),
      },
    },
    {
      title: 'faces of vertices: `for…of`',
      run: {
        halfedge: () => vertexFacesForOf(made.halfedge),
        hand: () => vertexFacesByHand(views()),
        tmh: () => tmhVertexFaces(made.tmh),
      },
    },
    {
      title: 'face neighbours: `for…of`',
      run: {
        halfedge: () => faceFacesForOf(made.halfedge),
        hand: () => faceFacesByHand(views()),
        flat: () => flatFaceFaces(made.flat),
        tmh: () => tmhFaceFaces(made.tmh),
        csg: () => csgFaceFaces(made.csg),
      },
    },
    {
      title: 'face neighbours: all as rows',
      run: {
        halfedge: () => made.halfedge.allFaceFaces(),
        hand: () => faceFaceRowsByHand(views()),
      },
      sum: (_, rows) => sumOfRows(rows),
    },
    {
      title: 'face neighbours: all as rows, into the same arrays, then read',
      run: {
        halfedge: () => {
          kept.faceFaces = made.halfedge.allFaceFaces('ccw', undefined, kept.faceFaces);
          return sumOfRows(kept.faceFaces);
        },
        hand: () => faceFacesByHand(views()),
        tmh: () => tmhFaceFaces(made.tmh),
      },
    },
    {
      title: 'face normals: all, into the same array',
      run: {
        halfedge: () => {
          kept.faceNormals = made.halfedge.allFaceNormals(kept.faceNormals);
          return kept.faceNormals;
        },
        hand: () => {
          kept.byHand ??= new Float32Array(triangles.length);
          faceNormalsByHand(views(), made.halfedge.positions, kept.byHand);
          return kept.byHand;
        },
      },
      sum: (_, normals) => roughSum(normals),
    },
    {
      title: 'vertex normals: all, into the same array',
      run: {
        halfedge: () => {
          kept.vertexNormals = made.halfedge.allVertexNormals(kept.vertexNormals);
          return kept.vertexNormals;
        },
        hand: () => {
          kept.smooth ??= new Float32Array(positions.length);
          vertexNormalsByHand(views(), made.halfedge.positions, kept.smooth);
          return kept.smooth;
        },
        three: () => {
          kept.geometry ??= new three.BufferGeometry()
            .setAttribute('position', new three.BufferAttribute(positions, 3))
            .setIndex(new three.BufferAttribute(triangles, 1));
          kept.geometry.computeVertexNormals();
          return kept.geometry.getAttribute('normal').array;
        },
      },
      sum: (_, normals) => roughSum(normals),
    },
  ];
  return { builds, passes, made };
}

// ---- halfedge ----------------------------------------------------------------------------------

export function oneRingsForOf(mesh) {
  let sum = 0;
  for (let v = 0; v < mesh.vertexSlots; v++) {
    for (const w of mesh.vertexVertices(v)) sum = (sum + (w ^ v)) | 0;
  }
  return sum;
}

export function oneRingsByAccessors(mesh) {
  let sum = 0;
  const { vertexSlots } = mesh;
  for (let v = 0; v < vertexSlots; v++) {
    const first = mesh.vertexHalfedge(v);
    if (first === NONE) continue;
    let h = first;
    do {
      sum = (sum + (mesh.toVertex(h) ^ v)) | 0;
      h = mesh.rotateCcw(h);
    } while (h !== first);
  }
  return sum;
}

function oneRingsByCirculators(mesh) {
  let sum = 0;
  const { vertexSlots } = mesh;
  for (let v = 0; v < vertexSlots; v++) {
    const ring = mesh.circulate('vertexVertices', v);
    const first = ring.halfedge;
    if (first === NONE) continue;
    do {
      sum = (sum + (ring.current ^ v)) | 0;
      ring.next();
    } while (ring.halfedge !== first);
  }
  return sum;
}

function oneRingsByCirculatorsCw(mesh) {
  let sum = 0;
  const { vertexSlots } = mesh;
  for (let v = 0; v < vertexSlots; v++) {
    const ring = mesh.circulate('vertexVertices', v, 'cw');
    const first = ring.halfedge;
    if (first === NONE) continue;
    do {
      sum = (sum + (ring.current ^ v)) | 0;
      ring.next();
    } while (ring.halfedge !== first);
  }
  return sum;
}

function oneRingsByMovedCirculator(mesh) {
  let sum = 0;
  const { vertexSlots } = mesh;
  const ring = mesh.circulate('vertexVertices', 0);
  for (let v = 0; v < vertexSlots; v++) {
    const first = ring.moveTo(v).halfedge;
    if (first === NONE) continue;
    do {
      sum = (sum + (ring.current ^ v)) | 0;
      ring.next();
    } while (ring.halfedge !== first);
  }
  return sum;
}

function oneRingsInto(mesh) {
  let sum = 0;
  const { vertexSlots } = mesh;
  const ring = new Int32Array(64);
  for (let v = 0; v < vertexSlots; v++) {
    const valence = mesh.vertexVertices(v).into(ring);
    for (let i = 0; i < valence; i++) sum = (sum + (ring[i] ^ v)) | 0;
  }
  return sum;
}

function vertexFacesForOf(mesh) {
  let sum = 0;
  for (let v = 0; v < mesh.vertexSlots; v++) {
    for (const f of mesh.vertexFaces(v)) sum = (sum + (f ^ v)) | 0;
  }
  return sum;
}

function faceFacesForOf(mesh) {
  let sum = 0;
  for (let f = 0; f < mesh.faceSlots; f++) {
    for (const g of mesh.faceFaces(f)) sum = (sum + (g ^ f)) | 0;
  }
  return sum;
}

/** What other parts of a program do: several kinds, both directions, a boundary, options, an isolated vertex. */
export function goAroundOthers(mesh) {
  mesh.addVertex([0, 0, 0]);
  for (let round = 0; round < 20; round++) {
    for (let v = 0; v < mesh.vertexSlots; v++) {
      walkOnce(mesh.circulate('vertexVertices', v));
      walkOnce(mesh.circulate('vertexFaces', v, 'cw'));
      walkOnce(mesh.circulate('vertexOutgoingHalfedges', v, { direction: 'cw' }));
      for (const f of mesh.vertexFaces(v)) if (f === NONE) throw new Error('A face that is none.');
    }
    for (let f = 0; f < mesh.faceSlots; f++) walkOnce(mesh.circulate('faceVertices', f));
  }
}

function walkOnce(circulator) {
  const first = circulator.halfedge;
  if (first === NONE) return;
  do circulator.next();
  while (circulator.halfedge !== first);
}

function sumOfRows({ offsets, items }) {
  let sum = 0;
  for (let row = 0; row + 1 < offsets.length; row++) {
    const end = offsets[row + 1];
    for (let i = offsets[row]; i < end; i++) sum = (sum + (items[i] ^ row)) | 0;
  }
  return sum;
}

// ---- by hand, over the same arrays ---------------------------------------------------------------

function oneRingsByHand({ prev, toVertex, vertexHalfedge }) {
  let sum = 0;
  for (let v = 0; v < vertexHalfedge.length; v++) {
    const first = vertexHalfedge[v];
    if (first < 0) continue;
    let h = first;
    do {
      h = prev[h] ^ 1;
      sum = (sum + (toVertex[h] ^ v)) | 0;
    } while (h !== first);
  }
  return sum;
}

function oneRingsByHandCw({ next, toVertex, vertexHalfedge }) {
  let sum = 0;
  for (let v = 0; v < vertexHalfedge.length; v++) {
    const first = vertexHalfedge[v];
    if (first < 0) continue;
    let h = first;
    do {
      sum = (sum + (toVertex[h] ^ v)) | 0;
      h = next[h ^ 1];
    } while (h !== first);
  }
  return sum;
}

function oneRingsIntoByHand({ prev, toVertex, vertexHalfedge }) {
  let sum = 0;
  const ring = new Int32Array(64);
  for (let v = 0; v < vertexHalfedge.length; v++) {
    const first = vertexHalfedge[v];
    if (first < 0) continue;
    let count = 0;
    let h = first;
    do {
      h = prev[h] ^ 1;
      ring[count++] = toVertex[h];
    } while (h !== first);
    for (let i = 0; i < count; i++) sum = (sum + (ring[i] ^ v)) | 0;
  }
  return sum;
}

function oneRingRowsByHand({ prev, toVertex, vertexHalfedge }) {
  const offsets = new Uint32Array(vertexHalfedge.length + 1);
  const items = new Uint32Array(toVertex.length);
  let count = 0;
  for (let v = 0; v < vertexHalfedge.length; v++) {
    const first = vertexHalfedge[v];
    let h = first;
    if (first >= 0) {
      do {
        h = prev[h] ^ 1;
        items[count++] = toVertex[h];
      } while (h !== first);
    }
    offsets[v + 1] = count;
  }
  return { offsets, items };
}

function vertexFacesByHand({ prev, face, vertexHalfedge }) {
  let sum = 0;
  for (let v = 0; v < vertexHalfedge.length; v++) {
    const first = vertexHalfedge[v];
    if (first < 0) continue;
    let h = first;
    do {
      h = prev[h] ^ 1;
      const f = face[h];
      if (f >= 0) sum = (sum + (f ^ v)) | 0;
    } while (h !== first);
  }
  return sum;
}

function faceFacesByHand({ next, face, faceHalfedge }) {
  let sum = 0;
  for (let f = 0; f < faceHalfedge.length; f++) {
    const first = faceHalfedge[f];
    let h = first;
    do {
      const g = face[h ^ 1];
      if (g >= 0) sum = (sum + (g ^ f)) | 0;
      h = next[h];
    } while (h !== first);
  }
  return sum;
}

function faceFaceRowsByHand({ next, face, faceHalfedge }) {
  const offsets = new Uint32Array(faceHalfedge.length + 1);
  const items = new Uint32Array(next.length);
  let count = 0;
  for (let f = 0; f < faceHalfedge.length; f++) {
    const first = faceHalfedge[f];
    let h = first;
    do {
      const g = face[h ^ 1];
      if (g >= 0) items[count++] = g;
      h = next[h];
    } while (h !== first);
    offsets[f + 1] = count;
  }
  return { offsets, items: items.subarray(0, count) };
}

// ---- three-mesh-halfedge ---------------------------------------------------------------------------

function geometryOf(three, { positions, triangles }) {
  const geometry = new three.BufferGeometry();
  geometry.setAttribute('position', new three.BufferAttribute(positions, 3));
  geometry.setIndex(new three.BufferAttribute(triangles, 1));
  return geometry;
}

function buildTmh(three, { HalfedgeDS }, input) {
  const structure = new HalfedgeDS();
  structure.setFromGeometry(geometryOf(three, input));
  return structure;
}

/** Gives vertices and faces the numbers of the input: it numbers vertices as faces first use them. */
function numbered(structure, triangles) {
  const named = new Uint8Array(structure.vertices.length);
  let i = 0;
  for (const v of triangles) {
    if (named[v]) continue;
    named[v] = 1;
    structure.vertices[i++].id = v;
  }
  structure.faces.forEach((face, f) => {
    face.id = f;
  });
  return structure;
}

function tmhOneRings({ vertices }) {
  let sum = 0;
  for (const vertex of vertices) {
    for (const h of vertex.loopCCW()) sum = (sum + (h.twin.vertex.id ^ vertex.id)) | 0;
  }
  return sum;
}

function tmhOneRingsByFields({ vertices }) {
  let sum = 0;
  for (const vertex of vertices) {
    const first = vertex.halfedge;
    let h = first;
    do {
      sum = (sum + (h.twin.vertex.id ^ vertex.id)) | 0;
      h = h.prev.twin;
    } while (h !== first);
  }
  return sum;
}

function tmhVertexFaces({ vertices }) {
  let sum = 0;
  for (const vertex of vertices) {
    for (const h of vertex.loopCCW()) if (h.face) sum = (sum + (h.face.id ^ vertex.id)) | 0;
  }
  return sum;
}

function tmhFaceFaces({ faces }) {
  let sum = 0;
  for (const face of faces) {
    for (const { twin } of face.halfedge.nextLoop()) {
      if (twin.face) sum = (sum + (twin.face.id ^ face.id)) | 0;
    }
  }
  return sum;
}

// ---- three-bvh-csg: for each triangle the ones across its edges, no more ---------------------------

function buildCsg(three, { HalfEdgeMap }, input) {
  const siblings = new HalfEdgeMap();
  siblings.updateFrom(geometryOf(three, input));
  return siblings;
}

function csgFaceFaces(siblings) {
  let sum = 0;
  const faces = siblings.data.length / 3;
  for (let f = 0; f < faces; f++) {
    for (let side = 0; side < 3; side++) {
      const g = siblings.getSiblingTriangleIndex(f, side);
      if (g >= 0) sum = (sum + (g ^ f)) | 0;
    }
  }
  return sum;
}
