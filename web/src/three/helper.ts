import { Color, type ColorRepresentation, Group, type Object3D } from 'three';
import { describe } from '../arguments.js';
import { refuse } from '../checks.js';
import type { HalfedgeMesh } from '../mesh.js';
import { checkObject, type OptionNames } from '../options.js';
import { arrowSizes } from './arrows.js';
import { checkMesh } from './columns.js';
import { type DrawnMesh, HalfedgeGlyphs } from './glyphs.js';
import { type DrawnLines, LineBatch, type LineKind, webglLines } from './lines.js';
import { ARROW_FLOATS } from './mitre.js';
import { quadVertices } from './triangulate.js';

/** Options of all helpers. */
export interface HelperOptions {
  /** Default: that of the helper. */
  color?: ColorRepresentation | undefined;
  /** In CSS pixels. Default: that of the helper, 1.5 to 3.5. */
  linewidth?: number | undefined;
  /**
   * What makes its lines. For WebGPURenderer, pass `webgpuLines` of `halfedge/three/webgpu`. Default: lines
   * that WebGLRenderer draws.
   */
  lines?: LineKind | undefined;
  /**
   * The size of a CSS pixel in units of the mesh, as it is seen: arrows and dashes are sized by it. By
   * default, a typical edge is taken to be 56 pixels long.
   */
  pixel?: number | undefined;
}

export const HELPER_OPTIONS: OptionNames<HelperOptions> = {
  color: true,
  linewidth: true,
  lines: true,
  pixel: true,
};

/**
 * Something drawn over a mesh, in its coordinates: add it to the object that shows the mesh. Lines keep their
 * width, in CSS pixels, at any distance. Call `update()` after edits. Rays pass through it, so a `Raycaster`
 * hits the object. Its `layers` are those of its lines.
 */
export abstract class MeshHelper extends Group implements DrawnMesh {
  /** What is drawn. */
  readonly mesh: HalfedgeMesh;
  /** See {@link HelperOptions}. Call `update()` after setting it. */
  pixel: number;
  /** The colour of what is drawn. Call `update()` after changing it. */
  readonly color: Color;
  protected readonly batch = new LineBatch();
  protected readonly glyphs = new HalfedgeGlyphs(this);
  readonly #lines: LineKind;
  readonly #drawn: DrawnLines;

