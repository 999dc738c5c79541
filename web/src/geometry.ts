import { Circulation } from './circulation.js';
import { counted } from './counted.js';
import type { EdgeLike, FaceLike, HalfedgeLike, ItemKind, VertexLike } from './items.js';
import { slotCount } from './links.js';
import type { Box, Floats, Surface, XYZ } from './measures.js';
import * as measures from './measures.js';
import { linksOf } from './navigation.js';
import { arrayFor, checkClosed, type FloatsConstructor, pointOf } from './results.js';
import { boundaryLoopsOf } from './topology.js';

/**
 * Normals, areas, lengths and angles, computed from the positions when they are asked for, in double precision.
 * Lengths have the unit of the positions, and angles are in radians.
 *
 * A method for one item takes time in proportion to what is around it. Methods that begin with `all` return one
 * typed array for the whole mesh, by slot, with zeros for deleted items; they take O(slots).
 *
 * `into`: the array to write to, for example one of an earlier call or a live view of an attribute, but not
 * of the positions. If it is as long as the result, it is returned; if it is longer, its first part; if it is
 * shorter, a new array.
 */
export abstract class Geometry extends Circulation {
  // ---- faces ------------------------------------------------------------------------------------

  /** The unit normal of `f`: whoever it points at sees the corners counter-clockwise. Zeros if `f` has no area. */
  faceNormal(f: FaceLike): XYZ {
    const links = linksOf(this);
    links.checkFace(f);
    return pointOf((out) => measures.writeFaceNormal(links, f, out, 0));
  }

  /**
   * The area of `f`, which may be convex or not. If it is warped, this is the area of its shadow on the plane on
   * which that is largest.
   */
  faceArea(f: FaceLike): number {
    const links = linksOf(this);
    links.checkFace(f);
    return measures.faceArea(links, f);
  }

  /** The mean of the corners of `f`: where `splitFace` and `dual` put their vertices. */
  faceCentroid(f: FaceLike): XYZ {
    const links = linksOf(this);
    links.checkFace(f);
    return pointOf((out) => measures.writeFaceCentroid(links, f, out, 0));
  }

  /** By face slot, x, y and z of each {@link faceNormal}. */
  allFaceNormals<Into extends Floats = Float32Array>(into?: Into): Into {
    const slots = this.faceSlots;
    const surface = surfaceOf(this);
    const out = arrayFor(3 * slots, Float32Array, surface.positions, into) as Into;
    measures.writeFaceNormals(surface, slots, out);
    return out;
  }

  /** By face slot, each {@link faceArea}. */
  allFaceAreas<Into extends Floats = Float64Array>(into?: Into): Into {
    return forAll(this, 'face', 1, Float64Array, into, (surface, f, out) => {
      out[f] = measures.faceArea(surface, f);
    });
  }

  /** By face slot, x, y and z of each {@link faceCentroid}. */
  allFaceCentroids<Into extends Floats = Float32Array>(into?: Into): Into {
    return forAll(this, 'face', 3, Float32Array, into, (surface, f, out) =>
      measures.writeFaceCentroid(surface, f, out, 3 * f),
    );
  }

  // ---- edges and corners ------------------------------------------------------------------------

  /** How far apart the two ends of `e` are. */
  edgeLength(e: EdgeLike): number {
    const links = linksOf(this);
    links.checkEdge(e);
    return measures.edgeLength(links, e);
  }

  /** The middle of `e`: where `splitEdge` puts its vertex. */
  edgeMidpoint(e: EdgeLike): XYZ {
    const links = linksOf(this);
    links.checkEdge(e);
    return pointOf((out) => measures.writeEdgeMidpoint(links, e, out, 0));
  }

  /**
   * By how much the surface bends at `e`, from -π to π: the angle between the normals of its two faces. It is 0
   * where the surface is flat, positive where it is convex, as at the edges of a cube, and negative in a valley.
   * It is also 0 on the boundary and beside a face without area.
   */
  dihedralAngle(e: EdgeLike): number {
    const links = linksOf(this);
    links.checkEdge(e);
    return measures.dihedralAngle(links, e);
  }

