import { HalfedgeMesh, init } from 'halfedge';
import { bytesInUse, withLeft } from './support/core.js';
import { quadGrid } from './support/meshes.js';

beforeAll(() => init());

const repairs: Record<string, (mesh: HalfedgeMesh) => void> = {
  splitPinchedVertices: (mesh) => mesh.splitPinchedVertices(),
  stitchBoundaries: (mesh) => mesh.stitchBoundaries({ tolerance: 1e-3 }),
  removeDegenerateFaces: (mesh) => mesh.removeDegenerateFaces({ tolerance: 1.5 }),
  dropSmallComponents: (mesh) => mesh.dropSmallComponents({ faces: 3 }),
  fillHoles: (mesh) => mesh.fillHoles({ maxAngle: 180 }),
  orientOutward: (mesh) => mesh.orientOutward({ open: true }),
};

/** Every other square of a chessboard: all vertices inside are pinched. */
function chessboard(): HalfedgeMesh {
  const { positions, faces } = quadGrid(40, 40);
  const width = Math.sqrt(faces.length);
  const black = faces.filter((_, f) => ((f % width) + Math.floor(f / width)) % 2 === 0);
  return HalfedgeMesh.fromPolygons(positions, black);
}

const countsOf = (mesh: HalfedgeMesh) => [mesh.vertexCount, mesh.edgeCount, mesh.faceCount];

const errorsOf = (mesh: HalfedgeMesh) =>
  mesh.validate().filter(({ severity }) => severity === 'error');

test.each(Object.keys(repairs))('%s without memory leaves a mesh that is whole', (name) => {
  const before = bytesInUse();
  const board = chessboard();
  let refused = 0;
  let done = 0;
  for (let room = 0; room < 6_000_000; room = Math.ceil(1.2 * room) + 2000) {
    using mesh = board.clone();
    mesh.attributes.add('halfedge', 'uv', { components: 2 });
    mesh.history.enabled = true;
    withLeft(room, () => {
      try {
        repairs[name](mesh);
        done += 1;
      } catch (error) {
        expect(error).toMatchObject({ code: 'out-of-memory' });
        refused += 1;
      }
    });
    expect([room, errorsOf(mesh)]).toEqual([room, []]);
    // Where there was no room for history, it has forgotten the step; else it undoes all of it.
    const expected = countsOf(mesh.history.undoCount > 0 ? board : mesh);
    while (mesh.history.undo());
    expect([room, countsOf(mesh), errorsOf(mesh)]).toEqual([room, expected, []]);
  }
  expect([refused > 0, done > 0]).toEqual([true, true]);
  board.dispose();
  expect(bytesInUse()).toBe(before);
});
