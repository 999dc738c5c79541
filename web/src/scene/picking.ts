import { Raycaster, Vector2, Vector3 } from 'three';
import type { Item } from '../teaching/items.js';
import { ARROW_FLOATS } from '../three/index.js';
import { ARROWS_FROM_PX } from './arrow-layer.js';
import type { FaceFrames } from './faces.js';
import type { Glyphs } from './glyphs.js';
import type { RayHit } from './ray-tree.js';
import type { Stage } from './stage.js';
import type { Surface } from './surface.js';

/** What the pointer picks: whatever is nearest, or only items of one kind. */
export type PickMode = 'auto' | 'vertex' | 'edge' | 'halfedge' | 'face';

/** The corner, edge or arrow of a face that is nearest to the pointer, in CSS pixels. */
interface Nearest {
  vertex: number;
  vertexDistance: number;
  halfedge: number;
  edgeDistance: number;
  edgeLength: number;
  arrowDistance: number;
}

/** Finds the item under the pointer: the face by a ray, then the nearest of its features. */
export class Picker {
  readonly #stage: Stage;
  readonly #surface: Surface;
  readonly #frames: FaceFrames;
  readonly #glyphs: Glyphs;
  readonly #raycaster = new Raycaster();
  readonly #ndc = new Vector2();
  readonly #point = new Vector3();

  constructor(stage: Stage, surface: Surface, frames: FaceFrames, glyphs: Glyphs) {
    this.#stage = stage;
    this.#surface = surface;
    this.#frames = frames;
    this.#glyphs = glyphs;
  }

  /**
   * The item at (x, y) in CSS pixels of the canvas, or null. `boundary` are the boundary
   * halfedges whose arrows are in the picture; `reach` is 1 for a mouse and larger for a finger.
   */
  pick(x: number, y: number, mode: PickMode, boundary: readonly number[], reach = 1): Item | null {
    const hit = this.#hit(x, y);
    if (mode === 'auto' || mode === 'halfedge') {
      const outside = this.#boundaryArrow(x, y, boundary, hit, 6 * reach);
      if (outside !== null) return { kind: 'halfedge', index: outside };
    }
    if (!hit) return this.#beside(x, y, mode, reach);
    if (mode === 'face') return { kind: 'face', index: hit.face };
    const nearest = this.#nearest(hit.face, x, y);
    switch (mode) {
      case 'vertex':
        return { kind: 'vertex', index: nearest.vertex };
      case 'edge':
        return { kind: 'edge', index: nearest.halfedge >> 1 };
      case 'halfedge':
        return { kind: 'halfedge', index: nearest.halfedge };
      case 'auto':
        return this.#closest(hit.face, nearest, reach);
    }
  }

  /** The face in the middle of the picture. */
  faceAt(x: number, y: number): number | null {
    return this.#hit(x, y)?.face ?? null;
  }

  /** Whether the surface hides a point of the scene from the camera. */
  hides(point: Vector3): boolean {
    const { position } = this.#stage.camera;
    const { ray } = this.#raycaster;
    ray.origin.copy(position);
    ray.direction.copy(point).sub(position);
    const distance = ray.direction.length();
    ray.direction.divideScalar(distance);
    const hit = this.#cast();
    return hit !== null && hit.distance < 0.992 * distance;
  }

