import { html, type SVGTemplateResult, svg, type TemplateResult } from 'lit';
import { PerspectiveCamera, Spherical, Vector3 } from 'three';
import type { HalfedgeMesh } from '../api.js';
import { facesAt } from '../scene/anchors.js';
import { Surface } from '../scene/surface.js';
import { UP, type UpAxis, uprightOf } from '../scene/up.js';
import { type Item, itemName, verticesOf } from '../teaching/items.js';
import { newellNormal } from '../three/index.js';
import { ItemPicker } from '../three/item-picker.js';
import { frontOf } from './front.js';
import type { FigureState } from './view.js';

const WIDTH = 640;
const HEIGHT = 400;
/** No more faces than these are drawn: it is a picture of the mesh, not the mesh. */
const MOST_FACES = 4000;
/** How far the eye is where the whole mesh is seen, and how near and how far it may come. */
const DISTANCE = 4.2;
const NEAREST = 1.4;
const FARTHEST = 20;
/** How much is seen of what names a hidden item, as of labels that are behind. */
const BEHIND = 0.32;

/**
 * A drawing of the mesh, for where there is no WebGL: faces from back to front, the selected item, and
 * the order of visits.
 */
export class Poster {
  readonly #camera = new PerspectiveCamera(32, WIDTH / HEIGHT, 0.01, 100);
  readonly #moved: () => void;
  /** Where the eye is, around the axis that points up. */
  readonly #eye = new Spherical(DISTANCE);
  #surface: Surface | null = null;
  #picker: ItemPicker | null = null;
  #version = -1;
  /** What the eye was told last, to tell when it is told otherwise. */
  #viewpoint = '';

  /** `moved` is called when it is to be drawn anew. */
  constructor(moved: () => void) {
    this.#moved = moved;
  }

  /** Turns by angles in radians. */
  orbit(horizontal: number, vertical: number): void {
    this.#eye.theta += horizontal;
    this.#eye.phi += vertical;
    this.#eye.makeSafe();
    this.#moved();
  }

  /** Moves the eye to `factor` times its distance. */
  zoom(factor: number): void {
    this.#eye.radius = Math.min(FARTHEST, Math.max(NEAREST, factor * this.#eye.radius));
    this.#moved();
  }

  /** Shows the whole mesh. */
  fit(): void {
    this.#eye.radius = DISTANCE;
    this.#moved();
  }

  /** Forgets the mesh as it was, whose vertices may have moved. */
  forget(): void {
    this.#surface?.tree.dispose();
    this.#surface = null;
  }

  /** The drawing, seen from `viewpoint`: a direction, or where the eye is and what it looks at. `up` points up. */
  draw(state: FigureState, viewpoint: readonly number[] | null, up: UpAxis): TemplateResult | null {
    const { mesh, selected, story } = state;
    if (!mesh) return null;
    const surface = this.#surfaceOf(mesh);
    this.#look(surface, viewpoint, up);
    const lit = new Set(selected?.kind === 'face' ? facesAt(surface, selected) : []);
    const visits = story?.visits ?? [];
    return html`<svg viewBox="0 0 ${WIDTH} ${HEIGHT}" preserveAspectRatio="xMidYMid meet" aria-hidden="true">
      ${facesOf(surface, this.#camera).map(({ face, shade }) => {
        const points = [...mesh.faceVertices(face)].map((v) =>
          this.#place(pointOf(surface, v)).map(round).join(','),
        );
        const fill = `color-mix(in srgb, var(${lit.has(face) ? '--self' : '--gl-surface'}) ${lit.has(face) ? 45 : 100}%, var(--page) ${round(18 * (1 - shade))}%)`;
        return svg`<polygon points=${points.join(' ')} style="fill: ${fill}; stroke: var(--gl-arrow); stroke-width: 1.2; stroke-linejoin: round"></polygon>`;
      })}
      ${selected && selected.kind !== 'face' ? this.#mark(surface, selected) : null}
      ${visits.map(({ item }, i) => this.#tag(surface, item, `${i + 1}`, 'var(--next-text)'))}
      ${selected ? this.#tag(surface, selected, itemName(selected), 'var(--self-text)') : null}
    </svg>`;
  }

