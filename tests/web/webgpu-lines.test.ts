// Helpers for WebGPURenderer, which the oldest three.js that is tested doesn't have.

import { HalfedgeMesh, init } from 'halfedge';
import {
  BoundaryLoopsHelper,
  CirculatorHelper,
  HalfedgesHelper,
  MeshGeometry,
  type MeshHelper,
  ProblemsHelper,
} from 'halfedge/three';
import { webgpuLines } from 'halfedge/three/webgpu';
import * as THREE from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { NodeMaterial } from 'three/webgpu';

beforeAll(() => init());

const lines = webgpuLines;

const HELPERS: [string, number, (mesh: HalfedgeMesh, options?: object) => MeshHelper][] = [
  ['HalfedgesHelper', 1.5, (m, o) => new HalfedgesHelper(m, { lines, ...o })],
  ['BoundaryLoopsHelper', 2.25, (m, o) => new BoundaryLoopsHelper(m, { lines, ...o })],
  ['CirculatorHelper', 2.5, (m, o) => new CirculatorHelper(m, 'vertexFaces', 4, { lines, ...o })],
  [
    'ProblemsHelper',
    3.5,
    (m, o) => new ProblemsHelper(m, { lines, problems: [{ kind: 'face', index: 0 }], ...o }),
  ],
];

const drawnBy = (helper: MeshHelper) => helper.children[0] as ReturnType<typeof webgpuLines.make>;

test('Lines for WebGPURenderer are left out under another material, and of shadows', () => {
  using mesh = HalfedgeMesh.cube();
  const helper = new HalfedgesHelper(mesh, { lines });
  const drawn = drawnBy(helper);
  const [scene, camera] = [new THREE.Scene(), new THREE.Camera()];
  const renderer = { isWebGPURenderer: true } as unknown as THREE.WebGLRenderer;
  const group = null as unknown as THREE.Group;
  const { geometry, material } = drawn;
  const args = [renderer, scene, camera, geometry, material, group] as const;
  const shadow = [
    renderer,
    drawn,
    camera,
    camera,
    geometry,
    material,
    group,
  ] as unknown as Parameters<typeof drawn.onBeforeShadow>;
  const count = () => {
    drawn.onBeforeRender(...args);
    const segments = geometry.instanceCount;
    drawn.onAfterRender(...args);
    return segments;
  };
  expect(count()).toBe(helper.segments);
  scene.overrideMaterial = new NodeMaterial();
  expect(count()).toBe(0);
  expect(geometry.instanceCount).toBe(helper.segments);
  // A shadow is drawn by a material that overrides the own one.
  drawn.onBeforeShadow(...shadow);
  expect(count()).toBe(0);
  drawn.onAfterShadow(...shadow);
  expect(geometry.instanceCount).toBe(helper.segments);
});

describe.each(HELPERS)('%s with lines for WebGPURenderer', (_, width, make) => {
  test('draws the segments that it draws for WebGLRenderer, in a material of nodes', () => {
    using mesh = HalfedgeMesh.grid(2, 2);
    const helper = make(mesh);
    const other = make(mesh, { lines: undefined });
    expect(helper.segments).toBeGreaterThan(0);
    const [drawn, expected] = [drawnBy(helper), drawnBy(other)];
    expect(drawn.material).toBeInstanceOf(NodeMaterial);
    expect(expected.material).toBeInstanceOf(LineMaterial);
    for (const name of ['instanceStart', 'instanceEnd', 'instanceColorStart']) {
      const [ours, theirs] = [drawn, expected].map(({ geometry }) => geometry.attributes[name]);
      expect(ours.array).toEqual(theirs.array);
    }
    expect(drawn.geometry.instanceCount).toBe(helper.segments);
    for (const key of ['renderOrder', 'frustumCulled'] as const) {
      expect(drawn[key]).toBe(expected[key]);
    }
    for (const key of [
      'polygonOffset',
      'polygonOffsetFactor',
      'polygonOffsetUnits',
      'side',
    ] as const) {
      expect(drawn.material[key]).toBe(expected.material[key]);
    }
    expect([drawn.material.linewidth, expected.material.linewidth]).toEqual([width, width]);
  });

  test('has clones with lines of their own for the same renderer', () => {
    using mesh = HalfedgeMesh.grid(2, 2);
    const helper = make(mesh, { linewidth: 7 });
    const copy = helper.clone();
    expect(drawnBy(copy).material).toBeInstanceOf(NodeMaterial);
    expect(drawnBy(copy).material).not.toBe(drawnBy(helper).material);
    expect(drawnBy(copy).material.linewidth).toBe(7);
    expect(copy.segments).toBe(helper.segments);
    expect(copy.children).toHaveLength(1);
  });

  test('is written as JSON without lines, and frees what it has', () => {
    using mesh = HalfedgeMesh.grid(2, 2);
    const helper = make(mesh);
    const json = JSON.parse(JSON.stringify(helper.toJSON()));
    expect(new THREE.ObjectLoader().parse(json).children).toEqual([]);
    const freed: string[] = [];
    const { geometry, material } = drawnBy(helper);
    geometry.addEventListener('dispose', () => freed.push('geometry'));
    material.addEventListener('dispose', () => freed.push('material'));
    helper.dispose();
    expect(freed).toEqual(['geometry', 'material']);
  });
});

test('A ray goes through lines for WebGPURenderer', () => {
  using mesh = HalfedgeMesh.cube({ size: 2 });
  const object = new THREE.Mesh(new MeshGeometry(mesh));
  object.add(new HalfedgesHelper(mesh, { lines, linewidth: 50 }));
  const raycaster = new THREE.Raycaster(
    new THREE.Vector3(0.1, 0.2, 5),
    new THREE.Vector3(0, 0, -1),
  );
  const hits = raycaster.intersectObject(object);
  expect(hits.length).toBeGreaterThan(0);
  expect(hits.every((hit) => hit.object === object)).toBe(true);
});

test('A copy of a material is as wide and as near as what it is a copy of', () => {
  using mesh = HalfedgeMesh.cube();
  const { material } = drawnBy(new HalfedgesHelper(mesh, { lines, linewidth: 4 }));
  const copy = material.clone() as typeof material & { lift: number };
  expect([copy.linewidth, copy.lift, copy.polygonOffsetUnits]).toEqual([4, 3, -2]);
  expect(copy.customProgramCacheKey()).toBe(material.customProgramCacheKey());
});

test('WebGLRenderer is told that it needs other lines, unless it has been taught nodes', () => {
  using mesh = HalfedgeMesh.cube();
  const { material } = drawnBy(new HalfedgesHelper(mesh, { lines }));
  const compile = (shader: object) =>
    material.onBeforeCompile(
      ...([shader] as unknown as Parameters<THREE.Material['onBeforeCompile']>),
    );
  expect(() => compile({ uniforms: undefined, vertexShader: undefined })).toThrow(
    /^WebGLRenderer can't draw .*\{ lines: webgpuLines \}; expected .*\.$/,
  );
  compile({ vertexShader: 'void main() {}' }); // as three.js's WebGLNodesHandler does
});
