import { Vector3 } from 'three';
import type { Item } from '../teaching/items.js';
import type { FaceFrames } from './faces.js';
import type { Glyphs } from './glyphs.js';
import type { Surface } from './surface.js';

/** The point of the scene that stands for an item: where its label goes, what the camera looks at. */
export function anchorOf(
  of: Item,
  surface: Surface,
  frames: FaceFrames,
  glyphs: Glyphs,
  out = new Vector3(),
): Vector3 {
  const { points } = surface;
  const { toVertex } = surface.mesh.connectivity;
  switch (of.kind) {
    case 'vertex':
      return out.fromArray(points, 3 * of.index);
    case 'edge': {
      const [a, b] = [3 * toVertex[2 * of.index], 3 * toVertex[2 * of.index + 1]];
      return out
        .set(points[a] + points[b], points[a + 1] + points[b + 1], points[a + 2] + points[b + 2])
        .multiplyScalar(0.5);
    }
    case 'halfedge': {
      const at = glyphs.halfedge(of.index);
      const { arrows } = glyphs;
      return out
        .set(
          arrows[at] + arrows[at + 3],
          arrows[at + 1] + arrows[at + 4],
          arrows[at + 2] + arrows[at + 5],
        )
        .multiplyScalar(0.5);
    }
    case 'face':
      return out.fromArray(frames.data, frames.at(of.index));
  }
}

/** Where the shaft of a halfedge's arrow begins and ends. */
export function shaftOf(h: number, glyphs: Glyphs): [Vector3, Vector3] {
  const at = glyphs.halfedge(h);
  const { arrows } = glyphs;
  return [new Vector3().fromArray(arrows, at), new Vector3().fromArray(arrows, at + 3)];
}

/** A point on the face side of a halfedge's arrow, from the middle of it. */
export function sideOf(h: number, glyphs: Glyphs): Vector3 {
  const at = glyphs.halfedge(h);
  const [start, end, tip] = [0, 3, 6].map((k) => new Vector3().fromArray(glyphs.arrows, at + k));
  const along = end.clone().sub(start).normalize();
  const barb = tip.sub(end);
  barb.addScaledVector(along, -barb.dot(along));
  return start.add(end).multiplyScalar(0.5).add(barb);
}

/** The radius of what is around an item: how close to come to see it well. */
export function reachOf(of: Item, surface: Surface): number {
  const { mesh, points } = surface;
  const { toVertex, next } = mesh.connectivity;
  const lengthOf = (h: number) => {
    const [a, b] = [3 * toVertex[h], 3 * toVertex[h ^ 1]];
    return Math.hypot(
      points[a] - points[b],
      points[a + 1] - points[b + 1],
      points[a + 2] - points[b + 2],
    );
  };
  let longest = 0;
  const measure = (halfedges: Iterable<number>) => {
    for (const h of halfedges) longest = Math.max(longest, lengthOf(h));
  };
  if (of.kind === 'vertex') measure(mesh.vertexOutgoingHalfedges(of.index));
  else if (of.kind === 'face') measure(mesh.faceHalfedges(of.index));
  else {
    const h = of.kind === 'edge' ? 2 * of.index : of.index;
    measure([h, next[h], next[h ^ 1]]);
  }
  return Math.max(longest, 1e-4);
}

/** The faces that an item touches. */
export function facesAt({ mesh }: Surface, { kind, index }: Item): number[] {
  switch (kind) {
    case 'vertex':
      return [...mesh.vertexFaces(index)];
    case 'edge':
      return [...mesh.edgeFaces(index)];
    case 'halfedge':
      return [...mesh.edgeFaces(mesh.edge(index))];
    case 'face':
      return [index];
  }
}
