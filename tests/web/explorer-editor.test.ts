import { HalfedgeError, HalfedgeMesh, init } from 'halfedge';
import type { Item, Operation } from 'halfedge/teaching';
import { itemName, operations, repairs } from 'halfedge/teaching';
import type { MeshDocument } from '../../web/explorer/app/documents.js';
import { Editor } from '../../web/explorer/app/editor.js';
import { bytesInUse } from './support/core.js';
import { importWithoutSamples } from './support/explorer.js';

beforeEach(() => import.meta.jest.useFakeTimers()); // what is measured later has no mesh any more
afterEach(() => import.meta.jest.useRealTimers());

let Explorer: typeof import('../../web/explorer/app/explorer.js').Explorer;
beforeAll(async () => {
  await init();
  const load = () => import('../../web/explorer/app/explorer.js');
  ({ Explorer } = await importWithoutSamples(load));
});

const fillHoles = repairs.find(({ stem }) => stem === 'fillHoles') as Operation;

const noRoom = () => {
  throw new HalfedgeError('out-of-memory', 'No room.');
};

test('An operation does not wait for a second item where the file is shown as it was', () => {
  const explorer = new Explorer();
  const mesh = HalfedgeMesh.cube();
  explorer.openMesh('cube', mesh);
  const opened = explorer.document.value as MeshDocument;
  explorer.document.value = { ...opened, diagnosis: {} as MeshDocument['diagnosis'] };
  explorer.select({ kind: 'halfedge', index: 3 });
  explorer.editor.run(operations.find(({ second }) => second?.kind === 'halfedge') as Operation);
  expect(explorer.editor.pending.value).not.toBeNull();
  explorer.showFile(true);
  expect(explorer.showsFile.value).toBe(true);
  expect(explorer.editor.pending.value).toBeNull();
  explorer.walker.pause();
  mesh.dispose();
});

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
    explorer.walker.pause();
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
  explorer.walker.pause();
  shown.dispose();
});

test('Steps that are forgotten stay edits that no file has, until one is saved', () => {
  const explorer = new Explorer();
  const mesh = HalfedgeMesh.cube();
  explorer.openMesh('cube', mesh);
  const { editor } = explorer;
  const poke = operations.find(({ stem }) => stem === 'splitFace') as Operation;
  const run = (index: number) => {
    explorer.select({ kind: 'face', index });
    editor.run(poke);
  };
  run(0);
  mesh.history.limit({ steps: 1 });
  run(1);
  editor.undo();
  expect([editor.past.value.undoCount, editor.isUnsaved]).toEqual([0, true]);
  editor.markSaved();
  expect(editor.isUnsaved).toBe(false);
  explorer.walker.pause();
  mesh.dispose();
});

