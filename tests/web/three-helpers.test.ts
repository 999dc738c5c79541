import { HalfedgeMesh, init, type Refusal } from 'halfedge';
import {
  BoundaryLoopsHelper,
  CirculatorHelper,
  ghostOf,
  HalfedgeGlyphs,
  HalfedgesHelper,
  IndexLabelsHelper,
  lineMaterial,
  MeshGeometry,
  type MeshHelper,
  ProblemsHelper,
} from 'halfedge/three';
import * as THREE from 'three';
import type { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { random } from './support/random.js';

beforeAll(() => init());

const linesOf = (helper: MeshHelper) => helper.children[0] as LineSegments2;

/** The segments that a helper draws: their two ends. */
function segmentsOf(helper: MeshHelper): THREE.Vector3[][] {
  const { instanceStart, instanceEnd } = linesOf(helper).geometry.attributes;
  return Array.from({ length: helper.segments }, (_, i) =>
    [instanceStart, instanceEnd].map((ends) => new THREE.Vector3().fromBufferAttribute(ends, i)),
  );
}

/** How many segments three.js draws. */
const drawnBy = (helper: MeshHelper) => linesOf(helper).geometry.instanceCount;

const colorsOf = (helper: MeshHelper) => {
  const { instanceColorStart: colors } = linesOf(helper).geometry.attributes;
  return Array.from({ length: helper.segments }, (_, i) =>
    new THREE.Color(colors.getX(i), colors.getY(i), colors.getZ(i)).getHex(),
  );
};

describe('HalfedgesHelper', () => {
  test('draws a shaft and a barb for each halfedge of a closed mesh, inside of its face', () => {
    const mesh = HalfedgeMesh.cube({ size: 2 });
    const helper = new HalfedgesHelper(mesh);
    expect(helper.segments).toBe(2 * mesh.halfedgeCount);
    for (const [a, b] of segmentsOf(helper)) {
      for (const end of [a, b]) {
        const sizes = end.toArray().map(Math.abs).sort();
        expect(sizes[2]).toBeCloseTo(1); // in the plane of a side of the cube
        expect(sizes[1]).toBeLessThan(0.999); // and not on an edge of it
      }
    }
  });

  test('lies in the triangles that a bent quad is cut into, also where its diagonals are alike', () => {
    const next = random(3);
    for (let round = 0; round < 60; round++) {
      const z = () => 0.5 * (next() - 0.5);
      const x = round % 3 === 0 ? 0 : 0.2 * next();
      const corners = [
        [0, 0, z()],
        [1 + x, 0, z()],
        [1, 1, z()],
        [0, 1, z()],
      ];
      if (round % 3 === 0) for (const i of [0, 1, 2, 3]) corners[i][2] = 0.2 * (i % 2);
      const turned = corners.map((corner) => corner.map((_, i) => corner[(i + round) % 3]));
      const mesh = HalfedgeMesh.fromPolygons(turned.flat(), [[0, 1, 2, 3]]);
      const { indices } = mesh.toTriangles();
      const triangles = [0, 3].map((at) => {
        const [a, b, c] = [0, 1, 2].map(
          (k) => new THREE.Vector3(...mesh.position(indices[at + k])),
        );
        return new THREE.Triangle(a, b, c);
      });
      const inside = segmentsOf(new HalfedgesHelper(mesh)).slice(0, 8);
      const apart = inside
        .flat()
        .map((p) =>
          Math.min(
            ...triangles.map((t) => t.closestPointToPoint(p, new THREE.Vector3()).distanceTo(p)),
          ),
        );
      expect({ round, apart: Math.max(...apart) }).toEqual({ round, apart: expect.closeTo(0, 5) });
      mesh.dispose();
    }
  });

  test('comes nearer to the camera than the triangles of a face that is not plane', () => {
    const { material } = linesOf(new HalfedgesHelper(HalfedgeMesh.cube()));
    const { vertexShader, uniforms } = material as THREE.ShaderMaterial;
    expect(uniforms.lineLift.value).toBeGreaterThanOrEqual(3); // CSS pixels
    expect(vertexShader.indexOf('clip.z +=')).toBeGreaterThan(vertexShader.indexOf('vec4 clip ='));
    expect(vertexShader.indexOf('clip.z +=')).toBeLessThan(vertexShader.indexOf('gl_Position ='));
  });

  test('is drawn on an object that is mirrored, too, whose front sides three.js culls', () => {
    for (const material of [
      linesOf(new HalfedgesHelper(HalfedgeMesh.cube())).material,
      ghostOf(lineMaterial(1, 0)),
    ]) {
      expect(material.side).toBe(THREE.DoubleSide);
    }
  });

  test('learns how large the picture is from WebGLRenderer, and tells WebGPURenderer what it needs', () => {
    const lines = linesOf(new HalfedgesHelper(HalfedgeMesh.cube()));
    const render = (renderer: object) => lines.onBeforeRender(renderer as THREE.WebGLRenderer);
    const getViewport = (to: THREE.Vector4) => to.set(0, 0, 640, 480);
    render({ isWebGLRenderer: true, getViewport });
    expect(lines.material.resolution.toArray()).toEqual([640, 480]);
    expect(() => render({ isWebGPURenderer: true, getViewport })).toThrow(
      /^WebGPURenderer can't draw .*; expected .* of halfedge\/three\/webgpu\.$/,
    );
  });

  test('shares the program of its lines with others that are wider or nearer, and with ghosts of them', () => {
    const [one, other] = [lineMaterial(1.5, 2), lineMaterial(7, 4)];
    const ghost = ghostOf(other);
    const programOf = ({ vertexShader, fragmentShader, defines }: THREE.ShaderMaterial) => ({
      vertexShader,
      fragmentShader,
      defines,
    });
    expect(programOf(other)).toEqual(programOf(one));
    expect(programOf(ghost)).toEqual(programOf(one));
    const lifts = [one, other, ghost].map(({ uniforms }) => uniforms.lineLift.value);
    expect(lifts).toEqual([3, 6, 6]); // CSS pixels
  });

  test('runs beside the halfedge, in its direction and on the side of its face', () => {
    const mesh = HalfedgeMesh.grid(2, 2);
    const glyphs = new HalfedgeGlyphs({ mesh, points: mesh.positions });
    for (const h of mesh.halfedges()) {
      const at = glyphs.halfedge(h, { inset: 0.05, trim: 0.01, barb: 0.05 });
      const [start, end, tip] = [0, 3, 6].map((k) =>
        new THREE.Vector3().fromArray(glyphs.arrows, at + k),
      );
      const from = new THREE.Vector3(...mesh.position(mesh.fromVertex(h)));
      const along = new THREE.Vector3(...mesh.position(mesh.toVertex(h))).sub(from).normalize();
      const left = new THREE.Vector3(0, 0, 1).cross(along);
      const shaft = end.clone().sub(start);
      expect(shaft.dot(along)).toBeCloseTo(shaft.length());
      expect(shaft.length()).toBeGreaterThan(0.1);
      expect(start.clone().sub(from).dot(left)).toBeCloseTo(0.05);
      expect(tip.clone().sub(end).dot(left)).toBeGreaterThan(0.01);
    }
  });

  test('has dotted arrows outside of the boundary, in another colour', () => {
    const mesh = HalfedgeMesh.grid(1, 1);
    const helper = new HalfedgesHelper(mesh, { color: 0x0000ff, boundaryColor: 0xff0000 });
    const colors = colorsOf(helper);
    const outside = segmentsOf(helper).filter((_, i) => colors[i] === 0xff0000);
    expect(segmentsOf(helper).length - outside.length).toBe(2 * 4);
    expect(outside.length).toBeGreaterThan(4 * 4); // dots, and barbs
    for (const [a, b] of outside) {
      const middle = a.clone().add(b).divideScalar(2);
      expect(Math.max(Math.abs(middle.x), Math.abs(middle.y))).toBeGreaterThan(0.5);
    }
  });

  test('follows edits, and shows the faces that are named', () => {
    const mesh = HalfedgeMesh.icosahedron();
    const helper = new HalfedgesHelper(mesh, { faces: [3, 4] });
    expect(helper.segments).toBe(2 * 2 * 3);
    helper.faces = undefined;
    mesh.splitEdge(0);
    helper.update();
    expect(helper.segments).toBe(2 * mesh.halfedgeCount);
    const big = HalfedgeMesh.grid(120, 120);
    const wide = new HalfedgesHelper(big);
    expect(wide.segments).toBeLessThan(8000 * 8 + 3000 * 60);
    helper.dispose();
    mesh.dispose();
    expect(() => helper.update()).toThrow(/disposed/);
    expect(drawnBy(helper)).toBe(0);
  });

  test('refuses wrong options with a sentence', () => {
    const mesh = HalfedgeMesh.cube();
    expect(() => new HalfedgesHelper(mesh, { pixel: -1 })).toThrow(
      'options.pixel is -1; expected a positive number.',
    );
    expect(() => new HalfedgesHelper({} as never)).toThrow(
      'mesh is an Object; expected a HalfedgeMesh.',
    );
    expect(() => new HalfedgesHelper(mesh, { faces: 3 as never })).toThrow(
      'options.faces is 3; expected faces to iterate over.',
    );
    expect(() => new HalfedgesHelper(mesh, { faces: 'f3' as never })).toThrow(/is "f3"; expected/);
    expect(() => new HalfedgesHelper(mesh, { faces: [3, 'x' as never] })).toThrow(
      'options.faces[1] is "x"; expected an index, an integer from 0 to 4294967294.',
    );
    expect(new HalfedgesHelper(mesh, { faces: new Set([1, 99]) }).segments).toBe(8);
  });

  test.each([
    ['color', (o: object) => new BoundaryLoopsHelper(HalfedgeMesh.cube(), o)],
    ['boundaryColor', (o: object) => new HalfedgesHelper(HalfedgeMesh.cube(), o)],
    ['currentColor', (o: object) => new CirculatorHelper(HalfedgeMesh.cube(), 'vertexFaces', 0, o)],
  ])('refuses what is no colour as %s, of which three.js would make white', (name, make) => {
    for (const color of [null, true, -1, Number.NaN, 0x1000000, { r: 1, g: 0, b: 0 }, [1, 0, 0]]) {
      expect(() => make({ [name]: color })).toThrow(
        /^options\.\w+ is .+; expected a colour: a Color, a string or a number from 0x000000 to 0xffffff\.$/,
      );
    }
    for (const color of [undefined, 0, 0xffffff, 0xffffff / 3, 'red', '#f00', new THREE.Color()]) {
      expect(make({ [name]: color })).toHaveProperty(`${name}.isColor`, true);
    }
  });

  test('refuses at an update what was set wrongly, and goes on once it is right', () => {
    const mesh = HalfedgeMesh.grid(2, 2);
    const arrows = new HalfedgesHelper(mesh);
    for (const pixel of [Number.NaN, -1, 0, Infinity, '1' as never]) {
      arrows.pixel = pixel;
      expect(() => arrows.update()).toThrow(/^pixel is .+; expected a positive number\.$/);
      expect(drawnBy(arrows)).toBe(0);
    }
    arrows.pixel = 0.01;
    arrows.faces = 3 as never;
    expect(() => arrows.update()).toThrow('faces is 3; expected faces to iterate over.');
    arrows.faces = undefined;
    arrows.update();
    expect(arrows.segments).toBeGreaterThan(0);
    const trace = new CirculatorHelper(mesh, 'vertexFaces', 4);
    trace.steps = Number.NaN;
    expect(() => trace.update()).toThrow('steps is NaN; expected a number from 0.');
  });

  test.each([
    ['webgpu', '"webgpu"'],
    [null, 'null'],
    [THREE.Mesh, 'a function'],
    [new THREE.Mesh(), 'a Mesh'],
  ])('refuses lines that are none: %p', (lines, found) => {
    const made = () => new HalfedgesHelper(HalfedgeMesh.cube(), { lines: lines as never });
    expect(made).toThrow(
      `options.lines is ${found}; expected webgpuLines of halfedge/three/webgpu, or nothing for WebGLRenderer.`,
    );
  });

  test('has buffers that no renderer uploads unless they change', () => {
    const { geometry } = linesOf(new HalfedgesHelper(HalfedgeMesh.cube()));
    for (const name of ['instanceStart', 'instanceColorStart']) {
      const { data } = geometry.attributes[name] as THREE.InterleavedBufferAttribute;
      expect(data.usage).toBe(THREE.StaticDrawUsage); // of others, WebGPURenderer uploads all in each frame
    }
  });
});

test('BoundaryLoopsHelper draws each boundary edge once', () => {
  const mesh = HalfedgeMesh.grid(3, 2);
  const helper = new BoundaryLoopsHelper(mesh);
  const ends = segmentsOf(helper).map(([a, b]) => `${a.toArray()} ${b.toArray()}`);
  const expected = mesh
    .halfedgeLoop(mesh.boundaryLoops()[0])
    .toArray()
    .map((h) => `${mesh.position(mesh.fromVertex(h))} ${mesh.position(mesh.toVertex(h))}`);
  expect(ends.sort()).toEqual(expected.sort());
  expect(new BoundaryLoopsHelper(HalfedgeMesh.cube()).segments).toBe(0);
});

test('CirculatorHelper shows the halfedges of a lap, or of some steps, the last in its colour', () => {
  const mesh = HalfedgeMesh.icosahedron();
  const helper = new CirculatorHelper(mesh, 'vertexVertices', 4, {
    direction: 'cw',
    currentColor: 0xff0000,
  });
  expect(helper.trace()).toEqual(mesh.vertexOutgoingHalfedges(4, 'cw').toArray());
  helper.steps = 2;
  helper.update();
  expect(helper.trace()).toHaveLength(2);
  expect(colorsOf(helper).map((color) => color === 0xff0000)).toEqual([false, false, true, true]);
  helper.item = 5;
  helper.steps = Infinity;
  expect(helper.trace()).toEqual(mesh.vertexOutgoingHalfedges(5, 'cw').toArray());
});

test('CirculatorHelper draws nothing where its item is gone, until it has another one', () => {
  const mesh = HalfedgeMesh.icosahedron();
  const helper = new CirculatorHelper(mesh, 'vertexVertices', 4);
  expect(drawnBy(helper)).toBe(10);
  mesh.deleteVertex(4);
  expect(() => helper.update()).toThrow('vertex 4, which was deleted');
  expect([helper.segments, drawnBy(helper)]).toEqual([0, 0]);
  helper.item = 5;
  helper.update();
  expect(drawnBy(helper)).toBe(helper.segments);
  expect(helper.segments).toBeGreaterThan(0);
});

test('A helper draws nothing where an update ends half way, rather than a part', () => {
  const helper = new HalfedgesHelper(HalfedgeMesh.cube());
  const faces = function* () {
    yield 0;
    throw new Error('of the user');
  };
  helper.faces = faces() as unknown as number[];
  expect(() => helper.update()).toThrow('of the user');
  expect([helper.segments, drawnBy(helper)]).toEqual([0, 0]);
});

test('ProblemsHelper draws what a refusal or the validation is about', () => {
  const mesh = HalfedgeMesh.grid(2, 2);
  expect(new ProblemsHelper(mesh).segments).toBe(0);
  const e = mesh.findEdge(0, 1);
  const refusal = mesh.checkFlipEdge(e) as Refusal;
  expect(refusal.witness.edges).toEqual([e]);
  const helper = new ProblemsHelper(mesh, { problems: [refusal] });
  const [a, b] = segmentsOf(helper).at(-1) as THREE.Vector3[];
  expect([a.toArray(), b.toArray()].sort()).toEqual([mesh.position(0), mesh.position(1)].sort());
  mesh.connectivity.next[5] = 5; // a broken link
  helper.problems = undefined;
  helper.update();
  expect(mesh.validate().length).toBeGreaterThan(0);
  expect(helper.segments).toBeGreaterThan(0);
});

describe('Where links were written over', () => {
  /** An icosahedron with one wrong link at or beside face 0, and the halfedge where that begins. */
  const broken = (break_: (mesh: HalfedgeMesh, h: number) => void) => {
    const mesh = HalfedgeMesh.icosahedron();
    break_(mesh, mesh.faceHalfedge(0));
    return mesh;
  };
  const ways: [string, (mesh: HalfedgeMesh, h: number) => void][] = [
    [
      'a face that a halfedge is not in',
      ({ connectivity: { face } }, h) => (face[h ^ 1] = face[h]),
    ],
    [
      'a loop that leaves out its first',
      ({ connectivity: { next } }, h) => {
        next[next[next[h]]] = next[h];
      },
    ],
    [
      'a loop that leaves out another',
      ({ connectivity: { next } }, h) => (next[h] = next[next[h]]),
    ],
    ['a loop that ends', ({ connectivity: { next } }, h) => (next[next[h]] = -1)],
    [
      'the first of another face',
      ({ connectivity: { faceHalfedge, next } }, h) => {
        faceHalfedge[0] = next[h] ^ 1;
      },
    ],
  ];

  test.each(ways)('ProblemsHelper draws what it can: %s', (_, way) => {
    const mesh = broken(way);
    const all = Array.from({ length: mesh.halfedgeSlots }, (_, index) => ({
      kind: 'halfedge' as const,
      index,
    }));
    expect(() => new ProblemsHelper(mesh)).not.toThrow();
    expect(new ProblemsHelper(mesh, { problems: all as never }).segments).toBeGreaterThan(50);
  });

  test.each(ways)('other helpers end: %s', (_, way) => {
    const mesh = broken(way);
    const makers = [
      () => new HalfedgesHelper(mesh),
      () => new CirculatorHelper(mesh, 'faceHalfedges', 0),
      ...[0, 1, 2, 3, 4].map((v) => () => new CirculatorHelper(mesh, 'vertexFaces', v)),
    ];
    for (const make of makers) {
      try {
        make();
      } catch (error) {
        expect(error).toMatchObject({ code: 'corrupt-connectivity' });
      }
    }
  });
});

test('ProblemsHelper takes any part of a witness, and refuses what is no problem', () => {
  using mesh = HalfedgeMesh.cube();
  const made = (problems: unknown) => new ProblemsHelper(mesh, { problems: problems as never });
  expect(made([{ witness: { faces: [2] } }, { kind: 'face', index: 99 }]).segments).toBe(4);
  const refusal = mesh.checkFlipEdge(0);
  expect(() => made(refusal)).toThrow(
    'problems is an Object; expected an array of problems and refusals.',
  );
  expect(() => made([refusal, mesh.checkSplitEdge(0)])).toThrow(
    'problems[1] is null; expected a problem, a refusal or an error.',
  );
});

test.each([
  ['HalfedgesHelper', 1.5, (o: object) => new HalfedgesHelper(HalfedgeMesh.cube(), o)],
  ['BoundaryLoopsHelper', 2.25, (o: object) => new BoundaryLoopsHelper(HalfedgeMesh.cube(), o)],
  [
    'CirculatorHelper',
    2.5,
    (o: object) => new CirculatorHelper(HalfedgeMesh.cube(), 'vertexFaces', 0, o),
  ],
  ['ProblemsHelper', 3.5, (o: object) => new ProblemsHelper(HalfedgeMesh.cube(), o)],
])('%s has lines of %d pixels, also where linewidth is undefined', (_, width, make) => {
  const widthOf = (options: object) => {
    const [lines] = make(options).children as LineSegments2[];
    return lines.material.linewidth;
  };
  expect(widthOf({})).toBe(width);
  expect(widthOf({ linewidth: undefined })).toBe(width);
  expect(widthOf({ linewidth: 4 })).toBe(4);
});

test('A ray that hits the surface does not hit the helpers upon it', () => {
  const mesh = HalfedgeMesh.cube({ size: 2 });
  const object = new THREE.Mesh(new MeshGeometry(mesh));
  object.add(new HalfedgesHelper(mesh, { linewidth: 50 }));
  const camera = new THREE.PerspectiveCamera();
  camera.position.z = 5;
  camera.updateMatrixWorld();
  const raycaster = new THREE.Raycaster();
  raycaster.setFromCamera(new THREE.Vector2(0.1, 0.2), camera);
  const hits = raycaster.intersectObject(object);
  expect(hits).not.toHaveLength(0);
  for (const hit of hits) expect(hit.object).toBe(object);
});

test('Helpers are seen by the cameras that their layers say, and so are their clones', () => {
  const mesh = HalfedgeMesh.cube();
  for (const helper of [new HalfedgesHelper(mesh), new CirculatorHelper(mesh, 'vertexFaces', 0)]) {
    helper.layers.set(2);
    for (const each of [helper, helper.clone()]) {
      expect(each.children.length).toBeGreaterThan(0);
      for (const { layers } of each.children) expect(layers.mask).toBe(4);
    }
  }
});

test('Helpers are drawn by materials of lines alone, and cast no shadows', () => {
  using mesh = HalfedgeMesh.cube();
  const helper = new HalfedgesHelper(mesh);
  const lines: THREE.Mesh = linesOf(helper);
  const { geometry } = linesOf(helper);
  const all = helper.segments;
  const [scene, camera] = [new THREE.Scene(), new THREE.Camera()];
  const renderer = { getViewport() {} } as unknown as THREE.WebGLRenderer;
  /** How many segments are drawn as three.js draws them by a material. */
  const drawn = (material: THREE.Material, way: 'Render' | 'Shadow' = 'Render') => {
    const group = null as unknown as THREE.Group;
    const asRendered = [renderer, scene, camera, geometry, material, group] as const;
    const asShadow = [renderer, lines, camera, camera, geometry, material, group] as const;
    if (way === 'Render') lines.onBeforeRender(...asRendered);
    else lines.onBeforeShadow(...(asShadow as unknown as Parameters<typeof lines.onBeforeShadow>));
    const count = drawnBy(helper);
    if (way === 'Render') lines.onAfterRender(...asRendered);
    else lines.onAfterShadow(...(asShadow as unknown as Parameters<typeof lines.onAfterShadow>));
    expect(drawnBy(helper)).toBe(all);
    return count;
  };
  expect(drawn(linesOf(helper).material)).toBe(all);
  expect(drawn(lineMaterial(3, 0))).toBe(all);
  expect(drawn(new THREE.MeshNormalMaterial())).toBe(0);
  expect(drawn(new THREE.MeshDepthMaterial(), 'Shadow')).toBe(0);
  scene.overrideMaterial = new THREE.MeshNormalMaterial();
  expect(drawn(linesOf(helper).material)).toBe(all); // of a material that allows no other
});

describe('An object with helpers upon it', () => {
  const options = { color: 0x123456, linewidth: 7, pixel: 0.02 };
  const HELPERS: [string, (mesh: HalfedgeMesh) => MeshHelper][] = [
    ['HalfedgesHelper', (m) => new HalfedgesHelper(m, { ...options, faces: [1, 2] })],
    ['BoundaryLoopsHelper', (m) => new BoundaryLoopsHelper(m, options)],
    [
      'CirculatorHelper',
      (m) => new CirculatorHelper(m, 'vertexFaces', 4, { ...options, direction: 'cw', steps: 3 }),
    ],
    [
      'ProblemsHelper',
      (m) => new ProblemsHelper(m, { ...options, problems: [{ kind: 'face', index: 0 }] }),
    ],
  ];

  test.each(HELPERS)('can be cloned: %s', (_, make) => {
    using mesh = HalfedgeMesh.grid(2, 2);
    const helper = make(mesh);
    helper.name = 'above';
    helper.position.z = 0.25;
    const object = new THREE.Mesh(new MeshGeometry(mesh)).add(helper);
    const [copy] = object.clone().children as MeshHelper[];
    expect(copy).toBeInstanceOf(helper.constructor);
    expect([copy.name, copy.position.z, copy.pixel]).toEqual(['above', 0.25, 0.02]);
    expect(copy.children).toHaveLength(1);
    expect(linesOf(copy).material.linewidth).toBe(7);
    expect(segmentsOf(copy)).toEqual(segmentsOf(helper));
    expect(colorsOf(copy)).toEqual(colorsOf(helper));
    helper.dispose();
    mesh.deleteFace(3);
    copy.update();
    copy.dispose();
  });

  test('can be cloned where one of them goes around a vertex that was deleted', () => {
    using mesh = HalfedgeMesh.grid(3, 3);
    const helper = new CirculatorHelper(mesh, 'vertexFaces', 5);
    const object = new THREE.Mesh(new MeshGeometry(mesh)).add(helper);
    mesh.deleteVertex(5);
    const [copy] = object.clone().children as [typeof helper];
    expect(copy.item).toBe(5);
    expect(copy.segments).toBe(0);
    expect(() => copy.update()).toThrow('vertex 5');
    expect(() => new CirculatorHelper(mesh, 'vertexFaces', 5)).toThrow('vertex 5');
    copy.item = 11;
    copy.update();
    expect(copy.segments).toBeGreaterThan(0);
  });

  test('is written as JSON, without their lines', () => {
    using mesh = HalfedgeMesh.grid(2, 2);
    const helper = new HalfedgesHelper(mesh);
    helper.name = 'above';
    const object = new THREE.Mesh(new MeshGeometry(mesh), new THREE.MeshBasicMaterial());
    const json = JSON.parse(JSON.stringify(object.add(helper).toJSON()));
    const [read] = new THREE.ObjectLoader().parse(json).children;
    expect([read.type, read.name, read.uuid]).toEqual(['Group', 'above', helper.uuid]);
    expect(read.children).toEqual([]);
    expect(json.geometries).toHaveLength(1);
  });
});

describe('A helper to which a page has added objects', () => {
  const HELPERS: [string, (mesh: HalfedgeMesh) => MeshHelper][] = [
    ['HalfedgesHelper', (m) => new HalfedgesHelper(m)],
    ['BoundaryLoopsHelper', (m) => new BoundaryLoopsHelper(m)],
    ['CirculatorHelper', (m) => new CirculatorHelper(m, 'vertexFaces', 4)],
    ['ProblemsHelper', (m) => new ProblemsHelper(m, { problems: [{ kind: 'face', index: 0 }] })],
  ];
  const names = ({ children }: THREE.Object3D) => children.map(({ name }) => name);
  const named = (object: THREE.Object3D, name: string) => Object.assign(object, { name });

  /** A helper with a box and, in a group, a helper that can't draw. */
  function dressed(mesh: HalfedgeMesh, make: (mesh: HalfedgeMesh) => MeshHelper) {
    const helper = make(mesh);
    const box = new THREE.Mesh(new THREE.BoxGeometry(), new THREE.MeshBasicMaterial());
    const inner = new CirculatorHelper(mesh, 'vertexFaces', 0);
    mesh.deleteVertex(0);
    const group = named(new THREE.Group(), 'group').add(named(inner, 'inner'));
    helper.add(named(box, 'box'), group);
    return { helper, box, inner };
  }

  test.each(HELPERS)('has clones of them as it is cloned: %s', (_, make) => {
    using mesh = HalfedgeMesh.grid(2, 2);
    const { helper, box } = dressed(mesh, make);
    const copy = helper.clone();
    expect(names(copy)).toEqual(['', 'box', 'group']);
    expect(copy.children[1]).not.toBe(box);
    expect(box.parent).toBe(helper);
    expect(names(copy.children[2])).toEqual(['inner']);
    expect(names(copy.children[2].children[0])).toEqual(['']);
    expect(names(helper.clone(false))).toEqual(['']);
    expect(() => new CirculatorHelper(mesh, 'vertexFaces', 0)).toThrow('vertex 0');
  });

  test.each(HELPERS)('is written as JSON with them: %s', (_, make) => {
    using mesh = HalfedgeMesh.grid(2, 2);
    const { helper, box, inner } = dressed(mesh, make);
    const json = JSON.parse(JSON.stringify(new THREE.Scene().add(helper).toJSON()));
    const [read] = new THREE.ObjectLoader().parse(json).children;
    expect(names(read)).toEqual(['box', 'group']);
    expect(read.children[0].uuid).toBe(box.uuid);
    expect(json.geometries).toHaveLength(1);
    expect(read.children[1].children[0].uuid).toBe(inner.uuid);
    expect(names(helper)).toEqual(['', 'box', 'group']);
    expect(box.parent).toBe(helper);
  });

  test.each(HELPERS)('hands them to a copy, which keeps its own mesh and lines: %s', (_, make) => {
    using mesh = HalfedgeMesh.grid(2, 2);
    using other = HalfedgeMesh.cube();
    const { helper } = dressed(mesh, make);
    helper.position.z = 0.25;
    const copy = make(other);
    const [lines, segments] = [linesOf(copy), segmentsOf(copy)];
    expect(copy.copy(helper)).toBe(copy);
    expect([copy.mesh, copy.position.z]).toEqual([other, 0.25]);
    expect(names(copy)).toEqual(['', 'box', 'group']);
    expect(linesOf(copy)).toBe(lines);
    expect(segmentsOf(copy)).toEqual(segments);
    expect(names(make(other).copy(helper, false))).toEqual(['']);
    expect(names(make(other).copy(new THREE.Group().add(helper)))).toHaveLength(2);
    expect(names(new THREE.Group().copy(helper as THREE.Group))).toHaveLength(3);
  });
});

describe('IndexLabelsHelper', () => {
  /** As much of a page as three.js's labels ask for. */
  class Element {
    readonly style = {};
    readonly ownerDocument = { defaultView: { Element } };
    readonly parentNode = null;
    textContent = '';
    className = '';
    isOnPage = true;
    setAttribute() {}
    remove() {
      this.isOnPage = false;
    }
  }

  beforeAll(() => {
    Object.assign(globalThis, { Element, document: { createElement: () => new Element() } });
  });
  afterAll(() => {
    for (const name of ['document', 'Element'])
      delete (globalThis as Record<string, unknown>)[name];
  });

  test('labels items where they are, no more than it may', () => {
    const mesh = HalfedgeMesh.cube({ size: 2 });
    const helper = new IndexLabelsHelper(mesh, { kinds: ['vertex', 'face', 'edge'] });
    const texts = () =>
      helper.children.map(
        (label) => (label as THREE.Object3D & { element: HTMLElement }).element.textContent,
      );
    expect(texts()).toHaveLength(8 + 6 + 12);
    expect(texts().slice(7, 9)).toEqual(['v7', 'f0']);
    expect(helper.children[8].position.length()).toBeCloseTo(1);
    expect(helper.children[14].position.length()).toBeCloseTo(Math.SQRT2);
    mesh.deleteVertex(0);
    helper.update();
    expect(texts()[0]).toBe('v1');
    expect(
      new IndexLabelsHelper(HalfedgeMesh.grid(30), { kinds: ['halfedge'], most: 20 }).children,
    ).toHaveLength(20);
    helper.dispose();
    expect(helper.children).toHaveLength(0);
  });

  test('takes its labels out of the page when it is removed, and keeps them for when it is added', () => {
    using mesh = HalfedgeMesh.cube();
    const helper = new IndexLabelsHelper(mesh);
    const labels = helper.children as (THREE.Object3D & { element: Element })[];
    const object = new THREE.Group().add(helper);
    expect(labels.every(({ element }) => element.isOnPage)).toBe(true);
    object.remove(helper);
    expect(labels.some(({ element }) => element.isOnPage)).toBe(false);
    expect(labels).toHaveLength(8);
  });

  test.each([0.01, 1, 1000])(
    'labels halfedges on their arrows, on a mesh of the size %p',
    (size) => {
      using mesh = HalfedgeMesh.cube({ size });
      const arrows = segmentsOf(new HalfedgesHelper(mesh));
      for (const { position } of new IndexLabelsHelper(mesh, { kinds: ['halfedge'] }).children) {
        const distances = arrows.map(([a, b]) => position.distanceTo(a.clone().lerp(b, 0.5)));
        expect(Math.min(...distances)).toBeLessThan(1e-6 * size);
      }
    },
  );

  test('is seen by the cameras that its layers say', () => {
    using mesh = HalfedgeMesh.cube();
    const helper = new IndexLabelsHelper(mesh);
    helper.layers.set(2);
    expect(helper.children.map(({ layers }) => layers.mask)).toEqual(new Array(8).fill(4));
  });

  test('can be cloned', () => {
    using mesh = HalfedgeMesh.cube();
    const helper = new IndexLabelsHelper(mesh, { kinds: ['face'], most: 4 });
    const [copy] = new THREE.Group().add(helper).clone().children;
    expect(copy).toBeInstanceOf(IndexLabelsHelper);
    expect(copy.children).toHaveLength(4);
  });

  test('leaves alone what a page has added to it, and clones, copies and writes that', () => {
    using mesh = HalfedgeMesh.cube();
    using small = HalfedgeMesh.grid(1, 1);
    const helper = new IndexLabelsHelper(mesh);
    const box = new THREE.Mesh(new THREE.BoxGeometry(), new THREE.MeshBasicMaterial());
    const object = new THREE.Group().add(helper.add(box));
    const [label] = helper.children;
    const boxes = (of: THREE.Object3D) => of.children.filter((child) => 'isMesh' in child);
    mesh.poke(0);
    helper.update();
    expect([helper.children.length, boxes(helper)]).toEqual([10, [box]]);
    helper.remove(label);
    helper.update();
    expect(helper.children).toHaveLength(10);
    const copy = helper.clone();
    expect([copy.children.length, boxes(copy).length]).toEqual([10, 1]);
    expect(helper.clone(false).children).toHaveLength(9);
    const other = new IndexLabelsHelper(small).copy(helper as never);
    expect([other.mesh, other.children.length, boxes(other).length]).toEqual([small, 5, 1]);
    const json = JSON.parse(JSON.stringify(object.toJSON()));
    const [read] = new THREE.ObjectLoader().parse(json).children;
    expect(read.children.map(({ uuid }) => uuid)).toEqual([box.uuid]);
    object.remove(helper);
    helper.dispose();
    expect(helper.children).toEqual([box]);
    helper.update();
    expect(helper.children).toHaveLength(10);
  });

  test('takes options that are inherited, and defaults for those that are undefined', () => {
    using mesh = HalfedgeMesh.grid(30);
    const labelled = (options: object) => new IndexLabelsHelper(mesh, options).children;
    expect(labelled(Object.create({ most: 20 }))).toHaveLength(20);
    expect(labelled({ most: 20.5 })).toHaveLength(20);
    expect(labelled({ kinds: undefined, most: undefined })).toHaveLength(300);
  });

  test('refuses wrong options with a sentence', () => {
    using mesh = HalfedgeMesh.cube();
    const made = (options: object) => () => new IndexLabelsHelper(mesh, options);
    expect(made({ kinds: 'vertex' })).toThrow(
      'options.kinds is "vertex"; expected an array of kinds of items.',
    );
    expect(made({ kinds: ['face', 'verts'] })).toThrow(
      `options.kinds[1] is "verts"; expected 'vertex', 'halfedge', 'edge' or 'face'.`,
    );
    expect(made({ most: -1 })).toThrow('options.most is -1; expected a number from 0.');
    expect(made({ className: 5 })).toThrow('options.className is 5; expected a string.');
    expect(made({ pixel: '1' })).toThrow('options.pixel is "1"; expected a positive number.');
    expect(made({ most: 2.5 })().children).toHaveLength(2);
  });
});
