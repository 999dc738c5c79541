import { checkFlag, indexOfChoice } from './checks.js';
import { Construction } from './construction.js';
import {
  answer,
  CHECK_ONLY,
  checkPosition,
  done,
  modeOf,
  OPTION,
  type Position,
  type Refusal,
  withPosition,
} from './edit.js';
import type {
  Edge,
  EdgeLike,
  Face,
  FaceLike,
  Halfedge,
  HalfedgeLike,
  NONE,
  Vertex,
  VertexLike,
} from './items.js';
import { linksOf } from './navigation.js';
import { checkOptions, type OptionNames } from './options.js';

/** What a collapse may leave. */
export interface CollapseOptions {
  /**
   * Whether the collapse may leave two faces with the same corners, glued along all edges, as with a
   * tetrahedron. Default: false.
   */
  permissive?: boolean | undefined;
}

/**
 * What fills the gap beside the new edge, on the side of `hl` and of `hr`: a triangle, or nothing, in which
 * case the face or the boundary gains a corner. Default: a triangle; on the boundary, nothing.
 */
export interface SplitVertexOptions {
  left?: 'triangle' | 'corner' | undefined;
  right?: 'triangle' | 'corner' | undefined;
}

const COLLAPSE_OPTIONS: OptionNames<CollapseOptions> = { permissive: true };
const SPLIT_VERTEX_OPTIONS: OptionNames<SplitVertexOptions> = { left: true, right: true };

/**
 * The Euler operations, each next to its inverse. They change the edges, faces and vertices of one surface.
 * The contract is that of `Construction`.
 */
export abstract class EulerOperations extends Construction {
  /**
   * Turns `e` counter-clockwise in the quad of its two triangles: the diagonal 0-2 of the quad 0123 becomes
   * 1-3. The edge and both faces keep their indices and attributes. O(valence).
   *
   * Inverse: the same operation, three times. Twice turns the edge around.
   *
   * @throws HalfedgeError `boundary-edge`, `not-a-triangle`, `same-vertex` (if the two corners opposite the
   * edge are the same vertex), `edge-exists` (if they are joined already)
   */
  flipEdge(e: EdgeLike): Edge {
    const links = linksOf(this);
    links.checkEdge(e);
    return done(links, links.core._flip_edge(links.address, modeOf(links), e)) as Edge;
  }

  /** Why {@link flipEdge} would be refused, or null. */
  checkFlipEdge(e: EdgeLike): Refusal | null {
    const links = linksOf(this);
    links.checkEdge(e);
    return answer(links, links.core._flip_edge(links.address, CHECK_ONLY, e));
  }

  /**
   * Adds a vertex of valence two on an edge, by default in its middle; both faces gain a corner. The edge
   * becomes the half at the end of its side 0; the other half is a new edge with the same attributes.
   * Attributes of the vertex and its corners are blended, at the point of the edge that is closest to
   * `position`.
   *
   * Inverse: `removeVertexOnEdge(returned)`.
   */
  insertVertexOnEdge(e: EdgeLike, position?: Position): Vertex {
    const links = linksOf(this);
    links.checkEdge(e);
    const p = checkPosition(position);
    const mode = withPosition(modeOf(links), position);
    const { core, address } = links;
    return done(links, core._insert_vertex_on_edge(address, mode, e, p[0], p[1], p[2])) as Vertex;
  }

  /** Why {@link insertVertexOnEdge} would be refused: never, so null. */
  checkInsertVertexOnEdge(e: EdgeLike, position?: Position): Refusal | null {
    const links = linksOf(this);
    links.checkEdge(e);
    checkPosition(position);
    const { core, address } = links;
    return answer(links, core._insert_vertex_on_edge(address, CHECK_ONLY, e, 0, 0, 0));
  }

  /**
   * Removes a vertex of valence two. Its two edges become one, which keeps the lower of the two indices, and
   * the faces there lose a corner.
   *
   * Inverse: `insertVertexOnEdge(returned, position)`.
   *
   * @throws HalfedgeError `not-valence-two`, `degree-below-three` (beside a triangle), `edge-exists`
   */
  removeVertexOnEdge(v: VertexLike): Edge {
    const links = linksOf(this);
    links.checkVertex(v);
    const { core, address } = links;
    return done(links, core._remove_vertex_on_edge(address, modeOf(links), v)) as Edge;
  }

