import type { ItemKind } from '../api.js';
import { PolyMesh } from '../dialects/index.js';
import type { View } from './circulators.js';
import type { Dialect, Step } from './dialects.js';

type Expression = (name: string) => string;

/** The names of a library whose mesh has all the methods, as calls of these. */
interface Names extends Pick<Dialect, 'id' | 'label' | 'mesh' | 'isEmpty' | 'links' | 'open'> {
  readonly anchors: Readonly<Record<ItemKind, Expression>>;
  readonly steps: Readonly<Record<Step, Expression>>;
  readonly views: Readonly<Record<View, Expression>>;
}

/** Sentences leave the mesh out, which code names before each method: `next(h)` is `mesh.next(h)`. */
function ofMesh({ mesh, anchors, steps, views, ...rest }: Names): Dialect {
  const inCode = (calls: string) => calls.replace(/\w+(?=\()/g, `${mesh}.$&`);
  return {
    ...rest,
    mesh,
    cursor: 'h',
    parameters: { vertex: 'v', halfedge: 'start', edge: 'e', face: 'f' },
    anchor: (kind, name) => inCode(anchors[kind](name)),
    step: (step) => [`h = ${inCode(steps[step]('h'))};`],
    view: (view) => inCode(views[view]('h')),
    stepName: (step, h) => steps[step](h),
  };
}

/** This package itself. */
export const halfedge = ofMesh({
  id: 'halfedge',
  label: 'halfedge',
  mesh: 'mesh',
  anchors: {
    vertex: (v) => `vertexHalfedge(${v})`,
    halfedge: (h) => h,
    edge: (e) => `edgeHalfedge(${e}, 0)`,
    face: (f) => `faceHalfedge(${f})`,
  },
  isEmpty: (name) => `${name} === NONE`,
  steps: {
    rotateCcw: (h) => `opposite(prev(${h}))`,
    rotateCw: (h) => `next(opposite(${h}))`,
    next: (h) => `next(${h})`,
    prev: (h) => `prev(${h})`,
    across: (h) => `opposite(${h})`,
  },
  views: {
    itself: (h) => h,
    opposite: (h) => `opposite(${h})`,
    toVertex: (h) => `toVertex(${h})`,
    edge: (h) => `edge(${h})`,
    face: (h) => `face(${h})`,
    faceAcross: (h) => `face(opposite(${h}))`,
  },
  links: {},
  open: (mesh) => ({ mesh, item: (_kind, index) => index, index: (item) => item as number }),
});

export const openmesh = ofMesh({
  id: 'openmesh',
  label: 'OpenMesh',
  mesh: 'om',
  anchors: {
    vertex: (v) => `halfedge_handle(${v})`,
    halfedge: (h) => h,
    edge: (e) => `halfedge_handle(${e}, 0)`,
    face: (f) => `halfedge_handle(${f})`,
  },
  isEmpty: (name) => `!${name}.is_valid()`,
  steps: {
    rotateCcw: (h) => `ccw_rotated_halfedge_handle(${h})`,
    rotateCw: (h) => `cw_rotated_halfedge_handle(${h})`,
    next: (h) => `next_halfedge_handle(${h})`,
    prev: (h) => `prev_halfedge_handle(${h})`,
    across: (h) => `opposite_halfedge_handle(${h})`,
  },
  views: {
    itself: (h) => h,
    opposite: (h) => `opposite_halfedge_handle(${h})`,
    toVertex: (h) => `to_vertex_handle(${h})`,
    edge: (h) => `edge_handle(${h})`,
    face: (h) => `face_handle(${h})`,
    faceAcross: (h) => `opposite_face_handle(${h})`,
  },
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
});
