import { checkFlag, refuse } from './checks.js';
import { modeOf } from './edit.js';
import type { Problem } from './errors.js';
import { Modelling } from './modelling.js';
import { linksOf } from './navigation.js';
import { checkOptions, type OptionNames } from './options.js';
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
  readonly problems: readonly Required<Problem>[];
  /** The items that were touched or made: each repair says which. */
  readonly vertices: Uint32Array;
  readonly edges: Uint32Array;
  readonly faces: Uint32Array;
  /** All of it in one readable line. */
  readonly summary: string;
}

/** How to stitch boundaries. */
export interface StitchOptions {
  /**
   * In the unit of positions: vertices closer than this count as one. Default: 0, those at the same position.
   */
  tolerance?: number | undefined;
}

/** How to orient components. */
export interface OrientOptions {
  /** Open components too, so that most of their area faces away from its centre. Default: false. */
  open?: boolean | undefined;
  /** Closed components inside of an odd number of others are cavities, and face inward. Default: false. */
  nested?: boolean | undefined;
}

/** Which components are too small: those that fall short in one of these. */
export interface DropOptions {
  /** The fewest faces that a component may have: an integer, or Infinity. */
  faces?: number | undefined;
  /** The least share of the area of the largest component, from 0 to 1. */
  area?: number | undefined;
  /** The least share of the longest diagonal of the box of a component, from 0 to 1. */
  diagonal?: number | undefined;
}

/** What counts as degenerate. */
export interface DegenerateOptions {
  /**
   * In the unit of positions: edges no longer than this are collapsed, and faces no wider removed. Default: 0,
   * which leaves the surface where it is.
   */
  tolerance?: number | undefined;
}

/** Which holes to fill. */
export interface FillOptions {
  /** Boundary loops with more edges are left: an integer, or Infinity, which is the default. */
  maxEdges?: number | undefined;
  /**
   * In degrees, between the normals of neighbours: what can only be filled with a sharper fold is left, such
   * as the outline of a flat sheet. Default: 160; 180 fills it too.
   */
  maxAngle?: number | undefined;
}

const STITCH_OPTIONS: OptionNames<StitchOptions> = { tolerance: true };
const ORIENT_OPTIONS: OptionNames<OrientOptions> = { open: true, nested: true };
const DROP_OPTIONS: OptionNames<DropOptions> = { faces: true, area: true, diagonal: true };
const DEGENERATE_OPTIONS: OptionNames<DegenerateOptions> = { tolerance: true };
const FILL_OPTIONS: OptionNames<FillOptions> = { maxEdges: true, maxAngle: true };

/**
 * Repairs of a mesh that is there. Each does all that it can, and reports the rest. A mesh that is valid at
 * level 4 stays so; live items keep their indices; each repair is one step of history.
 *
 * Beside wrong arguments (a TypeError or a RangeError) and a mesh that is `disposed`, the only error is
 * `out-of-memory`, and of {@link removeDegenerateFaces} `corrupt-connectivity`. Without room for the work a part may have been done then, which is a step of history as
 * long as that finds room; without room in JavaScript for the report, all was done.
 */
export abstract class Mending extends Modelling {
  /**
   * Glues boundary edges that lie together, end to end, and run opposite ways: closes cracks, and joins the
   * triangles of a soup. Vertices are joined where their edges are, not where they merely touch; those stay
   * that are reached first, from face to face, with position and attributes.
   *
   * Of more than two edges that lie together those are glued that close a gap at a vertex, and the two that are
   * left of four. Left are the others (`ambiguous-edge`), those that run the same way
   * (`opposite-orientation`), and what no valid mesh allows (`unstitchable-edge`). Pinched vertices are in
   * the way: {@link splitPinchedVertices} first. O(n log n) of n boundary edges, and the valences of the
   * vertices that go.
   *
   * @returns `edges`: those that were glued, and stay
   * @throws HalfedgeError `out-of-memory`, `disposed`
   */
  stitchBoundaries(options: StitchOptions = {}): MendReport {
    linksOf(this).checkAlive();
    const { tolerance = 0 } = checkOptions(options, STITCH_OPTIONS);
    checkFrom0('options.tolerance', tolerance);
    return mend(this, REPAIRS.stitch, tolerance);
  }

