import { Group, type Object3D, Vector3 } from 'three';
import { CSS2DObject } from 'three/addons/renderers/CSS2DRenderer.js';
import { indexOfChoice, refuse } from '../checks.js';
import { type ItemKind, LETTERS, PLURALS } from '../items.js';
import type { HalfedgeMesh } from '../mesh.js';
import { type Given, type OptionNames, takeOptions } from '../options.js';
import { arrowSizes } from './arrows.js';
import { checkMesh } from './columns.js';
import { HalfedgeGlyphs } from './glyphs.js';
import { checkLength, copyOnto, groupOf, typicalPixel } from './helper.js';
import { quadVertices } from './triangulate.js';

/** Options of {@link IndexLabelsHelper}. */
export interface LabelsOptions {
  /** Which kinds of items to label. Default: ['vertex']. */
  kinds?: readonly ItemKind[] | undefined;
  /** The largest number of labels. Default: 300. */
  most?: number | undefined;
  /** The CSS class of the labels, in addition to `halfedge-vertex` and so on. Default: 'halfedge-label'. */
  className?: string | undefined;
  /** The size of a pixel in units of the mesh, as for arrows, with the same default: labels of halfedges lie on them. */
  pixel?: number | undefined;
}

const LABELS_OPTIONS: OptionNames<LabelsOptions> = {
  kinds: true,
  most: true,
  className: true,
  pixel: true,
};

function checkLabels({ kinds, most = 0, className = '', pixel = 1 }: LabelsOptions): void {
  if (kinds !== undefined) {
    if (!Array.isArray(kinds)) refuse('options.kinds', kinds, 'an array of kinds of items');
    const known = Object.keys(LETTERS);
    kinds.forEach((kind, i) => void indexOfChoice(`options.kinds[${i}]`, kind, known));
  }
  if (typeof most !== 'number' || !(most >= 0)) {
    refuse('options.most', most, 'a number from 0', 'number');
  }
  if (typeof className !== 'string') refuse('options.className', className, 'a string');
  checkLength('options.pixel', pixel);
}

/**
 * Shows the indices of items as text, drawn by three.js's CSS2DRenderer: `v0`, `h12`, `e6`, `f3`. When it is removed from
 * its parent, they leave the page. Before you remove an object above that, call `dispose()`: three.js doesn't tell its
 * labels. `update()` makes them anew.
 */
export class IndexLabelsHelper extends Group {
  override readonly type = 'IndexLabelsHelper' as 'Group';
  /** The mesh whose items are labelled. */
  readonly mesh: HalfedgeMesh;
  readonly #options: Required<Given<LabelsOptions>>;
  /** Those that it has made, among its children. */
  #labels: CSS2DObject[] = [];

  constructor(mesh: HalfedgeMesh, options: LabelsOptions = {}) {
    super();
    const given = takeOptions(options, LABELS_OPTIONS);
    this.mesh = checkMesh(mesh);
    checkLabels(given);
    this.#options = {
      kinds: ['vertex'],
      most: 300,
      className: 'halfedge-label',
      pixel: typicalPixel(mesh),
      ...given,
    };
    // three.js takes labels out of the page only if each is removed by itself.
    this.addEventListener('removed', () => {
      for (const { element } of this.#labels) element.remove();
    });
    this.update();
  }

  /** Labels the current items, at their current places. */
  update(): void {
    checkMesh(this.mesh);
    const { kinds, most, className } = this.#options;
    this.#labels = this.#labels.filter(({ parent }) => parent === this); // not those that a page took away
    const labels = this.#labels;
    let count = 0;
    for (const kind of kinds) {
      for (const index of this.mesh[PLURALS[kind]]()) {
        if (count + 1 > most) break;
        let label = labels[count];
        if (label === undefined) {
          label = new CSS2DObject(document.createElement('span'));
          label.layers = this.layers; // three.js hands none down to children
          labels.push(label);
          this.add(label);
        }
        label.element.className = `${className} halfedge-${kind}`;
        label.element.textContent = `${LETTERS[kind]}${index}`;
        this.#place(kind, index, label.position);
        count += 1;
      }
    }
    this.remove(...labels.splice(count)); // which takes them out of the page
  }

  /** Removes all labels from the page. */
  override dispose(): void {
    this.remove(...this.#labels.splice(0));
  }

  /** A helper of its own for the same mesh, with the same options and clones of the children added to it. */
  override clone(recursive?: boolean): this {
    return new IndexLabelsHelper(this.mesh, this.#options).copy(this, recursive) as this;
  }

  /**
   * Takes over what every object has, such as its place, and clones of the children that were added to it. The mesh,
   * the options and the labels stay those of this helper.
   */
  override copy(source: Object3D, recursive = true): this {
    const labels = new Set<Object3D>(source instanceof IndexLabelsHelper ? source.#labels : []);
    return copyOnto(this, source, recursive, (child) => labels.has(child));
  }

  /** A group with the children that were added to it, without its labels, which are of a page. */
  override toJSON(...meta: Parameters<Group['toJSON']>): ReturnType<Group['toJSON']> {
    const labels = new Set<Object3D>(this.#labels);
    return groupOf(this as Group, (child) => labels.has(child)).toJSON(...meta);
  }

  /** Vertices and the middles of edges, arrows and faces. */
  #place(kind: ItemKind, index: number, out: Vector3): void {
    const { mesh } = this;
    if (kind === 'halfedge') {
      const triangleVertices = (face: number) => quadVertices(mesh, face);
      const glyphs = new HalfedgeGlyphs({ mesh, points: mesh.positions, triangleVertices });
      const at = glyphs.halfedge(index, arrowSizes(this.#options.pixel));
      const [a, b] = [at, at + 3].map((from) => new Vector3().fromArray(glyphs.arrows, from));
      out.addVectors(a, b).multiplyScalar(0.5);
      return;
    }
    const vertices =
      kind === 'vertex'
        ? [index]
        : kind === 'edge'
          ? mesh.edgeVertices(index)
          : mesh.faceVertices(index);
    out.set(0, 0, 0);
    let count = 0;
    for (const v of vertices) {
      const [x, y, z] = mesh.position(v);
      out.add(corner.set(x, y, z));
      count += 1;
    }
    out.divideScalar(count);
  }
}

const corner = new Vector3();
