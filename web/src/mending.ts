import { checkOptions, describe } from './arguments.js';
import { modeOf } from './edit.js';
import type { Problem } from './errors.js';
import { Modelling } from './modelling.js';
import { linksOf } from './navigation.js';
import { problemOf, unwrap } from './reports.js';
import { take } from './rings.js';

/** The repairs, in the order of `run` in wasm/mending_bindings.cpp. */
const REPAIRS = {
  stitch: 0,
  splitPinched: 1,
  orient: 2,
  dropSmall: 3,
  removeDegenerate: 4,
  fill: 5,
} as const;

/** What a repair of a mesh did, and then what it had to leave. */
export type MendCode =
  | 'stitched-edge'
  | 'split-vertex'
  | 'reversed-component'
  | 'collapsed-edge'
  | 'flipped-edge'
  | 'joined-face'
  | 'removed-face'
  | 'triangulated-face'
  | 'dropped-component'
  | 'filled-hole'
  | 'ambiguous-edge'
  | 'opposite-orientation'
  | 'unstitchable-edge'
  | 'open-component'
  | 'flat-component'
  | 'zero-length-edge'
  | 'degenerate-face'
  | 'large-hole'
  | 'unfillable-hole'
  | 'folding-hole';

/** What a repair of a mesh has done, and what not. */
export interface MendReport {
  /** How many items each code was found of. */
  readonly counts: Readonly<Partial<Record<MendCode, number>>>;
  /** What could not be done, and why: a sentence each; at most 100 of each code. */
  readonly problems: readonly Problem[];
  /** The items that were touched or made: each repair says which. */
  readonly vertices: Uint32Array;
  readonly edges: Uint32Array;
  readonly faces: Uint32Array;
  /** All of it in one readable line. */
  readonly summary: string;
}

/** How to stitch boundaries. */
export interface StitchOptions {
  /** Vertices closer than this count as one. Default: 0, those at the same position. */
  tolerance?: number;
}

/** How to orient components. */
export interface OrientOptions {
  /** Open components too, so that most of their area faces away from its centre. Default: false. */
  open?: boolean;
  /** Closed components inside of an odd number of others are cavities, and face inward. Default: false. */
  nested?: boolean;
}

/** Which components are too small: those that fall short in one of these. */
export interface DropOptions {
  /** The fewest faces that a component may have. */
  faces?: number;
  /** The least share of the area of the largest component, from 0 to 1. */
  area?: number;
  /** The least share of the longest diagonal of the box of a component, from 0 to 1. */
  diagonal?: number;
}

/** What counts as degenerate. */
export interface DegenerateOptions {
  /** Edges no longer than this are collapsed, and faces no wider removed. Default: 0. */
  tolerance?: number;
}

/** Which holes to fill. */
export interface FillOptions {
  /** Boundary loops with more edges are left. Default: Infinity. */
  maxEdges?: number;
  /**
   * In degrees, between the normals of neighbours: what can only be filled with a sharper fold is left, such
   * as the outline of a flat sheet. Default: 160; 180 fills it too.
   */
  maxAngle?: number;
}

/**
 * Repairs of a mesh that is there. Each does all that it can, and reports the rest. A mesh that is valid at
 * level 4 stays so; live items keep their indices; each repair is one step of history.
 *
 * The only error is `out-of-memory`: a part may have been done then, and can be undone.
 */
export abstract class Mending extends Modelling {
  /**
   * Glues boundary edges that lie together, end to end, and run opposite ways: closes cracks, and joins the
   * triangles of a soup. Vertices are joined where their edges are, not where they merely touch. The vertices
   * of the edge with the lower index stay where they are.
   *
   * Left are edges that several others fit (`ambiguous-edge`), those that run the same way
   * (`opposite-orientation`), and what no valid mesh allows (`unstitchable-edge`). Pinched vertices are in
   * the way: {@link splitPinchedVertices} first.
   *
   * @returns `edges`: those that were glued
   */
  stitchBoundaries(options: StitchOptions = {}): MendReport {
    const { tolerance = 0 } = checkOptions(options) as StitchOptions;
    checkFrom0('options.tolerance', tolerance);
    return mend(this, REPAIRS.stitch, tolerance);
  }

  /**
   * Gives each fan of faces at a pinched vertex a vertex of its own: one keeps the vertex, others get copies
   * with its position and attributes.
   *
   * @returns `vertices`: the copies
   */
  splitPinchedVertices(): MendReport {
    return mend(this, REPAIRS.splitPinched);
  }

