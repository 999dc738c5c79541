import { STORAGE_OPTIONS, type StorageOptions, storesPrev } from './build.js';
import { checkFlag, indexOfChoice, refuse } from './checks.js';
import { Links } from './links.js';
import { core } from './loader.js';
import type { HalfedgeMesh } from './mesh.js';
import { Neighbourhoods } from './neighbourhoods.js';
import { checkOptions, type OptionNames } from './options.js';
import { unwrap } from './reports.js';

/** The static methods that make shapes; in the order of `polygons_of` in wasm/making_bindings.cpp. */
export const SHAPES = [
  'tetrahedron',
  'cube',
  'octahedron',
  'icosahedron',
  'dodecahedron',
  'prism',
  'cone',
  'cylinder',
  'grid',
  'torus',
  'uvSphere',
  'icoSphere',
] as const;

/** In the order of the enum Caps in C++. */
const CAPS = ['polygon', 'fan', 'open'] as const;

/**
 * What closes a round end: one polygon, triangles around a vertex in its middle, or nothing, which
 * leaves a boundary loop.
 */
export type Cap = (typeof CAPS)[number];

/** A shape with its corners on a sphere around the origin. */
export interface SphereOptions extends StorageOptions {
  /** Default: 1. */
  radius?: number | undefined;
}

/** A cube around the origin. */
export interface CubeOptions extends StorageOptions {
  /** The length of an edge. Default: 1. */
  size?: number | undefined;
}

/** A shape around the y axis, from -height / 2 to height / 2. */
export interface PrismOptions extends StorageOptions {
  /** Default: 1. */
  radius?: number | undefined;
  /** Default: 1. */
  height?: number | undefined;
}

/** A cone, as a {@link PrismOptions} whose upper end is the apex. */
export interface ConeOptions extends PrismOptions {
  /** Default: 'polygon'. */
  base?: Cap | undefined;
}

/** Whether what has four sides is cut in two. */
export interface QuadOptions extends StorageOptions {
  /** Default: false, which leaves quads. */
  triangles?: boolean | undefined;
}

/** A cylinder. */
export interface CylinderOptions extends PrismOptions, QuadOptions {
  /** Rows of faces one above the other. Default: 1. */
  rings?: number | undefined;
  /** Both ends. Default: 'polygon'. */
  caps?: Cap | undefined;
}

/** A sheet in the plane of x and y, around the origin. */
export interface GridOptions extends QuadOptions {
  /** Along x. Default: 1. */
  width?: number | undefined;
  /** Along y. Default: 1. */
  height?: number | undefined;
}

/** A torus around the z axis. */
export interface TorusOptions extends QuadOptions {
  /** From the centre to the middle of the tube. Default: 1. */
  radius?: number | undefined;
  /** The radius of the tube. Default: 0.4. */
  tube?: number | undefined;
}

/** A sphere of meridians and circles of latitude. */
export interface UvSphereOptions extends QuadOptions, SphereOptions {}

const SPHERE_OPTIONS: OptionNames<SphereOptions> = { ...STORAGE_OPTIONS, radius: true };
const CUBE_OPTIONS: OptionNames<CubeOptions> = { ...STORAGE_OPTIONS, size: true };
const PRISM_OPTIONS: OptionNames<PrismOptions> = { ...SPHERE_OPTIONS, height: true };
const CONE_OPTIONS: OptionNames<ConeOptions> = { ...PRISM_OPTIONS, base: true };
const QUAD_OPTIONS: OptionNames<QuadOptions> = { ...STORAGE_OPTIONS, triangles: true };
const CYLINDER_OPTIONS: OptionNames<CylinderOptions> = {
  ...PRISM_OPTIONS,
  ...QUAD_OPTIONS,
  rings: true,
  caps: true,
};
const GRID_OPTIONS: OptionNames<GridOptions> = { ...QUAD_OPTIONS, width: true, height: true };
const TORUS_OPTIONS: OptionNames<TorusOptions> = { ...QUAD_OPTIONS, radius: true, tube: true };
const UV_SPHERE_OPTIONS: OptionNames<UvSphereOptions> = { ...QUAD_OPTIONS, radius: true };

