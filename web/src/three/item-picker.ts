import { type Camera, type Matrix4, type Ray, Vector3 } from 'three';
import { isIndex, refuseIndex } from '../arguments.js';
import { checkIterable, indexOfChoice, refuse } from '../checks.js';
import type { ItemKind } from '../items.js';
import { checkObject, checkOptions, type OptionNames } from '../options.js';
import { ARROWS_FROM, arrowSizes } from './arrows.js';
import type { FaceTree } from './face-tree.js';
import { type DrawnMesh, HalfedgeGlyphs } from './glyphs.js';
import { distanceToArrow, type Nearest, nearestOf } from './nearest.js';
import {
  fromNear,
  isClearlyBefore,
  type PickView,
  Projection,
  type ScreenPoint,
  type Sight,
  sightTo,
} from './projection.js';

/** What to pick: whatever is nearest, or only items of one kind. */
export type PickMode = 'auto' | ItemKind;

/** How to pick. */
export interface PickOptions {
  /** Default: 'auto'. */
  mode?: PickMode | undefined;
  /**
   * How far from a vertex, an edge or an arrow the pointer may be: 1 for a mouse, 2 for a finger. Default: 1.
   */
  reach?: number | undefined;
  /** Boundary halfedges whose arrows are drawn, outside the surface. Default: none. */
  boundary?: Iterable<number> | undefined;
}

const PICK_OPTIONS: OptionNames<PickOptions> = { mode: true, reach: true, boundary: true };

/** An item under the pointer. */
export interface PickedItem {
  readonly kind: ItemKind;
  readonly index: number;
}

/** A face that a ray hits, where it hits it, and how far from the ray's origin, in world space. */
export interface FaceHit {
  readonly face: number;
  readonly point: Vector3;
  readonly distance: number;
}

/** A mesh that is drawn somewhere, and the search tree over its faces. */
export interface PickTarget extends DrawnMesh {
  readonly tree: FaceTree;
  /** Transforms its points into world space. */
  readonly matrixWorld: Matrix4;
}

const MODES: readonly PickMode[] = ['auto', 'vertex', 'edge', 'halfedge', 'face'];
/** How near a pointer means something, in CSS pixels, if nothing else is nearer. */
const TO_VERTEX = 11;
const TO_ISOLATED = 10;
const BESIDE = 8;
const TO_BOUNDARY = 6;
const TO_ARROW = 5.5;
/** No more vertices without edges than these can be pointed at: each is looked at. */
const MOST_ISOLATED = 20_000;

/**
 * Finds the vertex, edge, halfedge or face under the pointer: first the face, with a ray, and then the
 * nearest item of that face, in pixels of the canvas. A polygon is picked as one face, not as triangles.
 */
export class ItemPicker {
  readonly #target: PickTarget;
  readonly #glyphs: HalfedgeGlyphs;
  /** The vertices without edges, and the version of the mesh that has them. */
  #isolated: { readonly version: number; readonly vertices: number[] } | null = null;

  constructor(target: PickTarget) {
    this.#target = target;
    this.#glyphs = new HalfedgeGlyphs(target);
  }