  /** `color` and `width` are the defaults of the helper. */
  constructor(mesh: HalfedgeMesh, options: HelperOptions, color: ColorRepresentation, width = 1.5) {
    super();
    checkObject(options);
    this.mesh = checkMesh(mesh);
    const { linewidth = width, lines = webglLines, pixel = typicalPixel(mesh) } = options;
    this.pixel = checkLength('options.pixel', pixel);
    this.color = colorOf('options.color', options.color, color);
    this.#lines = checkLines(lines);
    const drawn = this.#lines.make(
      this.batch.geometry,
      checkLength('options.linewidth', linewidth),
      2,
    );
    this.#drawn = drawn;
    drawn.layers = this.layers; // three.js hands none down to children
    this.add(Object.assign(drawn, { frustumCulled: false, renderOrder: 3, raycast() {} }));
  }

  /** By vertex of the mesh: x, y, z. */
  get points(): Float32Array {
    return this.mesh.positions;
  }

  /** The vertices of the two triangles of a quad, three each; nothing of other faces. */
  triangleVertices(face: number): number[] {
    return quadVertices(this.mesh, face);
  }

  /** How many segments of lines it draws. */
  get segments(): number {
    return this.batch.count;
  }

  /** Draws the mesh as it is now. Where it throws, nothing is drawn until it is called again. */
  update(): void {
    this.batch.clear();
    try {
      checkMesh(this.mesh);
      checkLength('pixel', this.pixel);
      this.draw();
    } catch (error) {
      this.batch.clear(); // a part would look like all of it
      if (!isCloning) throw error;
    } finally {
      this.batch.upload();
    }
  }

  /** Frees its memory on the graphics card. */
  override dispose(): void {
    this.batch.geometry.dispose();
    this.#drawn.material.dispose();
  }

  /**
   * Takes over what every object has, such as its place, and clones of the children that were added to it. The mesh,
   * the options and the lines stay those of this helper: for a helper like another one, call `clone()` of that one.
   */
  override copy(source: Object3D, recursive = true): this {
    const lines = source instanceof MeshHelper ? source.#drawn : undefined;
    return copyOnto(this, source, recursive, (child) => child === lines);
  }

  /** A group with the children that were added to it, without its lines, for which three.js has no JSON. */
  override toJSON(...meta: Parameters<Group['toJSON']>): ReturnType<Group['toJSON']> {
    return groupOf(this, (child) => child === this.#drawn).toJSON(...meta);
  }

  /**
   * Makes a clone and gives it what every object has, and clones of the children that were added. Where the original
   * can't draw, such as around a vertex that was deleted, the clone draws nothing either: who clones an object above it
   * need not know.
   */
  protected cloned(make: () => MeshHelper, recursive?: boolean): this {
    return quietly(make).copy(this, recursive) as this;
  }

  protected abstract draw(): void;

  /** The options as they are now, for a clone. */
  protected get options(): HelperOptions {
    const { linewidth } = this.#drawn.material;
    return { color: this.color, linewidth, lines: this.#lines, pixel: this.pixel };
  }

  /** Draws the arrow of a halfedge: dotted on the boundary. `before` is the one drawn just before, if there is one. */
  protected drawHalfedge(h: number, color: Color, before?: number): void {
    this.drawArrow(
      this.glyphs.halfedge(h, arrowSizes(this.pixel), before),
      this.mesh.isBoundaryHalfedge(h),
      color,
    );
  }

  /** Draws one of the arrows that were traced. */
  protected drawArrow(at: number, isBoundary: boolean, color: Color): void {
    const { arrows } = this.glyphs;
    if (isBoundary) this.batch.addDashed(arrows, at, at + 3, color, 5 * this.pixel, 0.4);
    else this.batch.add(arrows, at, at + 3, color);
    this.batch.add(arrows, at + 3, at + 6, color);
  }

  /** Draws the arrows of a face. */
  protected drawFace(f: number, color: Color): void {
    const degree = this.glyphs.face(f, arrowSizes(this.pixel));
    for (let i = 0; i < degree; i++) this.drawArrow(i * ARROW_FLOATS, false, color);
  }

  protected drawEdge(h: number, color: Color): void {
    const { toVertex } = this.mesh.connectivity;
    this.batch.add(this.points, 3 * toVertex[h ^ 1], 3 * toVertex[h], color);
  }
}

/** Whether a helper is being made that is the clone of another one. */
let isCloning = false;

function quietly<T>(make: () => T): T {
  isCloning = true;
  try {
    return make();
  } finally {
    isCloning = false;
  }
}

/** Tells what a helper draws from the children that were added to it. */
type OwnChild = (child: Object3D) => boolean;

/** What `copy` of three.js does, save for children that are what the source draws. */
export function copyOnto<Helper extends Group>(
  helper: Helper,
  source: Object3D,
  recursive: boolean,
  isOwn: OwnChild,
): Helper {
  Group.prototype.copy.call(helper, source as Group, false);
  // A list of its own: the source may be an object above the helper, or the helper itself.
  const others = recursive ? source.children.filter((child) => !isOwn(child)) : [];
  for (const child of others) helper.add(child.clone());
  return helper;
}

/** An ordinary group like a helper, to be written as JSON. */
export function groupOf(helper: Group, isOwn: OwnChild): Group {
  const group = new Group().copy(helper, false);
  // Not added to it: they stay where they are.
  const children = helper.children.filter((child) => !isOwn(child));
  return Object.assign(group, { uuid: helper.uuid, children });
}

/** A colour of its own; that of the helper where none is given. Of words that are none, three.js warns. */
export function colorOf(argument: string, given: unknown, others: ColorRepresentation): Color {
  if (given === undefined) return new Color(others);
  const isColor = typeof given === 'object' && given !== null && 'isColor' in given;
  // three.js rounds numbers down, such as those of Math.random() * 0xffffff.
  const isNumber = typeof given === 'number' && given >= 0 && given < 2 ** 24;
  if (isColor || isNumber || typeof given === 'string') return new Color(given as Color);
  refuse(
    argument,
    given,
    'a colour: a Color, a string or a number from 0x000000 to 0xffffff',
    'number',
  );
}

/** Throws unless it is a length. */
export function checkLength(argument: string, value: unknown): number {
  if (typeof value === 'number' && value > 0 && value < Infinity) return value;
  throw new RangeError(`${argument} is ${describe(value)}; expected a positive number.`);
}

function checkLines(lines: unknown): LineKind {
  const { make } = Object(lines) as Partial<LineKind>;
  if (typeof make === 'function') return lines as LineKind;
  refuse(
    'options.lines',
    lines,
    'webgpuLines of halfedge/three/webgpu, or nothing for WebGLRenderer',
  );
}

/** The size of a CSS pixel where a typical edge is 56 of them long. */
export function typicalPixel(mesh: HalfedgeMesh): number {
  return typicalEdge(mesh) / 56;
}

/** The median length of some of the edges; 1 if there are none that have a length. */
function typicalEdge({ connectivity: { toVertex, next }, positions }: HalfedgeMesh): number {
  const lengths: number[] = [];
  const stride = 2 * Math.max(1, Math.floor(next.length / 2000));
  for (let h = 0; h < next.length; h += stride) {
    if (next[h] < -1) continue;
    const [a, b] = [3 * toVertex[h], 3 * toVertex[h + 1]];
    const [x, y, z] = [0, 1, 2].map((k) => positions[a + k] - positions[b + k]);
    const length = Math.hypot(x, y, z);
    if (length > 0 && Number.isFinite(length)) lengths.push(length);
  }
  lengths.sort((p, q) => p - q);
  return lengths[lengths.length >> 1] ?? 1;
}
