import { type Color, Vector3 } from 'three';
import { type Link, linksOf } from '../teaching/item-links.js';
import { type Item, itemName } from '../teaching/items.js';
import { LineBatch, lineMaterial, lines } from '../three/lines.js';
import { anchorOf, shaftOf, sideOf } from './anchors.js';
import type { FaceFrames } from './faces.js';
import type { Glyphs } from './glyphs.js';
import { type Label, widthOf } from './labels.js';
import { ROLE_COLORS } from './marks.js';
import type { Palette } from './palette.js';
import type { Stage } from './stage.js';
import type { Surface } from './surface.js';

/** What belongs to the mesh on show. */
interface Parts {
  readonly surface: Surface;
  readonly frames: FaceFrames;
  readonly glyphs: Glyphs;
}

/** How the arrow of a link is bent: where it leaves and arrives, and how far it bulges to its left. */
interface Bend {
  /** Where on the shaft of a halfedge it begins and ends, from 0 to 1. */
  readonly from: number;
  readonly to: number;
  /** The bulge as a share of the way, and in CSS pixels, which show where the way is short. */
  readonly share: number;
  readonly pixels: number;
}

/** By the number of the link in the figure of the structure; all leave a halfedge at different places. */
const BENDS: Record<1 | 2 | 3 | 4 | 5 | 6 | 7, Bend> = {
  1: { from: 0, to: 0.5, share: 0.22, pixels: 10 },
  2: { from: 0, to: 0.5, share: 0.22, pixels: 10 },
  3: { from: 0.9, to: 0, share: -0.35, pixels: -16 },
  4: { from: 0.35, to: 0, share: 0.16, pixels: 6 },
  5: { from: 0.76, to: 0.3, share: 0.22, pixels: 8 },
  6: { from: 0.56, to: 0.56, share: -0.3, pixels: -16 },
  7: { from: 0.14, to: 0.72, share: -0.22, pixels: -8 },
};

const PIECES = 24;
const HEAD_PX = 9;
/** How far from the middle of a vertex its arrow ends: at the rim of its disc. */
const DISC_PX = 8;
/** Half of the height of the name in the middle of a face, which arrows don't go under, and some air. */
const NAME_PX = 13;
/** On shorter ways the number stands beside the arrow. */
const SHORT_PX = 54;

/** The links (1)–(7) of an item as curved arrows, each with its number; over everything else. */
export class Pointers {
  readonly #stage: Stage;
  readonly #batch = new LineBatch(256);
  readonly #material = lineMaterial(2.25, 0);
  readonly #halo = lineMaterial(5.5, 0);

