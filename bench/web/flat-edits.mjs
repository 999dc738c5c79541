// The baseline of edits: a flip in plain JavaScript, on arrays of the same layout, with the checks that
// ours makes, but of no arguments.

/** Copies of the links of a mesh. */
export function flatLinks(mesh) {
  const copies = Object.entries(mesh.connectivity).map(([name, view]) => [name, view.slice()]);
  return Object.fromEntries(copies);
}

/** Turns the edge; false if it can't be. */
export function flatFlip(links, e) {
  const { next, prev, toVertex, face, vertexHalfedge, faceHalfedge } = links;
  const h = 2 * e;
  const o = h + 1;
  if (face[h] < 0 || face[o] < 0) return false;
  const [h1, o1] = [next[h], next[o]];
  const [h2, o2] = [next[h1], next[o1]];
  if (next[h2] !== h || next[o2] !== o) return false;
  const [a, b] = [toVertex[h1], toVertex[o1]];
  const anchor = vertexHalfedge[a];
  let at = anchor;
  do {
    if (toVertex[at] === b) return false;
    at = next[at ^ 1];
  } while (at !== anchor);
  if (vertexHalfedge[toVertex[o]] === h) vertexHalfedge[toVertex[o]] = o1;
  if (vertexHalfedge[toVertex[h]] === o) vertexHalfedge[toVertex[h]] = h1;
  toVertex[h] = a;
  toVertex[o] = b;
  const link = (x, y) => {
    next[x] = y;
    prev[y] = x;
  };
  link(h, h2);
  link(h2, o1);
  link(o1, h);
  link(o, o2);
  link(o2, h1);
  link(h1, o);
  face[o1] = face[h];
  face[h1] = face[o];
  faceHalfedge[face[h]] = h;
  faceHalfedge[face[o]] = o;
  return true;
}
