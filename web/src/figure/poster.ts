import { html, type SVGTemplateResult, svg, type TemplateResult } from 'lit';
import { PerspectiveCamera, Vector3 } from 'three';
import { facesAt } from '../scene/anchors.js';
import { Surface } from '../scene/surface.js';
import { type Item, itemName, verticesOf } from '../teaching/items.js';
import { newellNormal } from '../three/index.js';
import { frontOf } from './front.js';
import type { FigureState } from './view.js';

const WIDTH = 640;
const HEIGHT = 400;
/** No more faces than these are drawn: it is a picture of the mesh, not the mesh. */
const MOST_FACES = 4000;

/**
 * A drawing of the mesh, for where there is no WebGL: faces from back to front, the selected item, and
 * the order of visits.
 */
export function posterOf(
  state: FigureState,
  direction: readonly number[] | null,
): TemplateResult | null {
  const { mesh, selected, story } = state;
  if (!mesh) return null;
  const surface = new Surface(mesh);
  const camera = new PerspectiveCamera(32, WIDTH / HEIGHT, 0.01, 100);
  const from = direction ? new Vector3().fromArray(direction) : frontOf(surface.points);
  camera.position.copy(from).setLength(4.2);
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  const place = (v: number) => {
    const { x, y } = new Vector3().fromArray(surface.points, 3 * v).project(camera);
    return [((x + 1) * WIDTH) / 2, ((1 - y) * HEIGHT) / 2] as const;
  };
  const lit = new Set(selected?.kind === 'face' ? facesAt(surface, selected) : []);
  const visits = story?.visits ?? [];
  return html`<svg viewBox="0 0 ${WIDTH} ${HEIGHT}" preserveAspectRatio="xMidYMid meet" aria-hidden="true">
    ${facesOf(surface, camera).map(({ face, shade }) => {
      const points = [...mesh.faceVertices(face)].map((v) => place(v).map(round).join(','));
      const fill = `color-mix(in srgb, var(${lit.has(face) ? '--self' : '--gl-surface'}) ${lit.has(face) ? 45 : 100}%, var(--page) ${round(18 * (1 - shade))}%)`;
      return svg`<polygon points=${points.join(' ')} style="fill: ${fill}; stroke: var(--gl-arrow); stroke-width: 1.2; stroke-linejoin: round"></polygon>`;
    })}
    ${selected && selected.kind !== 'face' ? mark(selected, verticesOf(mesh, selected).map(place)) : null}
    ${visits.map(({ item }, i) => tag(`${i + 1}`, middle(verticesOf(mesh, item).map(place)), 'var(--next-text)'))}
    ${selected ? tag(itemName(selected), middle(verticesOf(mesh, selected).map(place)), 'var(--self-text)') : null}
  </svg>`;
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

function mark(item: Item, places: readonly Point[]): SVGTemplateResult {
  const [[x, y], to] = places;
  if (item.kind === 'vertex') {
    return svg`<circle cx=${round(x)} cy=${round(y)} r="6" style="fill: var(--self)"></circle>`;
  }
  return svg`<line x1=${round(x)} y1=${round(y)} x2=${round(to[0])} y2=${round(to[1])} style="stroke: var(--self); stroke-width: 4; stroke-linecap: round"></line>`;
}

function tag(text: string, [x, y]: Point, color: string): SVGTemplateResult {
  return svg`<text x=${round(x)} y=${round(y - 10)} text-anchor="middle" style="font: 600 14px var(--mono); fill: ${color}; stroke: var(--page); stroke-width: 4; paint-order: stroke">${text}</text>`;
}

function middle(places: readonly Point[]): Point {
  const sum = places.reduce(([a, b], [x, y]) => [a + x, b + y] as const, [0, 0] as Point);
  return [sum[0] / places.length, sum[1] / places.length];
}

function round(x: number): number {
  return Math.round(x * 10) / 10;
}
