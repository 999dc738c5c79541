import { Color } from 'three';

/** The colours of the picture, read from the style sheet, so that a theme is written once. */
export interface Palette {
  readonly background: Color;
  readonly surface: Color;
  readonly back: Color;
  readonly wire: Color;
  readonly arrow: Color;
  readonly arrowFar: Color;
  readonly self: Color;
  readonly next: Color;
  readonly opposite: Color;
  readonly vertex: Color;
  readonly boundary: Color;
  readonly dropped: Color;
  readonly ink: Color;
  readonly dark: boolean;
}

/** The palette of the theme that an element has now. */
export function readPalette(element: Element = document.documentElement): Palette {
  const style = getComputedStyle(element);
  const color = (name: string) => new Color(style.getPropertyValue(name).trim());
  return {
    background: color('--gl-background'),
    surface: color('--gl-surface'),
    back: color('--gl-back'),
    wire: color('--gl-wire'),
    arrow: color('--gl-arrow'),
    arrowFar: color('--gl-arrow-far'),
    self: color('--self'),
    next: color('--next'),
    opposite: color('--opposite'),
    vertex: color('--vertex'),
    boundary: color('--boundary'),
    dropped: color('--dropped'),
    ink: color('--text'),
    dark: style.getPropertyValue('color-scheme').includes('dark'),
  };
}