  #closest(face: number, nearest: Nearest, reach: number): Item {
    const { vertexDistance, edgeDistance, arrowDistance, edgeLength } = nearest;
    // On short edges the features share the room that there is.
    if (vertexDistance <= Math.min(11 * reach, 0.28 * edgeLength)) {
      return { kind: 'vertex', index: nearest.vertex };
    }
    const arrows = this.#showsArrows(face);
    if (edgeDistance <= Math.min((arrows ? 3 : 4) * reach, 0.12 * edgeLength)) {
      return { kind: 'edge', index: nearest.halfedge >> 1 };
    }
    if (arrows && arrowDistance <= 5.5 * reach) {
      return { kind: 'halfedge', index: nearest.halfedge };
    }
    return { kind: 'face', index: face };
  }

  /** Just beside the outline of the surface: its vertices and edges can still be meant. */
  #beside(x: number, y: number, mode: PickMode, reach: number): Item | null {
    if (mode === 'face') return null;
    const radius = 8 * reach;
    let found: Item | null = null;
    let least = radius;
    for (let i = 0; i < 8; i++) {
      const angle = (Math.PI * i) / 4;
      const hit = this.#hit(x + radius * Math.cos(angle), y + radius * Math.sin(angle));
      if (!hit) continue;
      const nearest = this.#nearest(hit.face, x, y);
      if (mode !== 'edge' && mode !== 'halfedge' && nearest.vertexDistance < least) {
        least = nearest.vertexDistance;
        found = { kind: 'vertex', index: nearest.vertex };
      } else if (mode !== 'vertex' && nearest.edgeDistance + 3 < least) {
        least = nearest.edgeDistance + 3;
        found =
          mode === 'halfedge'
            ? { kind: 'halfedge', index: this.#outer(nearest.halfedge) }
            : { kind: 'edge', index: nearest.halfedge >> 1 };
      }
    }
    return found;
  }

  /** Of an edge on the boundary, the halfedge on the outside. */
  #outer(h: number): number {
    return this.#surface.mesh.connectivity.face[h ^ 1] < 0 ? h ^ 1 : h;
  }

  #boundaryArrow(
    x: number,
    y: number,
    boundary: readonly number[],
    hit: RayHit | null,
    reach: number,
  ): number | null {
    let found: number | null = null;
    let least = reach;
    for (const h of boundary) {
      this.#glyphs.boundary(h);
      const distance = this.#distanceToShaft(this.#glyphs.arrows, 0, x, y);
      if (distance >= least) continue;
      const [ax, ay, az] = this.#glyphs.arrows;
      const depth = this.#stage.camera.position.distanceTo(this.#point.set(ax, ay, az));
      if (hit && hit.distance < 0.99 * depth) continue;
      least = distance;
      found = h;
    }
    return found;
  }

  #nearest(face: number, x: number, y: number): Nearest {
    const { next, toVertex, faceHalfedge } = this.#surface.mesh.connectivity;
    const nearest: Nearest = {
      vertex: -1,
      vertexDistance: Infinity,
      halfedge: -1,
      edgeDistance: Infinity,
      edgeLength: 0,
      arrowDistance: Infinity,
    };
    this.#glyphs.face(face);
    const first = next[faceHalfedge[face]];
    let h = first;
    let place = 0;
    let from = this.#screen(toVertex[h ^ 1], [0, 0]);
    do {
      const to = this.#screen(toVertex[h], [0, 0]);
      const atVertex = Math.hypot(to[0] - x, to[1] - y);
      if (atVertex < nearest.vertexDistance) {
        nearest.vertexDistance = atVertex;
        nearest.vertex = toVertex[h];
      }
      const atEdge = distanceToSegment(x, y, from, to);
      if (atEdge < nearest.edgeDistance) {
        nearest.edgeDistance = atEdge;
        nearest.halfedge = h;
        nearest.edgeLength = Math.hypot(to[0] - from[0], to[1] - from[1]);
        nearest.arrowDistance = this.#distanceToShaft(this.#glyphs.arrows, place, x, y);
      }
      from = to;
      place += ARROW_FLOATS;
      h = next[h];
    } while (h !== first);
    return nearest;
  }

  #showsArrows(face: number): boolean {
    const at = this.#frames.at(face);
    const { data } = this.#frames;
    const depth = this.#stage.depthOf(data[at], data[at + 1], data[at + 2]);
    return data[at + 6] / this.#stage.pixelAt(depth) >= ARROWS_FROM_PX;
  }

  #screen(vertex: number, out: [number, number]): [number, number] {
    const { points } = this.#surface;
    return this.#toScreen(points[3 * vertex], points[3 * vertex + 1], points[3 * vertex + 2], out);
  }

  #toScreen(x: number, y: number, z: number, out: [number, number]): [number, number] {
    this.#stage.project(this.#point.set(x, y, z), this.#point);
    out[0] = this.#point.x;
    out[1] = this.#point.y;
    return out;
  }

  #distanceToShaft(arrows: Float32Array, at: number, x: number, y: number): number {
    const a = this.#toScreen(arrows[at], arrows[at + 1], arrows[at + 2], [0, 0]);
    const b = this.#toScreen(arrows[at + 3], arrows[at + 4], arrows[at + 5], [0, 0]);
    return distanceToSegment(x, y, a, b);
  }

  #hit(x: number, y: number): RayHit | null {
    const { size, camera } = this.#stage;
    this.#raycaster.setFromCamera(
      this.#ndc.set((2 * x) / size.x - 1, 1 - (2 * y) / size.y),
      camera,
    );
    return this.#cast();
  }

  #cast(): RayHit | null {
    return this.#surface.tree.cast(this.#raycaster.ray);
  }
}

type Point = readonly [number, number];

function distanceToSegment(x: number, y: number, a: Point, b: Point): number {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const length = dx * dx + dy * dy;
  const t = length > 0 ? ((x - a[0]) * dx + (y - a[1]) * dy) / length : 0;
  const clamped = Math.min(1, Math.max(0, t));
  return Math.hypot(a[0] + clamped * dx - x, a[1] + clamped * dy - y);
}