  /**
   * Turns components over so that their faces, counter-clockwise, are seen from outside: the volume of each
   * closed component becomes positive. What is open (`open-component`), or has next to no volume
   * (`flat-component`), is left.
   *
   * @returns `faces`: those that were turned over
   */
  orientOutward(options: OrientOptions = {}): MendReport {
    const { open = false, nested = false } = checkOptions(options) as OrientOptions;
    checkFlag('options.open', open);
    checkFlag('options.nested', nested);
    return mend(this, REPAIRS.orient, Number(open), Number(nested));
  }

  /**
   * Deletes components that are too small by one of the options. Isolated vertices stay.
   *
   * @returns `faces`: those that were deleted
   */
  dropSmallComponents(options: DropOptions): MendReport {
    void linksOf(this).address; // throws if the mesh is disposed, before anything is said of options
    const { faces = 0, area = 0, diagonal = 0 } = checkOptions(options) as DropOptions;
    checkFrom0('options.faces', faces);
    checkShare('options.area', area);
    checkShare('options.diagonal', diagonal);
    return mend(this, REPAIRS.dropSmall, upTo32Bits(faces), area, diagonal);
  }

  /**
   * Removes faces without area, and edges without length, so that the surface stays where it is. Short edges
   * are collapsed. Of a triangle whose corner lies on its opposite side, that side is flipped; beside a larger
   * face it is removed; on the boundary the triangle is deleted. Faces are taken to have no area if they are
   * so narrow that the rounding of positions may turn them over (10^-6 of their length).
   *
   * What would break the mesh, or turn another face over, is left (`zero-length-edge`, `degenerate-face`).
   *
   * @returns `vertices`: those that edges were collapsed into; `edges`: those that were flipped; `faces`: those
   * that gained a corner
   */
  removeDegenerateFaces(options: DegenerateOptions = {}): MendReport {
    const { tolerance = 0 } = checkOptions(options) as DegenerateOptions;
    checkFrom0('options.tolerance', tolerance);
    return mend(this, REPAIRS.removeDegenerate, tolerance);
  }

  /**
   * Fills boundary loops with triangles, without new vertices, so that they fold as little as can be against
   * each other and the faces around. New faces have default attributes.
   *
   * Left are loops with more edges than asked for (`large-hole`), those whose filling would fold over
   * (`folding-hole`), and those where each triangulation found joins vertices that are joined already
   * (`unfillable-hole`). Up to 200 edges the triangulation is the best of all, O(n^3); above, a good one.
   *
   * @returns `faces`: the new ones
   */
  fillHoles(options: FillOptions = {}): MendReport {
    const { maxEdges = Number.POSITIVE_INFINITY, maxAngle = 160 } = checkOptions(
      options,
    ) as FillOptions;
    checkFrom0('options.maxEdges', maxEdges);
    if (!(typeof maxAngle === 'number' && maxAngle >= 0 && maxAngle <= 180)) {
      refuse('options.maxAngle', maxAngle, 'a number of degrees from 0 to 180');
    }
    return mend(this, REPAIRS.fill, upTo32Bits(maxEdges), maxAngle);
  }
}

function mend(mesh: Mending, repair: number, a = 0, b = 0, c = 0): MendReport {
  const links = linksOf(mesh);
  const { core, address } = links;
  const raw = core.mend(address, modeOf(links), repair, a, b, c);
  links.update();
  const done = unwrap(raw);
  const [vertices, edges, faces] = take(core, done.vertices, done.edges, done.faces);
  return {
    counts: done.counts,
    problems: done.left.map((problem) => problemOf(problem, 'warning')),
    vertices,
    edges,
    faces,
    summary: done.summary,
  };
}

/** As the core takes it: no mesh has more. */
const upTo32Bits = (count: number) => Math.min(count, 2 ** 32 - 1);

/** Throws a sentence unless the option is a number from 0 on, which may be infinite. */
function checkFrom0(argument: string, value: unknown): void {
  if (typeof value === 'number' && value >= 0) return;
  refuse(argument, value, 'a number from 0');
}

function checkShare(argument: string, value: unknown): void {
  if (typeof value === 'number' && value >= 0 && value <= 1) return;
  refuse(argument, value, 'a number from 0 to 1');
}

function checkFlag(argument: string, value: unknown): void {
  if (typeof value === 'boolean') return;
  throw new TypeError(`${argument} is ${describe(value)}; expected true or false.`);
}

function refuse(argument: string, value: unknown, expected: string): never {
  const sentence = `${argument} is ${describe(value)}; expected ${expected}.`;
  throw typeof value === 'number' ? new RangeError(sentence) : new TypeError(sentence);
}
