import { checkCount, checkFlag, indexOfChoice } from './checks.js';
import {
  answer,
  CHECK_ONLY,
  checkGivenPosition,
  checkPosition,
  done,
  kindIndex,
  modeOf,
  OPTION,
  type Position,
  type Refusal,
  withList,
} from './edit.js';
import { Geometry } from './geometry.js';
import { checkNoGroup } from './history.js';
import type {
  EdgeLike,
  Face,
  FaceLike,
  Halfedge,
  ItemKind,
  ItemLike,
  ItemList,
  Vertex,
  VertexLike,
} from './items.js';
import { checkItem } from './links.js';
import { linksOf } from './navigation.js';
import { checkOptions, type OptionNames } from './options.js';
import { unwrap } from './reports.js';
import { takeMaps } from './transfer.js';

/** What is kept by a deletion. */
export interface DeleteOptions {
  /** Whether to keep vertices that have no edge any more. Default: false, they are deleted too. */
  keepIsolatedVertices?: boolean | undefined;
}

const DELETE_OPTIONS: OptionNames<DeleteOptions> = { keepIsolatedVertices: true };

/** In the order of the core: see `reorder`. */
const VERTEX_ORDERS = ['morton', 'breadth-first'] as const;
/** How `reorder()` numbers vertices: along a space-filling curve, or by breadth-first search over edges. */
export type VertexOrder = (typeof VERTEX_ORDERS)[number];

/** Where `compact()` and `reorder()` moved items: the new index by old index, -1 if the item was deleted. */
export interface CompactMaps {
  readonly vertices: Int32Array;
  readonly halfedges: Int32Array;
  readonly edges: Int32Array;
  readonly faces: Int32Array;
}

/**
 * Adds, moves and deletes single items. A valid mesh stays valid.
 *
 * What is impossible is refused, and then nothing has changed: the operation throws a HalfedgeError with a
 * code, a sentence, and a `witness`: the items that make it impossible. To ask in advance, call `check` plus
 * the name of the operation, if there is such a method; it returns null or the refusal. For wrong arguments
 * (an index that is out of range or deleted, an invalid position) both throw a RangeError or a TypeError.
 * Every operation may also throw `out-of-memory`.
 *
 * Live items keep their indices. New items use deleted slots first, and have defined positions and
 * attributes: the documentation of each operation says which. Each edit invalidates circulators, orbits and
 * lists of items: ask for new ones.
 */
export abstract class Construction extends Geometry {
  /** Adds an isolated vertex, by default at the origin, with default attributes. Amortised O(1). */
  addVertex(position?: Position): Vertex {
    const links = linksOf(this);
    links.checkAlive();
    const p = checkPosition(position);
    return done(
      links,
      links.core._add_vertex(links.address, modeOf(links), p[0], p[1], p[2]),
    ) as Vertex;
  }

  /** Why {@link addVertex} would be refused: never, so null. */
  checkAddVertex(position?: Position): Refusal | null {
    linksOf(this).checkAlive();
    checkPosition(position);
    return null;
  }

