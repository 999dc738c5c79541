import { HalfedgeError, type HalfedgeMesh, type Refusal } from 'halfedge';

/** An edit of a mesh, with arguments that fit it, and its check, where it has one. */
export interface Edit {
  name: string;
  run: () => unknown;
  check?: () => Refusal | null;
}

/** Makes an edit of one kind with random arguments; undefined if the mesh has no items for it. */
type Maker = (mesh: HalfedgeMesh, next: () => number) => Edit | undefined;

const pick = <T>(list: ArrayLike<T>, next: () => number): T | undefined =>
  list[Math.floor(next() * list.length)];

const point = (next: () => number): [number, number, number] => [next(), next(), next()];

/** A face around a triangle of neighbours, or of a few vertices at random. */
function someCorners(mesh: HalfedgeMesh, next: () => number): number[] {
  const vertices = mesh.vertices().toArray();
  const boundary = mesh
    .halfedges()
    .toArray()
    .filter((h) => mesh.isBoundaryHalfedge(h));
  const h = pick(boundary, next);
  if (h !== undefined && next() < 0.6) {
    const b = mesh.toVertex(h);
    const c = next() < 0.5 ? mesh.toVertex(mesh.next(h)) : (pick(vertices, next) as number);
    return [mesh.fromVertex(h), b, c];
  }
  return Array.from({ length: 3 + Math.floor(2 * next()) }, () => pick(vertices, next) as number);
}

/** Halfedges that follow each other, straight on or around a corner. */
function somePath(mesh: HalfedgeMesh, first: number, next: () => number): number[] {
  const path = [first];
  while (next() < 0.6) {
    const leaving = mesh.vertexOutgoingHalfedges(mesh.toVertex(path[path.length - 1])).toArray();
    path.push(pick(leaving, next) as number);
  }
  return path;
}

/** The edges of some paths from the same halfedge, which branch and cross; seldom one twice. */
function someEdges(mesh: HalfedgeMesh, first: number, next: () => number): number[] {
  const edges = new Set<number>();
  do {
    for (const h of somePath(mesh, first, next)) edges.add(mesh.edge(h));
  } while (next() < 0.5);
  return next() < 0.1 ? [mesh.edge(first), ...edges] : [...edges];
}

/** A cycle of halfedges: that of a face, or around a vertex, in either direction. */
function someCycle(mesh: HalfedgeMesh, h: number, next: () => number): number[] {
  if (next() < 0.5) return mesh.halfedgeLoop(h).toArray();
  const loop = mesh.vertexOutgoingHalfedges(mesh.toVertex(h), 'cw').toArray();
  return loop.map((out) => mesh.next(out));
}

const byItem =
  (
    kind: 'vertices' | 'halfedges' | 'edges' | 'faces',
    name: string,
    more: (mesh: HalfedgeMesh, item: number, next: () => number) => unknown[] = () => [],
  ): Maker =>
  (mesh, next) => {
    const item = pick(mesh[kind]().toArray() as number[], next);
    return item === undefined ? undefined : edit(mesh, name, [item, ...more(mesh, item, next)]);
  };

/** Of one list of halfedges, or of edges, which begins with one at random. */
function byList(
  name: string,
  list: (mesh: HalfedgeMesh, first: number, next: () => number) => number[],
): Maker {
  return (mesh, next) => {
    const h = pick(mesh.halfedges().toArray(), next);
    return h === undefined ? undefined : edit(mesh, name, [list(mesh, h, next)]);
  };
}

type Callable = Record<string, (...list: unknown[]) => unknown>;

/** The method `name` with these arguments, and its check. */
export function edit(mesh: HalfedgeMesh, name: string, list: unknown[]): Edit {
  const methods = mesh as unknown as Callable;
  const check = `check${name.charAt(0).toUpperCase()}${name.slice(1)}`;
  return {
    name: `${name}(${JSON.stringify(list).slice(1, -1)})`,
    run: () => methods[name](...list),
    ...(check in mesh && { check: () => methods[check](...list) as Refusal | null }),
  };
}

const halfedge = (mesh: HalfedgeMesh, _: number, next: () => number) =>
  pick(mesh.halfedges().toArray(), next);
const maybePoint = (_: HalfedgeMesh, __: number, next: () => number) =>
  next() < 0.5 ? [] : [point(next)];
/** One of the next halfedges in the loop of `h`. */
const onLoop = (mesh: HalfedgeMesh, h: number, next: () => number) => [
  pick(mesh.halfedgeLoop(h).toArray(), next),
];
/** A boundary halfedge that runs towards `h`, or any. */
const acrossGap = (mesh: HalfedgeMesh, h: number, next: () => number) =>
  next() < 0.5 ? mesh.next(h) : pick(mesh.boundaryLoops(), next);

