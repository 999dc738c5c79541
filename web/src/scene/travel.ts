import { Spherical, Vector3 } from 'three';
import { type Item, sameItem } from '../teaching/items.js';
import type { CirculatorPlayer } from '../teaching/player.js';
import type { ItemPicker } from '../three/item-picker.js';
import { anchorOf, facesAt, reachOf } from './anchors.js';
import type { FaceFrames } from './faces.js';
import type { Glyphs } from './glyphs.js';
import type { Stage } from './stage.js';
import type { Surface } from './surface.js';

/**
 * Numbers of visits can be read where their items lie so far apart on the screen, and so far from the
 * selected one, which has its name beside it.
 */
const NUMBER_PX = 24;
const NAME_PX = 44;
/** It is worth a flight to come to this share of the distance. */
const MUCH_NEARER = 0.8;
/** Walks longer than this go too far to be looked at from near. */
const LONG_WALK = 40;
/** No item is looked at from farther away than where a sphere of this radius is seen; all is within 1. */
const FARTHEST = 0.85;

/** A place of the scene, and how to look at it. */
export interface Sight {
  readonly centre: Vector3;
  readonly radius: number;
  /** Away from the surface, where the faces agree on that. */
  readonly normal: Vector3;
}

/** Everything that belongs to the mesh on show. */
export interface Shown {
  readonly surface: Surface;
  readonly frames: FaceFrames;
  readonly glyphs: Glyphs;
  readonly picker: ItemPicker;
}

/** Moves the camera: around the mesh, to items, and after the player. */
export class Travel {
  /** The mesh on show, if there is one. */
  shown: Shown | null = null;
  readonly #stage: Stage;

  constructor(stage: Stage) {
    this.#stage = stage;
  }

  /** Flies to an item, near enough to see its arrows; to the whole mesh if there is none. */
  focus(item: Item | null): void {
    const { shown } = this;
    if (!shown || !item) {
      this.fit();
      return;
    }
    const distance = this.#distanceFor(item, shown);
    this.#stage.fly(this.#anchor(item, shown), this.#towards([item], shown), distance);
  }

  /** Flies to a place of the file, as near as shows it with what is around it. */
  visit({ centre, radius, normal }: Sight): void {
    const distance = this.#stage.distanceFor(Math.min(1.1, 2.6 * radius));
    this.#stage.fly(centre, this.#facing(normal), distance);
  }

  /** Flies back to where the whole mesh is seen. */
  fit(): void {
    if (this.shown) this.#stage.flyToAll(this.shown.surface.points, this.#offset());
  }

