import type { Direction, EdgeLike, FaceLike, ItemList, VertexLike } from './items.js';
import { linksOf, Navigation } from './navigation.js';
import { type Rows, rings } from './rings.js';

/**
 * All rings of a mesh in one call: `all` plus the name of a circulator. Row i is the ring around item i, in
 * exactly the order of the circulator: counter-clockwise unless `direction` says otherwise. It is empty for
 * deleted slots and isolated vertices. This is faster than any loop in JavaScript.
 *
 * With a list of items, row i is the ring around the i-th of them. For edges, both directions have the same
 * order.
 *
 * `into`: the rows of an earlier call, to be overwritten. If their arrays have the right length, they are
 * returned; if they are longer, their first part; if they are shorter, new ones. This saves making and
 * clearing arrays, up to half the time of a call for a large mesh.
 */
export abstract class BulkRings extends Navigation {
  /** Row v: the one-ring vertices of vertex v. */
  allVertexVertices(
    direction: Direction = 'ccw',
    vertices?: ItemList<VertexLike>,
    into?: Rows,
  ): Rows {
    return rings(linksOf(this), 'vertexVertices', direction, vertices, into);
  }
  /** Row v: the halfedges that leave vertex v. */
  allVertexOutgoingHalfedges(
    direction: Direction = 'ccw',
    vertices?: ItemList<VertexLike>,
    into?: Rows,
  ): Rows {
    return rings(linksOf(this), 'vertexOutgoingHalfedges', direction, vertices, into);
  }
  /** Row v: the halfedges that arrive at vertex v. */
  allVertexIncomingHalfedges(
    direction: Direction = 'ccw',
    vertices?: ItemList<VertexLike>,
    into?: Rows,
  ): Rows {
    return rings(linksOf(this), 'vertexIncomingHalfedges', direction, vertices, into);
  }
  /** Row v: the edges at vertex v. */
  allVertexEdges(direction: Direction = 'ccw', vertices?: ItemList<VertexLike>, into?: Rows): Rows {
    return rings(linksOf(this), 'vertexEdges', direction, vertices, into);
  }
  /** Row v: the faces at vertex v. */
  allVertexFaces(direction: Direction = 'ccw', vertices?: ItemList<VertexLike>, into?: Rows): Rows {
    return rings(linksOf(this), 'vertexFaces', direction, vertices, into);
  }
  /** Row f: the corners of face f. */
  allFaceVertices(direction: Direction = 'ccw', faces?: ItemList<FaceLike>, into?: Rows): Rows {
    return rings(linksOf(this), 'faceVertices', direction, faces, into);
  }
  /** Row f: the halfedges of face f. */
  allFaceHalfedges(direction: Direction = 'ccw', faces?: ItemList<FaceLike>, into?: Rows): Rows {
    return rings(linksOf(this), 'faceHalfedges', direction, faces, into);
  }
  /** Row f: the edges of face f. */
  allFaceEdges(direction: Direction = 'ccw', faces?: ItemList<FaceLike>, into?: Rows): Rows {
    return rings(linksOf(this), 'faceEdges', direction, faces, into);
  }
  /** Row f: the neighbours across each edge of face f. */
  allFaceFaces(direction: Direction = 'ccw', faces?: ItemList<FaceLike>, into?: Rows): Rows {
    return rings(linksOf(this), 'faceFaces', direction, faces, into);
  }
  /** Row e: the two ends of edge e. Side 0 comes first. */
  allEdgeVertices(
    direction?: Direction | ItemList<EdgeLike>,
    edges?: ItemList<EdgeLike>,
    into?: Rows,
  ): Rows {
    return ringsOfEdges(this, 'edgeVertices', direction, edges, into);
  }
  /** Row e: the two halfedges of edge e. Side 0 comes first. */
  allEdgeHalfedges(
    direction?: Direction | ItemList<EdgeLike>,
    edges?: ItemList<EdgeLike>,
    into?: Rows,
  ): Rows {
    return ringsOfEdges(this, 'edgeHalfedges', direction, edges, into);
  }
  /** Row e: the one or two faces of edge e. Side 0 comes first. */
  allEdgeFaces(
    direction?: Direction | ItemList<EdgeLike>,
    edges?: ItemList<EdgeLike>,
    into?: Rows,
  ): Rows {
    return ringsOfEdges(this, 'edgeFaces', direction, edges, into);
  }
}

/** An edge has one order in both directions, so that its list may also come first. */
function ringsOfEdges(
  mesh: BulkRings,
  kind: 'edgeVertices' | 'edgeHalfedges' | 'edgeFaces',
  direction: Direction | ItemList<EdgeLike> = 'ccw',
  edges?: ItemList<EdgeLike>,
  into?: Rows,
): Rows {
  const isList = typeof direction === 'object' && direction !== null && edges === undefined;
  const [way, list] = isList ? (['ccw', direction] as const) : [direction as Direction, edges];
  return rings(linksOf(mesh), kind, way, list, into);
}
