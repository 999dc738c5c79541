declare const kind: unique symbol;

/** An index into the items of one kind. It is a plain number at run time. */
type Index<Kind extends string> = number & { readonly [kind]: Kind };

/** The index of a vertex, as the mesh hands it out. */
export type Vertex = Index<'vertex'>;
/** The index of a halfedge, as the mesh hands it out. `h ^ 1` is its opposite. */
export type Halfedge = Index<'halfedge'>;
/** The index of an edge, as the mesh hands it out. Its halfedges are `2 * e` and `2 * e + 1`. */
export type Edge = Index<'edge'>;
/** The index of a face, as the mesh hands it out. */
export type Face = Index<'face'>;

/**
 * A vertex as an argument: one that the mesh handed out, or any plain number. A `Face` is neither, and does
 * not compile.
 */
export type VertexLike = Vertex | PlainNumber;
/** A halfedge as an argument; like {@link VertexLike}. */
export type HalfedgeLike = Halfedge | PlainNumber;
/** An edge as an argument; like {@link VertexLike}. */
export type EdgeLike = Edge | PlainNumber;
/** A face as an argument; like {@link VertexLike}. */
export type FaceLike = Face | PlainNumber;

/**
 * Items as an argument: an array, a typed array, or what can be iterated over, such as a Set or a range
 * (`mesh.vertexFaces(v)`).
 */
export type ItemList<Item extends PlainNumber | Vertex | Halfedge | Edge | Face> =
  | ArrayLike<Item>
  | Iterable<Item>;

/** An item of a kind as an argument; like {@link VertexLike}. */
export type ItemLike<Kind extends ItemKind = ItemKind> = Indices[Kind] | PlainNumber;
/** An item of a kind, as the mesh hands it out; a plain number where the kind may be any. */
export type ItemOf<Kind extends ItemKind> = ItemKind extends Kind ? number : Indices[Kind];

/** By kind. `Index<Kind>` would be inferred from the index as well, and have no name in declarations. */
interface Indices {
  vertex: Vertex;
  halfedge: Halfedge;
  edge: Edge;
  face: Face;
}

/** A number without a brand. */
export type PlainNumber = number & { readonly [kind]?: never };

/**
 * The empty link, "no such item": -1. A boundary halfedge has the face `NONE`. A variable that begins without an
 * item is declared as `let best: Edge | typeof NONE = NONE`.
 */
export const NONE = -1;

/**
 * Which way round: counter-clockwise or clockwise, as seen from the side from which faces are
 * counter-clockwise.
 */
export type Direction = 'ccw' | 'cw';
/** What a mesh is made of. */
export type ItemKind = 'vertex' | 'halfedge' | 'edge' | 'face';

/** The letter that an item's name begins with: `v12`, `h31`. */
export const LETTERS = { vertex: 'v', halfedge: 'h', edge: 'e', face: 'f' } as const;

/** More than one of a kind; also the methods of a mesh that give all of them. */
export const PLURALS = {
  vertex: 'vertices',
  halfedge: 'halfedges',
  edge: 'edges',
  face: 'faces',
} as const;