  /** Turns the camera around the middle of the picture, by angles in radians. */
  orbit(horizontal: number, vertical: number): void {
    const offset = new Spherical().setFromVector3(this.#offset());
    offset.theta += horizontal;
    offset.phi += vertical;
    offset.makeSafe();
    const direction = new Vector3().setFromSpherical(offset);
    this.#stage.look(this.#stage.controls.target.clone(), direction, offset.radius);
  }

  /** Moves the camera to `factor` times its distance. */
  zoom(factor: number): void {
    const offset = this.#offset();
    this.#stage.look(this.#stage.controls.target.clone(), offset, factor * offset.length());
  }

  /**
   * Keeps the player in sight: comes near when a walk around `selected` begins whose numbers would lie
   * on each other, and turns to what has left the picture or lies on the far side of the mesh: the
   * selected item when a walk begins, the current one in any case.
   */
  follow(player: CirculatorPlayer, selected: Item, begins: boolean): void {
    const { shown } = this;
    const item = player.current?.item;
    if (!shown || !item) return;
    if (begins && this.#isTooSmall(player, selected, shown)) {
      this.focus(selected);
      return;
    }
    const items = begins ? [selected, item] : [item];
    const lost = items.find(
      (each) => !this.#stage.inSight(this.#anchor(each, shown)) || this.#isBehind(each, shown),
    );
    if (lost) this.#turnTo(lost, shown, items);
  }

  /** Whether the mesh hides an item that looks away from the camera: if it is turned, it is seen. */
  #isBehind(item: Item, shown: Shown): boolean {
    if (normalOf([item], shown).dot(this.#offset()) >= 0) return false;
    return shown.picker.hides(this.#anchor(item, shown), this.#stage.camera);
  }

  /** Whether a lap has numbers that can't be read from here, and could be from where the selected item is seen well. */
  #isTooSmall(player: CirculatorPlayer, selected: Item, shown: Shown): boolean {
    if (player.count >= LONG_WALK) return false;
    const { x, y, z } = this.#anchor(selected, shown);
    const near = this.#distanceFor(selected, shown);
    if (near > MUCH_NEARER * this.#stage.depthOf(x, y, z)) return false;
    const seen = (item: Item) => this.#stage.project(this.#anchor(item, shown), new Vector3());
    const name = seen(selected);
    const others = [...player.lap()].filter((item) => !sameItem(item, selected)).map(seen);
    return others.some(
      (one, i) =>
        apart(one, name) < NAME_PX ||
        others.slice(0, i).some((other) => apart(one, other) < NUMBER_PX),
    );
  }

  /** From how far an item fills the picture with what is around it. */
  #distanceFor(item: Item, { surface }: Shown): number {
    return this.#stage.distanceFor(Math.min(FARTHEST, 1.8 * reachOf(item, surface)));
  }

  /** Turns to the first of the items that can't be seen from here, if there is one. */
  bringIntoSight(items: readonly Item[]): void {
    const { shown } = this;
    const hidden = shown && this.#hidden(items, shown);
    if (hidden) this.#turnTo(hidden, shown);
  }

  /** The first of the items that can't be seen from here. */
  #hidden(items: readonly Item[], shown: Shown): Item | undefined {
    return items.find((item) => {
      const point = this.#anchor(item, shown);
      return !this.#stage.inSight(point) || shown.picker.hides(point, this.#stage.camera);
    });
  }

  /** Flies to an item, to look at it and those with it from as far away as now. */
  #turnTo(item: Item, shown: Shown, items: readonly Item[] = [item]): void {
    const distance = this.#offset().length();
    this.#stage.fly(this.#anchor(item, shown), this.#towards(items, shown), distance);
  }

  #anchor(item: Item, { surface, frames, glyphs }: Shown): Vector3 {
    return anchorOf(item, surface, frames, glyphs);
  }

  /** From the middle of the picture to the camera. */
  #offset(): Vector3 {
    const { camera, controls } = this.#stage;
    return camera.position.clone().sub(controls.target);
  }

  /** Flies to where the whole mesh is seen with all of the items before it, where one can't be seen now. */
  turnTo(items: readonly Item[]): void {
    const { shown } = this;
    const hidden = shown && this.#hidden(items, shown);
    if (hidden) this.#stage.flyToAll(shown.surface.points, this.#towards(items, shown));
  }

  /** Jumps to where the whole mesh is seen, and an item with all that is around it. */
  lookAtAll(item: Item): void {
    const { shown } = this;
    if (!shown) return;
    const direction = this.#offset().normalize();
    direction.lerp(normalOf([item], shown), 0.65);
    if (direction.lengthSq() > 1e-9) this.#stage.lookAtAll(shown.surface.points, direction);
  }

  /** The direction to look from: the present one, turned to the front of the items if that is behind. */
  #towards(items: readonly Item[], shown: Shown): Vector3 {
    return this.#facing(normalOf(items, shown));
  }

  /** The present direction, turned towards `normal` where that is far off. */
  #facing(normal: Vector3): Vector3 {
    const direction = this.#offset().normalize();
    if (normal.lengthSq() < 1e-9) return direction;
    normal.normalize();
    if (direction.dot(normal) > 0.55) return direction;
    return direction.lerp(normal, 0.7).normalize();
  }
}

/** How far two places are from each other on the screen, in CSS pixels. */
const apart = (a: Vector3, b: Vector3) => Math.hypot(a.x - b.x, a.y - b.y);

/** The mean normal of the faces at the items; zero where there is none. */
function normalOf(items: readonly Item[], { surface, frames }: Shown): Vector3 {
  const normal = new Vector3();
  for (const f of items.flatMap((item) => facesAt(surface, item))) {
    normal.add(new Vector3().fromArray(frames.data, frames.at(f) + 3));
  }
  return normal.normalize();
}
