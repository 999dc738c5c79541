// Colours as buffers have them: floats, or integers of which the largest stands for 1; with or without alpha.

import { newArray } from '../arguments.js';
import type { CornerAttribute, CornerValues } from './corners.js';

/** What stands for 1 in colours of this type. */
export function oneOf(values: CornerValues): number {
  if (values instanceof Uint8Array) return 255;
  return values instanceof Uint16Array ? 65535 : 1;
}

/** Copies rows to those from `row` on, scaled to another type of colours, with an alpha of 1 if they have none. */
export function widen(
  { components, values }: CornerAttribute,
  to: CornerValues,
  row: number,
  toComponents: number,
): void {
  if (components === toComponents && values.constructor === to.constructor) {
    to.set(values, row * components);
    return;
  }
  const [one, toOne] = [oneOf(values), oneOf(to)];
  for (let i = 0, at = row * toComponents; i < values.length; i += components) {
    for (let k = 0; k < toComponents; k++) {
      to[at++] = k < components ? (values[i + k] / one) * toOne : toOne;
    }
  }
}

/** A copy with an alpha of 1, of colours without one. */
export function withAlpha(attribute: CornerAttribute): CornerValues {
  const { values, components } = attribute;
  const Kind = values.constructor as new (length: number) => CornerValues;
  const wide = newArray('the colours', Kind, (values.length / components) * 4);
  widen(attribute, wide, 0, 4);
  return wide;
}
