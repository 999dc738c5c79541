import { AttachedBindMode, type BufferAttribute, type SkinnedMesh, Vector3 } from 'three';
import { type MeshGeometry, trianglesOf } from './mesh-geometry.js';

/** The vertices of a SkinnedMesh where its bones have moved them: where three.js draws them. */
export class Pose {
  readonly #object: SkinnedMesh;
  readonly #geometry: MeshGeometry;
  #points = new Float32Array(0);
  /** The matrices that the points were moved by. */
  #matrices: readonly number[] = [];
  /** The attributes of the weights, and which version of them. */
  #skin: readonly unknown[] = [];
  /** Faces that the geometry shows in another way since; null for all. */
  #changed: Set<number> | null = null;
  #hasEnded = false;

  constructor(object: SkinnedMesh, geometry: MeshGeometry) {
    this.#object = object;
    this.#geometry = geometry;
    this.update();
  }

  /** By vertex of the mesh: x, y, z as of the last update. */
  get points(): Float32Array {
    return this.#points;
  }

  /** Takes note of faces that the next update finds changed; null for all. */
  change(faces: readonly number[] | null): void {
    if (faces === null) this.#changed = null;
    else for (const face of faces) this.#changed?.add(face);
  }

  /** Stays as it is from now on. */
  end(): void {
    this.#hasEnded = true;
  }

  /** Follows bones, weights and geometry. Returns the faces that lie elsewhere since, null for all. */
  update(): ReadonlySet<number> | null {
    if (this.#hasEnded) return NONE;
    const matrices = this.#matricesNow();
    const skin = this.#skinNow();
    const hasMoved = !isSame(matrices, this.#matrices);
    const isSameSkin = isSame(skin, this.#skin);
    const changed = hasMoved ? null : this.#changed;
    if (changed?.size === 0 && isSameSkin) return changed;
    const before = this.#points;
    this.#move(); // which may throw: then the next update tries again
    if (changed && !isSameSkin) this.#addMoved(before, changed);
    this.#matrices = matrices;
    this.#skin = skin;
    this.#changed = new Set();
    return changed;
  }

  #matricesNow(): number[] {
    const { skeleton, bindMode, bindMatrix, bindMatrixInverse, matrixWorld } = this.#object;
    // As three.js does, but only when it updates what is below the object, too.
    if (bindMode === AttachedBindMode) bindMatrixInverse.copy(matrixWorld).invert();
    const bones = skeleton?.bones ?? [];
    for (const bone of bones) bone.updateWorldMatrix(true, false);
    const matrices = [bindMatrix, bindMatrixInverse, ...bones.map((bone) => bone.matrixWorld)];
    return [...matrices, ...(skeleton?.boneInverses ?? [])].flatMap(({ elements }) => elements);
  }

  /** What tells whether anyone has written into the weights: the geometry tells of faces that it draws elsewhere. */
  #skinNow(): unknown[] {
    const { skinIndex, skinWeight } = this.#geometry.attributes as Record<string, BufferAttribute>;
    return [skinIndex, skinIndex?.version, skinWeight, skinWeight?.version];
  }

  /** Adds the faces at vertices that lie elsewhere than they did. */
  #addMoved(before: Float32Array, changed: Set<number>): void {
    const points = this.#points;
    trianglesOf(this.#geometry).eachCorner((corner, v) => {
      for (let k = 3 * v; k < 3 * v + 3; k++) {
        if (!Object.is(points[k], before[k]))
          changed.add(this.#geometry.face(Math.floor(corner / 3)));
      }
    });
  }

  #move(): void {
    const { points, index, attributes } = this.#geometry;
    this.#points = points.slice();
    const isBent = this.#object.skeleton && attributes.skinIndex && attributes.skinWeight;
    // The object may have got another geometry, of which this one knows nothing.
    if (!isBent || this.#object.geometry !== this.#geometry) return;
    if (index !== null) {
      const count = Math.min(this.#geometry.mesh.vertexSlots, points.length / 3);
      for (let v = 0; v < count; v++) this.#place(v, v);
      return;
    }
    // Each triangle has vertices of its own.
    const isPlaced = new Uint8Array(points.length / 3);
    trianglesOf(this.#geometry).eachCorner((corner, v) => {
      if (isPlaced[v] === 0) this.#place(v, corner);
      isPlaced[v] = 1;
    });
  }

  /** Places a vertex of the mesh as a vertex of the geometry is. */
  #place(v: number, row: number): void {
    this.#checkBones(v, row);
    this.#object.getVertexPosition(row, moved).toArray(this.#points, 3 * v);
  }

  /** A weight of 0 may name any bone, as it may in three.js. */
  #checkBones(v: number, row: number): void {
    const { skinIndex, skinWeight } = this.#geometry.attributes;
    const { bones } = this.#object.skeleton;
    for (let i = 0; i < 4; i++) {
      const bone = skinIndex.getComponent(row, i);
      if (bones[bone] !== undefined || skinWeight.getComponent(row, i) === 0) continue;
      throw new RangeError(
        `skinIndex of vertex ${v} names bone ${bone} with the weight ${skinWeight.getComponent(row, i)}; expected one of the ${bones.length} bones of the skeleton.`,
      );
    }
  }
}

function isSame(some: readonly unknown[], others: readonly unknown[]): boolean {
  return some.length === others.length && some.every((x, i) => x === others[i]);
}

const moved = new Vector3();
const NONE: ReadonlySet<number> = new Set();
