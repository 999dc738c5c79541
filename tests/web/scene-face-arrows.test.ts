import { HalfedgeMesh, init } from 'halfedge';
import { ARROW_FLOATS, ArrowTracer, arrowSizes } from 'halfedge/three';
import { Color, Triangle, Vector3 } from 'three';
import { BoundaryArrows } from '../../dist/scene/boundary-arrows.js';
import { FaceArrows } from '../../dist/scene/face-arrows.js';
import { Surface } from '../../dist/scene/surface.js';
import { cornersAcross } from '../../dist/three/across.js';
import { Card } from './support/card.js';
import { describeArrow, drawnArrows, linesInSight } from './support/drawn-arrows.js';
import { drawLines } from './support/lines-on-card.js';
import { random } from './support/random.js';
import { randomEdit, refusalOf } from './support/random-edits.js';

beforeAll(() => init());

const FAINT = new Color(0.75, 0.5, 0.25);
const STRONG = new Color(0, 0.25, 1);
const SHADES = 31;
/** The length of a pixel, of which this is one of the steps in which arrows are sized. */
const PIXEL = 1 / 1024;

/** How a face is to be shown. */
interface Wish {
  readonly pixel: number;
  readonly strength: number;
}

/** The arrows of faces of a mesh, and a card that is sent what changes of them. */
class Picture {
  readonly card = new Card();
  readonly arrows = new FaceArrows();
  readonly surface: Surface;

  constructor(mesh: HalfedgeMesh) {
    this.surface = new Surface(mesh as never);
    this.arrows.setColors(FAINT, STRONG);
    this.arrows.reset(this.surface);
  }

  /** Shows these faces and no others; returns how many bytes the card is sent. */
  show(wishes: ReadonlyMap<number, Wish>): number {
    this.arrows.begin();
    for (const [face, { pixel, strength }] of wishes) this.arrows.show(face, pixel, strength);
    this.arrows.end();
    this.card.bytes = 0;
    for (const geometry of this.arrows.lines.geometries) drawLines(this.card, geometry);
    return this.card.bytes;
  }

  /** Takes up an edit. */
  update(): void {
    const change = this.surface.update();
    this.arrows.forget(change?.faces ?? null);
  }

  get drawn(): string[] {
    return drawnArrows(this.card, this.arrows.lines.geometries);
  }

  /** What is to be drawn, measured anew. */
  expected(wishes: ReadonlyMap<number, Wish>): string[] {
    const tracer = new ArrowTracer();
    const arrows: string[] = [];
    for (const [face, { pixel, strength }] of wishes) {
      const color = FAINT.clone().lerp(STRONG, strength).toArray();
      const corners: number[] = [];
      const degree = this.surface.corners(face, corners);
      const { next, toVertex, faceHalfedge } = this.surface.mesh.connectivity;
      const vertices: number[] = [];
      for (let h = faceHalfedge[face]; vertices.length < degree; h = next[h]) {
        vertices.push(toVertex[h]);
      }
      const across = cornersAcross(vertices, degree, this.surface.triangleVertices(face));
      const out = new Float32Array(degree * ARROW_FLOATS);
      tracer.traceFace(corners, degree, arrowSizes(pixel), out, 0, across);
      for (let i = 0; i < out.length; i += ARROW_FLOATS) {
        arrows.push(describeArrow(out.subarray(i, i + ARROW_FLOATS), color));
      }
    }
    return arrows.sort();
  }
}

/** All faces, or some of them, of one size and colour. */
function wishes(faces: Iterable<number>, pixel = PIXEL, strength = 1): Map<number, Wish> {
  return new Map([...faces].map((face) => [face, { pixel, strength }]));
}

