import { HalfedgeMesh, init } from 'halfedge';
import { MeshPicture, type Stage } from 'halfedge/scene';
import { type Mesh, type Object3D, PerspectiveCamera, Scene, Vector2, Vector3 } from 'three';

const page = { devicePixelRatio: 1, matchMedia: () => ({ matches: true }) };

beforeAll(async () => {
  await init();
  Object.assign(globalThis, { window: page }, page);
});

afterAll(() => {
  for (const name of ['window', ...Object.keys(page)]) Reflect.deleteProperty(globalThis, name);
});

/** A stage that draws nothing: how often it was asked for a frame. */
function emptyStage() {
  const stage = {
    scene: new Scene(),
    camera: new PerspectiveCamera(),
    controls: { target: new Vector3() },
    size: new Vector2(100, 100),
    frames: 0,
    invalidate: () => {
      stage.frames += 1;
    },
    onFrame: () => {},
    onWake: () => {},
    drawn: () => Promise.resolve(),
    move: () => {},
    pixelAt: () => 0.01,
    depthOf: () => 1,
  };
  return stage;
}

/** What is drawn of a scene, unless it has no triangles. */
function drawnOf(scene: Scene): Object3D[] {
  const drawn: Object3D[] = [];
  scene.traverseVisible((object) => {
    if ((object as Mesh).isMesh || 'isLine' in object) drawn.push(object);
  });
  return drawn;
}

test('A picture of no mesh is empty, until it shows another one', () => {
  using mesh = HalfedgeMesh.cube();
  using other = HalfedgeMesh.dodecahedron();
  const stage = emptyStage();
  const picture = new MeshPicture(stage as unknown as Stage, {} as HTMLElement, {
    overlay: () => ({ marks: [], labels: [] }),
    near: () => [],
  });
  picture.show(mesh);
  const drawn = drawnOf(stage.scene);
  expect(drawn.length).toBeGreaterThan(0);
  const { frames } = stage;
  picture.show(null);
  expect(picture.shown).toBeNull();
  expect(drawnOf(stage.scene)).toEqual([]);
  expect(stage.frames).toBeGreaterThan(frames);
  picture.show(other);
  expect(drawnOf(stage.scene)).toHaveLength(drawn.length);
});
