import type { SurfaceLook } from 'halfedge/scene';
import { Discs, FILE_LAYER, type Palette, readPalette, type Stage } from 'halfedge/scene';
import { LineBatch, lineMaterial, lines } from 'halfedge/three';
import {
  BufferAttribute,
  BufferGeometry,
  type Color,
  DoubleSide,
  LineBasicMaterial,
  LineSegments,
  type Matrix4,
  Mesh,
  MeshLambertMaterial,
} from 'three';
import { type Diagnosis, FACE_FATES, type Fate } from '../app/diagnosis.js';
import { SoupShape } from './soup-shape.js';

/** The colour of a fate, the same as in the list of problems. */
function colorOfFate(palette: Palette, fate: Fate): Color {
  switch (fate) {
    case 'dropped':
      return palette.dropped;
    case 'turned':
      return palette.vertex;
    case 'cut':
      return palette.opposite;
    case 'mended':
      return palette.next;
    case 'noted':
      return palette.arrow;
  }
}

/**
 * The polygons of a file as they stand there: faces in the colours of what became of them, and the
 * edges and vertices that the package names in its problems.
 */
export class SoupView {
  readonly #stage: Stage;
  readonly #plain: Mesh;
  readonly #tinted: Mesh<BufferGeometry, MeshLambertMaterial>;
  readonly #wireMaterial = new LineBasicMaterial({ transparent: true });
  readonly #wire = new LineSegments(new BufferGeometry(), this.#wireMaterial);
  readonly #edges = new LineBatch();
  readonly #discs: Discs;
  #diagnosis: Diagnosis | null = null;
  #shape: SoupShape | null = null;
  #isDrawn = false;
  #palette: Palette = readPalette();

  constructor(stage: Stage, look: SurfaceLook) {
    this.#stage = stage;
    this.#plain = new Mesh(new BufferGeometry(), look.material(1));
    const material = new MeshLambertMaterial({
      flatShading: true,
      side: DoubleSide,
      vertexColors: true,
    });
    // Before a plain face in the same place, of which it is a copy.
    material.polygonOffset = true;
    material.polygonOffsetFactor = material.polygonOffsetUnits = 0.5;
    this.#tinted = new Mesh(new BufferGeometry(), material);
    this.#wire.renderOrder = 1;
    const edges = lines(this.#edges, lineMaterial(3.5, 3), 3);
    this.#discs = new Discs(stage.scene, 4);
    const objects = [this.#plain, this.#tinted, this.#wire, edges];
    for (const object of objects) {
      object.frustumCulled = false;
      stage.scene.add(object);
    }
    for (const object of [...objects, ...this.#discs.objects]) object.layers.set(FILE_LAYER);
  }

  /** The polygons where they are in the scene; null if there is no file. */
  get shape(): SoupShape | null {
    return this.#shape;
  }

  /** Takes over a file, to be drawn when it is first looked at. */
  set(diagnosis: Diagnosis | null, placement: Matrix4 | null): void {
    this.#diagnosis = diagnosis;
    this.#shape = diagnosis && placement ? new SoupShape(diagnosis.soup, placement) : null;
    this.#isDrawn = false;
    for (const { geometry } of [this.#plain, this.#tinted, this.#wire]) {
      geometry.dispose();
      geometry.deleteAttribute('position');
      geometry.setIndex(null);
    }
    this.#edges.clear();
    this.#edges.upload();
    this.#discs.clear();
    this.#discs.upload();
  }

  setColors(palette: Palette): void {
    this.#palette = palette;
    this.#wireMaterial.color.copy(palette.wire);
    this.#discs.setRim(palette.background);
    if (this.#isDrawn) this.#draw();
  }

  /** Before each frame in which it is in the picture. */
  update(): void {
    if (!this.#shape) return;
    if (!this.#isDrawn) this.#draw();
    const depth = this.#stage.camera.position.distanceTo(this.#stage.controls.target);
    const pixels = this.#shape.typicalEdge / this.#stage.pixelAt(depth);
    this.#wire.visible = pixels > 4;
    this.#wireMaterial.opacity = Math.min(1, Math.max(0.15, (pixels - 4) / 12));
  }

  #draw(): void {
    const [diagnosis, shape] = [this.#diagnosis, this.#shape];
    if (!diagnosis || !shape) return;
    this.#isDrawn = true;
    this.#drawFaces(diagnosis, shape);
    this.#drawMarks(diagnosis, shape);
    this.#stage.invalidate();
  }

  #drawFaces({ fates }: Diagnosis, shape: SoupShape): void {
    const { points } = shape;
    const { triangles, faceOf, edges } = shape.drawn();
    // Whole faces are large: less glaring than marks.
    const share = this.#palette.dark ? 0.4 : 0.2;
    const tint = (fate: Fate) =>
      colorOfFate(this.#palette, fate).clone().lerp(this.#palette.surface, share);
    const tints = {
      dropped: tint('dropped'),
      turned: tint('turned'),
      cut: tint('cut'),
      mended: tint('mended'),
    };
    const plain: number[] = [];
    const tinted: number[] = [];
    const colors: number[] = [];
    for (let i = 0; i < faceOf.length; i++) {
      const fate = FACE_FATES[fates[faceOf[i]]];
      for (let k = 3 * i; k < 3 * i + 3; k++) {
        if (!fate) {
          plain.push(triangles[k]);
          continue;
        }
        const { r, g, b } = tints[fate];
        const p = 3 * triangles[k];
        tinted.push(points[p], points[p + 1], points[p + 2]);
        colors.push(r, g, b);
      }
    }
    const position = new BufferAttribute(points, 3);
    this.#plain.geometry = indexed(this.#plain, position, new Uint32Array(plain));
    this.#wire.geometry = indexed(this.#wire, position, edges);
    this.#tinted.geometry.dispose();
    this.#tinted.geometry = new BufferGeometry();
    for (const [name, values] of [
      ['position', tinted],
      ['color', colors],
    ] as const) {
      this.#tinted.geometry.setAttribute(name, new BufferAttribute(new Float32Array(values), 3));
    }
  }

  /** Edges with two named ends, and vertices named by themselves. */
  #drawMarks({ findings }: Diagnosis, shape: SoupShape): void {
    this.#edges.clear();
    this.#discs.clear();
    for (const { fate, problems } of findings) {
      const color = colorOfFate(this.#palette, fate);
      for (const { witness } of problems) {
        const vertices = (witness?.vertices ?? []).filter((v) => shape.isPlaced(v));
        if (vertices.length === 2) {
          this.#edges.add(shape.points, 3 * vertices[0], 3 * vertices[1], color);
        } else {
          for (const v of vertices) this.#discs.add(shape.points, 3 * v, 12, color);
        }
      }
    }
    this.#edges.upload();
    this.#discs.upload();
  }
}

function indexed(
  { geometry }: Mesh | LineSegments,
  position: BufferAttribute,
  index: Uint32Array,
): BufferGeometry {
  geometry.dispose();
  const fresh = new BufferGeometry();
  fresh.setAttribute('position', position);
  fresh.setIndex(new BufferAttribute(index, 1));
  return fresh;
}