  constructor(stage: Stage) {
    this.#stage = stage;
    for (const material of [this.#halo, this.#material]) {
      material.depthTest = false;
      material.transparent = true;
    }
    this.#halo.vertexColors = false;
    stage.scene.add(lines(this.#batch, this.#halo, 8.4), lines(this.#batch, this.#material, 8.5));
  }

  /** The colour that sets the arrows apart from what they lie on. */
  setHalo(color: Color): void {
    this.#halo.color.copy(color);
  }

  /**
   * Before each frame: draws the arrows of the items for the camera as it stands, and returns their numbers.
   * `faint` if they are behind the surface.
   */
  update(items: readonly Item[], parts: Parts, palette: Palette, faint: boolean): Label[] {
    this.#batch.clear();
    this.#material.opacity = faint ? 0.25 : 1;
    this.#halo.opacity = faint ? 0 : 0.8;
    const labels: Label[] = [];
    for (const item of items) {
      for (const link of linksOf(parts.surface.mesh, item)) {
        const { number, target } = link;
        if (number === undefined) continue;
        if (target) labels.push(this.#draw(item, link, target, BENDS[number], parts, palette));
        else labels.push(this.#empty(item, link, parts));
      }
    }
    this.#batch.upload();
    return labels.map((label) => ({ ...label, over: !faint }));
  }

  #draw(
    item: Item,
    { number, role }: Link,
    target: Item,
    bend: Bend,
    parts: Parts,
    palette: Palette,
  ): Label {
    const start = placeOn(item, bend.from, parts);
    const end = placeOn(target, bend.to, parts);
    const middle = start.clone().add(end).multiplyScalar(0.5);
    const pixel = this.#pixelAt(middle);
    const eye = this.#stage.camera.position.clone().sub(middle).normalize();
    const way = end.clone().sub(start);
    const left = eye.clone().cross(way).normalize();
    const control = middle.addScaledVector(left, bend.share * way.length() + bend.pixels * pixel);
    const arrives = end.clone().sub(control).normalize();
    if (target.kind === 'vertex') end.addScaledVector(arrives, -DISC_PX * pixel);
    if (target.kind === 'face')
      this.#leaveName(end, control, { text: itemName(target), look: 'index' });
    if (item.kind === 'face')
      this.#leaveName(start, control, { text: itemName(item), look: 'self' });
    const color = palette[ROLE_COLORS[role]];
    const at = (t: number) => bezier(start, control, end, t);
    for (let i = 0; i < PIECES; i++) {
      if (role === 'prev' && i % 4 === 3) continue;
      this.#segment(at(i / PIECES), at((i + 1) / PIECES), color);
    }
    const across = eye.cross(arrives).normalize();
    for (const side of [-0.45, 0.45]) {
      const barb = end.clone().addScaledVector(arrives, -HEAD_PX * pixel);
      this.#segment(end, barb.addScaledVector(across, side * HEAD_PX * pixel), color);
    }
    const lift = start.distanceTo(end) / pixel < SHORT_PX ? 14 : 0;
    return {
      text: `${number}`,
      look: 'link',
      role,
      point: at(0.5),
      side: control,
      line: [0, 0.25, 0.5, 0.75, 1].map(at),
      lift,
      yields: true,
    };
  }

  /** Moves the middle of a face towards a point, out from under its name. */
  #leaveName(middle: Vector3, towards: Vector3, name: Pick<Label, 'text' | 'look'>): void {
    const way = towards.clone().sub(middle);
    const [right, up] = [0, 1].map((axis) =>
      Math.abs(way.dot(new Vector3().setFromMatrixColumn(this.#stage.camera.matrixWorld, axis))),
    );
    const pixel = this.#pixelAt(middle);
    const width = widthOf(name) / 2 + 3;
    // However small the face is, some of the way is left for the arrow.
    const share = Math.min((width * pixel) / right, (NAME_PX * pixel) / up, 0.75);
    middle.addScaledVector(way, share);
  }

  /** A link that leads nowhere is told beside the item. */
  #empty(item: Item, { number, role }: Link, parts: Parts): Label {
    const point = placeOn(item, 0.5, parts);
    const side = item.kind === 'halfedge' ? sideOf(item.index, parts.glyphs) : undefined;
    return {
      text: `${number} ∅`,
      look: 'link',
      role,
      point,
      side,
      lift: side ? 22 : -22,
      yields: true,
    };
  }

  #segment(a: Vector3, b: Vector3, color: Color): void {
    this.#batch.add([a.x, a.y, a.z, b.x, b.y, b.z], 0, 3, color);
  }

  #pixelAt({ x, y, z }: Vector3): number {
    return this.#stage.pixelAt(Math.max(1e-6, this.#stage.depthOf(x, y, z)));
  }
}

/** A point of an item: of a halfedge, at this share of the shaft of its arrow. */
function placeOn(item: Item, share: number, { surface, frames, glyphs }: Parts): Vector3 {
  if (item.kind !== 'halfedge') return anchorOf(item, surface, frames, glyphs);
  const [start, end] = shaftOf(item.index, glyphs);
  return start.lerp(end, share);
}

/** The point at `t` of the curve from a to c that leaves towards b and arrives from it. */
function bezier(a: Vector3, b: Vector3, c: Vector3, t: number): Vector3 {
  return a
    .clone()
    .multiplyScalar((1 - t) ** 2)
    .addScaledVector(b, 2 * t * (1 - t))
    .addScaledVector(c, t ** 2);
}
