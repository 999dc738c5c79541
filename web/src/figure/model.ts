import type { HalfedgeMesh } from '../api.js';
import { counted } from '../counted.js';
import { PLURALS } from '../items.js';
import { circulators } from '../teaching/circulators.js';
import { linksOf, type WalkKey } from '../teaching/item-links.js';
import { type Item, isLive, itemName, sameItem } from '../teaching/items.js';
import type { Edit } from '../teaching/motion.js';
import { CirculatorPlayer } from '../teaching/player.js';
import { BuildStory, type FaceList, verticesOnly } from './build-story.js';
import { DeedStory } from './deed-story.js';
import { EditStory } from './edit-story.js';
import { DEFAULT_OVERLAYS, type OverlayName, overlaysNamed } from './overlays.js';
import { Player } from './player.js';
import { type Story, WalkStory } from './story.js';
import { type Trail, TrailStory } from './trail-story.js';
import { dialectNamed, directionNamed, itemNamed, queryNamed } from './words.js';

/** What a figure is told to show, as its attributes say it. */
export interface Settings {
  readonly select: string | null;
  readonly query: string | null;
  readonly direction: string;
  readonly operation: string | null;
  readonly dialect: string;
  readonly overlays: string | null;
  readonly trail: Trail | null;
}

/** What a model tells its figure. */
export interface ModelListener {
  /** The story has moved on, or back; `edit` is the change of the mesh, where there was one. */
  moved(edit: Edit | null): void;
  /** It began to play by itself, or stopped. */
  played(): void;
  /** Whether the mesh was disposed of; nothing is shown any more then. */
  isLost(): boolean;
}

/** The state of a figure, and what can be done to it. Knows nothing of the DOM. */
export class FigureModel {
  mesh: HalfedgeMesh | null = null;
  selected: Item | null = null;
  hovered: Item | null = null;
  overlays: ReadonlySet<OverlayName> = overlaysNamed(DEFAULT_OVERLAYS);
  /** What can't be shown of the settings that it was told last; null for nothing. */
  failure: Error | null = null;
  readonly player: Player;
  /** What the story was made of, and of which version of the mesh. */
  #told = '';
  #version = -1;
  /** The faces that are to be added one by one. */
  #list: FaceList | null = null;

  constructor(listener: ModelListener) {
    this.player = new Player({
      moved: (edit) => {
        this.#follow();
        listener.moved(edit);
      },
      played: () => listener.played(),
      isLost: () => listener.isLost(),
    });
  }

  get story(): Story | null {
    return this.player.story;
  }

  /** What is to be read beside the picture. */
  get words(): string {
    const { mesh, story, selected } = this;
    if (story) return story.words;
    if (!mesh) return '';
    if (selected) return linkWords(mesh, selected);
    return `${counted(mesh.vertexCount, 'vertex', 'vertices')}, ${counted(mesh.edgeCount, 'edge')}, ${counted(mesh.faceCount, 'face')}.`;
  }

  /** Shows another mesh, or none; the one before is disposed of. */
  take(mesh: HalfedgeMesh | null): void {
    this.player.story = null;
    this.mesh?.dispose();
    this.mesh = mesh;
    this.selected = this.hovered = this.#list = this.failure = null;
    this.#told = '';
  }

  /** Shows the vertices of a list; its faces are added step by step. */
  takeList(list: FaceList): void {
    this.take(verticesOnly(list));
    this.#list = list;
  }

  /** Whether these are the settings that it was told last. */
  follows(settings: Settings): boolean {
    return JSON.stringify(settings) === this.#told;
  }

  /**
   * Follows the settings as far as they have changed; returns the change of the mesh, where operations
   * were taken back. What can't be shown is told by `failure`.
   */
  tell(settings: Settings): Edit | null {
    const { mesh } = this;
    if (!mesh || this.follows(settings)) return null;
    const edit = this.story instanceof EditStory ? this.story.seek(0) : null;
    this.#tell(mesh, settings);
    return edit;
  }

  /**
   * Follows edits of the mesh by a program: what is gone is not selected any more, and a walk begins anew
   * where it may go elsewhere now. Operations stay as they were done.
   */
  refresh(settings: Settings): void {
    const { mesh, selected, story } = this;
    if (!mesh) return;
    this.hovered = null;
    if (selected && !isLive(mesh, selected)) this.selected = null;
    const isSame = story instanceof EditStory || mesh.version === this.#version;
    if (isSame || (!story && !this.failure)) this.#remember(mesh, settings);
    else this.#tell(mesh, settings);
  }

  /** Selects what a reader has picked; where the query does not go around it, its links are shown. */
  choose(item: Item | null, settings: Settings): boolean {
    const { mesh } = this;
    if (!mesh || sameItem(item, this.selected) || (item && !isLive(mesh, item))) return false;
    this.#remember(mesh, settings);
    this.failure = null;
    this.selected = item;
    if (this.story instanceof EditStory || this.story instanceof TrailStory) return true;
    this.player.story = null;
    try {
      if (item) this.#begin(mesh, settings);
    } catch {
      this.player.story = null;
    }
    return true;
  }

  /** Where the link with that key leads; null for nowhere. */
  walk(key: WalkKey): Item | null {
    const { mesh, selected } = this;
    if (!mesh || !selected) return null;
    return linksOf(mesh, selected).find((link) => link.key === key)?.target ?? null;
  }

  #tell(mesh: HalfedgeMesh, settings: Settings): void {
    const { select, overlays } = settings;
    this.#remember(mesh, settings);
    this.player.story = this.selected = this.failure = null;
    try {
      this.overlays = overlaysNamed(overlays ?? DEFAULT_OVERLAYS);
      if (select !== null) this.selected = itemNamed(mesh, select);
      this.#begin(mesh, settings);
    } catch (error) {
      this.failure = error as Error;
    }
  }

  #remember(mesh: HalfedgeMesh, settings: Settings): void {
    this.#told = JSON.stringify(settings);
    this.#version = mesh.version;
  }

  #begin(mesh: HalfedgeMesh, settings: Settings): void {
    const { query, operation, direction, dialect, trail } = settings;
    if (this.#list) {
      this.player.story = new BuildStory(mesh, this.#list);
    } else if (trail) {
      this.player.story = new TrailStory(mesh, trail);
    } else if (operation) {
      this.player.story = new DeedStory(mesh, operation);
      this.selected ??= this.story?.current ?? null;
    } else if (query) {
      this.selected ??= firstFor(mesh, query);
      if (!this.selected) return;
      const asked = queryNamed(mesh, query, this.selected, directionNamed(direction));
      this.player.story = new WalkStory(new CirculatorPlayer(mesh, asked, dialectNamed(dialect)));
    }
  }

  /** The selection goes with the operations: what they are done to may be gone. */
  #follow(): void {
    if (this.story instanceof EditStory) this.selected = this.story.current;
    this.hovered = null;
  }
}

/** The first item that a circulator can go around. */
function firstFor(mesh: HalfedgeMesh, query: string): Item | null {
  const kind = circulators.find(({ name }) => name === query)?.around ?? 'vertex';
  for (const index of mesh[PLURALS[kind]]()) return { kind, index };
  return null;
}

/** `h4: toVertex v2 (3), face f1 (4), …` */
function linkWords(mesh: HalfedgeMesh, selected: Item): string {
  const links = linksOf(mesh, selected).map(({ name, number, target }) =>
    number === undefined
      ? `${name} ${itemName(target)}`
      : `(${number}) ${name} ${itemName(target)}`,
  );
  return `${itemName(selected)}: ${links.join(', ')}.`;
}
