// Consumers whose own `lib` has no Symbol.dispose need this; the emitted types keep it.
/// <reference lib="esnext.disposable" preserve="true" />

import { buildDirectedEdges } from '../build.js';
import { refuse } from '../checks.js';
import * as circulate from '../circulate.js';
import type { CirculatorCentre, CirculatorKind, Shown } from '../circulation.js';
import type { CirculateOptions } from '../circulator.js';
import type { Problem } from '../errors.js';
import { displayed, printed } from '../inspect.js';
import type {
  Direction,
  Edge,
  EdgeLike,
  Face,
  FaceLike,
  Halfedge,
  HalfedgeLike,
  Vertex,
  VertexLike,
} from '../items.js';
import { Links } from '../links.js';
import { core } from '../loader.js';
import { HalfedgeMesh } from '../mesh.js';
import { linksOf } from '../navigation.js';
import { unwrap } from '../reports.js';
import { type Computed, checkLevel, findings, type LinkLevel } from '../topology.js';
import * as walks from '../walks.js';
import * as around from './around.js';
import * as circulators from './circulators.js';
import { DirectedEdgesGeometry } from './geometry.js';
import { boundaryLoopsOf, DirectedLinks } from './links.js';
import * as navigation from './navigation.js';
import { DirectedOrbit } from './orbit.js';
import { DirectedItems } from './ranges.js';

// Constants of this module's own: see walks.ts.
const { LONGEST, noSuchKind } = circulate;
const { CLASSES, MAKERS } = circulators;
const { directedLinksOf } = navigation;
const { aroundEdge, aroundFace, aroundLoop, aroundVertex } = around;
const { EDGE, FACE, ITSELF, OPPOSITE, OPPOSITE_FACE, TO_VERTEX } = walks;
type DirectedCirculator<
  Item extends number,
  Around extends number,
> = circulators.DirectedCirculator<Item, Around>;

const disposeSymbol: typeof Symbol.dispose = Symbol.dispose ?? Symbol.for('Symbol.dispose');

/**
 * A triangle mesh in about half the memory: Directed Edges (Campagna, Kobbelt, Seidel 1998), 64 bytes per
 * vertex of a closed mesh, positions included. The three halfedges of face f are 3 f, 3 f + 1 and 3 f + 2, so
 * `next`, `prev` and `face` are arithmetic. Boundary halfedges come after those of all faces.
 *
 * Links, circulators, queries about single items and measures are those of a {@link HalfedgeMesh}, in the same order
 * and with the same errors. The differences: it can't be edited; `opposite(h)` is not `h ^ 1`; and an edge
 * has the index of the smaller of its two halfedges, so edge indices have gaps. For edits, and for everything
 * else that a HalfedgeMesh has (rows of all rings, neighbourhoods, components, attributes, files), convert it
 * with {@link toMesh}.
 *
 * ```ts
 * await init();
 * using mesh = DirectedEdgesMesh.fromTriangles([0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 2]);
 * for (const w of mesh.vertexVertices(0)) console.log(w);
 * geometry.setIndex(new BufferAttribute(mesh.indices, 1)); // no copy
 * ```
 */
export class DirectedEdgesMesh extends DirectedEdgesGeometry {
  /** By {@link fromTriangles} and {@link fromMesh}. */
  private constructor(links: DirectedLinks) {
    if (!(links instanceof DirectedLinks)) {
      throw new TypeError(
        'A DirectedEdgesMesh is not made by `new`; expected DirectedEdgesMesh.fromTriangles(positions, indices) or fromMesh(mesh).',
      );
    }
    super(links);
  }

