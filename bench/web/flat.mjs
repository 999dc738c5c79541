// The baseline: what an expert writes in an afternoon, in plain JavaScript, for triangles only and
// without a check of anything. "Directed edges": halfedge 3f + i leaves corner i of face f, so that
// next, prev, face and vertices need no storage; 28 bytes to a vertex beside the index buffer.

const nextInFace = (h) => (h % 3 === 2 ? h - 2 : h + 1);
const prevInFace = (h) => (h % 3 === 0 ? h + 2 : h - 1);

/**
 * Finds the opposite of each halfedge (-1 on the boundary), and one outgoing halfedge of each vertex,
 * on the boundary the one from which turning counter-clockwise meets them all.
 */
export function buildFlat(vertexCount, triangles) {
  const opposite = new Int32Array(triangles.length).fill(-1);
  const vertexHalfedge = new Int32Array(vertexCount).fill(-1);
  // Halfedges that wait for their opposite, in a list for each smaller vertex.
  const waiting = new Int32Array(vertexCount).fill(-1);
  const following = new Int32Array(triangles.length);
  for (let h = 0; h < triangles.length; h++) {
    const from = triangles[h];
    const to = triangles[nextInFace(h)];
    const list = Math.min(from, to);
    let before = -1;
    let other = waiting[list];
    while (other >= 0 && !(triangles[other] === to && triangles[nextInFace(other)] === from)) {
      before = other;
      other = following[other];
    }
    if (other < 0) {
      following[h] = waiting[list];
      waiting[list] = h;
    } else {
      opposite[h] = other;
      opposite[other] = h;
      if (before < 0) waiting[list] = following[other];
      else following[before] = following[other];
    }
    vertexHalfedge[from] = h;
  }
  for (let v = 0; v < vertexCount; v++) {
    for (let h = waiting[v]; h >= 0; h = following[h]) vertexHalfedge[triangles[h]] = h;
  }
  return { triangles, opposite, vertexHalfedge };
}

/** All one-rings, summed up. */
export function flatOneRings({ triangles, opposite, vertexHalfedge }) {
  let sum = 0;
  for (let v = 0; v < vertexHalfedge.length; v++) {
    const first = vertexHalfedge[v];
    let h = first;
    while (h >= 0) {
      sum = (sum + (triangles[nextInFace(h)] ^ v)) | 0;
      const back = prevInFace(h);
      h = opposite[back];
      if (h === first) break;
      if (h < 0) sum = (sum + (triangles[back] ^ v)) | 0;
    }
  }
  return sum;
}

/** The neighbours of all faces, summed up. */
export function flatFaceFaces({ opposite }) {
  let sum = 0;
  for (let h = 0, f = 0; h < opposite.length; h += 3, f++) {
    for (let k = h; k < h + 3; k++) {
      const other = opposite[k];
      if (other >= 0) sum = (sum + (((other / 3) | 0) ^ f)) | 0;
    }
  }
  return sum;
}
