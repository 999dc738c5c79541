import { HalfedgeMesh, init } from 'halfedge';
import { ShownTriangles, Surface } from 'halfedge/scene';
import { ARROW_FLOATS, LineBatch } from 'halfedge/three';
import { Color, Vector3 } from 'three';
import { Card } from './support/card.js';
import { drawLines } from './support/lines-on-card.js';
import { random } from './support/random.js';
import { randomEdit, refusalOf } from './support/random-edits.js';

beforeAll(() => init());

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
  const color = new Color(0.1, 0.2, 0.3);
  const drawn = (batch: LineBatch, changed: number, arrows = 1000) => {
    batch.clear();
    for (let i = 0; i < arrows; i++) {
      const arrow = Float32Array.from({ length: ARROW_FLOATS }, (_, k) => 10 * i + k);
      if (i === changed) arrow[3] += 0.5;
      for (const at of [0, 3]) batch.add(arrow, at, at + 3, color);
    }
    batch.upload();
  };

  test('uploads nothing that the card has already, and some lines around one that is new', () => {
    const [batch, card] = [new LineBatch(), new Card()];
    const bytes = (changed: number, arrows?: number) => {
      drawn(batch, changed, arrows);
      card.bytes = 0;
      drawLines(card, batch.geometry);
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

  test('uploads a line of which one number has changed', () => {
    const [batch, card] = [new LineBatch(), new Card()];
    const numbers = [0, 1, 2, 3, 4, 5, 0.25, 0.5, 0.75];
    for (let k = -1; k < numbers.length; k++) {
      if (k >= 0) numbers[k] += 0.125;
      batch.clear();
      batch.add(numbers, 0, 3, new Color().fromArray(numbers, 6));
      batch.upload();
      expect(drawLines(card, batch.geometry)).toEqual([numbers]);
    }
    batch.geometry.dispose();
  });

  test('is on the card also after a thousand changes that it did not see', () => {
    const [batch, card] = [new LineBatch(), new Card()];
    const lines = Array.from({ length: 200 }, (_, i) => [i, 1, 2, 3, 4, 5, 0, 0, 0]);
    const upload = () => {
      batch.clear();
      for (const line of lines) batch.add(line, 0, 3, new Color(0, 0, 0));
      batch.upload();
    };
    upload();
    drawLines(card, batch.geometry);
    lines[0][1] = 7;
    for (let change = 0; change < 2500; change++) {
      lines[150][1] = change;
      upload();
    }
    expect(drawLines(card, batch.geometry)).toEqual(lines);
    batch.geometry.dispose();
  });

  test.each([1, 2, 3])('is on the card, however seldom that takes it up: seed %i', (seed) => {
    const next = random(seed);
    const [batch, card] = [new LineBatch(), new Card()];
    const sixty = () => Math.floor(60 * next());
    const lines: number[][] = [];
    const newLine = () => Array.from({ length: 9 }, () => Math.fround(next()));
    const add = (line: number[]) => batch.add(line, 0, 3, new Color().fromArray(line, 6));
    const expectDrawn = () => {
      const drawn = drawLines(card, batch.geometry);
      const wrong = lines.filter((line, i) => line.some((x, k) => x !== drawn[i]?.[k]));
      expect([drawn.length, wrong.length]).toEqual([lines.length, 0]);
    };
    for (let frame = 0; frame < 1500; frame++) {
      // Now and then many more or fewer; mostly one that is new among those of before.
      const way = next();
      if (way < 0.01) lines.push(...Array.from({ length: 5 * sixty() }, newLine));
      else if (way < 0.02) lines.length = Math.min(lines.length, sixty());
      if (lines.length > 700) lines.length = 100;
      for (let some = sixty() / 20; some > 0; some--) {
        lines[Math.floor(next() * (lines.length + 1))] = newLine();
      }
      batch.clear();
      for (const line of lines) add(line);
      batch.upload();
      // In the second half it is hidden for long: ranges come together.
      if (next() < (frame < 1000 ? 0.2 : 0.002)) {
        expectDrawn();
      }
    }
    expectDrawn();
    batch.geometry.dispose();
  });
});
