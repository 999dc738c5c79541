import type { Color, ColorRepresentation } from 'three';
import { describe, isIndex, refuseIndex } from '../arguments.js';
import { checkIterable, refuse } from '../checks.js';
import type { CirculatorCentre, CirculatorKind } from '../circulation.js';
import { HalfedgeError, type Problem, type Witness } from '../errors.js';
import type { Direction, Halfedge } from '../items.js';
import { noOrbit } from '../measures.js';
import type { HalfedgeMesh } from '../mesh.js';
import { checkOptions, type OptionNames } from '../options.js';
import { arrowSizes } from './arrows.js';
import { colorOf, HELPER_OPTIONS, type HelperOptions, MeshHelper } from './helper.js';

// The colours of the explorer in a light theme: told apart under every colour vision.
const ARROW = 0x2485f7;
const BOUNDARY = 0x6c1f04;
const TRAIL = 0x046a53;
const PROBLEM = 0xe01297;

/** More faces than these have arrows only if they are named. */
const MOST_FACES = 8000;

/** Options of {@link HalfedgesHelper}. */
export interface HalfedgesOptions extends HelperOptions {
  /** The colour of boundary halfedges. */
  boundaryColor?: ColorRepresentation | undefined;
  /**
   * Draws only the halfedges of these faces, and the boundary across their edges. Default: all faces, at most
   * 8,000.
   */
  faces?: Iterable<number> | undefined;
}

const HALFEDGES_OPTIONS: OptionNames<HalfedgesOptions> = {
  ...HELPER_OPTIONS,
  boundaryColor: true,
  faces: true,
};

/**
 * Draws all halfedges as half-arrows inside their faces, where they never cross, however thin the face is.
 * Boundary halfedges are drawn outside, dotted.
 *
 * ```ts
 * const helper = new HalfedgesHelper(mesh);
 * object.add(helper);
 * mesh.flipEdge(e);
 * helper.update();
 * ```
 */
export class HalfedgesHelper extends MeshHelper {
  override readonly type = 'HalfedgesHelper' as 'Group';
  /** The colour of boundary halfedges. Call `update()` after changing it. */
  readonly boundaryColor: Color;
  /** The faces that are shown; undefined for all. Call `update()` after setting it. */
  faces: readonly number[] | undefined;

  constructor(mesh: HalfedgeMesh, options: HalfedgesOptions = {}) {
    super(mesh, checkOptions(options, HALFEDGES_OPTIONS), ARROW);
    this.boundaryColor = colorOf('options.boundaryColor', options.boundaryColor, BOUNDARY);
    checkIterable('options.faces', options.faces, 'faces to iterate over');
    this.faces = options.faces && [...options.faces];
    for (const [i, f] of this.faces?.entries() ?? []) {
      if (!isIndex(f)) refuseIndex('options.faces', i, f);
    }
    this.update();
  }

  /** One of its own for the same mesh, with the options that this one has now and clones of the children added to it. */
  override clone(recursive?: boolean): this {
    const { mesh, options, boundaryColor, faces } = this;
    return this.cloned(
      () => new HalfedgesHelper(mesh, { ...options, boundaryColor, faces }),
      recursive,
    );
  }

  protected override draw(): void {
    const { mesh } = this;
    const { next, face, faceHalfedge } = mesh.connectivity;
    let left = MOST_FACES;
    checkIterable('faces', this.faces, 'faces to iterate over');
    for (const f of this.faces ?? mesh.faces()) {
      if (this.faces === undefined && left-- === 0) return;
      if (!(faceHalfedge[f] >= 0)) continue; // deleted since it was named
      this.drawFace(f, this.color);
      let before = -1;
      let h = faceHalfedge[f];
      do {
        if (face[h ^ 1] < 0) {
          this.glyphs.boundary(h ^ 1, arrowSizes(this.pixel), before);
          this.drawArrow(0, true, this.boundaryColor);
          before = h ^ 1;
        }
        h = next[h];
      } while (h !== faceHalfedge[f]);
    }
  }
}

/** The edges of all boundary loops, as strong lines. */
export class BoundaryLoopsHelper extends MeshHelper {
  override readonly type = 'BoundaryLoopsHelper' as 'Group';

