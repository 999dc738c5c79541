import { type HalfedgeMesh, init } from 'halfedge';
import { deal, type ExerciseTask, grade, samples, taskNamed, tasks } from 'halfedge/exercise/judge';
import { failureOf } from './support/exercises.js';

beforeAll(() => init());

const SEEDS = Array.from({ length: 12 }, (_, i) => 1 + 97 * i);

describe('The meshes of exercises', () => {
  test.each(samples.map(({ name }) => name))('%s is sound, also when it is shuffled', (name) => {
    const task = { ...taskNamed('valence'), meshes: [name] };
    for (const seed of SEEDS) {
      const [tidy, shuffled] = deal(task, seed);
      for (const { mesh } of [tidy, shuffled]) {
        expect(mesh.validate().filter(({ severity }) => severity === 'error')).toEqual([]);
      }
      expect(cornersOf(shuffled.mesh)).toEqual(cornersOf(tidy.mesh));
    }
  });

  test('have other numbers and other anchors with another seed, and the same with the same', () => {
    const numbers = (seed: number) => {
      const trial = deal(taskNamed('valence'), seed).find(({ numbering }) => numbering !== 'tidy');
      return JSON.stringify(Object.values(trial?.mesh.connectivity ?? {}).map((it) => [...it]));
    };
    expect(numbers(1)).toBe(numbers(1));
    expect(numbers(1)).not.toBe(numbers(2));
  });
});

test('Shuffling moves the anchors of vertices and faces, but keeps those of the boundary there', () => {
  const task: ExerciseTask = { ...taskNamed('valence'), meshes: ['sheet'] };
  const anchors = (seed: number) => {
    const { mesh } = deal(task, seed)[1];
    const place = (v: number) => [...mesh.positions.subarray(3 * v, 3 * v + 2)].join(' ');
    const towards = (h: number) => `${place(mesh.fromVertex(h))} → ${place(mesh.toVertex(h))}`;
    for (const v of mesh.vertices()) {
      const atBoundary = [...mesh.vertexOutgoingHalfedges(v)].some((h) => mesh.face(h) < 0);
      expect(mesh.face(mesh.vertexHalfedge(v)) < 0).toBe(atBoundary);
    }
    const inner = [...mesh.vertices()].filter((v) => !mesh.isBoundaryVertex(v));
    return {
      vertices: inner.map((v) => towards(mesh.vertexHalfedge(v))).sort(),
      faces: [...mesh.faces()].map((f) => towards(mesh.faceHalfedge(f))).sort(),
    };
  };
  const all = SEEDS.map(anchors);
  expect(new Set(all.map(({ vertices }) => vertices.join())).size).toBe(4);
  expect(new Set(all.map(({ faces }) => faces.join())).size).toBeGreaterThan(6);
});

/** The faces by where their corners are. */
function cornersOf(mesh: HalfedgeMesh): string[] {
  return [...mesh.faces()]
    .map((f) => {
      const corners = [...mesh.faceVertices(f)].map((v) =>
        [...mesh.positions.subarray(3 * v, 3 * v + 3)].join(' '),
      );
      const least = corners.indexOf([...corners].sort()[0]);
      return [...corners.slice(least), ...corners.slice(0, least)].join(', ');
    })
    .sort();
}

describe.each(tasks.map((task) => [task.name, task] as const))('The task %s', (_name, task) => {
  test.each(SEEDS)('takes its solution for right, with seed %i', (seed) => {
    const { failure, passed, meshes } = grade(task, task.solution, seed);
    expect(failure?.message).toBeUndefined();
    expect(passed).toBe(true);
    expect(meshes).toHaveLength(2 * (task.meshes?.length ?? samples.length));
  });

  test('does not take what the editor holds at first for right', () => {
    expect(failureOf(task, task.starter).message).not.toBe('');
  });
});

test('A program may have a constant NONE of its own', () => {
  const task = taskNamed('valence');
  expect(grade(task, `const NONE = -1;\n${task.solution}`, 1).passed).toBe(true);
});

describe('A task of a teacher', () => {
  const own: ExerciseTask = {
    name: 'degree',
    title: 'The degree of a face',
    statement: 'How many corners has `f`?',
    call: 'degree',
    starter: 'function degree(mesh, f) {}',
    solution: 'function degree(mesh, f) { return 3; }',
    gets: 'mesh',
    uses: ['faceHalfedge', 'next'],
    meshes: ['tetrahedron', 'prism'],
    asks: (mesh) => [...mesh.faces()].map((index) => [{ kind: 'face' as const, index }]),
    answer: { kind: 'number' },
    reference: (mesh, f) => mesh.degree((f as { index: number }).index),
    mistakes: [{ code: 'triangles', answer: () => 3, says: 'Not every face is a triangle.' }],
  };

  test('is judged by its reference, and has its own words', () => {
    expect(failureOf(own, own.solution).code).toBe('triangles');
    const { passed } = grade(
      own,
      'const degree = (mesh, f) => { let n = 0; let h = mesh.faceHalfedge(f); do { n++; h = mesh.next(h); } while (h !== mesh.faceHalfedge(f)); return n; };',
      3,
    );
    expect(passed).toBe(true);
  });

  test('can check by itself', () => {
    const checked: ExerciseTask = {
      ...own,
      check: (_mesh, got) => (got === 7 ? null : `It gives back ${got}; seven was asked.`),
    };
    expect(failureOf(checked, 'const degree = () => 6;').title).toBe(
      'It gives back 6; seven was asked.',
    );
    expect(grade(checked, 'const degree = () => 7;', 1).passed).toBe(true);
  });
});