  /**
   * Gives each fan of faces at a pinched vertex a vertex of its own: one keeps the vertex, others get copies
   * with its position and attributes. O(halfedges).
   *
   * @returns `vertices`: the copies
   * @throws HalfedgeError `out-of-memory`, `disposed`
   */
  splitPinchedVertices(): MendReport {
    return mend(this, REPAIRS.splitPinched);
  }

  /**
   * Turns components over so that their faces, counter-clockwise, are seen from outside: the volume of each
   * closed component becomes positive, but that of cavities with `nested`. What is open (`open-component`;
   * not with `open`), or has next to no volume (`flat-component`), is left. O(slots), nearly; with `nested` besides, for each component whose box lies in
   * that of another, three times the faces of the other, and up to sixteen times where the two touch.
   *
   * @returns `faces`: those that were turned over
   * @throws HalfedgeError `out-of-memory`, `disposed`
   */
  orientOutward(options: OrientOptions = {}): MendReport {
    linksOf(this).checkAlive();
    const { open = false, nested = false } = checkOptions(options, ORIENT_OPTIONS);
    checkFlag('options.open', open);
    checkFlag('options.nested', nested);
    return mend(this, REPAIRS.orient, Number(open), Number(nested));
  }

  /**
   * Deletes components that are too small by one of the options. Isolated vertices stay. O(slots), nearly.
   *
   * @returns `faces`: those that were deleted
   * @throws HalfedgeError `out-of-memory`, `disposed`
   */
  dropSmallComponents(options: DropOptions): MendReport {
    linksOf(this).checkAlive();
    const { faces = 0, area = 0, diagonal = 0 } = checkOptions(options, DROP_OPTIONS);
    checkItems('options.faces', faces);
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
   * O(slots), what `validate` costs, and what the operations cost.
   *
   * @returns `vertices`: those that edges were collapsed into; `edges`: those that were flipped; `faces`: those
   * that gained a corner
   * @throws HalfedgeError `corrupt-connectivity` if the mesh isn't valid at level 4; `out-of-memory`, `disposed`
   */
  removeDegenerateFaces(options: DegenerateOptions = {}): MendReport {
    linksOf(this).checkAlive();
    const { tolerance = 0 } = checkOptions(options, DEGENERATE_OPTIONS);
    checkFrom0('options.tolerance', tolerance);
    return mend(this, REPAIRS.removeDegenerate, tolerance);
  }

  /**
   * Fills boundary loops with triangles, without new vertices, so that they fold little against each other and
   * the faces around. New faces and edges have default attributes; corners have what the boundary had.
   *
   * Left are loops with more edges than asked for (`large-hole`), those whose filling would fold over
   * (`folding-hole`), and those where each triangulation found joins vertices that are joined already
   * (`unfillable-hole`). Up to 200 edges all triangulations are compared, by dynamic programming, in O(n^3):
   * the largest fold is the smallest but for steps of 30 degrees, and then diagonals are short. Above, it is a
   * good one, in about O(n log n) and the valences. Each loop is looked at once: what is filled later beside one
   * that is left may lead the search another way, so that, rarely, a second call fills it.
   *
   * @returns `faces`: the new ones
   * @throws HalfedgeError `out-of-memory`, `disposed`
   */
  fillHoles(options: FillOptions = {}): MendReport {
    linksOf(this).checkAlive();
    const { maxEdges = Number.POSITIVE_INFINITY, maxAngle = 160 } = checkOptions(
      options,
      FILL_OPTIONS,
    );
    checkItems('options.maxEdges', maxEdges);
    if (!(typeof maxAngle === 'number' && maxAngle >= 0 && maxAngle <= 180)) {
      refuse('options.maxAngle', maxAngle, 'a number of degrees from 0 to 180', 'number');
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

/** Throws unless it is a finite number from 0 on. */
function checkFrom0(argument: string, value: unknown): void {
  if (!(Number.isFinite(value) && (value as number) >= 0))
    refuse(argument, value, 'a finite number from 0', 'number');
}

/** Throws unless it is a number of items, or Infinity for all. */
function checkItems(argument: string, value: unknown): void {
  const isCount = value === Number.POSITIVE_INFINITY || Number.isInteger(value);
  if (!(isCount && (value as number) >= 0)) {
    refuse(argument, value, 'an integer from 0, or Infinity', 'number');
  }
}

function checkShare(argument: string, value: unknown): void {
  if (typeof value === 'number' && value >= 0 && value <= 1) return;
  refuse(argument, value, 'a number from 0 to 1', 'number');
}
