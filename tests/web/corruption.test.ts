import { HalfedgeMesh, init } from 'halfedge';
import { bytesInUse } from './support/core.js';
import { randomPolygons } from './support/meshes.js';
import { random } from './support/random.js';

beforeAll(() => init());

/** What the processor has done for this process so far, in seconds: other processes don't make it longer. */
function secondsOfProcessor(): number {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1e6;
}

/** The classes of operations: they need a mesh that is sound, and rely on it. */
const EDITS = ['Construction', 'EulerOperations', 'Surgery', 'Modelling', 'Mending'];

/** The names of all that a mesh has, but for operations. */
function membersOf(mesh: HalfedgeMesh): string[] {
  const names: string[] = [];
  for (let at = Object.getPrototypeOf(mesh); at !== Object.prototype; ) {
    if (!EDITS.includes(at.constructor.name)) names.push(...Object.getOwnPropertyNames(at));
    at = Object.getPrototypeOf(at);
  }
  return names;
}

/** Every question there is; each either answers or throws one of the library's errors. */
function askEverything(mesh: HalfedgeMesh): void {
  const questions: ((i: number) => unknown)[] = [];
  for (const name of membersOf(mesh)) {
    if (['constructor', 'clone', 'dual', 'dispose', 'circulate'].includes(name)) continue;
    questions.push((i) => {
      const member = Reflect.get(mesh, name);
      if (typeof member !== 'function') return member;
      const takesItem =
        /^(is|next|prev|opp|edge|face|to[VE]|from|rot|vertex|halfedgeL|val|deg|find|corner|dihedral|cotan|angle)/;
      const isWhole = /^(vertices|faces|edges|halfedges|validate)$/.test(name);
      const items =
        isWhole || !takesItem.test(name) ? [] : name.startsWith('find') ? [i, i + 1] : [i];
      const result = member.call(mesh, ...items);
      if (typeof result !== 'object' || result === null) return result;
      return Symbol.iterator in result ? [...result] : result;
    });
  }
  for (const kind of [
    'vertexVertices',
    'vertexFaces',
    'faceFaces',
    'edgeFaces',
    'halfedgeLoop',
  ] as const) {
    questions.push((i) => {
      const circulator = mesh.circulate(kind, i);
      for (let step = 0; step < 20; step++) circulator.next();
      for (let step = 0; step < 20; step++) circulator.prev();
      return circulator.current;
    });
  }
  expect(questions.length).toBeGreaterThan(60);
  for (const question of questions) {
    for (let i = 0; i < 6; i++) {
      try {
        question(i);
      } catch (error) {
        expect(String(error)).toMatch(/^(RangeError|HalfedgeError|TypeError): [A-Za-z].*[.?)]$/s);
        expect((error as Error).message).toMatch(/expected|corrupt|breaks|close/);
      }
    }
  }
}

describe('Whatever is written into the live views,', () => {
  const values: [string, (slots: number, next: () => number) => number][] = [
    ['valid indices', (slots, next) => Math.floor(next() * slots)],
    ['anything', (_, next) => Math.floor((next() - 0.5) * 2 ** 32)],
    ['-1', () => -1],
    ['marks of deleted items', (_, next) => -2 - Math.floor(next() * 100)],
    ['indices just out of range', (slots) => slots],
    ['zeros', () => 0],
  ];
  describe.each(values)('be it %s,', (_, value) => {
    test.each([1, 2, 3])('nothing hangs or crashes (seed %i)', (seed) => {
      const next = random(seed);
      const before = bytesInUse();
      const start = secondsOfProcessor();
      for (let round = 0; round < 8; round++) {
        const input = randomPolygons(1000 * seed + round);
        const mesh = HalfedgeMesh.fromPolygons(input.positions, input.faces);
        const slots = mesh.halfedgeSlots;
        const share = next() < 0.5 ? 0.02 : 1;
        for (const view of Object.values(mesh.connectivity) as Int32Array[]) {
          if (next() < 0.3) continue;
          for (let i = 0; i < view.length; i++) if (next() < share) view[i] = value(slots, next);
        }
        askEverything(mesh);
        mesh.clone().dispose();
        try {
          mesh.dual().dispose();
        } catch (error) {
          expect(String(error)).toMatch(/^HalfedgeError: /);
        }
        mesh.dispose();
      }
      expect(secondsOfProcessor() - start).toBeLessThan(50);
      expect(bytesInUse()).toBe(before);
    });
  });

  test('and a sound mesh is still made afterwards', () => {
    const input = randomPolygons(1);
    using mesh = HalfedgeMesh.fromPolygons(input.positions, input.faces);
    expect(mesh.validate().filter(({ severity }) => severity === 'error')).toEqual([]);
  });
});