  /** Why {@link removeVertexOnEdge} would be refused, or null. */
  checkRemoveVertexOnEdge(v: VertexLike): Refusal | null {
    const links = linksOf(this);
    links.checkVertex(v);
    return answer(links, links.core._remove_vertex_on_edge(links.address, CHECK_ONLY, v));
  }

  /**
   * Like {@link insertVertexOnEdge}, but also cuts each triangle beside the edge in two; the triangle at the
   * end of side 0 keeps the face. Larger faces gain the corner.
   *
   * Inverse: `collapse` of a halfedge from the new vertex to one of the ends; permissive, if that leaves a
   * pillow.
   *
   * @throws HalfedgeError `same-vertex` (both triangles have the same corners)
   */
  splitEdge(e: EdgeLike, position?: Position): Vertex {
    const links = linksOf(this);
    links.checkEdge(e);
    const p = checkPosition(position);
    const mode = withPosition(modeOf(links), position);
    return done(links, links.core._split_edge(links.address, mode, e, p[0], p[1], p[2])) as Vertex;
  }

  /** Why {@link splitEdge} would be refused, or null. */
  checkSplitEdge(e: EdgeLike, position?: Position): Refusal | null {
    const links = linksOf(this);
    links.checkEdge(e);
    checkPosition(position);
    return answer(links, links.core._split_edge(links.address, CHECK_ONLY, e, 0, 0, 0));
  }

  /**
   * Contracts the edge of `h`: `fromVertex(h)` disappears into `toVertex(h)`, triangles on the edge vanish,
   * and larger faces lose a corner. The surviving vertex stays where it is and keeps its attributes; if you
   * pass a position, it moves there and its attributes are blended. O(valence).
   *
   * Refused if the topology of the surface would change (the link condition): see `checkCollapse`.
   *
   * Inverse: `splitVertex(hl, hr, position, { left, right })`, where `hl` and `hr` are `next(h)` and
   * `opposite(prev(opposite(h)))` before the collapse. `left` is 'triangle' if the face of `h` was a triangle
   * and vanished, otherwise 'corner'; `right` is the same for the face of `opposite(h)`.
   *
   * @returns `toVertex(h)`
   * @throws HalfedgeError `same-loop` (one face lies on both sides of the edge, as in a segment), `loop-edge`
   * (the edge, or one of a triangle beside it, leads back to where it begins), `boundary-vertices` (both ends
   * lie on the boundary, the edge doesn't), `common-neighbour`, `same-vertex`, `edge-without-face`,
   * `repeated-vertex`, `leaves-pillow`
   */
  collapse(h: HalfedgeLike, position?: Position, options?: CollapseOptions): Vertex {
    const links = linksOf(this);
    links.checkHalfedge(h);
    const p = checkPosition(position);
    const mode = withPosition(modeOf(links) | condition(options), position);
    return done(links, links.core._collapse(links.address, mode, h, p[0], p[1], p[2])) as Vertex;
  }

  /** Why {@link collapse} would be refused, or null. */
  checkCollapse(h: HalfedgeLike, position?: Position, options?: CollapseOptions): Refusal | null {
    const links = linksOf(this);
    links.checkHalfedge(h);
    checkPosition(position);
    const mode = CHECK_ONLY | condition(options);
    return answer(links, links.core._collapse(links.address, mode, h, 0, 0, 0));
  }

  /**
   * Divides the vertex that `hl` and `hr` leave into two, joined by a new edge. The halfedges strictly
   * between them, counter-clockwise from `hl` to `hr`, go to the new vertex, all others if `hl` is `hr`. Two
   * new triangles fill the gap (none on the boundary). The new vertex has the attributes of the old one and,
   * by default, its position.
   *
   * Inverse: `collapse` of the halfedge from the new vertex to the old one, unless the split has separated
   * the fans of a pinched vertex.
   *
   * @returns the new vertex
   * @throws HalfedgeError `different-vertices`, `loop-edge`, `same-vertex` (`hl` is `hr`, with a triangle on
   * either side), `nothing-between`, `edge-without-face`
   */
  splitVertex(
    hl: HalfedgeLike,
    hr: HalfedgeLike,
    position?: Position,
    options?: SplitVertexOptions,
  ): Vertex {
    const links = linksOf(this);
    links.checkHalfedge(hl, 'hl');
    links.checkHalfedge(hr, 'hr');
    const p = checkPosition(position);
    const mode = withPosition(modeOf(links) | sides(options), position);
    const { core, address } = links;
    return done(links, core._split_vertex(address, mode, hl, hr, p[0], p[1], p[2])) as Vertex;
  }