  /**
   * The item at a point of the canvas, in CSS pixels from its top left; null if there is none.
   *
   * @throws TypeError or RangeError for wrong arguments, such as an unknown mode
   */
  pick(x: number, y: number, view: PickView, options: PickOptions = {}): PickedItem | null {
    const { mode = 'auto', reach = 1, boundary = [] } = checkOptions(options, PICK_OPTIONS);
    indexOfChoice('options.mode', mode, MODES);
    if (typeof reach !== 'number' || !(reach > 0)) {
      refuse('options.reach', reach, 'a positive number', 'number');
    }
    checkIterable('options.boundary', boundary, 'halfedges to iterate over');
    checkPlace(x, y, view);
    const at: ScreenPoint = [x, y];
    const projection = new Projection(view, this.#target.matrixWorld);
    const isolated =
      mode === 'auto' || mode === 'vertex' ? this.#isolatedAt(at, view, projection, reach) : -1;
    if (isolated >= 0) return { kind: 'vertex', index: isolated };
    const hit = this.#hit(projection.sight(x, y));
    if (mode === 'auto' || mode === 'halfedge') {
      const outside = this.#boundaryAt(at, boundary, view, projection, reach, hit);
      if (outside >= 0) return { kind: 'halfedge', index: outside };
    }
    if (hit === null) return this.#beside(at, projection, mode, reach);
    if (mode === 'face') return { kind: 'face', index: hit.face };
    const nearest = this.#nearest(hit.face, at, projection);
    if (mode === 'vertex') return { kind: 'vertex', index: nearest.vertex };
    if (mode === 'edge') return { kind: 'edge', index: nearest.halfedge >> 1 };
    if (mode === 'halfedge') return { kind: 'halfedge', index: nearest.halfedge };
    return closest(hit.face, nearest, reach);
  }

  /** The face that is visible at a point of the canvas. */
  faceAt(x: number, y: number, view: PickView): FaceHit | null {
    checkPlace(x, y, view);
    return this.#hit(new Projection(view, this.#target.matrixWorld).sight(x, y));
  }

  /** The face that a ray, in world space, hits first, from either side. */
  cast(ray: Ray): FaceHit | null {
    const { origin, applyMatrix4 } = Object(ray) as Partial<Ray>;
    if (!origin || !applyMatrix4) refuse('ray', ray, 'a Ray of three.js, such as raycaster.ray');
    return this.#hit(this.#sightOf(ray, origin));
  }

  /** Whether the surface hides a point, in world space, from a camera. */
  hides(point: Vector3, camera: Camera): boolean {
    if (Object(point).isVector3 !== true) refuse('point', point, 'a Vector3 of three.js');
    checkCamera('camera', camera);
    camera.updateWorldMatrix(true, false);
    const ray = sightTo(point, camera);
    const hit = this.#hit(this.#sightOf(fromNear(ray, camera), ray.origin));
    return hit !== null && isClearlyBefore(hit.point, point, camera);
  }

  /** Along a ray of the world. */
  #sightOf(ray: Ray, origin: Vector3): Sight {
    const toObject = this.#target.matrixWorld.clone().invert();
    return { ray: ray.clone().applyMatrix4(toObject), origin };
  }