  static #adopt(address: number): DirectedEdgesMesh {
    return new DirectedEdgesMesh(new DirectedLinks(core(), address));
  }

  /**
   * Makes the mesh of an index buffer; accepts and refuses what {@link HalfedgeMesh.fromTriangles} does.
   * Vertex i and face j are vertex i and face j of the input, which is copied.
   *
   * @param positions x, y, z of each vertex
   * @param indices three vertices of each face, counter-clockwise
   * @throws HalfedgeError, TypeError, RangeError as there
   */
  static fromTriangles(
    positions: ArrayLike<number>,
    indices: ArrayLike<number>,
  ): DirectedEdgesMesh {
    return DirectedEdgesMesh.#adopt(buildDirectedEdges(positions, indices));
  }

  /**
   * Makes Directed Edges from a mesh: with the same vertices, faces and positions, and with every circulator
   * beginning at the same place.
   *
   * @throws HalfedgeError `not-a-triangle` for the first face that doesn't have three corners, `deleted-item`
   * for a mesh that is not compact, `corrupt-connectivity`, `out-of-memory`
   */
  static fromMesh(mesh: HalfedgeMesh): DirectedEdgesMesh {
    if (!(mesh instanceof HalfedgeMesh)) refuse('mesh', mesh, 'a HalfedgeMesh');
    const links = linksOf(mesh);
    return DirectedEdgesMesh.#adopt(unwrap(links.core.directedEdgesFromMesh(links.address)).mesh);
  }

  /**
   * Makes the full mesh: with the same vertices, faces and positions, and with edges numbered as by
   * {@link HalfedgeMesh.fromTriangles}. The inverse of {@link fromMesh}.
   *
   * @throws HalfedgeError `corrupt-connectivity`, `out-of-memory`
   */
  toMesh(): HalfedgeMesh {
    const { core, address } = directedLinksOf(this);
    return new HalfedgeMesh(new Links(core, unwrap(core.directedEdgesToMesh(address)).mesh));
  }

  /** The one-ring: the vertices that share an edge with `v`. */
  vertexVertices(
    v: VertexLike,
    direction: Direction = 'ccw',
    start?: HalfedgeLike,
  ): DirectedOrbit<Vertex> {
    return aroundVertex(directedLinksOf(this), v, direction, start, TO_VERTEX);
  }

  /** The halfedges that leave `v`. */
  vertexOutgoingHalfedges(
    v: VertexLike,
    direction: Direction = 'ccw',
    start?: HalfedgeLike,
  ): DirectedOrbit<Halfedge> {
    return aroundVertex(directedLinksOf(this), v, direction, start, ITSELF);
  }

  /** The halfedges that arrive at `v`. */
  vertexIncomingHalfedges(
    v: VertexLike,
    direction: Direction = 'ccw',
    start?: HalfedgeLike,
  ): DirectedOrbit<Halfedge> {
    return aroundVertex(directedLinksOf(this), v, direction, start, OPPOSITE);
  }

  /** The edges at `v`. */
  vertexEdges(
    v: VertexLike,
    direction: Direction = 'ccw',
    start?: HalfedgeLike,
  ): DirectedOrbit<Edge> {
    return aroundVertex(directedLinksOf(this), v, direction, start, EDGE);
  }

  /** The faces at `v`. */
  vertexFaces(
    v: VertexLike,
    direction: Direction = 'ccw',
    start?: HalfedgeLike,
  ): DirectedOrbit<Face> {
    return aroundVertex(directedLinksOf(this), v, direction, start, FACE);
  }

  /** The corners of `f`. */
  faceVertices(
    f: FaceLike,
    direction: Direction = 'ccw',
    start?: HalfedgeLike,
  ): DirectedOrbit<Vertex> {
    return aroundFace(directedLinksOf(this), f, direction, start, TO_VERTEX);
  }

  /** The halfedges of `f`. */
  faceHalfedges(
    f: FaceLike,
    direction: Direction = 'ccw',
    start?: HalfedgeLike,
  ): DirectedOrbit<Halfedge> {
    return aroundFace(directedLinksOf(this), f, direction, start, ITSELF);
  }

  /** The edges of `f`. */
  faceEdges(f: FaceLike, direction: Direction = 'ccw', start?: HalfedgeLike): DirectedOrbit<Edge> {
    return aroundFace(directedLinksOf(this), f, direction, start, EDGE);
  }

  /** The neighbour across each edge of `f`. One that shares several edges with `f` occurs that many times. */
  faceFaces(f: FaceLike, direction: Direction = 'ccw', start?: HalfedgeLike): DirectedOrbit<Face> {
    return aroundFace(directedLinksOf(this), f, direction, start, OPPOSITE_FACE);
  }

  /** The two ends of `e`, side 0 first. */
  edgeVertices(e: EdgeLike): DirectedOrbit<Vertex> {
    return aroundEdge(directedLinksOf(this), e, TO_VERTEX);
  }

  /** The two halfedges of `e`, side 0 first. */
  edgeHalfedges(e: EdgeLike): DirectedOrbit<Halfedge> {
    return aroundEdge(directedLinksOf(this), e, ITSELF);
  }

  /** The one or two faces of `e`, side 0 first. */
  edgeFaces(e: EdgeLike): DirectedOrbit<Face> {
    return aroundEdge(directedLinksOf(this), e, FACE);
  }

  /** The face loop or boundary loop through `h`, beginning at `h`. */
  halfedgeLoop(h: HalfedgeLike, direction: Direction = 'ccw'): DirectedOrbit<Halfedge> {
    return aroundLoop(directedLinksOf(this), h, direction, ITSELF);
  }

  /** All vertices, in index order. */
  vertices(): DirectedItems<Vertex> {
    return new DirectedItems(directedLinksOf(this), this.vertexCount, false);
  }

  /** All halfedges, in index order. */
  halfedges(): DirectedItems<Halfedge> {
    return new DirectedItems(directedLinksOf(this), this.halfedgeCount, false);
  }

  /** All edges, in index order; their indices have gaps. */
  edges(): DirectedItems<Edge> {
    return new DirectedItems(directedLinksOf(this), this.edgeSlots, true);
  }

  /** All faces, in index order. */
  faces(): DirectedItems<Face> {
    return new DirectedItems(directedLinksOf(this), this.faceCount, false);
  }

  /**
   * An endless circulator around one item; `kind` is the name of one of the methods above. It begins
   * where a lap of that method does.
   *
   * @param options or a direction alone
   */
  circulate<Name extends CirculatorKind>(
    kind: Name,
    item: CirculatorCentre<Name>,
    options: Direction | CirculateOptions = 'ccw',
  ): DirectedCirculator<Shown<Name>, CirculatorCentre<Name>> {
    if (typeof kind !== 'string' || kind.length > LONGEST) throw noSuchKind(kind);
    return MAKERS[kind.length](directedLinksOf(this), kind, item, options) as never;
  }

  /** One halfedge of each boundary loop, in ascending order. O(boundary). */
  boundaryLoops(): Halfedge[] {
    return boundaryLoopsOf(directedLinksOf(this));
  }

  /** Vertices - edges + faces. */
  eulerCharacteristic(): number {
    return this.vertexCount - this.edgeCount + this.faceCount;
  }

  /**
   * Checks the invariants of `level` (0 to 4) and below, as {@link HalfedgeMesh.validate} does: an empty list
   * means valid. For `'geometry'`, ask the mesh that {@link toMesh} makes.
   */
  validate<Level extends number>(level: LinkLevel | Computed<Level> = 4): Problem[] {
    const { core, address } = directedLinksOf(this);
    return findings(core.validateDirectedEdges(address, checkLevel(level)));
  }

  /** Frees the memory of this mesh at once. Any later use throws; disposing twice does nothing. */
  dispose(): void {
    directedLinksOf(this).dispose();
  }

  /** Whether `dispose()` was called. */
  get disposed(): boolean {
    return directedLinksOf(this).disposed;
  }

  /** `dispose()`, at the end of the block that declares `using mesh = ...`. */
  [disposeSymbol](): void {
    this.dispose();
  }
}

printed('DirectedEdgesMesh', DirectedEdgesMesh, (mesh) => {
  if (mesh.disposed) return { disposed: true };
  const { vertexCount, edgeCount, faceCount } = mesh;
  return { vertexCount, edgeCount, faceCount };
});
displayed('DirectedOrbit', DirectedOrbit, (lap) => lap.toArray());
displayed('DirectedItems', DirectedItems, (items) => items.toArray());
for (const Class of CLASSES) {
  displayed('DirectedCirculator', Class, ({ current, halfedge }) => ({ current, halfedge }));
}