describe('The arrows of faces', () => {
  test.each([1, 2, 3])('are those that are to be shown, frame after frame: seed %i', (seed) => {
    const next = random(seed);
    const mesh = [
      HalfedgeMesh.icoSphere(2),
      HalfedgeMesh.grid(12, 12),
      HalfedgeMesh.dodecahedron(),
    ][seed - 1];
    mesh.history.enabled = true;
    const picture = new Picture(mesh);
    for (let i = 0; i < 60; i++) {
      if (i % 3 === 2) {
        if (next() < 0.3) mesh.history.undo();
        else refusalOf(randomEdit(mesh, next));
        picture.update();
      }
      const share = [0.1, 0.5, 0.95, 1][Math.floor(4 * next())];
      const wanted = new Map<number, Wish>();
      for (const face of mesh.faces()) {
        if (next() >= share) continue;
        // Only what lies on the steps is drawn exactly as it was wished for.
        const pixel = next() < 0.7 ? PIXEL : PIXEL * (1 + Math.floor(64 * next()) / 64);
        const strength = next() < 0.7 ? 1 : Math.floor((SHADES + 1) * next()) / SHADES;
        wanted.set(face, { pixel, strength });
      }
      picture.show(wanted);
      expect({ seed, i, drawn: picture.drawn }).toEqual({
        seed,
        i,
        drawn: picture.expected(wanted),
      });
    }
    mesh.dispose();
  });

  test('are sized to an eighth of a pixel, and coloured to a thirtieth', () => {
    const mesh = HalfedgeMesh.grid(1, 1);
    const picture = new Picture(mesh);
    const next = random(5);
    for (let i = 0; i < 200; i++) {
      const pixel = PIXEL * (1 + next());
      const strength = next();
      picture.show(wishes([0], pixel, strength));
      const numbers = (arrow: string) => arrow.replace('| ', '').split(' ').map(Number);
      const [drawn, expected] = [picture.drawn, picture.expected(wishes([0], pixel, strength))];
      expect(drawn).toHaveLength(4);
      drawn.forEach((arrow, k) => {
        const wanted = numbers(expected[k]);
        const off = numbers(arrow).map((x, at) => Math.abs(x - wanted[at]));
        expect(Math.max(...off.slice(0, ARROW_FLOATS))).toBeLessThan(pixel / 7);
        expect(Math.max(...off.slice(ARROW_FLOATS))).toBeLessThan(1 / 60);
      });
    }
    mesh.dispose();
  });

  test('stay as they are on the card while little changes', () => {
    const mesh = HalfedgeMesh.grid(40, 40);
    const picture = new Picture(mesh);
    const all = [...mesh.faces()];
    const block = 64 * (ARROW_FLOATS + 3) * 4;
    expect(picture.show(wishes(all))).toBeGreaterThan(4 * all.length * (ARROW_FLOATS + 3) * 4 - 1);
    expect(picture.show(wishes(all))).toBe(0);
    // A camera that moves by less than a step, and a pointer.
    expect(picture.show(wishes(all, 1.005 * PIXEL))).toBe(0);
    const pointed = new Map([...wishes(all), ...wishes([100], PIXEL, 0.5)]);
    expect(picture.show(pointed)).toBe(block);
    // Faces that leave, and others that take their places.
    expect(picture.show(wishes(all))).toBe(block);
    expect(picture.show(wishes(all.filter((f) => f !== 100)))).toBe(block);
    const { instanceCount } = picture.arrows.lines.geometries[0];
    expect(picture.show(wishes(all))).toBe(block);
    expect(picture.arrows.lines.geometries[0].instanceCount).toBe(instanceCount);
    mesh.dispose();
  });

  test('leave no more than half of what is drawn unused', () => {
    const mesh = HalfedgeMesh.grid(40, 40);
    const picture = new Picture(mesh);
    picture.show(wishes(mesh.faces()));
    const few = wishes([5, 700, 1500]);
    picture.show(few);
    expect(picture.arrows.lines.geometries[0].instanceCount).toBe(4 * few.size);
    expect(picture.drawn).toEqual(picture.expected(few));
    picture.show(new Map());
    expect(picture.drawn).toEqual([]);
    mesh.dispose();
  });

  test.each([
    ['a quad', 0.3, [0, 1, 2, 3]],
    ['a quad that is bent the other way', -0.3, [0, 1, 2, 3]],
    ['a polygon of five corners', 0.2, [0, 1, 2, 4, 3]],
  ])('lie on %s that is not flat', (_, height, face) => {
    const positions = [0, 0, 0, 1, 0, height, 1, 1, 0, 0, 1, height, 0.6, 1.4, -height];
    const mesh = HalfedgeMesh.fromPolygons(positions, [face]);
    const picture = new Picture(mesh);
    picture.show(wishes([0]));
    const { surface, arrows } = picture;
    const point = (v: number) => new Vector3().fromArray(surface.points, 3 * v);
    const vertices = surface.triangleVertices(0);
    const triangles = Array.from({ length: vertices.length / 3 }, (_it, t) => {
      const [a, b, c] = [0, 1, 2].map((k) => point(vertices[3 * t + k]));
      return new Triangle(a, b, c);
    });
    for (let i = 0; i < 3 * face.length; i++) {
      const end = new Vector3().fromArray(arrows.lines.positions, 3 * i);
      const distances = triangles.map((it) =>
        it.closestPointToPoint(end, new Vector3()).distanceTo(end),
      );
      expect(Math.min(...distances)).toBeLessThan(0.05 * 6.5 * PIXEL);
    }
    mesh.dispose();
  });

  test('have other colours when they are told to', () => {
    const mesh = HalfedgeMesh.cube();
    const picture = new Picture(mesh);
    const all = wishes(mesh.faces());
    picture.show(all);
    const before = picture.drawn;
    picture.arrows.setColors(STRONG, FAINT);
    picture.show(all);
    expect(picture.drawn).not.toEqual(before);
    expect(picture.drawn).toHaveLength(24);
    picture.arrows.setColors(FAINT, STRONG);
    picture.show(all);
    expect(picture.drawn).toEqual(before);
    mesh.dispose();
  });
});

describe('The arrows of boundary halfedges', () => {
  test('stay as they are on the card while little changes', () => {
    const mesh = HalfedgeMesh.grid(6, 6);
    const card = new Card();
    const arrows = new BoundaryArrows();
    const show = (faces: Iterable<number>, pixel: number) => {
      arrows.begin();
      for (const face of faces) arrows.show(face, pixel);
      arrows.end();
      card.bytes = 0;
      return linesInSight(card, arrows.lines.geometries[0]);
    };
    const beside = [...mesh.faces()].filter((f) => [...mesh.faceFaces(f)].length < 4);
    arrows.reset(new Surface(mesh as never));
    arrows.setColor(STRONG);
    const whole = show(beside, PIXEL);
    expect(whole.length).toBeGreaterThan(2 * 24);
    expect(whole.every((segment) => segment[8] === STRONG.b)).toBe(true);
    // A camera that moves by less than a step.
    expect([show(beside, 1.005 * PIXEL), card.bytes]).toEqual([whole, 0]);
    // Fewer dashes, and as many as before again.
    expect(show(beside, 4 * PIXEL).length).toBeLessThan(whole.length);
    expect(show(beside, PIXEL).sort()).toEqual(whole.sort());
    const alone = show([beside[3]], PIXEL);
    expect(alone.every((segment) => whole.some((one) => String(one) === String(segment)))).toBe(
      true,
    );
    arrows.setColor(FAINT);
    expect(show([beside[3]], PIXEL).map((segment) => segment[8])).toEqual(alone.map(() => FAINT.b));
    mesh.dispose();
  });
});
