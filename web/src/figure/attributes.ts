import { LitElement, type PropertyValues } from 'lit';
import type { UpAxis } from '../scene/up.js';
import { FLAG } from './flag.js';
import type { Settings } from './model.js';
import type { Source } from './source.js';
import type { Trail } from './trail-story.js';

/** Steps a second. */
const DEFAULT_SPEED = 1.5;
const CONTROLS = ['player', 'code'];
const THEMES = ['auto', 'light', 'dark'];
const LOADINGS = ['lazy', 'eager'];

/** What the properties are where nothing else is said. */
const DEFAULTS = {
  src: null,
  select: null,
  query: null,
  direction: 'ccw',
  step: 0,
  operation: null,
  build: false,
  overlays: null,
  dialect: 'halfedge',
  controls: null,
  camera: null,
  up: null,
  theme: null,
  speed: DEFAULT_SPEED,
  autoplay: false,
  loading: null,
  alt: null,
  bytes: null,
  trail: null,
};

/** What a figure is doing, as its attribute `state` tells. */
export type FigureStateName = 'waiting' | 'loading' | 'ready' | 'failed';

/** The attributes of a figure, which are its properties too, and what they say. */
export abstract class FigureAttributes extends LitElement {
  static override readonly properties = {
    src: { reflect: true },
    select: { reflect: true },
    query: { reflect: true },
    direction: { reflect: true },
    step: { type: Number, reflect: true },
    operation: { reflect: true },
    build: FLAG,
    overlays: { reflect: true },
    dialect: { reflect: true },
    controls: { reflect: true },
    camera: { reflect: true },
    up: { reflect: true },
    theme: { reflect: true },
    speed: { type: Number, reflect: true },
    autoplay: FLAG,
    loading: { reflect: true },
    alt: { reflect: true },
    bytes: { attribute: false },
    trail: { attribute: false },
    state: { reflect: true },
    failure: { state: true },
    hasCaption: { state: true },
  };

  /** Where the mesh comes from: an address, or `shape:` and a shape. */
  declare src: string | null;
  /** The selected item: `v3`, `h12`, `e4` or `f0`. */
  declare select: string | null;
  /** A circulator, by its name in the API. */
  declare query: string | null;
  /** `ccw` or `cw`. */
  declare direction: string;
  /** How many steps the player has made. */
  declare step: number;
  /** Operations, by their names in the API: `flip e3`; several with commas. */
  declare operation: string | null;
  /** Whether the faces are added one by one, instead of a query. */
  declare build: boolean;
  /** What is drawn over the mesh, in words. */
  declare overlays: string | null;
  /** Whose names the code has. */
  declare dialect: string;
  /** Which controls there are, of `player` and `code`: the player where it is empty, none where it is absent. */
  declare controls: string | null;
  /** A direction to look from, or where the camera stands and what it looks at. */
  declare camera: string | null;
  /** Which axis of the mesh points up: `y` (as where it is absent) or `z`. */
  declare up: string | null;
  /** `light`, `dark` or `auto`. */
  declare theme: string | null;
  /** Steps a second. */
  declare speed: number;
  /** Whether it plays by itself once it is loaded; never where less motion is asked for. */
  declare autoplay: boolean;
  /** `eager` loads also what is far outside of the window; `lazy`, as it is by default, does not. */
  declare loading: string | null;
  /** What the picture shows, for who can't see it. */
  declare alt: string | null;
  /** A mesh as `toBytes` of a mesh writes it, with all its numbers, instead of `src`. */
  declare bytes: Uint8Array | null;
  /** A walk that is shown instead of a query: see {@link Trail}. */
  declare trail: Trail | null;
  /** What it is doing; to be read only. */
  declare state: FigureStateName;
  /** @internal */
  declare failure: string | null;
  /** @internal */
  declare hasCaption: boolean;

  constructor() {
    super();
    Object.assign(this, DEFAULTS);
    this.state = 'waiting';
    this.failure = null;
    this.hasCaption = false;
  }