  /** Why {@link splitVertex} would be refused, or null. */
  checkSplitVertex(
    hl: HalfedgeLike,
    hr: HalfedgeLike,
    position?: Position,
    options?: SplitVertexOptions,
  ): Refusal | null {
    const links = linksOf(this);
    links.checkHalfedge(hl, 'hl');
    links.checkHalfedge(hr, 'hr');
    checkPosition(position);
    const mode = CHECK_ONLY | sides(options);
    return answer(links, links.core._split_vertex(links.address, mode, hl, hr, 0, 0, 0));
  }

  /**
   * Adds an edge from `toVertex(h0)` to `toVertex(h1)`, two corners of one face, and so cuts the face in two:
   * the part after `h0`, up to `h1`, becomes a new face with the same attributes. In a boundary loop, that
   * part is covered by a new face with default attributes, and the rest stays open; side 0 of the edge then
   * lies in the new face, and leads from `toVertex(h1)` to `toVertex(h0)`.
   *
   * Inverse: `removeEdge(returned)`.
   *
   * @throws HalfedgeError `different-loops`, `same-corner`, `adjacent-corners`, `edge-exists`,
   * `repeated-vertex` (if the new face would pass a pinched vertex twice)
   */
  insertEdge(h0: HalfedgeLike, h1: HalfedgeLike): Edge {
    const links = linksOf(this);
    links.checkHalfedge(h0, 'h0');
    links.checkHalfedge(h1, 'h1');
    return done(links, links.core._insert_edge(links.address, modeOf(links), h0, h1)) as Edge;
  }

  /** Why {@link insertEdge} would be refused, or null. */
  checkInsertEdge(h0: HalfedgeLike, h1: HalfedgeLike): Refusal | null {
    const links = linksOf(this);
    links.checkHalfedge(h0, 'h0');
    links.checkHalfedge(h1, 'h1');
    return answer(links, links.core._insert_edge(links.address, CHECK_ONLY, h0, h1));
  }

  /**
   * Removes an edge and merges the two faces beside it; the face of side 0 stays. For an edge on the
   * boundary, its face is removed, and the boundary then runs along the rest of the face's edges.
   *
   * Inverse: `insertEdge` with the two halfedges that came before those of the edge. The first is the one
   * before side 0 or, for an edge on the boundary, the one before its side without a face.
   *
   * @returns the face that stays; `NONE` for an edge on the boundary
   * @throws HalfedgeError `faces-share-edges`, `faces-share-vertex` (if the two faces have more in common),
   * `edge-without-face` (if another edge of the face is on the boundary, too), `last-edge` (for a loop)
   */
  removeEdge(e: EdgeLike): Face | typeof NONE {
    const links = linksOf(this);
    links.checkEdge(e);
    return done(links, links.core._remove_edge(links.address, modeOf(links), e)) as
      | Face
      | typeof NONE;
  }

  /** Why {@link removeEdge} would be refused, or null. */
  checkRemoveEdge(e: EdgeLike): Refusal | null {
    const links = linksOf(this);
    links.checkEdge(e);
    return answer(links, links.core._remove_edge(links.address, CHECK_ONLY, e));
  }

  /**
   * Like {@link removeEdge} of an interior edge, but as modelling programs do it: also removes the edges that
   * continue it, if both faces share them, and its ends, if only two edges are left there.
   *
   * Inverse: none; undo.
   *
   * @throws HalfedgeError `boundary-edge`, `loop-edge`, `faces-share-edges`, `faces-share-vertex`
   */
  dissolveEdge(e: EdgeLike): Face {
    const links = linksOf(this);
    links.checkEdge(e);
    return done(links, links.core._dissolve_edge(links.address, modeOf(links), e)) as Face;
  }

  /** Why {@link dissolveEdge} would be refused, or null. */
  checkDissolveEdge(e: EdgeLike): Refusal | null {
    const links = linksOf(this);
    links.checkEdge(e);
    return answer(links, links.core._dissolve_edge(links.address, CHECK_ONLY, e));
  }

