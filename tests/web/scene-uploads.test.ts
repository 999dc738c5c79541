import { HalfedgeMesh, init } from 'halfedge';
import { ShownTriangles, Surface } from 'halfedge/scene';
import { ARROW_FLOATS, LineBatch } from 'halfedge/three';
import { type BufferAttribute, Color, type InterleavedBufferAttribute, Vector3 } from 'three';
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
function drawnBy(card: Card, { triangles: shown, position }: Surface): string[] {
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

/** The triangles that the card should draw: those of all faces but some, where the vertices are now. */
function trianglesOf(surface: Surface, hidden: ReadonlySet<number>): string[] {
  const { mesh, points, placement } = surface;
  const far = [...mesh.vertices()].filter((v) => {
    const wanted = new Vector3(...mesh.position(v)).applyMatrix4(placement);
    return !(new Vector3().fromArray(points, 3 * v).distanceTo(wanted) < 1e-5);
  });
  expect(far).toEqual([]);
  const { vertices, faces } = new ShownTriangles(mesh).inOrder(mesh);
  const drawn: string[] = [];
  faces.forEach((face, t) => {
    if (hidden.has(face)) return;
    drawn.push([0, 1, 2].map((k) => xyz(points, vertices[3 * t + k])).join(' | '));
  });
  return drawn.sort();
}

describe('The triangles of a scene', () => {
  test.each([1, 2, 3])('are those of the surface, edit after edit: seed %i', (seed) => {
    const next = random(seed);
    const mesh = seed === 3 ? HalfedgeMesh.dodecahedron() : HalfedgeMesh.icoSphere(2);
    mesh.history.enabled = true;
    const card = new Card();
    const surface = new Surface(mesh);
    const show = (hidden: ReadonlySet<number>, what: string) => {
      surface.triangles.hide(hidden);
      card.upload(surface.triangles.index);
      card.upload(surface.position);
      expect([what, drawnBy(card, surface)]).toEqual([what, trianglesOf(surface, hidden)]);
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
      const change = surface.update();
      // As while an edit is in motion: first without what has changed, then with it.
      show(change?.faces ?? new Set(), `seed ${seed}, step ${i}: ${done}, in motion`);
      show(new Set(), `seed ${seed}, step ${i}: ${done}`);
    }
    mesh.dispose();
  });

  test('upload kilobytes after an edit of many faces', () => {
    const mesh = HalfedgeMesh.grid(300, 300, { triangles: true });
    const card = new Card();
    const surface = new Surface(mesh);
    const show = () => {
      card.bytes = 0;
      card.upload(surface.triangles.index);
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
      surface.update();
      const bytes = show();
      expect([bytes > 0, bytes < 4096]).toEqual([true, true]);
    }
    mesh.dispose();
  });
});

describe('A batch of lines', () => {
  const color = new Color(0.25, 0.5, 0.75);
  const drawn = (batch: LineBatch, changed: number, arrows = 1000) => {
    batch.clear();
    for (let i = 0; i < arrows; i++) {
      const arrow = Float32Array.from({ length: ARROW_FLOATS }, (_, k) => 10 * i + k);
      if (i === changed) arrow[3] += 0.5;
      batch.addArrows(arrow, 1, color);
    }
    batch.upload();
  };
  const buffers = ({ geometry: { attributes } }: LineBatch) =>
    ['instanceStart', 'instanceColorStart'].map((name) => {
      const { data } = attributes[name] as InterleavedBufferAttribute;
      return { stride: data.stride, data: data as unknown as BufferAttribute };
    });

  test('uploads nothing that the card has already, and some lines around one that is new', () => {
    const [batch, card] = [new LineBatch(), new Card()];
    const bytes = (changed: number, arrows?: number) => {
      drawn(batch, changed, arrows);
      card.bytes = 0;
      for (const { data, stride } of buffers(batch)) {
        card.upload(data);
        const known = Array.from(card.read(data)).slice(0, stride * batch.count);
        expect(known).toEqual(Array.from(data.array).slice(0, stride * batch.count));
      }
      return card.bytes;
    };
    expect(bytes(-1)).toBeGreaterThan(2000 * 9 * 4 - 1);
    expect(bytes(-1)).toBe(0);
    expect(bytes(500)).toBe(64 * 9 * 4);
    expect(bytes(501)).toBe(64 * 9 * 4);
    expect(bytes(-1, 0)).toBe(0);
    // After fewer lines, those beyond are known still.
    expect(bytes(-1, 20)).toBe(0);
    expect(bytes(-1)).toBe(64 * 9 * 4);
    batch.geometry.dispose();
  });
});
