import type { HalfedgeMesh } from 'halfedge';
import type { Item } from 'halfedge/teaching';
import type { ShownAttribute } from './item-attributes.js';

/** What can be measured at an item, as the package measures it: how long, how large, how much it bends. */
export function measuresOf(mesh: HalfedgeMesh, { kind, index }: Item): ShownAttribute[] {
  if (kind === 'vertex') return [angle('angle defect', 'angleDefect(v)', mesh.angleDefect(index))];
  if (kind === 'face') return [size('area', 'faceArea(f)', mesh.faceArea(index))];
  if (kind === 'halfedge') {
    if (mesh.isBoundaryHalfedge(index)) return [];
    return [angle('corner angle', 'cornerAngle(h)', mesh.cornerAngle(index))];
  }
  const length = size('length', 'edgeLength(e)', mesh.edgeLength(index));
  if (mesh.isBoundaryEdge(index)) return [length];
  return [length, angle('dihedral angle', 'dihedralAngle(e)', mesh.dihedralAngle(index))];
}

function size(name: string, method: string, value: number): ShownAttribute {
  return { name, type: `${method} is ${value}`, text: String(Number(value.toPrecision(4))) };
}

/** Shown in degrees, of which people have an idea. */
function angle(name: string, method: string, value: number): ShownAttribute {
  const degrees = Number(((value * 180) / Math.PI).toFixed(1)) + 0;
  return { name, type: `${method} is ${value}, in radians`, text: `${degrees}°` };
}