/** Makes a mesh of links: `HalfedgeMesh`, which is built on this class, says how. */
let meshOf: (links: Links) => HalfedgeMesh;
export function makeMeshesWith(make: typeof meshOf): void {
  meshOf = make;
}

/**
 * Shapes to begin with. All are centred on the origin and lie as those of three.js do: y is up, a
 * torus lies around z, a grid faces +z. Faces are counter-clockwise seen from outside. Numbers of
 * parts come first, lengths are options. All take `storePrev`, too.
 *
 * @throws RangeError or TypeError for a number of parts that is too small or no integer, and a
 * length that is not positive, or fits no 32-bit float; HalfedgeError `too-large`, `out-of-memory`
 */
export abstract class Shapes extends Neighbourhoods {
  /** 4 vertices, 6 edges, 4 triangles. */
  static tetrahedron(options: SphereOptions = {}): HalfedgeMesh {
    return solid('tetrahedron', options);
  }

  /** 8 vertices, 12 edges, 6 quads. Bits 0, 1, 2 of a vertex say on which side of x, y, z it is. */
  static cube(options: CubeOptions = {}): HalfedgeMesh {
    const { size = 1 } = checkOptions(options, CUBE_OPTIONS);
    return make('cube', options, { lengths: { size } });
  }

  /** 6 vertices, 12 edges, 8 triangles. */
  static octahedron(options: SphereOptions = {}): HalfedgeMesh {
    return solid('octahedron', options);
  }

  /** 12 vertices, 30 edges, 20 triangles. */
  static icosahedron(options: SphereOptions = {}): HalfedgeMesh {
    return solid('icosahedron', options);
  }

  /** 20 vertices, 30 edges, 12 pentagons. */
  static dodecahedron(options: SphereOptions = {}): HalfedgeMesh {
    return solid('dodecahedron', options);
  }

  /** n quads and two n-gons: 2n vertices, 3n edges, n + 2 faces. `sides` from 3 on. */
  static prism(sides = 6, options: PrismOptions = {}): HalfedgeMesh {
    const { radius = 1, height = 1 } = checkOptions(options, PRISM_OPTIONS);
    const parts = [count('sides', sides, 3)];
    return make('prism', options, { parts, lengths: { radius, height } });
  }

  /**
   * n triangles and a base: n + 1 vertices, 2n edges, n + 1 faces, with a polygon as the base;
   * `cone(4)` is a pyramid. The vertices of the base come first, then the apex. `segments` from 3 on.
   */
  static cone(segments = 32, options: ConeOptions = {}): HalfedgeMesh {
    const { radius = 1, height = 1, base } = checkOptions(options, CONE_OPTIONS);
    const parts = [count('segments', segments, 3)];
    return make('cone', options, { parts, lengths: { radius, height }, caps: cap('base', base) });
  }

  /**
   * `rings` times n quads, and what closes its ends. n (rings + 1) vertices, from the bottom to the
   * top; fans have their middles after that. `segments` from 3 on.
   */
  static cylinder(segments = 32, options: CylinderOptions = {}): HalfedgeMesh {
    const { radius = 1, height = 1, rings = 1, caps } = checkOptions(options, CYLINDER_OPTIONS);
    const parts = [count('segments', segments, 3), count('options.rings', rings, 1)];
    return make('cylinder', options, {
      parts,
      lengths: { radius, height },
      caps: cap('caps', caps),
    });
  }

  /**
   * A sheet with one boundary loop. Vertex `row * (columns + 1) + column`, quad `row * columns +
   * column`, from the lower left to the upper right; triangles have the diagonal in that direction.
   */
  static grid(columns = 10, rows = columns, options: GridOptions = {}): HalfedgeMesh {
    const { width = 1, height = 1 } = checkOptions(options, GRID_OPTIONS);
    const parts = [count('columns', columns, 1), count('rows', rows, 1)];
    return make('grid', options, { parts, lengths: { width, height } });
  }

