import { answer, CHECK_ONLY, done, modeOf, type Refusal } from './edit.js';
import type { FaceLike } from './items.js';
import { linksOf } from './navigation.js';
import { Surgery } from './surgery.js';

/** Modelling: what courses and modellers ask for. The contract is that of `Construction`. */
export abstract class Modelling extends Surgery {
  /**
   * Cuts a face of degree n, or each face, into n - 2 triangles like it, without new vertices. A face may be
   * concave, and only nearly planar: no triangle folds over, and diagonals are short. No two vertices are
   * joined a second time.
   *
   * Inverse: `removeEdge` of the new edges, in reverse order.
   *
   * @returns the number of new faces
   * @throws HalfedgeError `no-triangulation` (each way would join vertices that are joined already)
   */
  triangulate(f?: FaceLike): number {
    const links = linksOf(this);
    const { core, address } = links;
    if (f === undefined) return done(links, core._triangulate(address, modeOf(links)));
    links.checkFace(f);
    return done(links, core._triangulate_face(address, modeOf(links), f));
  }

  /** Why {@link triangulate} would be refused, or null. */
  checkTriangulate(f?: FaceLike): Refusal | null {
    const links = linksOf(this);
    const { core, address } = links;
    if (f === undefined) return answer(links, core._triangulate(address, CHECK_ONLY));
    links.checkFace(f);
    return answer(links, core._triangulate_face(address, CHECK_ONLY, f));
  }
}
