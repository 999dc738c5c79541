import type { HalfedgeMesh, ItemKind } from '../api.js';
import { HE_mesh, Polyhedron, PolyMesh } from '../dialects/index.js';
import type { View } from './circulators.js';

/** Whose names the page uses: those of this package, or of a library or article that many know. */
export type DialectId = 'halfedge' | 'openmesh' | 'cgal' | 'mcguire';

/** How a circulator gets from one halfedge to the next. */
export type Step = 'rotateCcw' | 'rotateCw' | 'next' | 'prev' | 'across';

/** The names of a library, as pieces of code that run on a mesh of this package. */
export interface Dialect {
  readonly id: DialectId;
  readonly label: string;
  /** The parameter that is the mesh; empty where items lead on by themselves. */
  readonly mesh: string;
  /** The variable that walks. */
  readonly cursor: string;
  /** What vertices, halfedges, edges and faces are called as parameters. */
  readonly parameters: Readonly<Record<ItemKind, string>>;
  /** The halfedge of an item of that name, at which a walk around it begins. */
  anchor(kind: ItemKind, name: string): string;
  /** Whether a link of that name is empty, as an expression. */
  isEmpty(name: string): string;
  /** The lines that take the cursor one step on. */
  step(step: Step): readonly string[];
  /** What the cursor shows, as an expression. */
  view(view: View, around: ItemKind): string;
  /** Around a vertex the cursor is a halfedge that arrives there, instead of one that leaves. */
  readonly arrives?: true;
  /** A step of the halfedge `h` in one expression, for a sentence; `before` is the one before it. */
  stepName(step: Step, h: string, before: string): string;
  /** The names of the links that the inspector shows; null for one that it doesn't have. */
  readonly links: Readonly<Record<string, string | null>>;
  /** What makes its items of indices, and indices of its items. */
  open(mesh: HalfedgeMesh): Items;
}

/** Items of a dialect and those of the mesh. */
export interface Items {
  /** What the code gets as the mesh. */
  readonly mesh: unknown;
  item(kind: ItemKind, index: number): unknown;
  index(item: unknown, kind: ItemKind): number;
}

/** Of the objects of CGAL and McGuire, where a halfedge stands for its edge. */
function indexIn(mesh: HalfedgeMesh): Items['index'] {
  return (item, kind) => {
    const { index } = item as { readonly index: number };
    return kind === 'edge' ? mesh.edge(index) : index;
  };
}

const halfedge: Dialect = {
  id: 'halfedge',
  label: 'halfedge',
  mesh: 'mesh',
  cursor: 'h',
  parameters: { vertex: 'v', halfedge: 'start', edge: 'e', face: 'f' },
  anchor: (kind, name) =>
    ({
      vertex: `mesh.vertexHalfedge(${name})`,
      halfedge: name,
      edge: `mesh.edgeHalfedge(${name}, 0)`,
      face: `mesh.faceHalfedge(${name})`,
    })[kind],
  isEmpty: (name) => `${name} === NONE`,
  step: (step) => [
    {
      rotateCcw: 'h = mesh.opposite(mesh.prev(h));',
      rotateCw: 'h = mesh.next(mesh.opposite(h));',
      next: 'h = mesh.next(h);',
      prev: 'h = mesh.prev(h);',
      across: 'h = mesh.opposite(h);',
    }[step],
  ],
  view: (view) =>
    ({
      itself: 'h',
      opposite: 'mesh.opposite(h)',
      toVertex: 'mesh.toVertex(h)',
      edge: 'mesh.edge(h)',
      face: 'mesh.face(h)',
      faceAcross: 'mesh.face(mesh.opposite(h))',
    })[view],
  stepName: (step, h) =>
    ({
      rotateCcw: `opposite(prev(${h}))`,
      rotateCw: `next(opposite(${h}))`,
      next: `next(${h})`,
      prev: `prev(${h})`,
      across: `opposite(${h})`,
    })[step],
  links: {},
  open: (mesh) => ({ mesh, item: (_kind, index) => index, index: (item) => item as number }),
};

const openmesh: Dialect = {
  id: 'openmesh',
  label: 'OpenMesh',
  mesh: 'om',
  cursor: 'h',
  parameters: { vertex: 'v', halfedge: 'start', edge: 'e', face: 'f' },
  anchor: (kind, name) =>
    ({
      vertex: `om.halfedge_handle(${name})`,
      halfedge: name,
      edge: `om.halfedge_handle(${name}, 0)`,
      face: `om.halfedge_handle(${name})`,
    })[kind],
  isEmpty: (name) => `!${name}.is_valid()`,
  step: (step) => [
    {
      rotateCcw: 'h = om.ccw_rotated_halfedge_handle(h);',
      rotateCw: 'h = om.cw_rotated_halfedge_handle(h);',
      next: 'h = om.next_halfedge_handle(h);',
      prev: 'h = om.prev_halfedge_handle(h);',
      across: 'h = om.opposite_halfedge_handle(h);',
    }[step],
  ],
  view: (view) =>
    ({
      itself: 'h',
      opposite: 'om.opposite_halfedge_handle(h)',
      toVertex: 'om.to_vertex_handle(h)',
      edge: 'om.edge_handle(h)',
      face: 'om.face_handle(h)',
      faceAcross: 'om.opposite_face_handle(h)',
    })[view],
  stepName: (step, h) =>
    ({
      rotateCcw: `ccw_rotated_halfedge_handle(${h})`,
      rotateCw: `cw_rotated_halfedge_handle(${h})`,
      next: `next_halfedge_handle(${h})`,
      prev: `prev_halfedge_handle(${h})`,
      across: `opposite_halfedge_handle(${h})`,
    })[step],
  links: {
    vertexHalfedge: 'halfedge_handle(v)',
    faceHalfedge: 'halfedge_handle(f)',
    'edgeHalfedge, side 0': 'halfedge_handle(e, 0)',
    'edgeHalfedge, side 1': 'halfedge_handle(e, 1)',
    toVertex: 'to_vertex_handle',
    face: 'face_handle',
    next: 'next_halfedge_handle',
    opposite: 'opposite_halfedge_handle',
    prev: 'prev_halfedge_handle',
    fromVertex: 'from_vertex_handle',
    edge: 'edge_handle',
  },
  open(mesh) {
    const om = new PolyMesh(mesh);
    const handles = {
      vertex: (i: number) => om.vertex_handle(i),
      halfedge: (i: number) => om.halfedge_handle(i),
      edge: (i: number) => om.edge_handle(i),
      face: (i: number) => om.face_handle(i),
    };
    return {
      mesh: om,
      item: (kind, index) => handles[kind](index),
      index: (item) => (item as { idx(): number }).idx(),
    };
  },
};

