import { HalfedgeError, HalfedgeMesh, init } from 'halfedge';
import type { Operation } from 'halfedge/teaching';
import { repairs } from 'halfedge/teaching';
import { Editor } from '../../web/explorer/app/editor.js';
import { bytesInUse } from './support/core.js';

beforeEach(() => import.meta.jest.useFakeTimers()); // what is measured later has no mesh any more
afterEach(() => import.meta.jest.useRealTimers());

/** What the types of Jest leave out. */
interface ModuleMocks {
  unstable_mockModule(path: string, make: () => object): void;
}

let Explorer: typeof import('../../web/explorer/app/explorer.js').Explorer;
beforeAll(async () => {
  await init();
  // One of the samples is a file, which only Vite can import.
  const noSamples = () => ({ samples: [] });
  (import.meta.jest as unknown as ModuleMocks).unstable_mockModule(
    '../../web/explorer/samples/index.js',
    noSamples,
  );
  ({ Explorer } = await import('../../web/explorer/app/explorer.js'));
});

const fillHoles = repairs.find(({ stem }) => stem === 'fillHoles') as Operation;

const noRoom = () => {
  throw new HalfedgeError('out-of-memory', 'No room.');
};

describe('An operation that runs out of memory', () => {
  test.each([
    ['after a part of it was done', true],
    ['after a part that history had no room for', false],
  ])('%s shows that part', (_, isKept) => {
    const explorer = new Explorer();
    const mesh = HalfedgeMesh.cube();
    explorer.openMesh('cube', mesh);
    const { editor } = explorer;
    mesh.fillHoles = () => {
      mesh.deleteFace(0);
      if (!isKept) mesh.history.clear();
      return noRoom();
    };
    editor.run(fillHoles);
    expect(editor.refused.value?.refusal.code).toBe('out-of-memory');
    expect(editor.edit.value).not.toBeNull();
    expect(editor.past.value).toMatchObject(
      isKept ? { undo: 'a part of fill holes', undoCount: 1 } : { undo: null, undoCount: 0 },
    );
    editor.undo();
    expect(mesh.faceCount).toBe(isKept ? 6 : 5);
    explorer.pause();
    mesh.dispose();
  });
});

test('A mesh that history has no room for leaves the one on show, and no memory behind', () => {
  const explorer = new Explorer();
  const shown = HalfedgeMesh.cube();
  explorer.openMesh('cube', shown);
  explorer.select({ kind: 'face', index: 3 });
  const before = bytesInUse();
  const preparing = import.meta.jest
    .spyOn(Editor.prototype, 'prepare')
    .mockImplementation(noRoom as never);
  explorer.openMesh('other', HalfedgeMesh.tetrahedron());
  preparing.mockRestore();
  expect(explorer.failure.value).toMatchObject({ message: 'No room.' });
  expect(explorer.document.value?.mesh).toBe(shown);
  expect(explorer.selected.value).toEqual({ kind: 'face', index: 3 });
  expect(bytesInUse()).toBe(before);
  explorer.pause();
  shown.dispose();
});
