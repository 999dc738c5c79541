import { HalfedgeMesh, init } from 'halfedge';
import { ShownTriangles, Surface } from 'halfedge/scene';
import type { BufferAttribute } from 'three';
import { random } from './support/random.js';
import { randomEdit, refusalOf } from './support/random-edits.js';

beforeAll(() => init());

/** What a graphics card holds of an attribute, which is sent ranges of it. */
class Card {
  readonly #copies = new Map<BufferAttribute, { array: ArrayLike<number>; version: number }>();
  bytes = 0;

  upload(attribute: BufferAttribute): void {
    const { array, version, updateRanges } = attribute;
    const known = this.#copies.get(attribute);
    if (known?.version === version) return;
    const copy = known && updateRanges.length > 0 ? (known.array as Float32Array) : array.slice();
    if (copy === known?.array) {
      for (const { start, count } of updateRanges) {
        copy.set(array.subarray(start, start + count), start);
        this.bytes += 4 * count;
      }
    } else {
      this.bytes += array.byteLength;
    }
    attribute.clearUpdateRanges();
    this.#copies.set(attribute, { array: copy, version });
  }

  read(attribute: BufferAttribute): ArrayLike<number> {
    return this.#copies.get(attribute)?.array ?? [];
  }
}

/** The triangles that the card draws, as coordinates, in some order; those without a place are left out. */
function drawnBy(card: Card, shown: ShownTriangles, { position }: Surface): string[] {
  const [index, points] = [card.read(shown.index), card.read(position)];
  const triangles: string[] = [];
  for (let t = 0; t < 3 * shown.count; t += 3) {
    if (index[t] === index[t + 1] && index[t] === index[t + 2]) continue;
    triangles.push([0, 1, 2].map((k) => xyz(points, index[t + k])).join(' | '));
  }
  return triangles.sort();
}

function xyz(points: ArrayLike<number>, v: number): string {
  return [points[3 * v], points[3 * v + 1], points[3 * v + 2]].join(' ');
}

/** The triangles that the card should draw. */
function trianglesOf(surface: Surface, hidden: ReadonlySet<number>): string[] {
  const { triangles, faceOf, points } = surface;
  const drawn: string[] = [];
  faceOf.forEach((face, t) => {
    if (hidden.has(face)) return;
    drawn.push([0, 1, 2].map((k) => xyz(points, triangles[3 * t + k])).join(' | '));
  });
  return drawn.sort();
}

describe('The triangles of a scene', () => {
  test.each([1, 2, 3])('are those of the surface, edit after edit: seed %i', (seed) => {
    const next = random(seed);
    const mesh = seed === 3 ? HalfedgeMesh.dodecahedron() : HalfedgeMesh.icoSphere(2);
    mesh.history.enabled = true;
    const [shown, card] = [new ShownTriangles(), new Card()];
    let surface = new Surface(mesh);
    const show = (hidden: ReadonlySet<number>, what: string) => {
      shown.show(surface, hidden);
      card.upload(shown.index);
      card.upload(surface.position);
      expect([what, drawnBy(card, shown, surface)]).toEqual([what, trianglesOf(surface, hidden)]);
    };
    show(new Set(), 'at first');
    for (let i = 0; i < 50; i++) {
      const way = next();
      let done = 'undo';
      if (way < 0.2) mesh.history.undo();
      else if (way < 0.3 && mesh.vertexCount > 0) {
        const [v] = mesh.vertices();
        mesh.positions[3 * v] += 0.1;
        done = `moved ${v}`;
      } else {
        const edit = randomEdit(mesh, next);
        refusalOf(edit);
        done = edit.name;
      }
      surface = new Surface(mesh, surface);
      // As while an edit is in motion: first without what has changed, then with it.
      show(surface.change?.faces ?? new Set(), `seed ${seed}, step ${i}: ${done}, in motion`);
      show(new Set(), `seed ${seed}, step ${i}: ${done}`);
    }
    mesh.dispose();
  });

  test('upload kilobytes after an edit of many faces', () => {
    const mesh = HalfedgeMesh.grid(300, 300, { triangles: true });
    const [shown, card] = [new ShownTriangles(), new Card()];
    let surface = new Surface(mesh);
    const show = () => {
      card.bytes = 0;
      shown.show(surface, new Set());
      card.upload(shown.index);
      card.upload(surface.position);
      return card.bytes;
    };
    expect(show()).toBeGreaterThan(3e6);
    for (const edit of [
      () => mesh.flipEdge(mesh.edge(mesh.faceHalfedge(50_000))),
      () => mesh.splitEdge(mesh.edge(mesh.faceHalfedge(60_000))),
      () => mesh.collapse(mesh.faceHalfedge(70_000)),
      () => mesh.setPosition(1000, [0, 0, 0.1]),
    ]) {
      edit();
      surface = new Surface(mesh, surface);
      const bytes = show();
      expect([bytes > 0, bytes < 4096]).toEqual([true, true]);
    }
    mesh.dispose();
  });
});
