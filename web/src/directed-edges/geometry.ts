import type { EdgeLike, FaceLike, HalfedgeLike, VertexLike } from '../items.js';
import { type Box, boxOf, type Floats, type XYZ } from '../measures.js';
import { arrayFor, checkClosed, type FloatsConstructor, pointOf } from '../results.js';
import { boundaryLoopsOf, type DirectedLinks } from './links.js';
import * as measures from './measures.js';
import { DirectedEdgesNavigation, directedLinksOf } from './navigation.js';

/**
 * Normals, areas, lengths and angles of Directed Edges, under the names that they have in `HalfedgeMesh`, and to the
 * last bit what they are there: computed from the positions when they are asked for, in double precision. Lengths have
 * the unit of the positions, and angles are in radians.
 *
 * A method for one item takes time in proportion to what is around it. Methods that begin with `all` return one typed
 * array for the whole mesh, by index, with zeros where no edge has that index; they take O(halfedges).
 *
 * `into`: the array to write to, for example one of an earlier call. If it is as long as the result, it is returned;
 * if it is longer, its first part; if it is shorter, a new array.
 */
export abstract class DirectedEdgesGeometry extends DirectedEdgesNavigation {
  // ---- faces ------------------------------------------------------------------------------------

  /** The unit normal of `f`: whoever it points at sees the corners counter-clockwise. Zeros if `f` has no area. */
  faceNormal(f: FaceLike): XYZ {
    const links = directedLinksOf(this);
    links.checkFace(f);
    return pointOf((out) => measures.writeFaceNormal(links, f, out, 0));
  }

  /** The area of `f`. */
  faceArea(f: FaceLike): number {
    const links = directedLinksOf(this);
    links.checkFace(f);
    return measures.faceArea(links, f);
  }

  /** The mean of the corners of `f`. */
  faceCentroid(f: FaceLike): XYZ {
    const links = directedLinksOf(this);
    links.checkFace(f);
    return pointOf((out) => measures.writeFaceCentroid(links, f, out, 0));
  }

  /** By face, x, y and z of each {@link faceNormal}. */
  allFaceNormals<Into extends Floats = Float32Array>(into?: Into): Into {
    const links = alive(this);
    const out = arrayFor(links.sides, Float32Array, links.positions, into) as Into;
    measures.writeFaceNormals(links, out);
    return out;
  }

  /** By face, each {@link faceArea}. */
  allFaceAreas<Into extends Floats = Float64Array>(into?: Into): Into {
    return forAll(this, this.faceCount, 1, Float64Array, into, (links, f, out) => {
      out[f] = measures.faceArea(links, f);
    });
  }

  /** By face, x, y and z of each {@link faceCentroid}. */
  allFaceCentroids<Into extends Floats = Float32Array>(into?: Into): Into {
    return forAll(this, this.faceCount, 3, Float32Array, into, (links, f, out) =>
      measures.writeFaceCentroid(links, f, out, 3 * f),
    );
  }

  // ---- edges and corners ------------------------------------------------------------------------

  /** How far apart the two ends of `e` are. */
  edgeLength(e: EdgeLike): number {
    const links = directedLinksOf(this);
    links.checkEdge(e);
    return measures.edgeLength(links, e);
  }

  /** The middle of `e`. */
  edgeMidpoint(e: EdgeLike): XYZ {
    const links = directedLinksOf(this);
    links.checkEdge(e);
    return pointOf((out) => measures.writeEdgeMidpoint(links, e, out, 0));
  }

  /**
   * By how much the surface bends at `e`, from -π to π: the angle between the normals of its two faces. It is 0
   * where the surface is flat, positive where it is convex, as at the edges of a cube, and negative in a valley.
   * It is also 0 on the boundary and beside a face without area.
   */
  dihedralAngle(e: EdgeLike): number {
    const links = directedLinksOf(this);
    links.checkEdge(e);
    return measures.dihedralAngle(links, e);
  }

  /**
   * The cotangent weight of `e`: half the sum of the cotangents of the one or two angles opposite to it. The Laplace
   * matrix consists of these (Pinkall and Polthier 1993). A triangle without area adds 0.
   */
  cotanWeight(e: EdgeLike): number {
    const links = directedLinksOf(this);
    links.checkEdge(e);
    return measures.cotanWeight(links, e);
  }

  /**
   * The angle of the face of `h` at the corner where `h` ends, between `h` and `next(h)`. It is 0 if `h` has no face,
   * and if one of the two sides has no length.
   */
  cornerAngle(h: HalfedgeLike): number {
    const links = directedLinksOf(this);
    links.checkHalfedge(h);
    return measures.cornerAngle(links, h);
  }

  /** By edge, each {@link edgeLength}. */
  allEdgeLengths<Into extends Floats = Float64Array>(into?: Into): Into {
    return forAllEdges(this, 1, Float64Array, into, (links, e, out) => {
      out[e] = measures.edgeLength(links, e);
    });
  }

  /** By edge, x, y and z of each {@link edgeMidpoint}. */
  allEdgeMidpoints<Into extends Floats = Float32Array>(into?: Into): Into {
    return forAllEdges(this, 3, Float32Array, into, (links, e, out) =>
      measures.writeEdgeMidpoint(links, e, out, 3 * e),
    );
  }

