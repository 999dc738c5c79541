import type { Operation } from './operation.js';

/** Repairs of the whole mesh: each does what it can, and says what it did and what it had to leave. */
export const repairs: readonly Operation[] = [
  {
    stem: 'stitchBoundaries',
    on: 'mesh',
    label: 'Stitch boundaries',
    meaning: 'joins coinciding edges',
    reports: true,
  },
  {
    stem: 'fillHoles',
    on: 'mesh',
    label: 'Fill holes',
    meaning: 'with triangles that don’t fold over',
    reports: true,
  },
  {
    stem: 'removeDegenerateFaces',
    on: 'mesh',
    label: 'Remove degenerate',
    meaning: 'faces without area',
    reports: true,
  },
  {
    stem: 'splitPinchedVertices',
    on: 'mesh',
    label: 'Split pinched',
    meaning: 'a vertex for each fan',
    reports: true,
  },
  {
    stem: 'orientOutward',
    on: 'mesh',
    label: 'Orient outward',
    meaning: 'closed parts face outward',
    reports: true,
  },
  {
    stem: 'dropSmallComponents',
    on: 'mesh',
    label: 'Drop small parts',
    meaning: 'below 10 % of the largest',
    arguments: () => [{ diagonal: 0.1 }],
    reports: true,
  },
];