  constructor(mesh: HalfedgeMesh, options: HelperOptions = {}) {
    super(mesh, checkOptions(options, HELPER_OPTIONS), BOUNDARY, 2.25);
    this.update();
  }

  /** One of its own for the same mesh, with the options that this one has now and clones of the children added to it. */
  override clone(recursive?: boolean): this {
    return this.cloned(() => new BoundaryLoopsHelper(this.mesh, this.options), recursive);
  }

  protected override draw(): void {
    const { next, face } = this.mesh.connectivity;
    for (let h = 0; h < next.length; h++) {
      if (next[h] >= 0 && face[h] < 0) this.drawEdge(h, this.color);
    }
  }
}

/** Options of {@link CirculatorHelper}. */
export interface CirculatorOptions extends HelperOptions {
  /** Default: 'ccw'. */
  direction?: Direction | undefined;
  /** How many steps of the circulator to show. Default: one lap. */
  steps?: number | undefined;
  /** The colour of the current step. */
  currentColor?: ColorRepresentation | undefined;
}

const CIRCULATOR_OPTIONS: OptionNames<CirculatorOptions> = {
  ...HELPER_OPTIONS,
  direction: true,
  steps: true,
  currentColor: true,
};

/** Draws the trace of a circulator: the halfedges that it has visited, the last one in a different colour. */
export class CirculatorHelper<Kind extends CirculatorKind = CirculatorKind> extends MeshHelper {
  override readonly type = 'CirculatorHelper' as 'Group';
  /** The colour of the current step. Call `update()` after changing it. */
  readonly currentColor: Color;
  /** Which circulator it is. */
  readonly kind: Kind;
  /** Which way it goes. */
  readonly direction: Direction;
  /**
   * The item that it goes around. Call `update()` after setting it. Where there is no such item any more, as after an
   * undo, `update()` throws, and draws nothing until it has another item.
   */
  item: CirculatorCentre<Kind>;
  /** How far it goes. Call `update()` after setting it. */
  steps: number;

  constructor(
    mesh: HalfedgeMesh,
    kind: Kind,
    item: CirculatorCentre<Kind>,
    options: CirculatorOptions = {},
  ) {
    super(mesh, checkOptions(options, CIRCULATOR_OPTIONS), TRAIL, 2.5);
    const { direction = 'ccw', steps = Infinity, currentColor } = options;
    checkSteps('options.steps', steps);
    this.kind = kind;
    this.item = item;
    this.direction = direction;
    this.steps = steps;
    this.currentColor = colorOf('options.currentColor', currentColor, ARROW);
    this.update();
  }

  /** The halfedges of the trace, in order. */
  trace(): Halfedge[] {
    checkSteps('steps', this.steps);
    const circulator = this.mesh.circulate(this.kind, this.item, { direction: this.direction });
    const halfedges: Halfedge[] = [];
    if (circulator.current === undefined) return halfedges;
    while (halfedges.length < this.steps) {
      const { halfedge } = circulator;
      if (!(halfedge >= 0) || halfedge === halfedges[0]) break;
      if (halfedges.length === this.mesh.halfedgeSlots) throw noOrbit();
      halfedges.push(halfedge);
      circulator.next();
    }
    return halfedges;
  }

  /** One of its own for the same mesh, with the options that this one has now and clones of the children added to it. */
  override clone(recursive?: boolean): this {
    const { mesh, kind, item, options, direction, steps, currentColor } = this;
    return this.cloned(
      () =>
        new CirculatorHelper(mesh, kind, item, {
          ...options,
          direction,
          steps,
          currentColor,
        }),
      recursive,
    );
  }

  protected override draw(): void {
    const halfedges = this.trace();
    halfedges.forEach((h, i) => {
      const color = i === halfedges.length - 1 ? this.currentColor : this.color;
      this.drawHalfedge(h, color, halfedges[i - 1]);
    });
  }
}

function checkSteps(argument: string, steps: unknown): void {
  if (typeof steps === 'number' && steps >= 0) return;
  throw new RangeError(`${argument} is ${describe(steps)}; expected a number from 0.`);
}

