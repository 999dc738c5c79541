import type { Input } from './meshes.js';

/** What surrounds a vertex, clockwise from its anchor, as vertex and face on each outgoing halfedge. */
export interface Spoke {
  /** The vertex that the outgoing halfedge points to. */
  to: number;
  /** The face on its left, or -1. */
  face: number;
}

/**
 * Adjacency by searching the list of faces, without halfedges: slow, obvious, and written only from
 * the rules of the order, to compare the library with.
 */
export class Reference {
  readonly faces: number[][];
  readonly vertexCount: number;
  readonly #faceOf = new Map<string, number>();
  /** By vertex: the vertices it shares an edge with. */
  readonly #neighbours: Set<number>[];

  constructor({ positions, faces }: Input) {
    this.faces = faces;
    this.vertexCount = positions.length / 3;
    this.#neighbours = Array.from({ length: this.vertexCount }, () => new Set());
    faces.forEach((face, f) => {
      face.forEach((from, i) => {
        const to = face[(i + 1) % face.length];
        this.#faceOf.set(`${from}>${to}`, f);
        this.#neighbours[from].add(to);
        this.#neighbours[to].add(from);
      });
    });
  }

  /** The face on the left of the directed edge a>b, or -1. */
  faceOf(a: number, b: number): number {
    return this.#faceOf.get(`${a}>${b}`) ?? -1;
  }

  edgeCount(): number {
    return this.#neighbours.reduce((sum, neighbours) => sum + neighbours.size, 0) / 2;
  }

  spokesCw(v: number): Spoke[] {
    const neighbours = [...this.#neighbours[v]];
    const starts = neighbours.filter((to) => this.faceOf(v, to) < 0).sort((a, b) => a - b);
    if (starts.length > 0) return starts.flatMap((to) => this.#fanCw(v, to));
    if (neighbours.length === 0) return [];
    const highest = Math.max(...neighbours.map((to) => this.faceOf(v, to)));
    return this.#fanCw(v, neighbours.find((to) => this.faceOf(v, to) === highest) as number);
  }

  /** Clockwise from v>to until the fan ends at the boundary, or is round. */
  #fanCw(v: number, first: number): Spoke[] {
    const spokes: Spoke[] = [];
    let to = first;
    do {
      spokes.push({ to, face: this.faceOf(v, to) });
      const face = this.faces[this.faceOf(to, v)];
      if (face === undefined) break;
      to = face[(face.indexOf(v) + 1) % face.length];
    } while (to !== first);
    return spokes;
  }

  /** The directed edges of a face, counter-clockwise, beginning with the one to its first vertex. */
  sidesCcw(f: number): [from: number, to: number][] {
    const face = this.faces[f];
    return face.map((to, i) => [face[(i + face.length - 1) % face.length], to]);
  }
}
