import { refuse } from './checks.js';
import { answer, CHECK_ONLY, done, modeOf, type Refusal } from './edit.js';
import type { EdgeLike, Face, FaceLike, Vertex, VertexLike } from './items.js';
import { linksOf } from './navigation.js';
import { Surgery } from './surgery.js';

/**
 * Modelling operations, as courses and modelling programs have them. The contract is that of `Construction`.
 */
export abstract class Modelling extends Surgery {
  /**
   * Cuts a face of degree n, or each face, into n - 2 triangles with the same attributes, without new
   * vertices. A face may be concave and not quite planar: no triangle folds over, and diagonals are short. No
   * two vertices are joined a second time.
   *
   * Inverse: `removeEdge` of the new edges, in reverse order.
   *
   * @returns the number of new faces
   * @throws HalfedgeError `no-triangulation` (each way without a fold would join vertices that are joined
   * already, of more than 32 corners each way tried; if all faces are cut, also those that diagonals of other
   * faces join: only a few orders of the faces are tried)
   */
  triangulate(f?: FaceLike): number {
    const links = linksOf(this);
    const { core, address } = links;
    if (f === undefined) return done(links, core._triangulate(address, modeOf(links)));
    links.checkFace(f);
    return done(links, core._triangulate_face(address, modeOf(links), f));
  }

  /** Why {@link triangulate} would be refused, or null. */
  checkTriangulate(f?: FaceLike): Refusal | null {
    const links = linksOf(this);
    const { core, address } = links;
    if (f === undefined) return answer(links, core._triangulate(address, CHECK_ONLY));
    links.checkFace(f);
    return answer(links, core._triangulate_face(address, CHECK_ONLY, f));
  }

  /**
   * Moves a face by `offset` along its unit normal, and closes the gap with a quad at each side. A negative
   * offset goes inwards. The face keeps its index, on top. New vertices, quads and sides have the attributes
   * of those that they were made from.
   *
   * Inverse: `deleteVertex` of each new vertex that is still there (one without edges goes with the last
   * beside it), then `fillHole`, whose face may begin at another corner; undo, where the face lies on the
   * boundary.
   *
   * @returns `f`
   * @throws HalfedgeError `degenerate-face` (it has no normal), `not-finite` (a new position would not fit
   * into 32-bit floats)
   */
  extrudeFace(f: FaceLike, offset: number): Face {
    const links = linksOf(this);
    links.checkFace(f);
    checkOffset(offset);
    return done(links, links.core._extrude_face(links.address, modeOf(links), f, offset)) as Face;
  }

  /** Why {@link extrudeFace} would be refused, or null. */
  checkExtrudeFace(f: FaceLike, offset: number): Refusal | null {
    const links = linksOf(this);
    links.checkFace(f);
    checkOffset(offset);
    return answer(links, links.core._extrude_face(links.address, CHECK_ONLY, f, offset));
  }

  /**
   * Shrinks a face towards the mean of its corners, by a fraction from 0 (the new corners are where the old
   * ones are) to 1 (at the mean), and puts a quad between each side and its old place. The face keeps its
   * index, inside. Attributes of new vertices are blended like their positions.
   *
   * Inverse: `deleteVertex` of each new vertex that is still there (one without edges goes with the last
   * beside it), then `fillHole`, whose face may begin at another corner; undo, where the face lies on the
   * boundary.
   *
   * @returns `f`
   * @throws HalfedgeError `out-of-range`
   */
  insetFace(f: FaceLike, fraction: number): Face {
    const links = linksOf(this);
    links.checkFace(f);
    checkNumber('fraction', fraction);
    return done(links, links.core._inset_face(links.address, modeOf(links), f, fraction)) as Face;
  }

  /** Why {@link insetFace} would be refused, or null. */
  checkInsetFace(f: FaceLike, fraction: number): Refusal | null {
    const links = linksOf(this);
    links.checkFace(f);
    checkNumber('fraction', fraction);
    return answer(links, links.core._inset_face(links.address, CHECK_ONLY, f, fraction));
  }

