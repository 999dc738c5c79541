// What is tried in each engine, on the shortest way through it.

/** Two triangles, as OFF. */
export const SQUARE = 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n';

/** Solves the exercise `valence`. */
export const VALENCE =
  'const valence = (mesh, v) => { let n = 0, h = mesh.vertexHalfedge(v); const first = h; if (h === NONE) return 0; do { n++; h = mesh.next(mesh.opposite(h)); } while (h !== first); return n; }';

export const FIGURE =
  '<halfedge-figure src="shape:icosahedron" select="v3" query="vertexVertices" controls="player code"></halfedge-figure>';

export const EXERCISE = '<halfedge-exercise task="valence" seed="5"></halfedge-exercise>';

/** A page of `dist` with an element of the package, as one file brings it. */
export const elementPage = (file: 'figure' | 'exercise', element: string) => `<!doctype html>
<link rel="icon" href="data:,">
<script type="module" src="${file}/standalone.js"></script>
${element}`;
