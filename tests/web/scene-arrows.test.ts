import { HalfedgeMesh, init } from 'halfedge';
import { ARROW_FLOATS, ArrowTracer, arrowSizes } from 'halfedge/three';
import { Color, type Mesh, PerspectiveCamera, Scene } from 'three';
import type { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { ArrowLayer } from '../../dist/scene/arrow-layer.js';
import { FaceFrames } from '../../dist/scene/faces.js';
import { Surface } from '../../dist/scene/surface.js';
import { Card } from './support/card.js';
import { linesInSight } from './support/drawn-arrows.js';
import { random } from './support/random.js';
import { randomEdit, refusalOf } from './support/random-edits.js';

beforeAll(() => init());

const ARROW = new Color(0.25, 0.5, 0.75);
const BOUNDARY = new Color(1, 0.5, 0);

/** A layer before a camera near enough for all faces of a mesh at the origin to be large, and what it draws. */
function layerInSight(pixels = 2000) {
  const camera = new PerspectiveCamera(60);
  camera.position.set(0, 0, 3);
  camera.updateMatrixWorld();
  const pixelAt = (depth: number) => depth / pixels;
  const scene = new Scene();
  const layer = new ArrowLayer({ scene, camera, pixelAt, depthOf: () => 3 } as never);
  layer.setColors(ARROW, ARROW, BOUNDARY);
  const card = new Card();
  const draw = (near: readonly number[], middle: number | null = null) => {
    layer.update(near, middle);
    return (scene.children as Mesh[]).flatMap(({ geometry }) =>
      linesInSight(card, geometry as unknown as LineSegmentsGeometry),
    );
  };
  const look = (x: number, y: number, z: number) => {
    camera.position.set(x, y, z);
    camera.lookAt(0, 0, 0);
    camera.updateMatrixWorld();
  };
  return { layer, draw, pixelAt, look };
}

const sorted = (segments: number[][]) => segments.map(String).sort();
const isArrow = (segment: number[]) => segment[8] === ARROW.b;

describe('The arrows of a scene', () => {
  test('are those of all faces of another mesh, whichever were near before', () => {
    const { layer, draw } = layerInSight();
    for (let turn = 0; turn < 4; turn++) {
      const mesh = HalfedgeMesh.grid(6, 6);
      const surface = new Surface(mesh as never);
      layer.show(surface, new FaceFrames(surface));
      for (let frame = 0; frame <= turn; frame++) {
        draw([(7 * turn + 5 * frame) % mesh.faceCount]);
        expect([...layer.large].sort((a, b) => a - b)).toEqual([...mesh.faces()]);
      }
      mesh.dispose();
    }
  });

  test('lie in each face where they are traced, frame after frame', () => {
    const mesh = HalfedgeMesh.grid(4, 3);
    mesh.insertVertexOnEdge(7); // a face of five corners
    const surface = new Surface(mesh as never);
    const frames = new FaceFrames(surface);
    const { layer, draw, pixelAt } = layerInSight();
    layer.show(surface, frames);
    const expected = [...mesh.faces()].flatMap((f) => {
      const corners: number[] = [];
      const degree = surface.corners(f, corners);
      const depth = 3 - frames.data[frames.at(f) + 2];
      const out = new Float32Array(degree * ARROW_FLOATS);
      new ArrowTracer().traceFace(corners, degree, arrowSizes(pixelAt(depth)), out, 0);
      return Array.from({ length: degree }, (_, i) => [9 * i, 9 * i + 3]).flatMap((ats) =>
        ats.map((at) => [...out.subarray(at, at + 6)]),
      );
    });
    for (let frame = 0; frame < 3; frame++) {
      const arrows = draw([frame]).filter(isArrow);
      expect(arrows.length).toBe(expected.length);
      const far = expected.filter(
        (segment) =>
          !arrows.some((drawn) =>
            // Sizes go in steps that are too small to be seen.
            segment.every((x, k) => Math.abs(x - drawn[k]) < pixelAt(3) / 7),
          ),
      );
      expect(far).toEqual([]);
    }
    mesh.dispose();
  });

  test.each([1, 2, 3])('are those of a layer that sees the mesh first: seed %i', (seed) => {
    const next = random(seed);
    const mesh = seed === 3 ? HalfedgeMesh.dodecahedron() : HalfedgeMesh.grid(5, 4);
    mesh.history.enabled = true;
    const surface = new Surface(mesh as never);
    const frames = new FaceFrames(surface);
    const { layer, draw } = layerInSight();
    layer.show(surface, frames);
    for (let step = 0; step < 60; step++) {
      const change = surface.update();
      frames.forget(change?.faces ?? null);
      layer.change(change?.faces ?? null);
      const faces = [...mesh.faces()];
      const near = faces.filter(() => next() < 0.1);
      const first = layerInSight();
      first.layer.show(surface, new FaceFrames(surface));
      const [mine, expected] = [sorted(draw(near)), sorted(first.draw(near))];
      const other = mine.filter((segment, i) => segment !== expected[i]);
      expect([mine.length, other.length]).toEqual([expected.length, 0]);
      expect(layer.boundary).toEqual(first.layer.boundary);
      expect(layer.large).toEqual(first.layer.large);
      if (next() < 0.2) mesh.history.undo();
      else refusalOf(randomEdit(mesh, next));
    }
    mesh.dispose();
  });

  test('leave out what is hidden, and all where they are not to be seen', () => {
    const mesh = HalfedgeMesh.grid(3, 3);
    const surface = new Surface(mesh as never);
    const { layer, draw } = layerInSight();
    layer.show(surface, new FaceFrames(surface));
    const whole = sorted(draw([]));
    expect(layer.boundary).toHaveLength(12);
    layer.hidden = new Set([4]);
    expect(whole.length - draw([]).length).toBe(2 * mesh.degree(4));
    layer.visible = false;
    expect(draw([])).toEqual([]);
    expect([layer.boundary, layer.large]).toEqual([[], []]);
    [layer.hidden, layer.visible] = [new Set(), true];
    expect(sorted(draw([]))).toEqual(whole);
    mesh.dispose();
  });

  test('spread from the middle of a mesh with more faces than are drawn', () => {
    const mesh = HalfedgeMesh.grid(100, 100);
    const surface = new Surface(mesh as never);
    const { layer, draw } = layerInSight(20_000);
    layer.show(surface, new FaceFrames(surface));
    expect(draw([]).length).toBe(0);
    const middle = 5050;
    expect(draw([], middle).filter(isArrow).length).toBe(8 * 8000);
    expect(layer.large[0]).toBe(middle);
    expect(new Set(layer.large).size).toBe(8000);
    draw([17], middle);
    expect(layer.large[0]).toBe(17);
    expect(layer.large.includes(middle)).toBe(true);
    mesh.dispose();
  });

  test.each([1, 2, 3, 4])('do not depend on the frames before: seed %i', (seed) => {
    const next = random(seed);
    const mesh = [
      () => HalfedgeMesh.grid(20, 20),
      () => HalfedgeMesh.icoSphere(3),
      () => HalfedgeMesh.dodecahedron(),
      () => HalfedgeMesh.grid(64, 64, { triangles: true }), // more faces than show arrows
    ][seed - 1]();
    const surface = new Surface(mesh as never);
    const layerOf = () => {
      const shown = layerInSight();
      shown.layer.setColors(new Color(1, 1, 1), ARROW, BOUNDARY);
      shown.layer.show(surface, new FaceFrames(surface));
      return shown;
    };
    const moved = layerOf();
    const counts = new Set<number>();
    for (let frame = 0; frame < (seed === 4 ? 4 : 10); frame++) {
      const place = [2 * next() - 1, 2 * next() - 1, 1.2 + 3 * next()] as const;
      const near = next() < 0.5 ? [Math.floor(mesh.faceCount * next())] : [];
      const hidden = new Set(next() < 0.3 ? [0, 1, 2] : []);
      const [mine, expected] = [moved, layerOf()].map(({ layer, look, draw }) => {
        look(...place);
        layer.hidden = hidden;
        return sorted(draw(near, 1));
      });
      const other = mine.filter((segment, i) => segment !== expected[i]);
      expect([frame, mine.length, other.length]).toEqual([frame, expected.length, 0]);
      counts.add(mine.length);
    }
    expect(counts.size).toBeGreaterThan(1);
    mesh.dispose();
  });
});