  /**
   * The cotangent weight of `e`: half the sum of the cotangents of the one or two angles opposite to it. The Laplace
   * matrix of a triangle mesh consists of these (Pinkall and Polthier 1993). A triangle without area adds 0.
   *
   * @throws RangeError if a face beside `e` is no triangle
   */
  cotanWeight(e: EdgeLike): number {
    const links = linksOf(this);
    links.checkEdge(e);
    const f = measures.nonTriangleBeside(links, e);
    if (f < 0) return measures.cotanWeight(links, e);
    throw new RangeError(`e is edge ${e}, ${besideWhich(links, f)}`);
  }

  /**
   * The angle of the face of `h` at the corner where `h` ends, between `h` and `next(h)`. It is more than π at a
   * reflex corner. It is 0 if `h` has no face, and if one of the two sides has no length.
   */
  cornerAngle(h: HalfedgeLike): number {
    const links = linksOf(this);
    links.checkHalfedge(h);
    return measures.cornerAngle(links, h);
  }

  /** By edge slot, each {@link edgeLength}. */
  allEdgeLengths<Into extends Floats = Float64Array>(into?: Into): Into {
    return forAll(this, 'edge', 1, Float64Array, into, (surface, e, out) => {
      out[e] = measures.edgeLength(surface, e);
    });
  }

  /** By edge slot, x, y and z of each {@link edgeMidpoint}. */
  allEdgeMidpoints<Into extends Floats = Float32Array>(into?: Into): Into {
    return forAll(this, 'edge', 3, Float32Array, into, (surface, e, out) =>
      measures.writeEdgeMidpoint(surface, e, out, 3 * e),
    );
  }

  /** By edge slot, each {@link dihedralAngle}. */
  allDihedralAngles<Into extends Floats = Float64Array>(into?: Into): Into {
    return forAll(this, 'edge', 1, Float64Array, into, (surface, e, out) => {
      out[e] = measures.dihedralAngle(surface, e);
    });
  }

  /**
   * By edge slot, each {@link cotanWeight}.
   *
   * @throws RangeError if a face is no triangle
   */
  allCotanWeights<Into extends Floats = Float64Array>(into?: Into): Into {
    return forAll(this, 'edge', 1, Float64Array, into, (surface, e, out) => {
      const f = measures.nonTriangleBeside(surface, e);
      if (f >= 0) throw new RangeError(`This mesh has edge ${e}, ${besideWhich(surface, f)}`);
      out[e] = measures.cotanWeight(surface, e);
    });
  }

  /** By halfedge slot, each {@link cornerAngle}. */
  allCornerAngles<Into extends Floats = Float64Array>(into?: Into): Into {
    return forAll(this, 'halfedge', 1, Float64Array, into, (surface, h, out) => {
      out[h] = measures.cornerAngle(surface, h);
    });
  }

  // ---- vertices ---------------------------------------------------------------------------------

  /**
   * The unit normal at `v`: the mean of the normals of its faces, weighted by their areas. Zeros if it has no face, or
   * if the normals cancel each other.
   */
  vertexNormal(v: VertexLike): XYZ {
    const links = linksOf(this);
    links.checkVertex(v);
    return pointOf((out) => measures.writeVertexNormal(links, v, out, 0));
  }

  /**
   * The part of the surface that belongs to `v`: from each of its faces, the area divided by the number of corners.
   * The areas of all vertices add up to that of the mesh.
   */
  vertexArea(v: VertexLike): number {
    const links = linksOf(this);
    links.checkVertex(v);
    return measures.vertexArea(links, v);
  }

