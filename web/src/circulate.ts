import { describe } from './arguments.js';
import { refuse } from './checks.js';
import * as circulator from './circulator.js';
import * as circulators from './circulators.js';
import type { Direction } from './items.js';
import type { Links } from './links.js';
import { checkOptions } from './options.js';
import * as walks from './walks.js';

// Constants of this module's own: see walks.ts.
const { CIRCULATE_OPTIONS, anchorsOf, kindOf, slowly } = circulator;
const {
  Across,
  FacesAlongNext,
  FacesAlongPrev,
  IndicesAlongNext,
  IndicesAlongPrev,
  VerticesAlongNext,
  VerticesAlongPrev,
  beginAlongNext,
  beginAlongPrev,
  beginFacesAlongNext,
  beginFacesAlongPrev,
} = circulators;
const { ACROSS, EDGE, FACE, ITSELF, OPPOSITE, OPPOSITE_FACE, TO_VERTEX, beginsAtHome } = walks;
type CirculateOptions = circulator.CirculateOptions;
type Going = circulators.Going;
type Course = circulator.Course;

/** How `circulate` makes one: by a direction alone, or by options. */
export type Way = Direction | CirculateOptions;

const VERTEX_VERTICES = kindOf('vertex', TO_VERTEX);
const VERTEX_OUTGOING_HALFEDGES = kindOf('vertex', ITSELF);
const VERTEX_INCOMING_HALFEDGES = kindOf('vertex', OPPOSITE);
const VERTEX_EDGES = kindOf('vertex', EDGE);
const VERTEX_FACES = kindOf('vertex', FACE);
const FACE_VERTICES = kindOf('face', TO_VERTEX);
const FACE_HALFEDGES = kindOf('face', ITSELF);
const FACE_EDGES = kindOf('face', EDGE);
const FACE_FACES = kindOf('face', OPPOSITE_FACE);

/** All kinds, by their names. */
export const KINDS = {
  vertexVertices: VERTEX_VERTICES,
  vertexOutgoingHalfedges: VERTEX_OUTGOING_HALFEDGES,
  vertexIncomingHalfedges: VERTEX_INCOMING_HALFEDGES,
  vertexEdges: VERTEX_EDGES,
  vertexFaces: VERTEX_FACES,
  faceVertices: FACE_VERTICES,
  faceHalfedges: FACE_HALFEDGES,
  faceEdges: FACE_EDGES,
  faceFaces: FACE_FACES,
  edgeVertices: kindOf('edge', TO_VERTEX),
  edgeHalfedges: kindOf('edge', ITSELF),
  edgeFaces: kindOf('edge', FACE),
  halfedgeLoop: kindOf('loop', ITSELF),
};
Object.setPrototypeOf(KINDS, null); // `constructor` is no kind

/** Makes a circulator of the kind of that name. */
type Maker = (links: Links, kind: string, item: number, way: Way) => Going;

/** By options, of a rare kind, or of none. */
const circulateOther: Maker = (links, kind, item, way) => {
  const { course, start } = courseBy(kind, way);
  const { centre, walk, view } = course;
  const [prevClass, nextClass] =
    view === TO_VERTEX
      ? [VerticesAlongPrev, VerticesAlongNext]
      : view < TO_VERTEX
        ? [IndicesAlongPrev, IndicesAlongNext]
        : [FacesAlongPrev, FacesAlongNext];
  const Class = walk === ACROSS ? Across : beginsAtHome(walk) ? nextClass : prevClass;
  const at = slowly.begin(links, course, item, start);
  return new Class(links, course, anchorsOf(links, centre), at);
};

/** How long the longest name of a kind is. */
export const LONGEST = 'vertexOutgoingHalfedges'.length;

// Each is written out, because V8 keeps its notes by the text of a function; and apart from the others, because it
// counts the whole text of what it inlines.

const vertexVerticesCcw = (links: Links, item: number): Going => {
  const at = beginAlongPrev(links, VERTEX_VERTICES.ccw, links.vertexAnchors, item);
  return new VerticesAlongPrev(links, VERTEX_VERTICES.ccw, links.vertexAnchors, at);
};