  /**
   * `rings` circles of `sides` vertices each, as many quads, twice as many edges; genus 1. Both from 3
   * on.
   */
  static torus(rings = 32, sides = 16, options: TorusOptions = {}): HalfedgeMesh {
    const { radius = 1, tube = 0.4 } = checkOptions(options, TORUS_OPTIONS);
    const parts = [count('rings', rings, 3), count('sides', sides, 3)];
    const outer = length('options.radius', radius) + length('options.tube', tube);
    length('options.radius + options.tube', outer);
    return make('torus', options, { parts, lengths: { radius, tube } });
  }

  /**
   * n `segments` around and `rings` from pole to pole: n (rings - 1) + 2 vertices, n · rings faces, of
   * which those at the poles are triangles. `segments` from 3 on, `rings` from 2 on.
   */
  static uvSphere(segments = 32, rings = 16, options: UvSphereOptions = {}): HalfedgeMesh {
    const { radius = 1 } = checkOptions(options, UV_SPHERE_OPTIONS);
    const parts = [count('segments', segments, 3), count('rings', rings, 2)];
    return make('uvSphere', options, { parts, lengths: { radius } });
  }

  /**
   * An icosahedron whose triangles are cut in four `subdivisions` times, q = 4^subdivisions: 10 q + 2
   * vertices, 30 q edges, 20 q triangles, nearly all valences 6.
   */
  static icoSphere(subdivisions = 3, options: SphereOptions = {}): HalfedgeMesh {
    const { radius = 1 } = checkOptions(options, SPHERE_OPTIONS);
    const parts = [count('subdivisions', subdivisions, 0)];
    return make('icoSphere', options, { parts, lengths: { radius } });
  }
}

function solid(shape: (typeof SHAPES)[number], options: SphereOptions): HalfedgeMesh {
  const { radius = 1 } = checkOptions(options, SPHERE_OPTIONS);
  return make(shape, options, { lengths: { radius } });
}

interface Parameters {
  parts?: number[];
  /** By the names that they have as options. */
  lengths: Record<string, number>;
  caps?: number;
}

function make(
  shape: (typeof SHAPES)[number],
  options: StorageOptions & QuadOptions,
  { parts: [a = 0, b = 0] = [], lengths, caps = 0 }: Parameters,
): HalfedgeMesh {
  const withPrev = storesPrev(options);
  const faces = trianglesAsked(options) ? 1 : 0;
  const [x, y = 1] = Object.entries(lengths).map(([name, value]) =>
    length(`options.${name}`, value),
  );
  const wasm = core();
  const raw = wasm.shape(SHAPES.indexOf(shape), a, b, x, y, faces, caps, withPrev);
  return meshOf(new Links(wasm, unwrap(raw).mesh));
}

function count(argument: string, value: unknown, least: number): number {
  const isCount = Number.isInteger(value) && (value as number) >= least;
  if (isCount && (value as number) < 2 ** 31) return value as number;
  const range = isCount ? `to ${2 ** 31 - 1}` : 'on';
  refuse(argument, value, `an integer from ${least} ${range}`, 'number');
}

/** The largest number that a 32-bit float holds. */
const LARGEST_FLOAT = (2 - 2 ** -23) * 2 ** 127;

function length(argument: string, value: unknown): number {
  if (typeof value === 'number' && Math.fround(value) > 0 && value <= LARGEST_FLOAT) return value;
  refuse(argument, value, 'a positive number that fits a 32-bit float', 'number');
}

function cap(option: string, value: unknown = 'polygon'): number {
  return indexOfChoice(`options.${option}`, value, CAPS);
}

function trianglesAsked({ triangles = false }: QuadOptions): boolean {
  checkFlag('options.triangles', triangles);
  return triangles;
}
