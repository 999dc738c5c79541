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

/** What a repair of a mesh did, followed by what it had to leave. */
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

/** What a repair of a mesh has done, and what it could not do. */
export interface MendReport {
  /** How many items there are with each code. */
  readonly counts: Readonly<Partial<Record<MendCode, number>>>;
  /** What could not be done, and why, each in a sentence; at most 100 of each code. */
  readonly problems: readonly Required<Problem>[];
  /** The items that were touched or made; each repair says which. */
  readonly vertices: Uint32Array;
  readonly edges: Uint32Array;
  readonly faces: Uint32Array;
  /** All of it in one readable line. */
  readonly summary: string;
}

/** How to stitch boundaries. */
export interface StitchOptions {
  /**
   * Vertices closer than this count as one, in the unit of positions. Default: 0, those at the same position.
   */
  tolerance?: number | undefined;
}

/** How to orient components. */
export interface OrientOptions {
  /**
   * Whether to turn open components too, so that most of their area faces away from its centre. Default:
   * false.
   */
  open?: boolean | undefined;
  /**
   * Whether closed components inside an odd number of others are cavities, and face inward. Default: false.
   */
  nested?: boolean | undefined;
}

/** Which components are too small: those that fall short of any of these. */
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
   * Edges no longer than this are collapsed, and faces no wider than this removed, in the unit of positions.
   * Default: 0, which leaves the surface where it is.
   */
  tolerance?: number | undefined;
}

/** Which holes to fill. */
export interface FillOptions {
  /** Boundary loops with more edges are left alone: an integer, or Infinity, the default. */
  maxEdges?: number | undefined;
  /**
   * The largest angle between the normals of neighbours, in degrees. A loop that can only be filled with a
   * sharper fold is left alone, such as the outline of a flat sheet. Default: 160; 180 fills that too.
   */
  maxAngle?: number | undefined;
}

const STITCH_OPTIONS: OptionNames<StitchOptions> = { tolerance: true };
const ORIENT_OPTIONS: OptionNames<OrientOptions> = { open: true, nested: true };
const DROP_OPTIONS: OptionNames<DropOptions> = { faces: true, area: true, diagonal: true };
const DEGENERATE_OPTIONS: OptionNames<DegenerateOptions> = { tolerance: true };
const FILL_OPTIONS: OptionNames<FillOptions> = { maxEdges: true, maxAngle: true };

/**
 * Repairs of an existing mesh. Each does all that it can, and reports the rest. A mesh that is valid at level
 * 4 stays valid; live items keep their indices; each repair is one step of history.
 *
 * Apart from wrong arguments (a TypeError or a RangeError) and a mesh that is `disposed`, the only errors are
 * `out-of-memory` and, from {@link removeDegenerateFaces}, `corrupt-connectivity`. If there was no memory for
 * the work, part of it may have been done; that is a step of history, as long as history finds memory. If
 * there was no memory in JavaScript for the report, everything was done.
 */
export abstract class Mending extends Modelling {
  /**
   * Glues boundary edges that lie together, end to end, and run opposite ways. This closes cracks, and joins
   * the triangles of a soup. Vertices are joined if their edges are, not if they merely touch. The vertices
   * that are reached first, from face to face, stay, with position and attributes.
   *
   * If more than two edges lie together, those that close a gap at a vertex are glued, and so are the last
   * two of four. The rest are left (`ambiguous-edge`), as are edges that run the same way
   * (`opposite-orientation`) and those that no valid mesh allows to be glued (`unstitchable-edge`). Pinched
   * vertices are in the way: call {@link splitPinchedVertices} first. O(n log n) of n boundary edges, and the
   * valences of the vertices that go.
   *
   * @returns `edges`: those that were glued and have stayed
   * @throws HalfedgeError `out-of-memory`, `disposed`
   */
  stitchBoundaries(options: StitchOptions = {}): MendReport {
    linksOf(this).checkAlive();
    const { tolerance = 0 } = checkOptions(options, STITCH_OPTIONS);
    checkFrom0('options.tolerance', tolerance);
    return mend(this, REPAIRS.stitch, tolerance);
  }

  /**
   * Gives each fan of faces at a pinched vertex a vertex of its own. One fan keeps the vertex; the others get
   * copies with its position and attributes. O(halfedges).
   *
   * @returns `vertices`: the copies
   * @throws HalfedgeError `out-of-memory`, `disposed`
   */
  splitPinchedVertices(): MendReport {
    return mend(this, REPAIRS.splitPinched);
  }

  /**
   * Turns components over so that their faces run counter-clockwise as seen from outside: the volume of each
   * closed component becomes positive, except that of cavities with `nested`. Open components
   * (`open-component`; unless `open` is set) and components with next to no volume (`flat-component`) are
   * left. Almost O(slots). With `nested`, in addition, for each component whose box lies in that of another,
   * three times the faces of the other, and up to sixteen times if the two touch.
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
   * Deletes components that are too small by any of the options. Isolated vertices stay. O(slots), nearly.
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
   * Removes faces of zero area and edges of zero length, so that the surface stays where it is. Short edges
   * are collapsed. If a corner of a triangle lies on its opposite side, that side is flipped; if the side
   * borders a larger face, it is removed; if it is on the boundary, the triangle is deleted. A face counts as
   * having no area if it is so narrow that rounding its positions may turn it over (10^-6 of its length).
   *
   * Whatever would break the mesh or turn another face over is left (`zero-length-edge`, `degenerate-face`).
   * O(slots), plus the cost of `validate` and of the operations.
   *
   * @returns `vertices`: those into which edges were collapsed; `edges`: those that were flipped; `faces`:
   * those that gained a corner
   * @throws HalfedgeError `corrupt-connectivity` if the mesh isn't valid at level 4; `out-of-memory`,
   * `disposed`
   */
  removeDegenerateFaces(options: DegenerateOptions = {}): MendReport {
    linksOf(this).checkAlive();
    const { tolerance = 0 } = checkOptions(options, DEGENERATE_OPTIONS);
    checkFrom0('options.tolerance', tolerance);
    return mend(this, REPAIRS.removeDegenerate, tolerance);
  }

  /**
   * Fills boundary loops with triangles, without new vertices, so that they fold little against each other
   * and the faces around. New faces and edges have default attributes; corners get those of the
   * boundary halfedges, which in a mesh from a file are those of the faces beside the hole.
   *
   * Three kinds of loops are left: those with more edges than allowed (`large-hole`), those whose filling
   * would fold over (`folding-hole`), and those for which each triangulation found joins vertices that are
   * joined already (`unfillable-hole`). Up to 200 edges, triangulations are compared by dynamic programming,
   * in O(n^3): the largest fold is kept small, in steps of 30 degrees, and then diagonals short. Above that,
   * the triangulation is a good one, in about O(n log n) and the valences.
   *
   * @returns `faces`: the new ones
   * @throws HalfedgeError `out-of-memory`, `disposed`
   */
  fillHoles(options: FillOptions = {}): MendReport {
    linksOf(this).checkAlive();
    const { maxEdges = Infinity, maxAngle = 160 } = checkOptions(options, FILL_OPTIONS);
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
  const isCount = value === Infinity || Number.isInteger(value);
  if (!(isCount && (value as number) >= 0)) {
    refuse(argument, value, 'an integer from 0, or Infinity', 'number');
  }
}

function checkShare(argument: string, value: unknown): void {
  if (typeof value === 'number' && value >= 0 && value <= 1) return;
  refuse(argument, value, 'a number from 0 to 1', 'number');
}
