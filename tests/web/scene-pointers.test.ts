import { HalfedgeMesh, init } from 'halfedge';
import { Color, type Mesh, PerspectiveCamera, Scene, Vector3 } from 'three';
import type { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { FaceFrames } from '../../dist/scene/faces.js';
import { Glyphs } from '../../dist/scene/glyphs.js';
import { widthOf } from '../../dist/scene/labels.js';
import { Pointers } from '../../dist/scene/pointers.js';
import { Surface } from '../../dist/scene/surface.js';
import { Card } from './support/card.js';
import { drawLines } from './support/lines-on-card.js';

beforeAll(() => init());

const SIZE = 800;
const PALETTE = new Proxy({}, { get: () => new Color(1, 0, 0) });

/** A grid before a camera, and what is drawn of links of its items, in CSS pixels. */
function gridInSight() {
  const camera = new PerspectiveCamera(60);
  camera.position.set(0.4, -0.8, 1.6);
  camera.up.set(0.3, 1, 0);
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  const depthOf = (x: number, y: number, z: number) =>
    -new Vector3(x, y, z).applyMatrix4(camera.matrixWorldInverse).z;
  const pixelAt = (depth: number) => (2 * depth * Math.tan(Math.PI / 6)) / SIZE;
  const stage = { scene: new Scene(), camera, pixelAt, depthOf };
  const surface = new Surface(HalfedgeMesh.grid(4, 4) as never);
  const frames = new FaceFrames(surface);
  const pointers = new Pointers(stage as never);
  const parts = { surface, frames, glyphs: new Glyphs(surface, frames, stage as never) };
  const toScreen = (xyz: ArrayLike<number>) => {
    const { x, y } = new Vector3(xyz[0], xyz[1], xyz[2]).project(camera);
    return [(x * SIZE) / 2, (y * SIZE) / 2] as const;
  };
  const draw = (kind: 'face' | 'halfedge', index: number) => {
    pointers.update([{ kind, index }], parts, PALETTE as never, false);
    const { geometry } = stage.scene.children[1] as Mesh;
    const lines = drawLines(new Card(), geometry as unknown as LineSegmentsGeometry);
    return lines.map((line) => [toScreen(line), toScreen(line.slice(3))] as const);
  };
  const middle = (face: number) => toScreen(frames.data.subarray(frames.at(face)));
  return { mesh: surface.mesh, draw, middle };
}

describe('The arrow of a link', () => {
  test('leaves a face beside its name, on the way to its halfedge', () => {
    const { mesh, draw, middle } = gridInSight();
    for (const face of mesh.faces()) {
      const [x, y] = middle(face);
      const [[start]] = draw('face', face);
      const [aside, up] = [Math.abs(start[0] - x), Math.abs(start[1] - y)];
      const width = widthOf({ text: `f${face}`, look: 'self' });
      expect({ face, isBeside: aside > width / 2 || up > 11 }).toEqual({ face, isBeside: true });
      expect(Math.hypot(aside, up)).toBeLessThan(width);
    }
    mesh.dispose();
  });
});
