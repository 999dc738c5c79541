import type { BufferAttribute } from 'three';
import { RowBuffer, roomFor } from '../three/rows.js';
import { TriangleSlots } from '../three/slots.js';
import type { Surface } from './surface.js';

/** The triangles of a surface as an index in which each face keeps its place: edits upload what they change. */
export class ShownTriangles {
  #slots = new TriangleSlots(0);
  readonly #rows = new RowBuffer(new Uint32Array(0), 3, false, 1);
  #surface: Surface | null = null;
  #hidden: ReadonlySet<number> = new Set();

  /** Another one, when there was not room enough. */
  get index(): BufferAttribute {
    return this.#rows.attribute;
  }

  /** How many triangles are to be drawn; some of them show nothing. */
  get count(): number {
    return this.#slots.end;
  }

  /** Shows a surface, but for some of its faces. */
  show(surface: Surface, hidden: ReadonlySet<number>): void {
    const stale = new Set([...this.#hidden, ...hidden]);
    if (surface !== this.#surface) {
      // Surfaces that come one from the other have one tree.
      const isNext = surface.tree === this.#surface?.tree;
      if (isNext && surface.change) for (const face of surface.change.faces) stale.add(face);
      else this.#fill(surface);
    }
    this.#surface = surface;
    this.#hidden = hidden;
    this.#place(surface, stale);
    this.#rows.mark();
  }

  #fill({ triangles, faceOf, mesh }: Surface): void {
    this.#slots = new TriangleSlots(roomFor(faceOf.length));
    this.#slots.assign(faceOf, mesh.faceSlots);
    this.#rows.reserve(this.#slots.capacity);
    this.#rows.array.set(triangles);
    this.#rows.forget();
    this.index.needsUpdate = true;
  }

  /** Gives faces the triangles that they have now; none if they are hidden. */
  #place(surface: Surface, faces: ReadonlySet<number>): void {
    const slots = this.#slots;
    const shown: { face: number; vertices: Uint32Array }[] = [];
    for (const face of faces) {
      const vertices = this.#hidden.has(face) ? NONE : surface.triangleVertices(face);
      if (vertices.length > 0) shown.push({ face, vertices });
      const count = slots.count(face);
      if (3 * count === vertices.length) continue;
      // All that is freed comes first, so that what is new can take it.
      const first = slots.first(face);
      for (let t = first; t < first + count; t++) this.#rows.write(t, NOTHING, 0);
      slots.release(face);
    }
    slots.resize(Math.max(slots.faces, surface.mesh.faceSlots));
    for (const { face, vertices } of shown) {
      if (slots.count(face) === 0) slots.take(face, vertices.length / 3);
    }
    this.#rows.reserve(slots.capacity);
    for (const { face, vertices } of shown) {
      const first = slots.first(face);
      for (let i = 0; i < vertices.length; i += 3) this.#rows.write(first + i / 3, vertices, i);
    }
  }
}

const NONE = new Uint32Array(0);
const NOTHING = [0, 0, 0];