  #surfaceOf(mesh: HalfedgeMesh): Surface {
    const { mesh: before } = this.#surface ?? {};
    if (this.#surface && before === mesh && this.#version === mesh.version) return this.#surface;
    if (before !== mesh) this.#viewpoint = '';
    this.forget();
    this.#version = mesh.version;
    this.#surface = new Surface(mesh);
    this.#picker = new ItemPicker(this.#surface);
    return this.#surface;
  }

  #look({ points }: Surface, viewpoint: readonly number[] | null, up: UpAxis): void {
    const upright = uprightOf(UP[up]);
    const told = JSON.stringify([viewpoint, up]);
    if (told !== this.#viewpoint) {
      const [position, target] = [0, 3].map((at) => new Vector3().fromArray(viewpoint ?? [], at));
      const from = viewpoint?.length === 6 ? position.sub(target) : position;
      const direction = viewpoint ? from : frontOf(points, up);
      this.#eye.setFromVector3(direction.applyQuaternion(upright));
      this.#eye.radius = DISTANCE;
      this.#viewpoint = told;
    }
    this.#camera.up.copy(UP[up]);
    this.#camera.position.setFromSpherical(this.#eye).applyQuaternion(upright.invert());
    this.#camera.lookAt(0, 0, 0);
    this.#camera.updateMatrixWorld();
  }

  #place(point: Vector3): Point {
    const { x, y } = point.clone().project(this.#camera);
    return [((x + 1) * WIDTH) / 2, ((1 - y) * HEIGHT) / 2];
  }

  /** Fainter, where the surface hides it. */
  #opacity(point: Vector3): number {
    return this.#picker?.hides(point, this.#camera) ? BEHIND : 1;
  }

  #mark(surface: Surface, item: Item): SVGTemplateResult {
    const corners = verticesOf(surface.mesh, item).map((v) => pointOf(surface, v));
    const opacity = this.#opacity(middle(corners));
    const [[x, y], to] = corners.map((point) => this.#place(point));
    if (item.kind === 'vertex') {
      return svg`<circle cx=${round(x)} cy=${round(y)} r="6" opacity=${opacity} style="fill: var(--self)"></circle>`;
    }
    return svg`<line x1=${round(x)} y1=${round(y)} x2=${round(to[0])} y2=${round(to[1])} opacity=${opacity} style="stroke: var(--self); stroke-width: 4; stroke-linecap: round"></line>`;
  }

  #tag(surface: Surface, item: Item, text: string, color: string): SVGTemplateResult {
    const point = middle(verticesOf(surface.mesh, item).map((v) => pointOf(surface, v)));
    const [x, y] = this.#place(point);
    return svg`<text x=${round(x)} y=${round(y - 10)} opacity=${this.#opacity(point)} text-anchor="middle" style="font: 600 14px var(--mono); fill: ${color}; stroke: var(--page); stroke-width: 4; paint-order: stroke">${text}</text>`;
  }
}

type Point = readonly [x: number, y: number];

/** The faces from back to front, and how much each is turned to the eye. */
function facesOf(surface: Surface, camera: PerspectiveCamera): { face: number; shade: number }[] {
  const corners: number[] = [];
  const normal = new Float64Array(3);
  const faces: { face: number; shade: number; depth: number }[] = [];
  for (const face of surface.mesh.faces()) {
    const degree = surface.corners(face, corners);
    newellNormal(corners, degree, normal);
    const centre = new Vector3();
    for (let i = 0; i < degree; i++) {
      centre.addScaledVector(new Vector3().fromArray(corners, 3 * i), 1 / degree);
    }
    const towards = camera.position.clone().sub(centre);
    const depth = towards.length();
    const shade = Math.abs(new Vector3(...normal).dot(towards)) / depth;
    faces.push({ face, shade, depth });
    if (faces.length === MOST_FACES) break;
  }
  return faces.sort((a, b) => b.depth - a.depth);
}

function pointOf({ points }: Surface, v: number): Vector3 {
  return new Vector3().fromArray(points, 3 * v);
}

function middle(points: readonly Vector3[]): Vector3 {
  const sum = new Vector3();
  for (const point of points) sum.add(point);
  return sum.divideScalar(points.length);
}

function round(x: number): number {
  return Math.round(x * 10) / 10;
}
