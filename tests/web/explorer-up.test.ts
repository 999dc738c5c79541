// Which axis points up in the explorer, without its page.

import { HalfedgeMesh, init } from 'halfedge';
import { importWithoutSamples } from './support/explorer.js';

let Explorer: typeof import('../../web/explorer/app/explorer.js').Explorer;
beforeAll(async () => {
  await init();
  ({ Explorer } = await importWithoutSamples(() => import('../../web/explorer/app/explorer.js')));
});

test('The axis that was chosen for a file is that of the next one, too', () => {
  const explorer = new Explorer();
  explorer.openMesh('one', HalfedgeMesh.cube());
  expect(explorer.up.value).toBe('y');
  explorer.setUp('z');
  explorer.openMesh('another', HalfedgeMesh.cube());
  expect(explorer.up.value).toBe('z');
  explorer.setUp('y');
  explorer.openMesh('a third', HalfedgeMesh.cube());
  expect(explorer.up.value).toBe('y');
});

test('A mesh that is made of another one has its axis, and undo brings back what each had', () => {
  const explorer = new Explorer();
  explorer.openMesh('cube', HalfedgeMesh.cube());
  explorer.setUp('z');

  explorer.editor.runKey('M');
  expect(explorer.document.value?.mesh.vertexCount).toBe(6);
  expect(explorer.up.value).toBe('z');
  explorer.setUp('y');
  explorer.editor.undo();
  expect(explorer.document.value?.mesh.vertexCount).toBe(8);
  expect(explorer.up.value).toBe('z');
  // Not what was chosen for a file last, which is y by now.
  explorer.editor.runKey('M');
  expect(explorer.document.value?.mesh.vertexCount).toBe(6);
  expect(explorer.up.value).toBe('z');
});
