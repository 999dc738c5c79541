import { Color, SRGBColorSpace } from 'three';

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

/** The custom properties that the colours are read from. */
export const PALETTE_PROPERTIES = {
  background: '--gl-background',
  surface: '--gl-surface',
  back: '--gl-back',
  wire: '--gl-wire',
  arrow: '--gl-arrow',
  arrowFar: '--gl-arrow-far',
  self: '--self',
  next: '--next',
  opposite: '--opposite',
  vertex: '--vertex',
  boundary: '--boundary',
  dropped: '--dropped',
  ink: '--text',
} as const satisfies Record<Exclude<keyof Palette, 'dark'>, string>;

/** The palette of the theme that an element has now. */
export function readPalette(element: Element = document.documentElement): Palette {
  const style = getComputedStyle(element);
  const read = (name: string) => colorOf(style.getPropertyValue(name).trim(), element);
  const names = Object.entries(PALETTE_PROPERTIES);
  const colors = names.map(([role, name]) => [role, read(name)] as const);
  return {
    ...(Object.fromEntries(colors) as Record<keyof typeof PALETTE_PROPERTIES, Color>),
    dark: style.getPropertyValue('color-scheme').includes('dark'),
  };
}

/** Whether two have the same colours. */
export function samePalette(one: Palette, other: Palette): boolean {
  const roles = Object.keys(PALETTE_PROPERTIES) as (keyof typeof PALETTE_PROPERTIES)[];
  return one.dark === other.dark && roles.every((role) => one[role].equals(other[role]));
}

/** The colour that CSS means by a text at an element, without its alpha: three.js knows the older notations only. */
function colorOf(text: string, element: Element): Color {
  if (/^#([\da-f]{3}){1,2}$/i.test(text)) return new Color(text);
  const probe = document.createElement('span');
  // A mix comes out as numbers, whatever the notation was. Forced colours would be those of the system.
  probe.style.cssText = `display: none !important; forced-color-adjust: none; transition: none; background-color: color-mix(in srgb, ${text}, ${text})`;
  (element.shadowRoot ?? element).append(probe);
  const mixed = /^color\(srgb ([^ /]+) ([^ /]+) ([^ /)]+)/.exec(
    getComputedStyle(probe).backgroundColor,
  );
  probe.remove();
  if (!mixed) return new Color(text); // three.js says what is wrong
  const [r, g, b] = mixed.slice(1).map((x) => Math.min(1, Math.max(0, Number(x) || 0)));
  return new Color().setRGB(r, g, b, SRGBColorSpace);
}
