/** What {@link program} shows: 16 vertices, 24 edges, 9 faces, and the one-ring of vertex 1. */
export const EXPECTED = '16 24 9: 2 5 0';

interface Choices {
  /** What it imports. */
  from?: string;
  /** The argument of `init`, as source. */
  options?: string;
}

/**
 * A program that builds a grid of 4 × 4 vertices, row by row, and hands a line about it to `show`:
 * `console.log` in Node, `postMessage` in a worker, and {@link TITLE} in a page. If the module
 * can't be loaded, the line is the error.
 */
export function program(show: string, { from = 'halfedge', options = '' }: Choices = {}): string {
  return `
import { HalfedgeMesh, init } from '${from}';

const show = ${show};

function oneRing() {
  const positions = Array.from({ length: 16 }, (_, v) => [v % 4, v >> 2, 0]).flat();
  const quads = [0, 1, 2, 4, 5, 6, 8, 9, 10].map((v) => [v, v + 1, v + 5, v + 4]);
  const mesh = HalfedgeMesh.fromPolygons(positions, quads);
  const counts = [mesh.vertexCount, mesh.edgeCount, mesh.faceCount];
  return counts.join(' ') + ': ' + [...mesh.vertexVertices(1)].join(' ');
}

init(${options}).then(oneRing).then(show, (error) => show(error.name + ' ' + error.code + ': ' + error.message));
`;
}

/** Shows a line as the title of the page, where `visit` waits for it. */
export const TITLE = '(text) => { document.title = text; }';

/** A program that starts a module worker and shows what it posts. */
export const startWorker = (show = TITLE) => `
const worker = new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });
worker.onmessage = ({ data }) => (${show})(data);
worker.onerror = ({ message }) => (${show})('The worker failed: ' + message);
`;

/** A page that loads one module script. */
export const page = (script: string, head = '') => `<!doctype html>
<html lang="en">
<meta charset="utf-8">
<link rel="icon" href="data:,">
${head}
<script type="module" src="${script}"></script>
</html>
`;