  /** By edge, each {@link dihedralAngle}. */
  allDihedralAngles<Into extends Floats = Float64Array>(into?: Into): Into {
    return forAllEdges(this, 1, Float64Array, into, (links, e, out) => {
      out[e] = measures.dihedralAngle(links, e);
    });
  }

  /** By edge, each {@link cotanWeight}. */
  allCotanWeights<Into extends Floats = Float64Array>(into?: Into): Into {
    return forAllEdges(this, 1, Float64Array, into, (links, e, out) => {
      out[e] = measures.cotanWeight(links, e);
    });
  }

  /** By halfedge, each {@link cornerAngle}. */
  allCornerAngles<Into extends Floats = Float64Array>(into?: Into): Into {
    return forAll(this, this.halfedgeCount, 1, Float64Array, into, (links, h, out) => {
      out[h] = measures.cornerAngle(links, h);
    });
  }

  // ---- vertices ---------------------------------------------------------------------------------

  /**
   * The unit normal at `v`: the mean of the normals of its faces, weighted by their areas. Zeros if it has no face, or
   * if the normals cancel each other.
   */
  vertexNormal(v: VertexLike): XYZ {
    const links = directedLinksOf(this);
    links.checkVertex(v);
    return pointOf((out) => measures.writeVertexNormal(links, v, out, 0));
  }

  /**
   * The part of the surface that belongs to `v`: a third of each of its faces. The areas of all vertices add up to
   * that of the mesh.
   */
  vertexArea(v: VertexLike): number {
    const links = directedLinksOf(this);
    links.checkVertex(v);
    return measures.vertexArea(links, v);
  }

  /**
   * What the angles of the faces at `v` lack to a full turn; half a turn counts as filled for each boundary halfedge
   * that leaves `v`. It is the Gaussian curvature that lies at `v`. The angle defects of all vertices add up to 2π
   * times `eulerCharacteristic()`.
   */
  angleDefect(v: VertexLike): number {
    const links = directedLinksOf(this);
    links.checkVertex(v);
    return measures.angleDefect(links, v);
  }

  /** By vertex, x, y and z of each {@link vertexNormal}. */
  allVertexNormals<Into extends Floats = Float32Array>(into?: Into): Into {
    const links = alive(this);
    const out = arrayFor(3 * links.vertices, Float32Array, links.positions, into) as Into;
    measures.writeVertexNormals(links, out);
    return out;
  }

  /** By vertex, each {@link vertexArea}. */
  allVertexAreas<Into extends Floats = Float64Array>(into?: Into): Into {
    const links = alive(this);
    const out = arrayFor(links.vertices, Float64Array, links.positions, into) as Into;
    measures.writeVertexAreas(links, out);
    return out;
  }

  /** By vertex, each {@link angleDefect}. */
  allAngleDefects<Into extends Floats = Float64Array>(into?: Into): Into {
    return forAll(this, this.vertexCount, 1, Float64Array, into, (links, v, out) => {
      out[v] = measures.angleDefect(links, v);
    });
  }

  // ---- the whole mesh ---------------------------------------------------------------------------

  /** The sum of all {@link faceArea}s. O(faces). */
  area(): number {
    return measures.totalArea(alive(this));
  }

  /**
   * The volume inside of this mesh, negative if its faces look inwards. Components that lie inside of others count
   * with their own sign: those of a cavity, whose faces look into it, are taken away. O(halfedges).
   *
   * @throws HalfedgeError `open-surface` if there is a boundary, where the inside leaks out
   */
  volume(): number {
    const links = alive(this);
    checkClosed(boundaryLoopsOf(links).length, 'fillHoles() of toMesh()');
    return measures.enclosedVolume(links);
  }

  /**
   * The smallest box along the axes that holds all vertices, isolated ones too, but not those that have a coordinate
   * that is infinite or NaN. Null if there is no vertex. O(vertices).
   */
  boundingBox(): Box | null {
    const links = alive(this);
    return boxOf(links, links.vertices);
  }
}

/** The links of a mesh, whose views are good until something allocates. */
function alive(mesh: DirectedEdgesGeometry): DirectedLinks {
  const links = directedLinksOf(mesh);
  links.revive();
  return links;
}

/** Calls `write` for each of `count` items. */
function forAll<Into extends Floats>(
  mesh: DirectedEdgesGeometry,
  count: number,
  components: 1 | 3,
  Default: FloatsConstructor,
  into: Into | undefined,
  write: (links: DirectedLinks, item: number, out: Floats) => void,
): Into {
  const links = alive(mesh);
  const out = arrayFor(components * count, Default, links.positions, into);
  for (let i = 0; i < count; i++) write(links, i, out);
  return out as Into;
}

/** Calls `write` for each edge; the rest is zeros. */
function forAllEdges<Into extends Floats>(
  mesh: DirectedEdgesGeometry,
  components: 1 | 3,
  Default: FloatsConstructor,
  into: Into | undefined,
  write: (links: DirectedLinks, e: number, out: Floats) => void,
): Into {
  const links = alive(mesh);
  const { opposite, sides } = links;
  const out = arrayFor(components * sides, Default, links.positions, into);
  out.fill(0);
  for (let e = 0; e < sides; e++) if (opposite[e] >= e) write(links, e, out);
  return out as Into;
}
