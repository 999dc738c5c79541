import { type PerspectiveCamera, Spherical, Vector3 } from 'three';
import { type Item, sameItem } from '../teaching/items.js';
import type { CirculatorPlayer } from '../teaching/player.js';
import type { ItemPicker } from '../three/item-picker.js';
import { anchorOf, facesAt, reachOf } from './anchors.js';
import type { FaceFrames } from './faces.js';
import type { Pose } from './flight.js';
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
/** What a walk visits is looked at with so much of the picture around it. */
const ROOM = 1.15;
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
    this.#approach(item, this.#distanceFor(item, shown), shown);
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
    const { upright, pose } = this.#stage;
    const offset = new Spherical().setFromVector3(this.#offset(pose).applyQuaternion(upright));
    offset.theta += horizontal;
    offset.phi += vertical;
    offset.makeSafe();
    const direction = new Vector3().setFromSpherical(offset).applyQuaternion(upright.invert());
    this.#stage.look(this.#stage.controls.target.clone(), direction, offset.radius);
  }

  /** Moves the camera to `factor` times its distance. */
  zoom(factor: number): void {
    const offset = this.#offset(this.#stage.pose);
    this.#stage.look(this.#stage.controls.target.clone(), offset, factor * offset.length());
  }

  /**
   * Keeps the player in sight: comes near when a walk around `selected` begins whose numbers would lie
   * on each other, and turns to what is out of the picture or behind the mesh: when a walk begins to the
   * selected item and to all that a short one visits, later to the current item. Short walks keep the
   * selected item in the middle. What a flight under way will show is waited for, and nobody's hand is led.
   */
  follow(player: CirculatorPlayer, selected: Item, begins: boolean): void {
    const { shown } = this;
    const item = player.current?.item;
    if (!shown || !item || this.#stage.held) return;
    if (!begins && this.#isSeen(item, shown, this.#camera())) return;
    const lap = player.count < LONG_WALK ? [...player.lap()] : null;
    const reach = lap && this.#reach(lap, selected, shown);
    const whole = reach === null ? 0 : this.#distanceFor(selected, shown, reach);
    const all = [item, selected, ...(lap ?? [])];
    if (begins && lap && this.#shouldComeNear(lap, selected, whole, shown)) {
      this.#lookAround(selected, whole, all, -1, shown);
      return;
    }
    if (begins && !this.#hidden(all, shown)) return;
    if (lap) {
      const seen = this.#seen(all, shown, this.#camera());
      const distance = Math.max(whole, this.#offset().length());
      if (this.#lookAround(selected, distance, all, seen, shown)) return;
    }
    if (this.#isSeen(item, shown, this.#camera())) return;
    this.#turnTo(item, shown, begins ? all : [item]);
  }

  /** How far from the selected item the others are, with room around them. */
  #reach(lap: readonly Item[], selected: Item, shown: Shown): number {
    const middle = this.#anchor(selected, shown);
    return ROOM * Math.max(0, ...lap.map((item) => this.#anchor(item, shown).distanceTo(middle)));
  }

  /** Whether the numbers of a lap can be read from `near`, which is nearer than the camera is, but not from there. */
  #shouldComeNear(lap: readonly Item[], selected: Item, near: number, shown: Shown): boolean {
    const middle = this.#anchor(selected, shown);
    const camera = this.#camera();
    if (near > MUCH_NEARER * camera.position.distanceTo(middle)) return false;
    const seen = (point: Vector3) => this.#stage.project(point, new Vector3(), camera);
    const name = seen(middle);
    const numbers = lap
      .filter((item) => !sameItem(item, selected))
      .map((item) => seen(this.#anchor(item, shown)));
    return numbers.some(
      (one, i) =>
        apart(one, name) < NAME_PX ||
        numbers.slice(0, i).some((other) => apart(one, other) < NUMBER_PX),
    );
  }

  /**
   * Flies to look at an item from the side from which most of the others are seen, above all the first of
   * them, where more than `least` are; false where that one is seen neither from there nor now.
   */
  #lookAround(
    item: Item,
    distance: number,
    others: readonly Item[],
    least: number,
    shown: Shown,
  ): boolean {
    const middle = this.#anchor(item, shown);
    let best: Vector3 | null = null;
    let most = least;
    for (const direction of [...this.#sides(item, others, shown), normalOf(others, shown)]) {
      if (direction.lengthSq() < 1e-9) continue;
      const pose = this.#stage.poseFor(middle, direction, distance);
      const seen = this.#seen(others, shown, this.#stage.cameraAt(pose));
      if (seen > most) [best, most] = [direction, seen];
    }
    if (best) this.#stage.fly(middle, best, distance);
    return most >= others.length;
  }

  /** How many items a camera sees; the first of them counts for more than all others. */
  #seen(items: readonly Item[], shown: Shown, camera: PerspectiveCamera): number {
    const seen = items.filter((item) => this.#isSeen(item, shown, camera)).length;
    return this.#isSeen(items[0], shown, camera) ? seen + items.length : seen;
  }

  /** From how far an item fills the picture with what is around it, and all that is so far from it. */
  #distanceFor(item: Item, { surface }: Shown, reach = 0): number {
    const radius = Math.max(1.8 * reachOf(item, surface), reach);
    return this.#stage.distanceFor(Math.min(FARTHEST, radius));
  }

  /** Flies to an item, to look at it from so far. */
  #approach(item: Item, distance: number, shown: Shown): void {
    this.#stage.fly(this.#anchor(item, shown), this.#towards([item], shown), distance);
  }

  /** Turns to the first of the items that can't be seen from here, if there is one. */
  bringIntoSight(items: readonly Item[]): void {
    const { shown } = this;
    const hidden = shown && this.#hidden(items, shown);
    if (hidden) this.#turnTo(hidden, shown);
  }

  /** The first of the items that can't be seen from here. */
  #hidden(items: readonly Item[], shown: Shown): Item | undefined {
    const camera = this.#camera();
    return items.find((item) => !this.#isSeen(item, shown, camera));
  }

  #isSeen(item: Item, shown: Shown, camera: PerspectiveCamera): boolean {
    const point = this.#anchor(item, shown);
    return this.#stage.inSight(point, camera) && !shown.picker.hides(point, camera);
  }

  /**
   * Flies to an item, to look at it and those with it from as far away as now. Where the mesh would hide it
   * from that side as well it tries others, and stays where none shows more than is seen already.
   */
  #turnTo(item: Item, shown: Shown, items: readonly Item[] = [item]): void {
    const distance = this.#offset().length();
    const at = this.#anchor(item, shown);
    const pose = (direction: Vector3) => this.#stage.poseFor(at, direction, distance);
    const side = this.#sideOf(item, items, shown, pose);
    if (side) this.#stage.fly(at, side, distance);
    else if (!this.#stage.inSight(at, this.#camera())) {
      this.#stage.fly(at, this.#towards(items, shown), distance);
    }
  }

  /** From where the mesh does not hide an item; rather where those with it are seen, too. `pose`: where the camera is then. */
  #sideOf(
    item: Item,
    items: readonly Item[],
    shown: Shown,
    pose: (direction: Vector3) => Pose,
  ): Vector3 | undefined {
    const at = this.#anchor(item, shown);
    return this.#sides(item, items, shown).find(
      (direction) => !shown.picker.hides(at, this.#stage.cameraAt(pose(direction))),
    );
  }

  /** Directions from which an item and those with it may be seen, the nearest to the present one first. */
  #sides(item: Item, items: readonly Item[], shown: Shown): Vector3[] {
    const normal = normalOf([item], shown);
    // Faces that were wound the wrong way round are seen from their backs.
    const directions = [
      this.#towards(items, shown),
      this.#facing(normalOf(items, shown).negate()),
      this.#facing(normal.clone()),
      this.#facing(normal.clone().negate()),
      normal,
    ];
    return directions.filter((direction) => direction.lengthSq() > 1e-9);
  }

  #anchor(item: Item, { surface, frames, glyphs }: Shown): Vector3 {
    return anchorOf(item, surface, frames, glyphs);
  }

  /** From the middle of the picture to the camera; to where it will be, if it flies. */
  #offset({ target, position }: Pose = this.#stage.goal): Vector3 {
    return position.clone().sub(target);
  }

  /** The camera as it stands, or will when its flight is over. */
  #camera(): PerspectiveCamera {
    return this.#stage.cameraAt(this.#stage.goal);
  }

  /** Flies to where the whole mesh is seen with all of the items before it, where one can't be seen now. */
  turnTo(items: readonly Item[]): void {
    const { shown } = this;
    const hidden = shown && this.#hidden(items, shown);
    if (!hidden) return;
    const { points } = shown.surface;
    const pose = (direction: Vector3) => this.#stage.poseForAll(points, direction);
    const side = this.#sideOf(hidden, items, shown, pose) ?? this.#towards(items, shown);
    this.#stage.flyToAll(points, side);
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