  /**
   * Adds a vertex in a face, by default at the mean of its corners, and joins it to each of the n corners:
   * the face becomes n triangles with the same attributes. The vertex gets the means of the attributes of the
   * corners. O(degree).
   *
   * Inverse: `dissolveVertex(returned)`.
   */
  splitFace(f: FaceLike, position?: Position): Vertex {
    const links = linksOf(this);
    links.checkFace(f);
    const p = checkPosition(position);
    const mode = withPosition(modeOf(links), position);
    return done(links, links.core._split_face(links.address, mode, f, p[0], p[1], p[2])) as Vertex;
  }

  /** Why {@link splitFace} would be refused, or null. */
  checkSplitFace(f: FaceLike, position?: Position): Refusal | null {
    const links = linksOf(this);
    links.checkFace(f);
    checkPosition(position);
    return answer(links, links.core._split_face(links.address, CHECK_ONLY, f, 0, 0, 0));
  }

  /**
   * Removes a vertex and its edges, and merges the faces around it into one. On the boundary, its two
   * boundary edges become one, which joins its two neighbours there.
   *
   * Inverse: `splitFace(returned)`, if the faces were triangles around it.
   *
   * @throws HalfedgeError `isolated-vertex`, `pinched-vertex`, `degree-below-three`, `repeated-vertex` (in
   * the resulting face), `edge-exists` (between the neighbours on the boundary)
   */
  dissolveVertex(v: VertexLike): Face {
    const links = linksOf(this);
    links.checkVertex(v);
    return done(links, links.core._dissolve_vertex(links.address, modeOf(links), v)) as Face;
  }

  /** Why {@link dissolveVertex} would be refused, or null. */
  checkDissolveVertex(v: VertexLike): Refusal | null {
    const links = linksOf(this);
    links.checkVertex(v);
    return answer(links, links.core._dissolve_vertex(links.address, CHECK_ONLY, v));
  }

  /**
   * Removes a face and leaves its edges: they become a boundary loop. O(degree).
   *
   * Inverse: `fillHole(returned)`.
   *
   * @returns a halfedge of the boundary loop
   * @throws HalfedgeError `edge-without-face` (if an edge of it has no other face: see `deleteFace`)
   */
  makeHole(f: FaceLike): Halfedge {
    const links = linksOf(this);
    links.checkFace(f);
    return done(links, links.core._make_hole(links.address, modeOf(links), f)) as Halfedge;
  }

  /** Why {@link makeHole} would be refused, or null. */
  checkMakeHole(f: FaceLike): Refusal | null {
    const links = linksOf(this);
    links.checkFace(f);
    return answer(links, links.core._make_hole(links.address, CHECK_ONLY, f));
  }

  /**
   * Adds a face on the boundary loop of `h`, with default attributes. O(sum of the valences along it).
   *
   * Inverse: `makeHole(returned)`.
   *
   * @throws HalfedgeError `not-a-boundary-halfedge`, `repeated-vertex` (if the loop passes a pinched vertex
   * twice), `degree-below-three` (in a degenerate complex)
   */
  fillHole(h: HalfedgeLike): Face {
    const links = linksOf(this);
    links.checkHalfedge(h);
    return done(links, links.core._fill_hole(links.address, modeOf(links), h)) as Face;
  }

  /** Why {@link fillHole} would be refused, or null. */
  checkFillHole(h: HalfedgeLike): Refusal | null {
    const links = linksOf(this);
    links.checkHalfedge(h);
    return answer(links, links.core._fill_hole(links.address, CHECK_ONLY, h));
  }
}

function condition(options: CollapseOptions | undefined): number {
  if (options === undefined) return 0;
  const { permissive = false } = checkOptions(options, COLLAPSE_OPTIONS);
  checkFlag('permissive', permissive);
  return permissive ? OPTION : 0;
}

function sides(options: SplitVertexOptions | undefined): number {
  if (options === undefined) return 0;
  const { left, right } = checkOptions(options, SPLIT_VERTEX_OPTIONS);
  return OPTION * side('left', left) + 4 * OPTION * side('right', right);
}

/** A value of the enum SplitSide in C++. */
function side(argument: string, fill: unknown): number {
  return fill === undefined ? 0 : 1 + indexOfChoice(argument, fill, ['triangle', 'corner']);
}