  /**
   * What the angles of the faces at `v` lack to a full turn; half a turn counts as filled for each boundary halfedge
   * that leaves `v`. It is the Gaussian curvature that lies at `v`. In a triangle mesh, the angle defects of all
   * vertices add up to 2π times `eulerCharacteristic()`.
   */
  angleDefect(v: VertexLike): number {
    const links = linksOf(this);
    links.checkVertex(v);
    return measures.angleDefect(links, v);
  }

  /** By vertex slot, x, y and z of each {@link vertexNormal}. */
  allVertexNormals<Into extends Floats = Float32Array>(into?: Into): Into {
    const slots = this.vertexSlots;
    const surface = surfaceOf(this);
    const out = arrayFor(3 * slots, Float32Array, surface.positions, into) as Into;
    measures.writeVertexNormals(surface, slots, out);
    return out;
  }

  /** By vertex slot, each {@link vertexArea}. */
  allVertexAreas<Into extends Floats = Float64Array>(into?: Into): Into {
    const surface = surfaceOf(this);
    const out = arrayFor(this.vertexSlots, Float64Array, surface.positions, into) as Into;
    measures.writeVertexAreas(surface, out);
    return out;
  }

  /** By vertex slot, each {@link angleDefect}. */
  allAngleDefects<Into extends Floats = Float64Array>(into?: Into): Into {
    return forAll(this, 'vertex', 1, Float64Array, into, (surface, v, out) => {
      out[v] = measures.angleDefect(surface, v);
    });
  }

  // ---- the whole mesh ---------------------------------------------------------------------------

  /** The sum of all {@link faceArea}s. O(halfedges). */
  area(): number {
    return measures.totalArea(surfaceOf(this));
  }

  /**
   * The volume inside of this mesh, negative if its faces look inwards. Components that lie inside of others count
   * with their own sign: those of a cavity, whose faces look into it, are taken away. Warped faces count as if they
   * were cut into triangles around their centroids. O(halfedges).
   *
   * @throws HalfedgeError `open-surface` if there is a boundary, where the inside leaks out
   */
  volume(): number {
    checkClosed(boundaryLoopsOf(linksOf(this)).length, 'fillHoles()');
    return measures.enclosedVolume(surfaceOf(this));
  }

  /**
   * The smallest box along the axes that holds all vertices, isolated ones too, but not those that have a coordinate
   * that is infinite or NaN. Null if there is no vertex. O(vertices).
   */
  boundingBox(): Box | null {
    return measures.boxOf(surfaceOf(this), this.vertexSlots);
  }
}

/** The views of a mesh as they are now: they are good until something allocates. */
function surfaceOf(mesh: Geometry): Surface {
  const links = linksOf(mesh);
  links.revive();
  const { next, toVertex, face, vertexHalfedge, faceHalfedge, positions } = links;
  return { next, toVertex, face, vertexHalfedge, faceHalfedge, positions };
}

/** Calls `write` for each live item of a kind; the rest is zeros. */
function forAll<Into extends Floats>(
  mesh: Geometry,
  kind: ItemKind,
  components: 1 | 3,
  Default: FloatsConstructor,
  into: Into | undefined,
  write: (surface: Surface, item: number, out: Floats) => void,
): Into {
  const surface = surfaceOf(mesh);
  const slots = slotCount(linksOf(mesh), kind);
  const out = arrayFor(components * slots, Default, surface.positions, into);
  const { vertexHalfedge, next, faceHalfedge } = surface;
  const link = { vertex: vertexHalfedge, halfedge: next, edge: next, face: faceHalfedge }[kind];
  const stride = kind === 'edge' ? 2 : 1;
  for (let i = 0; i < slots; i++) {
    if (link[stride * i] >= -1) write(surface, i, out);
    else out.fill(0, components * i, components * (i + 1));
  }
  return out as Into;
}

const besideWhich = (links: Surface, f: number) =>
  `beside which face ${f} has ${counted(measures.degreeOf(links, links.faceHalfedge[f]), 'corner')}; expected triangles.`;
