import { refuse } from './checks.js';
import { Editing } from './editing.js';
import type { EdgeLike, FaceLike, ItemList, VertexLike } from './items.js';
import { type Links, listOfItems } from './links.js';
import { withInputs } from './memory.js';
import { linksOf } from './navigation.js';
import { checkObject, checkOptions, type OptionNames } from './options.js';
import { unwrap } from './reports.js';
import { type Rows, take, takeItems } from './rings.js';
import type { AppendMaps } from './transfer.js';

/** Some items of a mesh, in any order. */
export interface Items {
  readonly vertices?: ItemList<VertexLike> | undefined;
  readonly edges?: ItemList<EdgeLike> | undefined;
  readonly faces?: ItemList<FaceLike> | undefined;
}

const ITEMS: OptionNames<Items> = { vertices: true, edges: true, faces: true };

/** Some items of a mesh, each once, in ascending order. Can be passed wherever {@link Items} are expected. */
export interface ItemSet {
  readonly vertices: Uint32Array;
  readonly edges: Uint32Array;
  readonly faces: Uint32Array;
}

/** In the order of the enum Surroundings in C++. */
const SURROUNDINGS = ['star', 'closure', 'link'] as const;

/**
 * Queries about the kind of surface, and about the surroundings of items. Each is one call into WebAssembly.
 */
export abstract class Neighbourhoods extends Editing {
  /** Whether there is no boundary. True for a mesh without edges. */
  isClosed(): boolean {
    const { core, address } = linksOf(this);
    return core.isClosed(address);
  }

  /** Whether all faces have three corners. True for a mesh without faces. */
  isTriangleMesh(): boolean {
    const { core, address } = linksOf(this);
    return core.onlyTrianglesOrQuads(address, true);
  }

  /** Whether all faces have four corners. True for a mesh without faces. */
  isQuadMesh(): boolean {
    const { core, address } = linksOf(this);
    return core.onlyTrianglesOrQuads(address, false);
  }

  /**
   * All vertices up to `k` edges away from a vertex, or from the nearest of several. Row d has those at
   * distance d, and row 0 the given vertices; `items` has all of them. Rows end with the last that has
   * vertices, so `k` may be Infinity. Linear in what is visited, plus one bit for each vertex.
   *
   * ```ts
   * const { offsets, items } = mesh.kRing(v, 2); // items.subarray(offsets[2]): the second ring alone
   * ```
   */
  kRing(vertices: VertexLike | ItemList<VertexLike>, k: number): Rows {
    const links = linksOf(this);
    const { core } = links;
    if (typeof vertices === 'number') links.checkVertex(vertices, 'vertices');
    const list = listOfItems(
      links,
      'vertex',
      'vertices',
      typeof vertices === 'number' ? [vertices] : vertices,
    );
    const most = checkDistance(k);
    const { offsets, items } = withInputs(core, (inputs) => {
      const block = inputs.indices('vertices', list);
      return unwrap(core.kRing(links.address, block.address, block.count, most));
    });
    const [first, second] = take(core, offsets, items);
    return { offsets: first, items: second };
  }

  /**
   * The items, and all edges and faces that they lie on: for a vertex, its edges and faces; for an edge, its
   * faces.
   */
  star(items: Items): ItemSet {
    return surroundings(linksOf(this), 'star', items);
  }

  /** The items, and all their edges and vertices: the smallest complex that contains them. */
  closure(items: Items): ItemSet {
    return surroundings(linksOf(this), 'closure', items);
  }

  /**
   * The closure of the star, minus the star of the closure. For an interior vertex of a triangle mesh, that
   * is the ring of edges and vertices around it.
   */
  link(items: Items): ItemSet {
    return surroundings(linksOf(this), 'link', items);
  }
}

function surroundings(links: Links, which: (typeof SURROUNDINGS)[number], items: unknown): ItemSet {
  links.checkAlive();
  const { core } = links;
  const { vertices = [], edges = [], faces = [] } = listsOf(items);
  const lists = {
    vertices: listOfItems(links, 'vertex', 'items.vertices', vertices),
    edges: listOfItems(links, 'edge', 'items.edges', edges),
    faces: listOfItems(links, 'face', 'items.faces', faces),
  };
  const raw = withInputs(core, (inputs) => {
    inputs.hold(...Object.values(lists));
    const blocks = Object.entries(lists).flatMap(([name, list]) => {
      const { address, count } = inputs.indices(`items.${name}`, list);
      return [address, count];
    }) as [number, number, number, number, number, number];
    return unwrap(core.surroundings(links.address, SURROUNDINGS.indexOf(which), ...blocks));
  });
  return takeItems(core, raw);
}

/** What AppendMaps have, too: their halfedges are those of their edges. */
function listsOf(items: unknown): Items {
  const named = checkObject(items, 'items') as Partial<AppendMaps>;
  if (!named.halfedges || !named.edges) return checkOptions(named, ITEMS, 'items');
  const { halfedges, ...lists } = named;
  return checkOptions(lists, ITEMS, 'items');
}

/** `k` as the core takes it, which has no infinity, but no distance that is as large either. */
function checkDistance(k: unknown): number {
  if (typeof k === 'number' && k >= 0 && (Number.isInteger(k) || k === Infinity)) {
    return Math.min(k, 2 ** 32 - 1);
  }
  refuse('k', k, 'an integer from 0 on, or Infinity', 'number');
}
