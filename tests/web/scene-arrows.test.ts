import { HalfedgeMesh, init } from 'halfedge';
import { PerspectiveCamera, Scene } from 'three';
import { ArrowLayer } from '../../dist/scene/arrow-layer.js';
import { FaceFrames } from '../../dist/scene/faces.js';
import { Surface } from '../../dist/scene/surface.js';

beforeAll(() => init());

/** A stage with a camera near enough for all faces of a mesh at the origin to be large. */
function stage() {
  const camera = new PerspectiveCamera(60);
  camera.position.set(0, 0, 3);
  camera.updateMatrixWorld();
  const pixelAt = (depth: number) => depth / 2000;
  return { scene: new Scene(), camera, pixelAt, depthOf: () => 3 };
}

test('faces of another mesh have their arrows, whichever were near before', () => {
  const layer = new ArrowLayer(stage() as never);
  for (let turn = 0; turn < 4; turn++) {
    const mesh = HalfedgeMesh.grid(6, 6);
    const surface = new Surface(mesh as never);
    layer.show(surface, new FaceFrames(surface));
    for (let frame = 0; frame <= turn; frame++) {
      layer.update([(7 * turn + 5 * frame) % mesh.faceCount], null);
      expect([...layer.large].sort((a, b) => a - b)).toEqual([...mesh.faces()]);
    }
  }
});