describe('A mesh that was made of another one', () => {
  const opened = (keptHalfedges?: number) => {
    const explorer = new Explorer(keptHalfedges);
    explorer.openMesh('cube', HalfedgeMesh.cube());
    const { editor } = explorer;
    const run = (stem: string, item: Item) => {
      explorer.select(item);
      const operation = operations.find((candidate) => candidate.stem === stem);
      editor.run(operation as Operation);
    };
    const end = () => {
      explorer.walker.pause();
      explorer.document.value?.mesh.dispose();
    };
    return { explorer, editor, run, end };
  };
  const face = (index: number): Item => ({ kind: 'face', index });

  test('says why its picture is empty, where no vertex is interior', () => {
    const { explorer, editor, run, end } = opened();
    run('dual', face(0));
    expect(editor.report.value).toBe('');
    explorer.openMesh(
      'triangle',
      HalfedgeMesh.fromTriangles([0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 2]),
    );
    run('dual', face(0));
    expect(explorer.document.value?.mesh.faceCount).toBe(0);
    expect(editor.report.value).toBe('The dual has no faces: no vertex is interior.');
    editor.undo();
    expect(editor.report.value).toBe('');
    end();
  });

  test('leads back to it by undo, and there again by redo', () => {
    const { explorer, editor, run, end } = opened();
    /** Its name, what is selected, and the way back and forth. */
    const state = () => {
      const { document, selected } = explorer;
      const { mesh, name } = document.value as MeshDocument;
      const { undo, redo, undoCount, redoCount } = editor.past.value;
      const item = selected.value && itemName(selected.value);
      return [name, mesh.vertexCount, item, undo, undoCount, redo, redoCount];
    };
    const states: unknown[] = [state()];
    run('splitFace', face(3));
    states.push(state());
    run('dual', face(2));
    expect(editor.outcome.value).toBe('Done: dual.');
    expect(editor.isUnsaved).toBe(true);
    run('splitFace', face(0));
    states.push(state());
    expect(states).toEqual([
      ['cube', 8, 'v0', null, 0, null, 0],
      ['cube', 9, 'v8', 'poke f3', 1, null, 0],
      ['Dual of cube', 10, 'v9', 'poke f0', 3, null, 0],
    ]);

    editor.undo();
    expect(state()).toEqual(['Dual of cube', 9, 'f0', 'dual', 2, 'poke f0', 1]);
    editor.undo();
    expect(editor.outcome.value).toBe('Undone: dual.');
    expect(state()).toEqual(['cube', 9, 'f2', 'poke f3', 1, 'dual', 2]);
    expect(editor.deeds).toEqual(['splitFace f3']);
    editor.undo();
    expect(state()).toEqual(['cube', 8, 'f3', null, 0, 'poke f3', 3]);
    editor.undo();
    expect(editor.outcome.value).toBe('There is nothing to undo.');

    editor.redo();
    expect(state()).toEqual(['cube', 9, 'v8', 'poke f3', 1, 'dual', 2]);
    editor.redo();
    expect(editor.outcome.value).toBe('Redone: dual.');
    expect(state()).toEqual(['Dual of cube', 9, 'f0', 'dual', 2, 'poke f0', 1]);
    editor.redo();
    expect(state()).toEqual(['Dual of cube', 10, 'v9', 'poke f0', 3, null, 0]);
    editor.redo();
    expect(editor.outcome.value).toBe('There is nothing to redo.');
    end();
  });

  test('leads back to edits that no file has, past meshes without, when another one is opened', () => {
    const before = bytesInUse();
    const { explorer, editor, run, end } = opened();
    const shown = () => explorer.document.value?.mesh as HalfedgeMesh;
    const open = (name: string) => explorer.openMesh(name, HalfedgeMesh.tetrahedron());
    const cube = shown();
    run('splitFace', face(3));
    expect([editor.isUnsaved, editor.anyUnsaved]).toEqual([true, true]);
    open('second');
    const second = shown();
    expect(editor.left.value).toBe('cube');
    expect([editor.isUnsaved, editor.anyUnsaved]).toEqual([false, true]);
    expect(editor.deeds).toEqual([]);
    open('third');
    const third = shown();
    expect([cube.disposed, second.disposed]).toEqual([false, true]);
    expect(editor.left.value).toBeNull();
    expect(editor.past.value.undo).toBe('open third');

    editor.undo();
    expect(editor.outcome.value).toBe('Undone: open third.');
    expect([shown(), cube.vertexCount, editor.past.value.undo]).toEqual([cube, 9, 'poke f3']);
    expect(editor.past.value.redo).toBe('open third');
    editor.redo();
    expect(shown()).toBe(third);

    editor.undo();
    editor.markSaved();
    open('fourth');
    expect([cube.disposed, third.disposed, editor.past.value.undo]).toEqual([true, true, null]);
    expect(editor.anyUnsaved).toBe(false);
    end();
    expect(bytesInUse()).toBe(before);
  });

  test('is forgotten where there are too many before the one on show, but not the last', () => {
    const { explorer, editor, run, end } = opened(80);
    const meshes = [explorer.document.value?.mesh as HalfedgeMesh];
    run('splitFace', face(0));
    for (const name of ['second', 'third', 'fourth']) {
      meshes.push(HalfedgeMesh.cube());
      explorer.openMesh(name, meshes[meshes.length - 1]);
      run('splitFace', face(0));
    }
    // A cube has 24 halfedges, and 32 with a vertex in one face.
    expect(meshes.map(({ disposed }) => disposed)).toEqual([true, false, false, false]);
    for (let step = 0; step < 5; step++) editor.undo();
    expect(explorer.document.value?.name).toBe('second');
    editor.undo();
    expect(editor.outcome.value).toBe('There is nothing to undo.');
    end();
    const [, , third, fourth] = meshes;
    third.dispose();
    fourth.dispose();

    const last = opened(1);
    last.run('splitFace', face(0));
    last.explorer.openMesh('second', HalfedgeMesh.cube());
    last.editor.undo();
    expect(last.explorer.document.value?.mesh.vertexCount).toBe(9);
    last.end();
  });

  test('gives its memory back once nothing leads there any more', () => {
    const before = bytesInUse();
    const { explorer, editor, run, end } = opened();
    const shown = () => explorer.document.value?.mesh as HalfedgeMesh;
    const cube = shown();
    run('dual', face(0));
    const dual = shown();
    run('dual', face(0));
    const twice = shown();
    editor.undo();
    editor.undo();
    expect([shown(), dual.disposed, twice.disposed]).toEqual([cube, false, false]);
    run('splitFace', face(0));
    expect([cube.disposed, dual.disposed, twice.disposed]).toEqual([false, true, true]);
    expect(editor.past.value.redo).toBeNull();
    run('dual', face(0));
    const again = shown();
    editor.markSaved();
    explorer.openMesh('other', HalfedgeMesh.tetrahedron());
    expect([cube.disposed, again.disposed]).toEqual([false, true]);
    editor.undo();
    editor.markSaved();
    explorer.openMesh('other', HalfedgeMesh.tetrahedron());
    expect(cube.disposed).toBe(true);
    end();
    expect(bytesInUse()).toBe(before);
  });
});

describe('what is wrong with where the vertices lie', () => {
  /** Two triangles along one edge, of which each has vertices of its own. */
  const crack = () =>
    HalfedgeMesh.fromTriangles(
      [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, -1, 0],
      [0, 1, 2, 3, 4, 5],
    );

  test('is found once the mesh is at rest', () => {
    const explorer = new Explorer();
    explorer.openMesh('crack', crack());
    expect(explorer.problems.value).toBeNull();
    import.meta.jest.runAllTimers();
    const found = explorer.problems.value?.map(({ code, index }) => [code, index]);
    expect(found).toEqual([
      ['coincident-vertices', 3],
      ['coincident-vertices', 4],
    ]);
    expect(explorer.facts.value?.problems).toEqual([]);
  });

  test('is looked for again after an edit', () => {
    const explorer = new Explorer();
    explorer.openMesh('crack', crack());
    import.meta.jest.runAllTimers();
    const stitch = repairs.find(({ stem }) => stem === 'stitchBoundaries') as Operation;
    explorer.editor.run(stitch);
    import.meta.jest.runAllTimers();
    expect(explorer.problems.value).toEqual([]);
  });

  test('is of the mesh on show: another one begins with nothing', () => {
    const explorer = new Explorer();
    explorer.openMesh('crack', crack());
    import.meta.jest.runAllTimers();
    explorer.openMesh('cube', HalfedgeMesh.cube());
    expect(explorer.problems.value).toBeNull();
    import.meta.jest.runAllTimers();
    expect(explorer.problems.value).toEqual([]);
  });
});