const cgal: Dialect = {
  id: 'cgal',
  label: 'CGAL',
  mesh: '',
  cursor: 'h',
  // CGAL has no edges: one of its two halfedges stands for it.
  parameters: { vertex: 'v', halfedge: 'start', edge: 'start', face: 'f' },
  arrives: true,
  anchor: (kind, name) => (kind === 'vertex' || kind === 'face' ? `${name}.halfedge()` : name),
  isEmpty: (name) => `${name} === null`,
  step: (step) => [
    {
      rotateCcw: 'h = h.opposite().prev();',
      rotateCw: 'h = h.next().opposite();',
      next: 'h = h.next();',
      prev: 'h = h.prev();',
      across: 'h = h.opposite();',
    }[step],
  ],
  view(view, around) {
    const leaving = around === 'vertex' ? 'h.opposite()' : 'h';
    return {
      itself: leaving,
      opposite: around === 'vertex' ? 'h' : 'h.opposite()',
      toVertex: `${leaving}.vertex()`,
      edge: 'h',
      face: `${leaving}.facet()`,
      faceAcross: 'h.opposite().facet()',
    }[view];
  },
  stepName: (step, h) =>
    ({
      rotateCcw: `${h}->opposite()->prev()`,
      rotateCw: `${h}->next()->opposite()`,
      next: `${h}->next()`,
      prev: `${h}->prev()`,
      across: `${h}->opposite()`,
    })[step],
  links: {
    vertexHalfedge: 'halfedge()->opposite()',
    faceHalfedge: 'halfedge()',
    'edgeHalfedge, side 0': null,
    'edgeHalfedge, side 1': null,
    toVertex: 'vertex()',
    face: 'facet()',
    next: 'next()',
    opposite: 'opposite()',
    prev: 'prev()',
    fromVertex: 'opposite()->vertex()',
    edge: null,
  },
  open(mesh) {
    const p = new Polyhedron(mesh);
    const items = {
      vertex: (i: number) => p.vertex(i),
      halfedge: (i: number) => p.halfedge(i),
      edge: (i: number) => p.halfedge(mesh.edgeHalfedge(i)),
      face: (i: number) => p.facet(i),
    };
    return { mesh: p, item: (kind, index) => items[kind](index), index: indexIn(mesh) };
  },
};

const mcguire: Dialect = {
  id: 'mcguire',
  label: 'McGuire',
  mesh: '',
  cursor: 'edge',
  parameters: { vertex: 'vert', halfedge: 'start', edge: 'start', face: 'face' },
  anchor: (kind, name) => (kind === 'vertex' || kind === 'face' ? `${name}.edge` : name),
  isEmpty: (name) => `${name} === null`,
  step(step) {
    // There is no link back: the walk around the face leads there in the end.
    const back = ['let e = edge;', 'while (e.next !== edge) e = e.next;'];
    return {
      rotateCcw: [...back, 'edge = e.pair;'],
      rotateCw: ['edge = edge.pair.next;'],
      next: ['edge = edge.next;'],
      prev: [...back, 'edge = e;'],
      across: ['edge = edge.pair;'],
    }[step];
  },
  view: (view) =>
    ({
      itself: 'edge',
      opposite: 'edge.pair',
      toVertex: 'edge.vert',
      edge: 'edge',
      face: 'edge.face',
      faceAcross: 'edge.pair.face',
    })[view],
  stepName: (step, h, before) =>
    ({
      rotateCcw: `${before}->next is ${h}, and ${before}->pair`,
      rotateCw: `${h}->pair->next`,
      next: `${h}->next`,
      prev: `${before}->next is ${h}; prev`,
      across: `${h}->pair`,
    })[step],
  links: {
    vertexHalfedge: 'vert->edge',
    faceHalfedge: 'face->edge',
    'edgeHalfedge, side 0': null,
    'edgeHalfedge, side 1': null,
    toVertex: 'vert',
    face: 'face',
    next: 'next',
    opposite: 'pair',
    prev: null,
    fromVertex: 'pair->vert',
    edge: null,
  },
  open(mesh) {
    const he = new HE_mesh(mesh);
    const items = {
      vertex: (i: number) => he.vert(i),
      halfedge: (i: number) => he.edge(i),
      edge: (i: number) => he.edge(mesh.edgeHalfedge(i)),
      face: (i: number) => he.face(i),
    };
    return { mesh: he, item: (kind, index) => items[kind](index), index: indexIn(mesh) };
  },
};

export const dialects: readonly Dialect[] = [halfedge, openmesh, cgal, mcguire];

export function dialectOf(id: DialectId): Dialect {
  return dialects.find((dialect) => dialect.id === id) ?? halfedge;
}
