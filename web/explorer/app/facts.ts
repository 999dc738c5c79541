import { type HalfedgeMesh, NONE } from 'halfedge';

/** The topology numbers of a mesh, in the order in which they are told. */
export interface Numbers {
  readonly vertices: number;
  readonly edges: number;
  readonly faces: number;
  readonly characteristic: number;
  readonly genus: number;
  readonly loops: number;
  readonly components: number;
}

/** What validation found. */
export type Problems = ReturnType<HalfedgeMesh['validate']>;

/** What the panels tell of a mesh. */
export interface MeshFacts {
  readonly numbers: Numbers;
  /** What the last change added to each number; nothing where it stayed. */
  readonly changes: Partial<Numbers>;
  /** One halfedge of each boundary loop. */
  readonly boundaryLoops: readonly number[];
  readonly isolatedVertices: number;
  /** Of its connectivity. */
  readonly problems: Problems;
}

/** Goes through the whole mesh: on a million faces this takes a noticeable moment. */
export function factsOfMesh(mesh: HalfedgeMesh, before: MeshFacts | null): MeshFacts {
  const boundaryLoops = mesh.boundaryLoops();
  const numbers: Numbers = {
    vertices: mesh.vertexCount,
    edges: mesh.edgeCount,
    faces: mesh.faceCount,
    characteristic: mesh.eulerCharacteristic(),
    genus: mesh.genus(),
    loops: boundaryLoops.length,
    components: mesh.components().length,
  };
  return {
    numbers,
    changes: before ? changesBetween(before.numbers, numbers) : {},
    boundaryLoops,
    isolatedVertices: isolatedIn(mesh),
    problems: mesh.validate(4),
  };
}

function isolatedIn({ connectivity: { vertexHalfedge } }: HalfedgeMesh): number {
  let count = 0;
  for (const h of vertexHalfedge) if (h === NONE) count += 1;
  return count;
}

function changesBetween(before: Numbers, after: Numbers): Partial<Numbers> {
  const names = Object.keys(after) as (keyof Numbers)[];
  const changed = names.filter((name) => after[name] !== before[name]);
  return Object.fromEntries(changed.map((name) => [name, after[name] - before[name]]));
}

/** `+3`, `−1`: a change with its sign. */
export function signed(change: number): string {
  return change > 0 ? `+${grouped(change)}` : grouped(change);
}

/** `5,648`, `−2`. */
export function grouped(value: number): string {
  return value.toLocaleString('en-US').replace('-', '−');
}