  /** An attribute that is taken away, or set to nothing as frameworks do, is what it was at first. */
  protected override willUpdate(changed: PropertyValues<this>): void {
    for (const name of Object.keys(DEFAULTS) as (keyof typeof DEFAULTS)[]) {
      if (changed.has(name)) Object.assign(this, { [name]: this[name] ?? DEFAULTS[name] });
    }
  }

  /** The attributes that say what is shown. */
  protected get settings(): Settings {
    const { select, query, direction, operation, dialect, overlays, trail } = this;
    return { select, query, direction, operation, dialect, overlays, trail };
  }

  /** Steps a second, also where `speed` is none. */
  protected get pace(): number {
    return this.speed > 0 ? this.speed : DEFAULT_SPEED;
  }

  /** The step to go to, also where `step` is none. */
  protected get position(): number {
    return Number.isNaN(this.step) ? 0 : this.step;
  }

  /** The controls that there are. */
  protected get controlNames(): readonly string[] {
    if (this.controls === '') return ['player'];
    return (this.controls ?? '').split(/[\s,]+/).filter(Boolean);
  }

  /** The numbers of `camera`: three, or six; null where it is absent or wrong. */
  protected get viewpoint(): readonly number[] | null {
    if (this.camera === null) return null;
    const numbers = numbersOf(this.camera);
    return expectedOf(numbers) === null ? numbers : null;
  }

  /** The axis that points up, also where `up` is none. */
  protected get upAxis(): UpAxis {
    return this.up === 'z' ? 'z' : 'y';
  }

  /** What is wrong with an attribute that needs no mesh to tell; null for nothing. */
  protected get mistake(): Error | null {
    const { camera, up, step, speed, theme, loading, controlNames } = this;
    const expected = camera === null ? null : expectedOf(numbersOf(camera));
    if (expected !== null) return new Error(`camera is “${camera}”; expected ${expected}.`);
    if (up !== null && up !== 'y' && up !== 'z') {
      return new Error(`up is “${up}”; expected y or z.`);
    }
    if (Number.isNaN(step)) {
      return new Error('step is no number; expected how many steps are made.');
    }
    if (!(speed > 0 && speed < Infinity)) {
      const found = Number.isNaN(speed) ? 'no number' : speed;
      return new Error(`speed is ${found}; expected steps a second, more than 0.`);
    }
    if (theme !== null && !THEMES.includes(theme)) {
      return new Error(`theme is “${theme}”; expected auto, light or dark.`);
    }
    if (loading !== null && !LOADINGS.includes(loading)) {
      return new Error(`loading is “${loading}”; expected lazy or eager.`);
    }
    const wrong = controlNames.find((name) => !CONTROLS.includes(name));
    if (wrong === undefined) return null;
    return new Error(`controls has “${wrong}”; expected some of ${CONTROLS.join(', ')}.`);
  }

  /** Where the mesh comes from. */
  protected get source(): Source {
    const holder = this.querySelector(':scope > script, :scope > template, :scope > pre');
    const text =
      holder instanceof HTMLTemplateElement ? holder.content.textContent : holder?.textContent;
    return { src: this.src, text: text ?? null, bytes: this.bytes };
  }
}

const numbersOf = (camera: string) =>
  camera
    .trim()
    .split(/[\s,]+/)
    .map(Number);

/** What is expected instead of these numbers of `camera`; null where they are right. */
function expectedOf(numbers: readonly number[]): string | null {
  if (![3, 6].includes(numbers.length) || !numbers.every(Number.isFinite)) {
    return 'three numbers, a direction, or six, where it stands and what it looks at';
  }
  // Of what the graphics card has no number for, a picture would never come to rest.
  if (!numbers.every((x) => Number.isFinite(Math.fround(x)))) return 'numbers below 3.4e38';
  const [x, y, z] = [0, 1, 2].map((k) => numbers[k] - (numbers[k + 3] ?? 0));
  if (x * x + y * y + z * z > 0) return null;
  return numbers.length === 3
    ? 'a direction, other than 0 0 0'
    : 'that it stands elsewhere than where it looks';
}
