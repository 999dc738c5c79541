import { HalfedgeMesh, init } from 'halfedge';
import { ARROW_FLOATS, arrowSizes } from 'halfedge/three';
import { Color } from 'three';
import { FaceArrows } from '../../dist/scene/face-arrows.js';
import { FaceRows } from '../../dist/scene/face-rows.js';
import { Surface } from '../../dist/scene/surface.js';
import { Card } from './support/card.js';
import { describeArrow, drawnArrows } from './support/drawn-arrows.js';
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
  readonly #rows: FaceRows;

  constructor(mesh: HalfedgeMesh) {
    this.surface = new Surface(mesh as never);
    this.#rows = new FaceRows(this.surface);
    this.arrows.setColors(FAINT, STRONG);
    this.arrows.reset(this.#rows, mesh.faceSlots);
  }

  /** Shows these faces and no others; returns how many bytes the card is sent. */
  show(wishes: ReadonlyMap<number, Wish>): number {
    this.arrows.begin();
    for (const [face, { pixel, strength }] of wishes) this.arrows.show(face, pixel, strength);
    this.arrows.end();
    this.card.bytes = 0;
    drawLines(this.card, this.arrows.lines.geometry);
    return this.card.bytes;
  }

  /** Takes up an edit. */
  update(): void {
    const change = this.surface.update();
    const faces = change?.faces ?? null;
    this.#rows.forget(faces);
    this.arrows.forget(faces, this.surface.mesh.faceSlots);
  }

  get drawn(): string[] {
    return drawnArrows(this.card, this.arrows.lines.geometry);
  }

  /** What is to be drawn, measured anew. */
  expected(wishes: ReadonlyMap<number, Wish>): string[] {
    const rows = new FaceRows(this.surface);
    const arrows: string[] = [];
    for (const [face, { pixel, strength }] of wishes) {
      const color = FAINT.clone().lerp(STRONG, strength).toArray();
      const at = rows.at(face);
      const out = new Float32Array(rows.rows.degree(at) * ARROW_FLOATS);
      rows.rows.place(at, arrowSizes(pixel), out, 0);
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
    const block = 64 * 9 * 4;
    expect(picture.show(wishes(all))).toBeGreaterThan(4 * 2 * all.length * 9 * 4 - 1);
    expect(picture.show(wishes(all))).toBe(0);
    // A camera that moves by less than a step, and a pointer.
    expect(picture.show(wishes(all, 1.005 * PIXEL))).toBe(0);
    const pointed = new Map([...wishes(all), ...wishes([100], PIXEL, 0.5)]);
    expect(picture.show(pointed)).toBe(block);
    // Faces that leave, and others that take their places.
    expect(picture.show(wishes(all))).toBe(block);
    expect(picture.show(wishes(all.filter((f) => f !== 100)))).toBe(block);
    const { instanceCount } = picture.arrows.lines.geometry;
    expect(picture.show(wishes(all))).toBe(block);
    expect(picture.arrows.lines.geometry.instanceCount).toBe(instanceCount);
    mesh.dispose();
  });

  test('leave no more than half of what is drawn unused', () => {
    const mesh = HalfedgeMesh.grid(40, 40);
    const picture = new Picture(mesh);
    picture.show(wishes(mesh.faces()));
    const few = wishes([5, 700, 1500]);
    picture.show(few);
    expect(picture.arrows.lines.geometry.instanceCount).toBe(2 * 4 * few.size);
    expect(picture.drawn).toEqual(picture.expected(few));
    picture.show(new Map());
    expect(picture.drawn).toEqual([]);
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
