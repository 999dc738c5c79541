// Pages other than the explorer that are worth a picture: where they are, and what is then done.

const click = (selector) => (page) => page.click(selector);

/** A click on what lies in the middle of the canvas. */
async function pick(page) {
  const { x, y, width, height } = await page.locator('canvas').boundingBox();
  await page.mouse.click(x + width / 2, y + height / 2);
}

/** Of the page of exercises: one that doesn't end, two that are there at first and wrong, one that can't be read. */
const PROGRAMS = [
  `function faceVertices(mesh, f) {
  const ring = [];
  let h = mesh.faceHalfedge(f);
  while (h !== NONE) {
    ring.push(mesh.toVertex(h));
    h = mesh.next(h);
  }
  return ring;
}
`,
  undefined,
  undefined,
  `function countBoundaryLoops(mesh) {
  let count = 0;
  for (const h of mesh.halfedges() {
    if (mesh.face(h) === NONE) count++;
  }
  return count;
}
`,
  'solution',
];

/** Runs a program in each exercise of a page, one after the other. */
const runAll = (page) =>
  page.$$eval(
    'halfedge-exercise',
    async (all, programs) => {
      for (const [i, one] of all.entries()) {
        const code = programs[i] === 'solution' ? one.exercise.solution : programs[i];
        if (code) one.code = code;
        await one.run();
      }
    },
    PROGRAMS,
  );

/** `project` is an example with a package.json of its own; `path` a file of the repository. */
export const pageStates = {
  page: { path: 'examples/page.html', ready: '#picture line' },
  'page-refusal': {
    path: 'examples/page.html',
    ready: '#picture line',
    act: async (page) => {
      await page.selectOption('#operation', 'collapse');
      for (let i = 0; i < 12; i++) await page.locator('#picture g[data-edge]').first().click();
    },
  },
  three: { project: 'three', ready: 'main button' },
  'three-picked': {
    project: 'three',
    ready: 'main button',
    act: async (page) => {
      await pick(page);
      await click('[data-edit=extrude]')(page);
    },
  },
  fiber: { project: 'react-three-fiber', ready: 'main button' },
  'fiber-picked': { project: 'react-three-fiber', ready: 'main button', act: pick },
  exercises: { path: 'docs/exercises.html', ready: 'halfedge-exercise .cm-content' },
  'exercises-run': {
    path: 'docs/exercises.html',
    ready: 'halfedge-exercise .cm-content',
    act: runAll,
    each: 'halfedge-exercise',
  },
  // One picture for each of its figures.
  course: { path: 'docs/course.html', ready: 'halfedge-figure', each: 'halfedge-figure' },
};
