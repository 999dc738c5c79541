import { Quaternion, Vector3 } from 'three';

/** The axis of the mesh that points up in the picture. */
export type UpAxis = 'y' | 'z';

export const UP: Readonly<Record<UpAxis, Vector3>> = {
  y: new Vector3(0, 1, 0),
  z: new Vector3(0, 0, 1),
};

/** What turns the direction that points up into y: around y, three.js computes with angles. */
export const uprightOf = (up: Vector3): Quaternion => new Quaternion().setFromUnitVectors(up, UP.y);
