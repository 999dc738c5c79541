import { HalfedgeMesh, init } from 'halfedge';
import { bytesInUse } from './support/core.js';
import { addAttributes, expectState, stateOf } from './support/editing.js';
import {
  annulus,
  bowTie,
  type Input,
  pillow,
  quadGrid,
  randomPolygons,
  tetrahedron,
  torus,
} from './support/meshes.js';
import { random } from './support/random.js';
import { EDITS, randomEdit, refusalOf } from './support/random-edits.js';

beforeAll(() => init());

const STEPS = 300;

const shapes: [string, Input][] = [
  ['a tetrahedron', tetrahedron()],
  ['a torus', torus()],
  ['an annulus', annulus()],
  ['a disk of quads', quadGrid()],
  ['a pinched vertex', bowTie()],
  ['a pillow', pillow()],
  ...[1, 2, 3, 4].map((seed): [string, Input] => [`polygons ${seed}`, randomPolygons(seed)]),
];

const cases = shapes.flatMap(([name, input], i) =>
  [true, false].map((storePrev) => ({ name, input, storePrev, seed: 100 + i })),
);

/** How often each edit was done and refused, over all cases. */
const tally = new Map(EDITS.map((name) => [name, { done: 0, refused: 0 }]));

describe.each(cases)('$name, prev stored: $storePrev, seed $seed', ({ input, storePrev, seed }) => {
  test('stays valid through random edits, and goes back to the first word and forth', () => {
    const next = random(seed);
    using mesh = HalfedgeMesh.fromPolygons(input.positions, input.faces, { storePrev });
    addAttributes(mesh, next);
    mesh.history.enabled = true;
    const states = [stateOf(mesh)];
    const log: string[] = [];
    for (let i = 0; i < STEPS; i++) {
      const edit = randomEdit(mesh, next);
      log.push(edit.name);
      const { undoCount } = mesh.history;
      const { version } = mesh;
      const foreseen = edit.check?.() ?? null;
      const refusal = refusalOf(edit);
      const counts = tally.get(edit.name.split('(')[0]) as { done: number; refused: number };
      counts[refusal ? 'refused' : 'done'] += 1;
      if (edit.check) expect([edit.name, foreseen?.code]).toEqual([edit.name, refusal?.code]);
      if (refusal) {
        if (foreseen) expect(foreseen).toEqual({ ...foreseen, message: refusal.message });
        expect(refusal.message).toMatch(/^[A-Z].*\.$/);
        expect([edit.name, mesh.version, mesh.history.undoCount]).toEqual([
          edit.name,
          version,
          undoCount,
        ]);
        expectState(mesh, states[states.length - 1]);
        continue;
      }
      const errors = mesh.validate().filter(({ severity }) => severity === 'error');
      if (errors.length > 0) throw new Error(`${log.join('; ')}: ${JSON.stringify(errors)}`);
      if (mesh.history.undoCount > undoCount) states.push(stateOf(mesh));
    }
    expect(states.length).toBe(mesh.history.undoCount + 1);
    expect(states.length).toBeGreaterThan(STEPS / 5);
    for (let i = states.length - 2; i >= 0; i--) {
      expect(mesh.history.undo()).toBe(true);
      expectState(mesh, states[i]);
    }
    expect(mesh.history.undo()).toBe(false);
    for (let i = 1; i < states.length; i++) mesh.history.redo();
    expectState(mesh, states[states.length - 1]);
  });
});

test('each edit was done and refused in these sequences, where it can be', () => {
  const never = [...tally].filter(([, { done }]) => done === 0).map(([name]) => name);
  expect(never).toEqual([]);
});

test('Thousands of edits, refusals and undos leave not a byte behind', () => {
  const { positions, faces } = torus();
  const run = () => {
    const next = random(7);
    using mesh = HalfedgeMesh.fromPolygons(positions, faces);
    addAttributes(mesh, next);
    mesh.history.enabled = true;
    mesh.generations.enabled = true;
    for (let i = 0; i < 2000; i++) {
      refusalOf(randomEdit(mesh, next));
      if (next() < 0.3) mesh.history.undo();
    }
  };
  run();
  const before = bytesInUse();
  run();
  expect(bytesInUse()).toBe(before);
});