  /**
   * Like `splitFace`, with the new vertex at the mean of the corners, moved by `offset` along the unit
   * normal.
   *
   * Inverse: `dissolveVertex(returned)`.
   *
   * @returns the new vertex
   * @throws HalfedgeError `degenerate-face` (it has no normal, and the offset isn't 0), `not-finite` (as of
   * {@link extrudeFace})
   */
  poke(f: FaceLike, offset = 0): Vertex {
    const links = linksOf(this);
    links.checkFace(f);
    checkOffset(offset);
    return done(links, links.core._poke(links.address, modeOf(links), f, offset)) as Vertex;
  }

  /** Why {@link poke} would be refused, or null. */
  checkPoke(f: FaceLike, offset = 0): Refusal | null {
    const links = linksOf(this);
    links.checkFace(f);
    checkOffset(offset);
    return answer(links, links.core._poke(links.address, CHECK_ONLY, f, offset));
  }

  /**
   * Replaces an edge by a quad, whose long sides move into the two faces beside it, along the neighbouring
   * sides, as far as `amount` says, from 0 to 1. An end of valence two stays one vertex, and the new face is
   * then a triangle. The edge itself becomes the long side in the face of its side 0.
   *
   * Inverse: `collapse` of the short sides; only undo restores positions.
   *
   * @returns the new face
   * @throws HalfedgeError `loop-edge`, `boundary-edge`, `valence-below-three`, `out-of-range`
   */
  bevelEdge(e: EdgeLike, amount: number): Face {
    const links = linksOf(this);
    links.checkEdge(e);
    checkNumber('amount', amount);
    return done(links, links.core._bevel_edge(links.address, modeOf(links), e, amount)) as Face;
  }

  /** Why {@link bevelEdge} would be refused, or null. */
  checkBevelEdge(e: EdgeLike, amount: number): Refusal | null {
    const links = linksOf(this);
    links.checkEdge(e);
    checkNumber('amount', amount);
    return answer(links, links.core._bevel_edge(links.address, CHECK_ONLY, e, amount));
  }

  /**
   * Cuts a vertex off. A face takes its place, with a corner on each of its edges, as far along the edge as
   * `amount` says, from 0 (at the vertex) to 1 (at the other end). The vertex itself becomes one of the
   * corners.
   *
   * Inverse: `collapse` of all sides of the new face except one; only undo restores positions. At a pinched
   * vertex undo, because a collapse would let the boundary meet itself.
   *
   * @returns the new face, whose degree is the former valence of `v`
   * @throws HalfedgeError `valence-below-three`, `out-of-range`
   */
  bevelVertex(v: VertexLike, amount: number): Face {
    const links = linksOf(this);
    links.checkVertex(v);
    checkNumber('amount', amount);
    return done(links, links.core._bevel_vertex(links.address, modeOf(links), v, amount)) as Face;
  }

  /** Why {@link bevelVertex} would be refused, or null. */
  checkBevelVertex(v: VertexLike, amount: number): Refusal | null {
    const links = linksOf(this);
    links.checkVertex(v);
    checkNumber('amount', amount);
    return answer(links, links.core._bevel_vertex(links.address, CHECK_ONLY, v, amount));
  }
}

/** Throws a sentence unless `value` can be added to a position. */
function checkOffset(value: unknown): void {
  checkNumber('offset', value);
  if (Number.isFinite(Math.fround(value as number))) return;
  refuse('offset', value, 'a number that fits a 32-bit float', 'number');
}

/** Throws a sentence unless `value` is a number; which ones the operation takes, the core tells. */
function checkNumber(argument: string, value: unknown): void {
  if (typeof value === 'number' && Number.isFinite(value)) return;
  refuse(argument, value, 'a finite number', 'number');
}