test.each([
  ['throws', "throw new Error('x'.repeat(1e6));", 'x …'],
  ['gives back', "return 'x'.repeat(1e6);", 'x …” (1000000 characters)'],
  ['lists', "return ['x'.repeat(1e6)];", 'x …” (1000000 characters)'],
])('A text without measure that a program %s is cut', (_what, body, end) => {
  const { message } = failureOf(taskNamed('face-vertices'), `function faceVertices() { ${body} }`);
  expect(message).toContain(end);
  expect(message.length).toBeLessThan(1000);
});

test('A grader is told what it is to be given', () => {
  const graded = (...list: unknown[]) => (grade as (...list: unknown[]) => unknown)(...list);
  const [task] = tasks;
  expect(() => graded('valence', '', 1)).toThrow(
    'task is "valence"; expected a task, as taskNamed()',
  );
  expect(() => graded(task, new Uint8Array(3), 1)).toThrow(
    'code is a Uint8Array of 3 elements; expected the text of a program.',
  );
  expect(() => graded(task, '')).toThrow('seed is undefined; expected an integer.');
});

test.each([
  [{ name: undefined }, 'task.name is undefined; expected a text.'],
  [{ call: 3 }, 'task.call is 3; expected a text.'],
  [{ call: 'my valence' }, 'task.call is "my valence"; expected the name of a function.'],
  [{ gets: 'arrays' }, 'task.gets is "arrays"; expected "mesh" or "links".'],
  [{ uses: 'next' }, 'task.uses is "next"; expected an array.'],
  [{ uses: ['next', 7] }, 'task.uses[1] is 7; expected a text.'],
  [
    { uses: ['mesh.next'] },
    'task.uses[0] is "mesh.next"; expected the name of a method or property',
  ],
  [{ meshes: [] }, 'task.meshes is an array of 0 elements; expected one mesh or more.'],
  [{ meshes: ['torus', 'cube'] }, 'task.meshes[1] is "cube"; expected one of tetrahedron, prism,'],
  [{ asks: [[]] }, 'task.asks is an array of 1 element; expected a function.'],
  [{ reference: 3 }, 'task.reference is 3; expected a function.'],
  [{ check: true }, 'task.check is true; expected a function.'],
  [{ answer: 'number' }, 'task.answer is "number"; expected a kind: one of cycle, item, number,'],
  [{ answer: { kind: 'list' } }, 'task.answer is "list"; expected a kind: one of cycle, item,'],
  [
    { answer: { kind: 'cycle', of: 'corner' } },
    'task.answer.of is "corner"; expected one of vertex, halfedge, edge, face.',
  ],
  [{ answer: { kind: 'item' } }, 'task.answer.of is undefined; expected one of vertex, halfedge,'],
  [{ mistakes: [{ code: 'x' }] }, 'task.mistakes[0].says is undefined; expected a text.'],
  [{ mistakes: [null] }, 'task.mistakes[0].code is undefined; expected a text.'],
])('A task with %j is told what is wrong with it', (wrong, sentence) => {
  const task = { ...taskNamed('valence'), ...wrong } as never;
  expect(() => grade(task, 'function valence() {}', 1)).toThrow(sentence);
});

test.each<[asked: unknown, sentence: string]>([
  [0, 'What asks gives is 0; expected a list of calls, each a list of items, numbers or words.'],
  [[0], 'A call that asks gives is 0; expected a list of items, numbers or words.'],
  [[[null]], "A parameter that asks gives is null; expected an item such as { kind: 'face', index"],
  [[[{ kind: 'face', index: 99 }]], 'asks gives face 99, which the mesh does not have.'],
  [[], 'asks gives no call on any mesh: every program would be right.'],
  [undefined, 'asks gives no call on any mesh: every program would be right.'],
])('A task that asks for %j is told what is wrong with it', (asked, sentence) => {
  const task = { ...taskNamed('valence'), asks: () => asked } as never;
  expect(() => grade(task, 'function valence() {}', 1)).toThrow(sentence);
});

test.each(tasks)('The task $name is one', (task) => {
  expect(() => grade(task, task.solution, 1)).not.toThrow();
});
