import { HalfedgeMesh, NONE } from '../api.js';
import type { Item } from '../teaching/items.js';
import type { Refusal } from '../teaching/operation.js';
import { type Done, EditStory } from './edit-story.js';

/** A list of faces: where their corners are, and which they have. */
export interface FaceList {
  readonly positions: Float32Array;
  readonly faces: readonly (readonly number[])[];
}

/** The faces of a list become a mesh, one by one. */
export class BuildStory extends EditStory {
  readonly count: number;
  readonly #mesh: HalfedgeMesh;
  readonly #faces: FaceList['faces'];

  /** The mesh has the vertices of the list, and no faces: see `verticesOnly`. */
  constructor(mesh: HalfedgeMesh, { faces }: FaceList) {
    super(mesh);
    this.#mesh = mesh;
    this.#faces = faces;
    this.count = faces.length;
  }

  protected override title(step: number): string {
    return `face ${step} of the corners ${this.#faces[step]?.join(', ')}`;
  }

  protected override item(): Item | null {
    return null;
  }

  protected override attempt(step: number): Done | Refusal {
    const mesh = this.#mesh;
    const corners = this.#faces[step];
    const refusal = mesh.checkAddFace(corners);
    if (refusal) return refusal;
    const found = corners.map((v, i) => {
      const to = corners[(i + 1) % corners.length];
      return { side: `v${v} → v${to}`, halfedge: mesh.findHalfedge(v, to) };
    });
    const index = mesh.addFace(corners);
    return {
      edit: { slides: new Map(), grows: new Map(), renumbers: false },
      after: { kind: 'face', index },
      words: sentence(index, corners, found),
    };
  }
}

/** `f1 = addFace(1, 4, 2): v1 → v4 and v4 → v2 are new edges; v2 → v1 is h3, the free side of e1.` */
function sentence(
  face: number,
  corners: readonly number[],
  found: readonly { readonly side: string; readonly halfedge: number }[],
): string {
  const isNew = ({ halfedge }: { halfedge: number }) => halfedge === NONE;
  const fresh = found.filter(isNew).map(({ side }) => side);
  const known = found
    .filter((it) => !isNew(it))
    .map(({ side, halfedge }) => `${side} is h${halfedge}, the free side of e${halfedge >> 1}`);
  const parts: string[] = [];
  if (fresh.length === corners.length) parts.push('all its edges are new');
  else if (fresh.length > 0)
    parts.push(`${list(fresh)} ${fresh.length > 1 ? 'are new edges' : 'is a new edge'}`);
  if (known.length > 0) parts.push(list(known));
  return `f${face} = addFace(${corners.join(', ')}): ${parts.join('; ')}.`;
}

function list(words: readonly string[]): string {
  if (words.length < 2) return words.join('');
  return `${words.slice(0, -1).join(', ')} and ${words.at(-1)}`;
}

/** The faces of a mesh as a list. */
export function faceListOf(mesh: HalfedgeMesh): FaceList {
  const faces = [...mesh.faces()].map((f) => [...mesh.faceVertices(f)]);
  return { positions: mesh.positions.slice(), faces };
}

/** A mesh of the vertices of a list alone. */
export function verticesOnly({ positions }: FaceList): HalfedgeMesh {
  return HalfedgeMesh.fromPolygons(positions, []);
}