  /** A copy of the position of `v`: x, y, z. */
  position(v: VertexLike): [x: number, y: number, z: number] {
    const links = linksOf(this);
    links.checkVertex(v);
    const { positions } = links;
    return [positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]];
  }

  /** Moves `v`, like writing to `positions`, except that history records it. Connectivity doesn't change. */
  setPosition(v: VertexLike, position: Position): void {
    const links = linksOf(this);
    links.checkVertex(v);
    const p = checkGivenPosition(position);
    done(links, links.core._set_position(links.address, modeOf(links), v, p[0], p[1], p[2]));
  }

  /**
   * Adds a face with these corners, counter-clockwise, and the edges between them that don't exist yet. If a
   * set of faces forms a valid mesh, you can add them in any order and get the same mesh. The face and new
   * edges have default attributes.
   *
   * Amortised O(number of corners), plus the smaller valence of the two ends of each side, plus O(valence)
   * for each corner with several fans of faces. So if you add many faces around one vertex, add them in
   * order.
   *
   * Inverse: `deleteFace`, keeping isolated vertices, up to the order of fans around pinched vertices.
   *
   * @throws HalfedgeError `degree-below-three`, `repeated-vertex`, `duplicate-face`, `edge-with-many-faces`,
   * `opposite-orientation` (a neighbour runs along an edge in the same direction), `pinched-vertex` (some
   * faces around a vertex form, or would form, a closed fan, and the vertex has others besides)
   */
  addFace(vertices: ItemList<VertexLike>): Face {
    const links = linksOf(this);
    const add = (address: number, count: number) =>
      links.core._add_face(links.address, modeOf(links), address, count);
    return done(links, withList(links, 'vertices', vertices, 'vertex', add)) as Face;
  }

  /** Why {@link addFace} would be refused, or null. */
  checkAddFace(vertices: ItemList<VertexLike>): Refusal | null {
    const links = linksOf(this);
    const check = (address: number, count: number) =>
      links.core._add_face(links.address, CHECK_ONLY, address, count);
    return answer(links, withList(links, 'vertices', vertices, 'vertex', check));
  }

  /**
   * Deletes a vertex with the faces and edges around it, and those of their vertices that are left without an
   * edge. O(sum of the valences around it).
   *
   * Inverse: none; undo.
   *
   * @throws HalfedgeError `same-loop` (one of the faces lies on both sides of an edge, as in a segment)
   */
  deleteVertex(v: VertexLike, options?: DeleteOptions): void {
    const links = linksOf(this);
    links.checkAlive();
    const kept = deletion(options); // whose getters may do anything to the mesh
    links.checkVertex(v);
    done(links, links.core._delete_vertex(links.address, modeOf(links) | kept, v));
  }

  /** Why {@link deleteVertex} would be refused, or null. */
  checkDeleteVertex(v: VertexLike, options?: DeleteOptions): Refusal | null {
    const links = linksOf(this);
    links.checkAlive();
    deletion(options);
    links.checkVertex(v);
    return answer(links, links.core._delete_vertex(links.address, CHECK_ONLY, v));
  }

  /**
   * Deletes the one or two faces of an edge, and so the edge itself; see {@link deleteFace}.
   *
   * Inverse: `addFace`, where vertices were kept, up to the order of fans around pinched vertices.
   *
   * @throws HalfedgeError that of {@link deleteFace}
   */
  deleteEdge(e: EdgeLike, options?: DeleteOptions): void {
    const links = linksOf(this);
    links.checkAlive();
    const kept = deletion(options); // whose getters may do anything to the mesh
    links.checkEdge(e);
    done(links, links.core._delete_edge(links.address, modeOf(links) | kept, e));
  }

  /** Why {@link deleteEdge} would be refused, or null. */
  checkDeleteEdge(e: EdgeLike, options?: DeleteOptions): Refusal | null {
    const links = linksOf(this);
    links.checkAlive();
    deletion(options);
    links.checkEdge(e);
    return answer(links, links.core._delete_edge(links.address, CHECK_ONLY, e));
  }

  /**
   * Deletes a face, those of its edges that have no other face, and those of its vertices that have no other
   * edge. If the remaining faces touch only in a vertex, that vertex becomes pinched. To keep all edges, use
   * `makeHole`. O(sum of the valences of the corners).
   *
   * Inverse: `addFace`, where vertices were kept, up to the order of fans around pinched vertices.
   *
   * @throws HalfedgeError `same-loop` (it lies on both sides of an edge, as in a segment)
   */
  deleteFace(f: FaceLike, options?: DeleteOptions): void {
    const links = linksOf(this);
    links.checkAlive();
    const kept = deletion(options); // whose getters may do anything to the mesh
    links.checkFace(f);
    done(links, links.core._delete_face(links.address, modeOf(links) | kept, f));
  }

  /** Why {@link deleteFace} would be refused, or null. */
  checkDeleteFace(f: FaceLike, options?: DeleteOptions): Refusal | null {
    const links = linksOf(this);
    links.checkAlive();
    deletion(options);
    links.checkFace(f);
    return answer(links, links.core._delete_face(links.address, CHECK_ONLY, f));
  }

  /** Deletes all vertices without an edge, and returns how many. O(vertices). */
  deleteIsolatedVertices(): number {
    const links = linksOf(this);
    return done(links, links.core._delete_isolated_vertices(links.address, modeOf(links)));
  }

  /** Why {@link deleteIsolatedVertices} would be refused: never, so null. */
  checkDeleteIsolatedVertices(): Refusal | null {
    linksOf(this).checkAlive();
    return null;
  }

  /**
   * Deletes the connected component of an item: all that is reached from it over edges, also through
   * pinched vertices.
   *
   * @returns the number of faces deleted
   */
  deleteComponent<Kind extends ItemKind>(kind: Kind, item: ItemLike<Kind>): number {
    const links = linksOf(this);
    links.checkAlive();
    const i = kindIndex(kind);
    checkItem(links, kind, item);
    return done(links, links.core._delete_component(links.address, modeOf(links), i, item));
  }

  /** Why {@link deleteComponent} would be refused: never, so null. */
  checkDeleteComponent<Kind extends ItemKind>(kind: Kind, item: ItemLike<Kind>): Refusal | null {
    const links = linksOf(this);
    links.checkAlive();
    kindIndex(kind);
    checkItem(links, kind, item);
    return null;
  }

  /**
   * Deletes all components but the `count` largest, by their numbers of vertices, and all isolated vertices.
   *
   * @returns the number of components deleted, not counting isolated vertices
   */
  keepLargestComponents(count = 1): number {
    const links = linksOf(this);
    links.checkAlive();
    checkCount('count', count);
    const { core, address } = links;
    return done(links, core._keep_largest_components(address, modeOf(links), count));
  }

  /** Why {@link keepLargestComponents} would be refused: never, so null. */
  checkKeepLargestComponents(count = 1): Refusal | null {
    linksOf(this).checkAlive();
    checkCount('count', count);
    return null;
  }

  /**
   * Closes the gaps that deletions have left, so that there are as many slots as items. Items keep their
   * order. History records all links, positions and attributes, so this step costs more than others; if there
   * are no gaps, there is no step. O(slots).
   *
   * @returns where each item went
   */
  compact(): CompactMaps {
    const links = linksOf(this);
    const { core, address } = links;
    const raw = core.compact(address, modeOf(links));
    links.update();
    return takeMaps(core, unwrap(raw));
  }

  /** Why {@link compact} would be refused: never, so null. */
  checkCompact(): Refusal | null {
    linksOf(this).checkAlive();
    return null;
  }

  /**
   * Renumbers all items so that items that are close together in space are also close together in memory. A
   * mesh whose vertices or faces were in random order is read several times as fast afterwards. Edges are
   * ordered by the smaller of their faces, faces by the smallest of their vertices, and vertices
   *
   * - `'morton'`: along a Morton curve (Z-order) through their positions;
   * - `'breadth-first'`: by a breadth-first search over the edges, for meshes without meaningful positions.
   *
   * Items for which that is the same stay in their order. Edges without a face come last; in a mesh without
   * faces, edges are ordered by the smaller of their vertices.
   *
   * It stays the same mesh: edges keep their sides, vertices and faces keep the halfedge that they store, and
   * all items keep their attributes. As with {@link compact}, gaps are closed and history records everything.
   * A mesh that is in this order already isn't changed. O(slots).
   *
   * @returns where each item went
   */
  reorder(order: VertexOrder = 'morton'): CompactMaps {
    const links = linksOf(this);
    links.checkAlive();
    const choice = indexOfChoice('order', order, VERTEX_ORDERS);
    const { core, address } = links;
    const raw = core.reorder(address, modeOf(links), choice);
    links.update();
    return takeMaps(core, unwrap(raw));
  }

  /** Why {@link reorder} would be refused: never, so null. */
  checkReorder(order: VertexOrder = 'morton'): Refusal | null {
    linksOf(this).checkAlive();
    indexOfChoice('order', order, VERTEX_ORDERS);
    return null;
  }

  /**
   * Reserves room for this many slots, live and deleted, so that no array moves while items are added up to
   * these numbers. The arrays move now, if they have to, and views of them are stale.
   */
  reserve(vertices: number, edges: number, faces: number): void {
    const links = linksOf(this);
    links.checkAlive();
    checkCount('vertices', vertices);
    checkCount('edges', edges);
    checkCount('faces', faces);
    done(links, links.core._reserve(links.address, vertices, edges, faces));
  }

  /**
   * Removes all items, with their slots. Attributes stay, without values; history is forgotten.
   *
   * @throws HalfedgeError `open-group` inside of `history.group`
   */
  clear(): void {
    const links = linksOf(this);
    links.checkAlive();
    checkNoGroup(links, 'clear()', 'called');
    links.core._clear(links.address);
    links.update();
  }

  /**
   * Adds the smallest complex, a loop: one edge with the same vertex, at the origin, at both ends, and a
   * face on either side. Degenerate complexes are valid up to level 3 of `validate`; level 4 is for polygon
   * meshes, and so are the operations.
   *
   * @returns one of its two halfedges, which is its own `next`
   */
  makeLoop(): Halfedge {
    const links = linksOf(this);
    return done(links, links.core._make_loop(links.address, modeOf(links))) as Halfedge;
  }

  /** Why {@link makeLoop} would be refused: never, so null. */
  checkMakeLoop(): Refusal | null {
    linksOf(this).checkAlive();
    return null;
  }

  /**
   * Adds a segment: one edge with two vertices, at the origin, in a single face. As {@link makeLoop},
   * valid up to level 3.
   *
   * @returns one of its two halfedges, whose `next` is its opposite
   */
  makeSegment(): Halfedge {
    const links = linksOf(this);
    return done(links, links.core._make_segment(links.address, modeOf(links))) as Halfedge;
  }

  /** Why {@link makeSegment} would be refused: never, so null. */
  checkMakeSegment(): Refusal | null {
    linksOf(this).checkAlive();
    return null;
  }
}

function deletion(options: DeleteOptions | undefined): number {
  if (options === undefined) return 0;
  const { keepIsolatedVertices = false } = checkOptions(options, DELETE_OPTIONS);
  checkFlag('keepIsolatedVertices', keepIsolatedVertices);
  return keepIsolatedVertices ? OPTION : 0;
}