const vertexVerticesCw = (links: Links, item: number): Going => {
  const at = beginAlongNext(links, VERTEX_VERTICES.cw, links.vertexAnchors, item);
  return new VerticesAlongNext(links, VERTEX_VERTICES.cw, links.vertexAnchors, at);
};

const vertexOutgoingHalfedgesCcw = (links: Links, item: number): Going => {
  const at = beginAlongPrev(links, VERTEX_OUTGOING_HALFEDGES.ccw, links.vertexAnchors, item);
  return new IndicesAlongPrev(links, VERTEX_OUTGOING_HALFEDGES.ccw, links.vertexAnchors, at);
};

const vertexOutgoingHalfedgesCw = (links: Links, item: number): Going => {
  const at = beginAlongNext(links, VERTEX_OUTGOING_HALFEDGES.cw, links.vertexAnchors, item);
  return new IndicesAlongNext(links, VERTEX_OUTGOING_HALFEDGES.cw, links.vertexAnchors, at);
};

const vertexIncomingHalfedgesCcw = (links: Links, item: number): Going => {
  const at = beginAlongPrev(links, VERTEX_INCOMING_HALFEDGES.ccw, links.vertexAnchors, item);
  return new IndicesAlongPrev(links, VERTEX_INCOMING_HALFEDGES.ccw, links.vertexAnchors, at);
};

const vertexIncomingHalfedgesCw = (links: Links, item: number): Going => {
  const at = beginAlongNext(links, VERTEX_INCOMING_HALFEDGES.cw, links.vertexAnchors, item);
  return new IndicesAlongNext(links, VERTEX_INCOMING_HALFEDGES.cw, links.vertexAnchors, at);
};

const vertexEdgesCcw = (links: Links, item: number): Going => {
  const at = beginAlongPrev(links, VERTEX_EDGES.ccw, links.vertexAnchors, item);
  return new IndicesAlongPrev(links, VERTEX_EDGES.ccw, links.vertexAnchors, at);
};

const vertexEdgesCw = (links: Links, item: number): Going => {
  const at = beginAlongNext(links, VERTEX_EDGES.cw, links.vertexAnchors, item);
  return new IndicesAlongNext(links, VERTEX_EDGES.cw, links.vertexAnchors, at);
};

const vertexFacesCcw = (links: Links, item: number): Going => {
  const at = beginFacesAlongPrev(links, VERTEX_FACES.ccw, links.vertexAnchors, item);
  return new FacesAlongPrev(links, VERTEX_FACES.ccw, links.vertexAnchors, at);
};

const vertexFacesCw = (links: Links, item: number): Going => {
  const at = beginFacesAlongNext(links, VERTEX_FACES.cw, links.vertexAnchors, item);
  return new FacesAlongNext(links, VERTEX_FACES.cw, links.vertexAnchors, at);
};

const faceVerticesCcw = (links: Links, item: number): Going => {
  const at = beginAlongNext(links, FACE_VERTICES.ccw, links.faceAnchors, item);
  return new VerticesAlongNext(links, FACE_VERTICES.ccw, links.faceAnchors, at);
};

const faceVerticesCw = (links: Links, item: number): Going => {
  const at = beginAlongPrev(links, FACE_VERTICES.cw, links.faceAnchors, item);
  return new VerticesAlongPrev(links, FACE_VERTICES.cw, links.faceAnchors, at);
};

const faceHalfedgesCcw = (links: Links, item: number): Going => {
  const at = beginAlongNext(links, FACE_HALFEDGES.ccw, links.faceAnchors, item);
  return new IndicesAlongNext(links, FACE_HALFEDGES.ccw, links.faceAnchors, at);
};

const faceHalfedgesCw = (links: Links, item: number): Going => {
  const at = beginAlongPrev(links, FACE_HALFEDGES.cw, links.faceAnchors, item);
  return new IndicesAlongPrev(links, FACE_HALFEDGES.cw, links.faceAnchors, at);
};

const faceEdgesCcw = (links: Links, item: number): Going => {
  const at = beginAlongNext(links, FACE_EDGES.ccw, links.faceAnchors, item);
  return new IndicesAlongNext(links, FACE_EDGES.ccw, links.faceAnchors, at);
};

const faceEdgesCw = (links: Links, item: number): Going => {
  const at = beginAlongPrev(links, FACE_EDGES.cw, links.faceAnchors, item);
  return new IndicesAlongPrev(links, FACE_EDGES.cw, links.faceAnchors, at);
};