  #hit({ ray, origin }: Sight): FaceHit | null {
    const { tree, matrixWorld, mesh } = this.#target;
    const hit = tree.cast(ray);
    // An edit may have taken the face away, and the tree not know it yet.
    if (hit === null || !(mesh.connectivity.faceHalfedge[hit.face] >= 0)) return null;
    const point = ray.at(hit.distance, new Vector3()).applyMatrix4(matrixWorld);
    return { face: hit.face, point, distance: point.distanceTo(origin) };
  }

  #nearest(face: number, at: ScreenPoint, projection: Projection): Nearest {
    return nearestOf(face, at, this.#target, this.#glyphs, projection);
  }

  /** Just beside the outline of the surface: its vertices and edges can still be meant. */
  #beside(
    at: ScreenPoint,
    projection: Projection,
    mode: PickMode,
    reach: number,
  ): PickedItem | null {
    if (mode === 'face') return null;
    let least = BESIDE * reach;
    let found: PickedItem | null = null;
    for (let i = 0; i < 8; i++) {
      const [dx, dy] = [Math.cos((Math.PI * i) / 4), Math.sin((Math.PI * i) / 4)];
      const hit = this.#hit(
        projection.sight(at[0] + BESIDE * reach * dx, at[1] + BESIDE * reach * dy),
      );
      if (!hit) continue;
      const { vertex, vertexDistance, halfedge, edgeDistance } = this.#nearest(
        hit.face,
        at,
        projection,
      );
      if (mode !== 'edge' && mode !== 'halfedge' && vertexDistance < least) {
        least = vertexDistance;
        found = { kind: 'vertex', index: vertex };
      } else if (mode !== 'vertex' && edgeDistance + 3 < least) {
        least = edgeDistance + 3;
        found =
          mode === 'halfedge'
            ? { kind: 'halfedge', index: this.#outer(halfedge) }
            : { kind: 'edge', index: halfedge >> 1 };
      }
    }
    return found;
  }

  /** Of an edge on the boundary, the halfedge on the outside. */
  #outer(h: number): number {
    return this.#target.mesh.connectivity.face[h ^ 1] < 0 ? h ^ 1 : h;
  }

  /** The boundary halfedge whose arrow is there; -1 for none. */
  #boundaryAt(
    at: ScreenPoint,
    boundary: Iterable<number>,
    { camera }: PickView,
    projection: Projection,
    reach: number,
    hit: FaceHit | null,
  ): number {
    const { mesh, points, matrixWorld } = this.#target;
    const { toVertex, next, face } = mesh.connectivity;
    let found = -1;
    let least = TO_BOUNDARY * reach;
    let before = -1;
    let i = 0;
    for (const h of boundary) {
      if (!isIndex(h)) refuseIndex('options.boundary', i, h);
      i += 1;
      if (!(next[h] >= 0 && face[h] < 0)) continue; // deleted or filled since it was named
      const from = 3 * toVertex[h ^ 1];
      const pixel = projection.pixelAt(points[from], points[from + 1], points[from + 2]);
      this.#glyphs.boundary(h, arrowSizes(pixel), before);
      before = h;
      const distance = distanceToArrow(at, this.#glyphs, 0, projection);
      if (!(distance < least)) continue;
      const start = new Vector3().fromArray(this.#glyphs.arrows).applyMatrix4(matrixWorld);
      if (hit && isClearlyBefore(hit.point, start, camera)) continue;
      least = distance;
      found = h;
    }
    return found;
  }

  /** The vertex without edges that is there and that nothing hides; -1 for none. */
  #isolatedAt(
    at: ScreenPoint,
    { camera }: PickView,
    projection: Projection,
    reach: number,
  ): number {
    const { points, matrixWorld } = this.#target;
    let found = -1;
    let least = TO_ISOLATED * reach;
    for (const v of this.#isolatedVertices()) {
      const [x, y] = projection.project(points, 3 * v);
      const distance = Math.hypot(x - at[0], y - at[1]);
      if (!(distance < least)) continue;
      const point = new Vector3().fromArray(points as number[], 3 * v).applyMatrix4(matrixWorld);
      if (this.hides(point, camera)) continue;
      least = distance;
      found = v;
    }
    return found;
  }

  #isolatedVertices(): readonly number[] {
    const { mesh } = this.#target;
    const { version } = mesh;
    if (this.#isolated?.version !== version) {
      const { vertexHalfedge } = mesh.connectivity;
      const vertices: number[] = [];
      for (let v = 0; v < vertexHalfedge.length && vertices.length < MOST_ISOLATED; v++) {
        if (vertexHalfedge[v] === -1) vertices.push(v);
      }
      this.#isolated = { version, vertices };
    }
    return this.#isolated.vertices;
  }
}

/** Throws unless it is a place of a canvas, and the view of a camera. */
function checkPlace(x: unknown, y: unknown, view: unknown): void {
  if (typeof x !== 'number') refuse('x', x, 'a number of pixels');
  if (typeof y !== 'number') refuse('y', y, 'a number of pixels');
  const { camera, width, height } = checkObject(view, 'view') as Partial<PickView>;
  if (!camera?.isCamera) refuse('view.camera', camera, 'a Camera of three.js');
  if (typeof width !== 'number') refuse('view.width', width, 'a number of pixels');
  if (typeof height !== 'number') refuse('view.height', height, 'a number of pixels');
  checkCamera('view.camera', camera);
}

/** Throws unless it is a camera that tells in which direction it sees a place. */
function checkCamera(argument: string, camera: unknown): void {
  const { isPerspectiveCamera, isOrthographicCamera } = Object(camera);
  if (isPerspectiveCamera !== true && isOrthographicCamera !== true) {
    refuse(argument, camera, 'a PerspectiveCamera or an OrthographicCamera');
  }
}

/** What of a face is meant; on short edges its features share the room that there is. */
function closest(face: number, nearest: Nearest, reach: number): PickedItem {
  const { vertexDistance, edgeDistance, arrowDistance, edgeLength, meanEdge } = nearest;
  if (vertexDistance <= Math.min(TO_VERTEX * reach, 0.28 * edgeLength)) {
    return { kind: 'vertex', index: nearest.vertex };
  }
  const hasArrows = meanEdge >= ARROWS_FROM;
  if (edgeDistance <= Math.min((hasArrows ? 3 : 4) * reach, 0.12 * edgeLength)) {
    return { kind: 'edge', index: nearest.halfedge >> 1 };
  }
  if (hasArrows && arrowDistance <= TO_ARROW * reach) {
    return { kind: 'halfedge', index: nearest.halfedge };
  }
  return { kind: 'face', index: face };
}