/** Options of {@link ProblemsHelper}. */
export interface ProblemsOptions extends HelperOptions {
  /**
   * The problems, refusals and errors whose items are shown. Default: what `mesh.validate()` finds at each
   * update.
   */
  problems?: readonly Partial<Pick<Problem, 'kind' | 'index' | 'witness'>>[] | undefined;
}

const PROBLEMS_OPTIONS: OptionNames<ProblemsOptions> = { ...HELPER_OPTIONS, problems: true };

/**
 * Draws the items that problems or refusals are about: edges, the outlines of faces, the edges at vertices.
 *
 * ```ts
 * const refusal = mesh.checkFlipEdge(e);
 * if (refusal) object.add(new ProblemsHelper(mesh, { problems: [refusal] }));
 * ```
 */
export class ProblemsHelper extends MeshHelper {
  override readonly type = 'ProblemsHelper' as 'Group';
  /** Call `update()` after setting it. */
  problems: ProblemsOptions['problems'];
  /** The halfedge that was drawn just before, if it was one. */
  #before: number | undefined;

  constructor(mesh: HalfedgeMesh, options: ProblemsOptions = {}) {
    super(mesh, checkOptions(options, PROBLEMS_OPTIONS), PROBLEM, 3.5);
    this.problems = options.problems;
    this.update();
  }

  /** One of its own for the same mesh, with the options that this one has now and clones of the children added to it. */
  override clone(recursive?: boolean): this {
    const { mesh, options, problems } = this;
    return this.cloned(() => new ProblemsHelper(mesh, { ...options, problems }), recursive);
  }

  protected override draw(): void {
    this.#before = undefined;
    for (const { kind, index, witness } of checkProblems(this.problems) ?? this.mesh.validate()) {
      if (kind !== undefined && index !== undefined) this.#drawItem(kind, index);
      if (witness) this.#drawWitness(witness);
    }
  }

  #drawWitness({ vertices = [], halfedges = [], edges = [], faces = [] }: Partial<Witness>): void {
    for (const v of vertices) this.#drawItem('vertex', v);
    for (const h of halfedges) this.#drawItem('halfedge', h);
    for (const e of edges) this.#drawItem('edge', e);
    for (const f of faces) this.#drawItem('face', f);
  }

  /** Items that are gone, or whose links are broken, are left out: a mesh with problems may have such. */
  #drawItem(kind: string, index: number): void {
    const { next, toVertex, vertexHalfedge, faceHalfedge } = this.mesh.connectivity;
    const isDrawable = (h: number) => next[h] >= 0 && toVertex[h] >= 0 && toVertex[h ^ 1] >= 0;
    const walk = (first: number, step: (h: number) => number) => {
      let h = first;
      for (let left = next.length; left > 0 && isDrawable(h); left--) {
        this.drawEdge(h, this.color);
        h = step(h);
        if (h === first) return;
      }
    };
    if (kind === 'vertex') walk(vertexHalfedge[index], (h) => next[h ^ 1]);
    else if (kind === 'face') walk(faceHalfedge[index], (h) => next[h]);
    else if (kind === 'edge' && isDrawable(2 * index)) this.drawEdge(2 * index, this.color);
    else if (kind === 'halfedge' && isDrawable(index)) this.#drawArrow(index);
  }

  /** The arrow of a halfedge; its edge, where the face beside it has no closed loop that it is in. */
  #drawArrow(h: number): void {
    const before = this.#before;
    this.#before = undefined;
    try {
      this.drawHalfedge(h, this.color, before);
      this.#before = h;
    } catch (error) {
      if (!(error instanceof HalfedgeError)) throw error;
      this.drawEdge(h, this.color);
    }
  }
}

function checkProblems(problems: unknown): ProblemsOptions['problems'] {
  if (problems === undefined) return undefined;
  if (!Array.isArray(problems)) refuse('problems', problems, 'an array of problems and refusals');
  const i = problems.findIndex((problem) => typeof problem !== 'object' || problem === null);
  if (i >= 0) refuse(`problems[${i}]`, problems[i], 'a problem, a refusal or an error');
  return problems;
}
