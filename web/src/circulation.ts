import { checkOptions } from './arguments.js';
import { BulkRings } from './bulk.js';
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
} from './items.js';
import { Circulator, type CirculatorKind, lap, liveItems } from './laps.js';
import { linksOf } from './navigation.js';

/** Which way a circulator goes, and where it begins. */
export interface CirculateOptions {
  /** Default: 'ccw'. */
  direction?: Direction;
  /** A halfedge that leaves the vertex, or lies in the face, to begin at. Edges and loops have none. */
  start?: HalfedgeLike;
}

/**
 * Circulators: what lies around one item, one lap of it.
 *
 * Around a vertex, 'cw' begins at its anchor, and 'ccw' is the exact reverse; on the boundary both
 * list an open path from one boundary neighbour to the other. Around a face, 'ccw' begins with the
 * first vertex of the input, and 'cw' is the exact reverse. With a `start` both directions begin at
 * that halfedge. Sides without a face are skipped. An isolated vertex has nothing around it.
 */
export abstract class Circulation extends BulkRings {
  /** The one-ring: the vertices that share an edge with `v`. */
  vertexVertices(
    v: VertexLike,
    direction: Direction = 'ccw',
    start?: HalfedgeLike,
  ): Iterable<Vertex> {
    return lap(linksOf(this), 'vertexVertices', v, direction, start) as Vertex[];
  }

  /** The halfedges that leave `v`. */
  vertexOutgoingHalfedges(
    v: VertexLike,
    direction: Direction = 'ccw',
    start?: HalfedgeLike,
  ): Iterable<Halfedge> {
    return lap(linksOf(this), 'vertexOutgoingHalfedges', v, direction, start) as Halfedge[];
  }

  /** The halfedges that arrive at `v`; `start` is still one that leaves it. */
  vertexIncomingHalfedges(
    v: VertexLike,
    direction: Direction = 'ccw',
    start?: HalfedgeLike,
  ): Iterable<Halfedge> {
    return lap(linksOf(this), 'vertexIncomingHalfedges', v, direction, start) as Halfedge[];
  }

  /** The edges at `v`. */
  vertexEdges(v: VertexLike, direction: Direction = 'ccw', start?: HalfedgeLike): Iterable<Edge> {
    return lap(linksOf(this), 'vertexEdges', v, direction, start) as Edge[];
  }

  /** The faces at `v`. */
  vertexFaces(v: VertexLike, direction: Direction = 'ccw', start?: HalfedgeLike): Iterable<Face> {
    return lap(linksOf(this), 'vertexFaces', v, direction, start) as Face[];
  }

  /** The corners of `f`. */
  faceVertices(f: FaceLike, direction: Direction = 'ccw', start?: HalfedgeLike): Iterable<Vertex> {
    return lap(linksOf(this), 'faceVertices', f, direction, start) as Vertex[];
  }

  /** The halfedges of `f`. */
  faceHalfedges(
    f: FaceLike,
    direction: Direction = 'ccw',
    start?: HalfedgeLike,
  ): Iterable<Halfedge> {
    return lap(linksOf(this), 'faceHalfedges', f, direction, start) as Halfedge[];
  }

  /** The edges of `f`. */
  faceEdges(f: FaceLike, direction: Direction = 'ccw', start?: HalfedgeLike): Iterable<Edge> {
    return lap(linksOf(this), 'faceEdges', f, direction, start) as Edge[];
  }

  /** The neighbour across each edge of `f`: one that shares several edges comes as often. */
  faceFaces(f: FaceLike, direction: Direction = 'ccw', start?: HalfedgeLike): Iterable<Face> {
    return lap(linksOf(this), 'faceFaces', f, direction, start) as Face[];
  }

  /** The two ends of `e`, side 0 first. */
  edgeVertices(e: EdgeLike): Iterable<Vertex> {
    return lap(linksOf(this), 'edgeVertices', e, 'ccw') as Vertex[];
  }

  /** The two halfedges of `e`, side 0 first. */
  edgeHalfedges(e: EdgeLike): Iterable<Halfedge> {
    return lap(linksOf(this), 'edgeHalfedges', e, 'ccw') as Halfedge[];
  }

  /** The one or two faces of `e`, side 0 first. */
  edgeFaces(e: EdgeLike): Iterable<Face> {
    return lap(linksOf(this), 'edgeFaces', e, 'ccw') as Face[];
  }

  /** The face loop or boundary loop through `h`, beginning at `h`. */
  halfedgeLoop(h: HalfedgeLike, direction: Direction = 'ccw'): Iterable<Halfedge> {
    return lap(linksOf(this), 'halfedgeLoop', h, direction) as Halfedge[];
  }

  /** All live vertices, in index order. */
  vertices(): Iterable<Vertex> {
    return liveItems(linksOf(this), 'vertex') as Vertex[];
  }

  /** All live halfedges, in index order. */
  halfedges(): Iterable<Halfedge> {
    return liveItems(linksOf(this), 'halfedge') as Halfedge[];
  }

  /** All live edges, in index order. */
  edges(): Iterable<Edge> {
    return liveItems(linksOf(this), 'edge') as Edge[];
  }

  /** All live faces, in index order. */
  faces(): Iterable<Face> {
    return liveItems(linksOf(this), 'face') as Face[];
  }

  /** An endless circulator around one item; `kind` is the name of one of the methods above. */
  circulate(kind: CirculatorKind, item: number, options: CirculateOptions = {}): Circulator {
    const { direction = 'ccw', start } = checkOptions(options) as CirculateOptions;
    return new Circulator(linksOf(this), kind, item, direction, start);
  }
}
