import type { HalfedgeMesh, ItemKind } from '../api.js';
import { HE_mesh, Polyhedron } from '../dialects/index.js';
import type { Dialect, Items } from './dialects.js';

/** The items of a library without edges as items: one of the two halfedges stands for each. */
function itemsOf(
  mesh: HalfedgeMesh,
  library: unknown,
  items: Record<Exclude<ItemKind, 'edge'>, (index: number) => unknown>,
): Items {
  return {
    mesh: library,
    item: (kind, index) =>
      kind === 'edge' ? items.halfedge(mesh.edgeHalfedge(index)) : items[kind](index),
    index(item, kind) {
      const { index } = item as { readonly index: number };
      return kind === 'edge' ? mesh.edge(index) : index;
    },
  };
}

/** Items lead on by themselves: these are the same for CGAL and McGuire. */
const ofPointers = {
  mesh: '',
  isEmpty: (name: string) => `${name} === null`,
};

/** Links that a library without edges doesn't have. */
const noEdges = { 'edgeHalfedge, side 0': null, 'edgeHalfedge, side 1': null, edge: null };

const CGAL_STEPS = {
  rotateCcw: 'h.opposite().prev()',
  rotateCw: 'h.next().opposite()',
  next: 'h.next()',
  prev: 'h.prev()',
  across: 'h.opposite()',
};

export const cgal: Dialect = {
  ...ofPointers,
  id: 'cgal',
  label: 'CGAL',
  cursor: 'h',
  parameters: { vertex: 'v', halfedge: 'start', edge: 'start', face: 'f' },
  arrives: true,
  anchor: (kind, name) => (kind === 'vertex' || kind === 'face' ? `${name}.halfedge()` : name),
  step: (step) => [`h = ${CGAL_STEPS[step]};`],
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
  // As C++ has it.
  stepName: (step, h) => h + CGAL_STEPS[step].slice(1).replaceAll('.', '->'),
  links: {
    ...noEdges,
    vertexHalfedge: 'halfedge()->opposite()',
    faceHalfedge: 'halfedge()',
    toVertex: 'vertex()',
    face: 'facet()',
    next: 'next()',
    opposite: 'opposite()',
    prev: 'prev()',
    fromVertex: 'opposite()->vertex()',
  },
  open(mesh) {
    const p = new Polyhedron(mesh);
    return itemsOf(mesh, p, {
      vertex: (i) => p.vertex(i),
      halfedge: (i) => p.halfedge(i),
      face: (i) => p.facet(i),
    });
  },
};

export const mcguire: Dialect = {
  ...ofPointers,
  id: 'mcguire',
  label: 'McGuire',
  cursor: 'edge',
  parameters: { vertex: 'vert', halfedge: 'start', edge: 'start', face: 'face' },
  anchor: (kind, name) => (kind === 'vertex' || kind === 'face' ? `${name}.edge` : name),
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
    ...noEdges,
    vertexHalfedge: 'vert->edge',
    faceHalfedge: 'face->edge',
    toVertex: 'vert',
    face: 'face',
    next: 'next',
    opposite: 'pair',
    prev: null,
    fromVertex: 'pair->vert',
  },
  open(mesh) {
    const he = new HE_mesh(mesh);
    return itemsOf(mesh, he, {
      vertex: (i) => he.vert(i),
      halfedge: (i) => he.edge(i),
      face: (i) => he.face(i),
    });
  },
};
