// Normals by hand, over the links and positions of a mesh of triangles. The same lines stand in both loops: these are
// what ours are measured by, and a call would be one thing more that V8 may inline or not.

/** Triangles only, as an expert writes it for one program. */
export function faceNormalsByHand({ next, toVertex, faceHalfedge }, positions, out) {
  for (let f = 0; f < faceHalfedge.length; f++) {
    const h = faceHalfedge[f];
    const a = 3 * toVertex[h];
    const b = 3 * toVertex[next[h]];
    const c = 3 * toVertex[h ^ 1];
    const ux = positions[b] - positions[a];
    const uy = positions[b + 1] - positions[a + 1];
    const uz = positions[b + 2] - positions[a + 2];
    const vx = positions[c] - positions[a];
    const vy = positions[c + 1] - positions[a + 1];
    const vz = positions[c + 2] - positions[a + 2];
    const x = uy * vz - uz * vy;
    const y = uz * vx - ux * vz;
    const z = ux * vy - uy * vx;
    const scale = 1 / Math.sqrt(x * x + y * y + z * z);
    out[3 * f] = x * scale;
    out[3 * f + 1] = y * scale;
    out[3 * f + 2] = z * scale;
  }
}

/** The same, scattered to the corners; weighted by area. */
export function vertexNormalsByHand({ next, toVertex, faceHalfedge }, positions, out) {
  out.fill(0);
  for (let f = 0; f < faceHalfedge.length; f++) {
    const h = faceHalfedge[f];
    const a = 3 * toVertex[h];
    const b = 3 * toVertex[next[h]];
    const c = 3 * toVertex[h ^ 1];
    const ux = positions[b] - positions[a];
    const uy = positions[b + 1] - positions[a + 1];
    const uz = positions[b + 2] - positions[a + 2];
    const vx = positions[c] - positions[a];
    const vy = positions[c + 1] - positions[a + 1];
    const vz = positions[c + 2] - positions[a + 2];
    const x = uy * vz - uz * vy;
    const y = uz * vx - ux * vz;
    const z = ux * vy - uy * vx;
    out[a] += x;
    out[a + 1] += y;
    out[a + 2] += z;
    out[b] += x;
    out[b + 1] += y;
    out[b + 2] += z;
    out[c] += x;
    out[c + 1] += y;
    out[c + 2] += z;
  }
  for (let i = 0; i < out.length; i += 3) {
    const scale = 1 / Math.sqrt(out[i] ** 2 + out[i + 1] ** 2 + out[i + 2] ** 2);
    out[i] *= scale;
    out[i + 1] *= scale;
    out[i + 2] *= scale;
  }
}

/** Whether the normals are unit vectors and where they lead, without the digits in which floats differ. */
export function roughSum(normals) {
  let [length, ahead] = [0, 0];
  for (let i = 0; i < normals.length; i += 3) {
    length += Math.hypot(normals[i], normals[i + 1], normals[i + 2]);
    ahead += (normals[i] + 2 * normals[i + 1] + 3 * normals[i + 2]) ** 2 * (1 + (i % 5));
  }
  const count = normals.length / 3;
  return `${(length / count).toFixed(4)} ${(ahead / count).toFixed(3)}`;
}
