import { describe } from './arguments.js';
import * as around from './around.js';
import { BulkRings } from './bulk.js';
import * as circulator from './circulator.js';
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
import type { Links } from './links.js';
import { LiveItems } from './live.js';
import * as navigation from './navigation.js';
import { checkOptions, type OptionNames } from './options.js';
import * as orbit from './orbit.js';
import type { RingKind } from './rings.js';
import * as walks from './walks.js';

// Constants of this module's own: see walks.ts.
const { linksOf } = navigation;
const { aroundEdge, aroundFace, aroundLoop, aroundVertex } = around;
const { Circulator, kindOf } = circulator;
const { EDGE, FACE, ITSELF, OPPOSITE, OPPOSITE_FACE, TO_VERTEX } = walks;
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

/** Which way a circulator goes, and where it begins. */
export interface CirculateOptions {
  /** Default: 'ccw'. */
  direction?: Direction | undefined;
  /**
   * A halfedge to begin at: one that leaves the vertex (`vertexIncomingHalfedges` also takes one that
   * arrives there), or one of the face. Edges and loops have none.
   */
  start?: HalfedgeLike | undefined;
}

export const CIRCULATE_OPTIONS: OptionNames<CirculateOptions> = { direction: true, start: true };

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
   * lap of that method begins. For a single lap, `for...of` over that method is faster in a program that goes
   * around several kinds of items.
   *
   * @param options or just a direction, which is faster in a loop that makes many circulators
   */
  circulate<Kind extends CirculatorKind>(
    kind: Kind,
    item: CirculatorCentre<Kind>,
    options: Direction | CirculateOptions = 'ccw',
  ): Circulator<Shown<Kind>, CirculatorCentre<Kind>> {
    // What is seldom stands apart: V8 inlines so many bytecodes into a loop, and then no more.
    if (typeof kind !== 'string' || typeof options !== 'string') {
      return circulateBy(linksOf(this), kind, item, options as CirculateOptions);
    }
    const around = KINDS[kind];
    if (around === undefined) throw noSuchKind(kind);
    return new Circulator<Shown<Kind>, CirculatorCentre<Kind>>(
      linksOf(this),
      around,
      options,
    ).moveTo(item);
  }
}

/** `circulate` with options that are no direction alone, or with what is no kind. */
function circulateBy<Kind extends CirculatorKind>(
  links: Links,
  kind: Kind,
  item: CirculatorCentre<Kind>,
  options: CirculateOptions,
): Circulator<Shown<Kind>, CirculatorCentre<Kind>> {
  const around = typeof kind === 'string' ? KINDS[kind] : undefined;
  if (around === undefined) throw noSuchKind(kind);
  const { direction = 'ccw', start } = checkOptions(options, CIRCULATE_OPTIONS);
  return new Circulator<Shown<Kind>, CirculatorCentre<Kind>>(links, around, direction).moveTo(
    item,
    start,
  );
}

displayed('Orbit', orbit.Orbit, (lap) => lap.toArray());
displayed('LiveItems', LiveItems, (items) => items.toArray());
displayed('Circulator', Circulator, ({ current, halfedge }) => ({ current, halfedge }));

const KINDS: Record<CirculatorKind, circulator.Kind> = {
  vertexVertices: kindOf('vertex', TO_VERTEX),
  vertexOutgoingHalfedges: kindOf('vertex', ITSELF),
  vertexIncomingHalfedges: kindOf('vertex', OPPOSITE),
  vertexEdges: kindOf('vertex', EDGE),
  vertexFaces: kindOf('vertex', FACE),
  faceVertices: kindOf('face', TO_VERTEX),
  faceHalfedges: kindOf('face', ITSELF),
  faceEdges: kindOf('face', EDGE),
  faceFaces: kindOf('face', OPPOSITE_FACE),
  edgeVertices: kindOf('edge', TO_VERTEX),
  edgeHalfedges: kindOf('edge', ITSELF),
  edgeFaces: kindOf('edge', FACE),
  halfedgeLoop: kindOf('loop', ITSELF),
};

Object.setPrototypeOf(KINDS, null); // `constructor` is no kind

function noSuchKind(kind: unknown): Error {
  const kinds = Object.keys(KINDS).join(', ');
  const sentence = `kind is ${describe(kind)}; expected one of ${kinds}.`;
  return typeof kind === 'string' ? new RangeError(sentence) : new TypeError(sentence);
}