const MAKERS: Record<string, [weight: number, Maker]> = {
  addVertex: [1, (mesh, next) => edit(mesh, 'addVertex', [point(next)])],
  addFace: [6, (mesh, next) => edit(mesh, 'addFace', [someCorners(mesh, next)])],
  setPosition: [1, byItem('vertices', 'setPosition', (_, __, next) => [point(next)])],
  deleteVertex: [1, byItem('vertices', 'deleteVertex')],
  deleteEdge: [1, byItem('edges', 'deleteEdge')],
  deleteFace: [
    1,
    byItem('faces', 'deleteFace', (_, __, next) => [{ keepIsolatedVertices: next() < 0.5 }]),
  ],
  deleteIsolatedVertices: [0.2, (mesh) => edit(mesh, 'deleteIsolatedVertices', [])],
  keepLargestComponents: [0.1, (mesh) => edit(mesh, 'keepLargestComponents', [3])],
  compact: [0.3, (mesh) => edit(mesh, 'compact', [])],
  reorder: [
    0.3,
    (mesh, next) => edit(mesh, 'reorder', [next() < 0.5 ? 'morton' : 'breadth-first']),
  ],
  flipEdge: [4, byItem('edges', 'flipEdge')],
  splitEdge: [2, byItem('edges', 'splitEdge', maybePoint)],
  insertVertexOnEdge: [2, byItem('edges', 'insertVertexOnEdge', maybePoint)],
  removeVertexOnEdge: [2, byItem('vertices', 'removeVertexOnEdge')],
  collapse: [4, byItem('halfedges', 'collapse', maybePoint)],
  splitVertex: [
    3,
    byItem('halfedges', 'splitVertex', (mesh, h, next) => [
      pick(mesh.vertexOutgoingHalfedges(mesh.fromVertex(h)).toArray(), next),
    ]),
  ],
  insertEdge: [3, byItem('halfedges', 'insertEdge', onLoop)],
  removeEdge: [2, byItem('edges', 'removeEdge')],
  dissolveEdge: [1, byItem('edges', 'dissolveEdge')],
  splitFace: [1, byItem('faces', 'splitFace', maybePoint)],
  dissolveVertex: [2, byItem('vertices', 'dissolveVertex')],
  makeHole: [1, byItem('faces', 'makeHole')],
  fillHole: [1, byItem('halfedges', 'fillHole')],
  glue: [2, byItem('halfedges', 'glue', (mesh, h, next) => [acrossGap(mesh, h, next) ?? h])],
  gluePath: [
    3,
    byItem('halfedges', 'gluePath', (mesh, h, next) => [mesh.next(h), 1 + Math.floor(2 * next())]),
  ],
  cut: [2, byItem('halfedges', 'cut')],
  cutPath: [1, byList('cutPath', somePath)],
  cutEdges: [1, byList('cutEdges', someEdges)],
  splitLoop: [1, byList('splitLoop', someCycle)],
  joinLoop: [1, byItem('halfedges', 'joinLoop', (...given) => [halfedge(...given)])],
  bridge: [1, byItem('halfedges', 'bridge', (...given) => [halfedge(...given)])],
  removeBridge: [5, byItem('halfedges', 'removeBridge')],
  reverse: [0.2, (mesh) => edit(mesh, 'reverse', [])],
  reverseComponent: [0.5, byItem('halfedges', 'reverseComponent')],
  triangulate: [1, byItem('faces', 'triangulate')],
  extrudeFace: [0.5, byItem('faces', 'extrudeFace', (_, __, next) => [next() - 0.5])],
  insetFace: [0.5, byItem('faces', 'insetFace', (_, __, next) => [1.1 * next()])],
  poke: [0.5, byItem('faces', 'poke', (_, __, next) => [next()])],
  bevelEdge: [1, byItem('edges', 'bevelEdge', (_, __, next) => [next()])],
  bevelVertex: [1, byItem('vertices', 'bevelVertex', (_, __, next) => [next()])],
};

/** The names of all edits that are drawn. */
export const EDITS = Object.keys(MAKERS);

const total = Object.values(MAKERS).reduce((sum, [weight]) => sum + weight, 0);

/** An edit at random. Meshes that have grown large shrink again. */
export function randomEdit(mesh: HalfedgeMesh, next: () => number): Edit {
  for (;;) {
    let at = next() * total;
    const name = EDITS.find((key) => {
      at -= MAKERS[key][0];
      return at < 0;
    }) as string;
    if (
      mesh.edgeCount > 150 &&
      /^(split|insert|bridge|triangulate|cut|extrude|inset|poke|bevel)/.test(name)
    )
      continue;
    if (mesh.edgeCount < 12 && /^(delete|keep|remove|dissolve|collapse)/.test(name)) continue;
    const made = MAKERS[name][1](mesh, next);
    if (made !== undefined) return made;
  }
}

/** Runs an edit; returns the refusal, or undefined if it was done. Other errors go on. */
export function refusalOf({ run }: Edit): HalfedgeError | undefined {
  try {
    run();
    return undefined;
  } catch (error) {
    if (error instanceof HalfedgeError) return error;
    throw error;
  }
}