const faceFacesCcw = (links: Links, item: number): Going => {
  const at = beginFacesAlongNext(links, FACE_FACES.ccw, links.faceAnchors, item);
  return new FacesAlongNext(links, FACE_FACES.ccw, links.faceAnchors, at);
};

const faceFacesCw = (links: Links, item: number): Going => {
  const at = beginFacesAlongPrev(links, FACE_FACES.cw, links.faceAnchors, item);
  return new FacesAlongPrev(links, FACE_FACES.cw, links.faceAnchors, at);
};

/**
 * By the length of the name. While V8 inlines it knows how long a name in a program is, and what a frozen array
 * has there, but not yet that two names are the same: it would inline whatever the program goes around anywhere.
 */
export const MAKERS: readonly Maker[] = Object.freeze(
  Object.assign(new Array<Maker>(LONGEST + 1).fill(circulateOther), {
    9: (links, kind, item, way) => {
      if (kind === 'faceEdges') {
        if (way === 'ccw') return faceEdgesCcw(links, item);
        if (way === 'cw') return faceEdgesCw(links, item);
      }
      if (kind === 'faceFaces') {
        if (way === 'ccw') return faceFacesCcw(links, item);
        if (way === 'cw') return faceFacesCw(links, item);
      }
      return circulateOther(links, kind, item, way);
    },
    11: (links, kind, item, way) => {
      if (kind === 'vertexEdges') {
        if (way === 'ccw') return vertexEdgesCcw(links, item);
        if (way === 'cw') return vertexEdgesCw(links, item);
      }
      if (kind === 'vertexFaces') {
        if (way === 'ccw') return vertexFacesCcw(links, item);
        if (way === 'cw') return vertexFacesCw(links, item);
      }
      return circulateOther(links, kind, item, way);
    },
    12: (links, kind, item, way) => {
      if (kind === 'faceVertices') {
        if (way === 'ccw') return faceVerticesCcw(links, item);
        if (way === 'cw') return faceVerticesCw(links, item);
      }
      return circulateOther(links, kind, item, way);
    },
    13: (links, kind, item, way) => {
      if (kind === 'faceHalfedges') {
        if (way === 'ccw') return faceHalfedgesCcw(links, item);
        if (way === 'cw') return faceHalfedgesCw(links, item);
      }
      return circulateOther(links, kind, item, way);
    },
    14: (links, kind, item, way) => {
      if (kind === 'vertexVertices') {
        if (way === 'ccw') return vertexVerticesCcw(links, item);
        if (way === 'cw') return vertexVerticesCw(links, item);
      }
      return circulateOther(links, kind, item, way);
    },
    23: (links, kind, item, way) => {
      if (kind === 'vertexOutgoingHalfedges') {
        if (way === 'ccw') return vertexOutgoingHalfedgesCcw(links, item);
        if (way === 'cw') return vertexOutgoingHalfedgesCw(links, item);
      }
      if (kind === 'vertexIncomingHalfedges') {
        if (way === 'ccw') return vertexIncomingHalfedgesCcw(links, item);
        if (way === 'cw') return vertexIncomingHalfedgesCw(links, item);
      }
      return circulateOther(links, kind, item, way);
    },
  } satisfies Record<number, Maker>),
);

/** The course of the kind of that name, by a direction or by options; and where it starts. */
export function courseBy(
  kind: string,
  way: Way,
): Pick<CirculateOptions, 'start'> & { course: Course } {
  const found = KINDS[kind as keyof typeof KINDS];
  if (found === undefined) throw noSuchKind(kind);
  const { direction = 'ccw', start } =
    typeof way === 'string' ? { direction: way } : checkOptions(way, CIRCULATE_OPTIONS);
  if (direction !== 'ccw' && direction !== 'cw') {
    return refuse('direction', direction, "'ccw' or 'cw'", 'string');
  }
  return { course: found[direction], start };
}

export function noSuchKind(kind: unknown): Error {
  const kinds = Object.keys(KINDS).join(', ');
  const sentence = `kind is ${describe(kind)}; expected one of ${kinds}.`;
  return typeof kind === 'string' ? new RangeError(sentence) : new TypeError(sentence);
}
