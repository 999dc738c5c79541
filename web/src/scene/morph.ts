import { Color } from 'three';
import type { Edit } from '../teaching/motion.js';
import { ghostOf, LineBatch, lineMaterial, lines } from '../three/index.js';
import type { SurfaceChange } from './change.js';
import { Paths } from './paths.js';
import { Pieces } from './pieces.js';
import { prefersReducedMotion } from './reduced-motion.js';
import type { Stage } from './stage.js';
import type { Surface } from './surface.js';
import type { SurfaceLook } from './surface-view.js';

const DURATION_MS = 420;

/** What the layers that show the mesh at rest leave out, because it is in motion. */
export interface InMotion {
  readonly faces: ReadonlySet<number>;
  readonly edges: ReadonlySet<number>;
}

/** Nothing is. */
export const AT_REST: InMotion = { faces: new Set(), edges: new Set() };

/** Animates the picture from the state before an edit to the one after it. */
export class Morph {
  readonly #stage: Stage;
  readonly #old: Pieces;
  readonly #new: Pieces;
  readonly #lines = new LineBatch();
  #color = new Color();
  #paths: Paths | null = null;

  constructor(stage: Stage, look: SurfaceLook) {
    this.#stage = stage;
    this.#old = new Pieces(stage, look.material(1));
    this.#new = new Pieces(stage, look.material(0.5));
    const material = lineMaterial(2.5, 2);
    stage.scene.add(lines(this.#lines, ghostOf(material, 0.6), 4), lines(this.#lines, material, 4));
  }

  /** The colour of edges in motion. */
  setColor(color: Color): void {
    this.#color = color;
  }

  /**
   * Begins to move a surface from how it was to how it is, and returns what is in motion. `moved` is called
   * before each frame, `ended` once when all is at rest; where nothing is to be animated, neither.
   */
  start(
    surface: Surface,
    change: SurfaceChange | null,
    edit: Edit,
    moved: () => void,
    ended: () => void,
  ): InMotion {
    this.stop();
    if (prefersReducedMotion() || edit.renumbers || !change) return AT_REST;
    const paths = new Paths(surface, change, edit);
    this.#paths = paths;
    if (paths.manner !== 'grow') this.#old.set(change.before, (v) => paths.oldPath(v));
    if (paths.manner !== 'slide') this.#new.set(change.after, (v) => paths.newPath(v));
    const began = performance.now();
    this.#show(paths, 0);
    this.#stage.animate((now) => {
      if (this.#paths !== paths) return false;
      const linear = Math.min(1, Math.max(0, (now - began) / DURATION_MS));
      if (linear === 1) {
        this.stop();
        ended();
        return false;
      }
      this.#show(paths, linear * linear * (3 - 2 * linear));
      moved();
      return true;
    });
    return {
      faces: change.faces,
      edges: new Set(change.edges.map(({ edge }) => edge)),
    };
  }

  /** Puts everything where it belongs at the end, at once. */
  stop(): void {
    const paths = this.#paths;
    if (!paths) return;
    paths.moveTo(1);
    this.#paths = null;
    this.#old.clear();
    this.#new.clear();
    this.#lines.clear();
    this.#lines.upload();
  }

  #show(paths: Paths, t: number): void {
    paths.moveTo(t);
    const fades = paths.manner === 'fade';
    this.#old.show(t, fades ? Math.min(1, 2 - 2 * t) : 1);
    this.#new.show(t, fades ? Math.min(1, 2 * t) : 1);
    this.#lines.clear();
    for (const [from, to] of paths.segments) {
      const segment = from.map((x, i) => x + t * (to[i] - x));
      this.#lines.add(segment, 0, 3, this.#color);
    }
    this.#lines.upload();
  }
}
