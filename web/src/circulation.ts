import * as around from './around.js';
import { BulkRings } from './bulk.js';
import * as making from './circulate.js';
import type * as circulator from './circulator.js';
import { CLASSES } from './circulators.js';
import { displayed } from './inspect.js';
import type {
  Direction,
  Edge,
  EdgeLike,
  Face,
  FaceLike,
  Halfedge,
  HalfedgeLike,
  PlainNumber,
  Vertex,
  VertexLike,
} from './items.js';
import { LiveItems } from './live.js';
import * as navigation from './navigation.js';
import * as orbit from './orbit.js';
import type { RingKind } from './rings.js';
import * as walks from './walks.js';

// Constants of this module's own: see walks.ts.
const { linksOf } = navigation;
const { aroundEdge, aroundFace, aroundLoop, aroundVertex } = around;
const { LONGEST, MAKERS, noSuchKind } = making;
const { EDGE, FACE, ITSELF, OPPOSITE, OPPOSITE_FACE, TO_VERTEX } = walks;
type CirculateOptions = circulator.CirculateOptions;
type Orbit<Item extends number> = orbit.Orbit<Item>;
type Circulator<Item extends number, Around extends number> = circulator.Circulator<Item, Around>;

/**
 * The circulators that `circulate` knows, by the names of their methods: all those that go around one item.
 */
export type CirculatorKind = RingKind | 'halfedgeLoop';

/** What a circulator shows. */
export type Shown<Kind extends CirculatorKind> =
  ReturnType<Circulation[Kind]> extends Orbit<infer Item> ? Item : never;

/** What a circulator goes around. */
export type CirculatorCentre<Kind extends CirculatorKind> =
  | PlainNumber
  | {
      [Name in CirculatorKind]: Parameters<Circulation[Name]>[0];
    }[Kind];

/**
 * Circulators: one lap around an item, counter-clockwise unless `direction` says otherwise.
 *
 * Around a vertex, 'cw' begins at its anchor, and 'ccw' is the exact reverse; on the boundary both list an
 * open path from one boundary neighbour to the other. Around a face, 'ccw' begins with the first vertex of
 * the input, and 'cw' is the exact reverse. With a `start`, both directions begin at that halfedge.
 * Circulators of faces skip sides without a face. An isolated vertex has nothing around it.
 */
export abstract class Circulation extends BulkRings {
  /** The one-ring: the vertices that share an edge with `v`. */
  vertexVertices(v: VertexLike, direction: Direction = 'ccw', start?: HalfedgeLike): Orbit<Vertex> {
    return aroundVertex(linksOf(this), v, direction, start, TO_VERTEX);
  }

  /** The halfedges that leave `v`. */
  vertexOutgoingHalfedges(
    v: VertexLike,
    direction: Direction = 'ccw',
    start?: HalfedgeLike,
  ): Orbit<Halfedge> {
    return aroundVertex(linksOf(this), v, direction, start, ITSELF);
  }

  /**
   * The halfedges that arrive at `v`. `start` is one of them, or one that leaves `v`; its opposite is then
   * the first.
   */
  vertexIncomingHalfedges(
    v: VertexLike,
    direction: Direction = 'ccw',
    start?: HalfedgeLike,
  ): Orbit<Halfedge> {
    return aroundVertex(linksOf(this), v, direction, start, OPPOSITE);
  }

  /** The edges at `v`. */
  vertexEdges(v: VertexLike, direction: Direction = 'ccw', start?: HalfedgeLike): Orbit<Edge> {
    return aroundVertex(linksOf(this), v, direction, start, EDGE);
  }

  /** The faces at `v`. */
  vertexFaces(v: VertexLike, direction: Direction = 'ccw', start?: HalfedgeLike): Orbit<Face> {
    return aroundVertex(linksOf(this), v, direction, start, FACE);
  }

  /** The corners of `f`. */
  faceVertices(f: FaceLike, direction: Direction = 'ccw', start?: HalfedgeLike): Orbit<Vertex> {
    return aroundFace(linksOf(this), f, direction, start, TO_VERTEX);
  }

  /** The halfedges of `f`. */
  faceHalfedges(f: FaceLike, direction: Direction = 'ccw', start?: HalfedgeLike): Orbit<Halfedge> {
    return aroundFace(linksOf(this), f, direction, start, ITSELF);
  }

  /** The edges of `f`. */
  faceEdges(f: FaceLike, direction: Direction = 'ccw', start?: HalfedgeLike): Orbit<Edge> {
    return aroundFace(linksOf(this), f, direction, start, EDGE);
  }

  /** The neighbour across each edge of `f`. One that shares several edges with `f` occurs that many times. */
  faceFaces(f: FaceLike, direction: Direction = 'ccw', start?: HalfedgeLike): Orbit<Face> {
    return aroundFace(linksOf(this), f, direction, start, OPPOSITE_FACE);
  }

  /** The two ends of `e`, side 0 first. */
  edgeVertices(e: EdgeLike): Orbit<Vertex> {
    return aroundEdge(linksOf(this), e, TO_VERTEX);
  }

  /** The two halfedges of `e`, side 0 first. */
  edgeHalfedges(e: EdgeLike): Orbit<Halfedge> {
    return aroundEdge(linksOf(this), e, ITSELF);
  }

  /** The one or two faces of `e`, side 0 first. */
  edgeFaces(e: EdgeLike): Orbit<Face> {
    return aroundEdge(linksOf(this), e, FACE);
  }

  /** The face loop or boundary loop through `h`, beginning at `h`. */
  halfedgeLoop(h: HalfedgeLike, direction: Direction = 'ccw'): Orbit<Halfedge> {
    return aroundLoop(linksOf(this), h, direction, ITSELF);
  }

  /** All live vertices, in index order. */
  vertices(): LiveItems<Vertex> {
    return new LiveItems(linksOf(this), 'vertex');
  }

  /** All live halfedges, in index order. */
  halfedges(): LiveItems<Halfedge> {
    return new LiveItems(linksOf(this), 'halfedge');
  }

  /** All live edges, in index order. */
  edges(): LiveItems<Edge> {
    return new LiveItems(linksOf(this), 'edge');
  }

  /** All live faces, in index order. */
  faces(): LiveItems<Face> {
    return new LiveItems(linksOf(this), 'face');
  }

  /**
   * An endless circulator around one item; `kind` is the name of one of the methods above. It begins where a
   * lap of that method begins. For laps around the faces of an open mesh, `for...of` is faster.
   *
   * @param options or just a direction, which is faster in a loop that makes many circulators
   */
  circulate<Kind extends CirculatorKind>(
    kind: Kind,
    item: CirculatorCentre<Kind>,
    options: Direction | CirculateOptions = 'ccw',
  ): Circulator<Shown<Kind>, CirculatorCentre<Kind>> {
    if (typeof kind !== 'string' || kind.length > LONGEST) throw noSuchKind(kind);
    return MAKERS[kind.length](linksOf(this), kind, item, options) as never;
  }
}

displayed('Orbit', orbit.Orbit, (lap) => lap.toArray());
displayed('LiveItems', LiveItems, (items) => items.toArray());
for (const Class of CLASSES) {
  displayed('Circulator', Class, ({ current, halfedge }) => ({ current, halfedge }));
}
