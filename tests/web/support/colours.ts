/** Red, green and blue of a colour, as parts of the light: linear, 0 to 1. */
export type Light = readonly [number, number, number];

/** Of a colour as `#2485f7`. */
export function lightOf(hex: string): Light {
  const [r, g, b] = [1, 3, 5].map((at) => {
    const c = Number.parseInt(hex.slice(at, at + 2), 16) / 255;
    return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
  });
  return [r, g, b];
}

/** Contrast ratio of WCAG 2, from 1 to 21. */
export function contrast(a: string, b: string): number {
  const [low, high] = [a, b]
    .map(lightOf)
    .map(([r, g, blue]) => 0.2126 * r + 0.7152 * g + 0.0722 * blue)
    .sort((p, q) => p - q);
  return (high + 0.05) / (low + 0.05);
}

/**
 * How colours look to those who lack one kind of cones: G. M. Machado, M. M. Oliveira, L. A. F. Fernandes,
 * "A Physiologically-based Model for Simulation of Color Vision Deficiency", 2009, severity 1. Row by row.
 */
export const VISIONS = {
  full: [1, 0, 0, 0, 1, 0, 0, 0, 1],
  protanopia: [
    0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998,
  ],
  deuteranopia: [
    0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.01182, 0.04294, 0.968881,
  ],
  tritanopia: [
    1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.3039,
  ],
} as const;

export function seenBy(vision: keyof typeof VISIONS, [r, g, b]: Light): Light {
  const m = VISIONS[vision];
  const row = (k: number) => Math.min(1, Math.max(0, m[k] * r + m[k + 1] * g + m[k + 2] * b));
  return [row(0), row(3), row(6)];
}

/** CIE L*a*b* under D65. */
function lab([r, g, b]: Light): readonly [number, number, number] {
  const f = (t: number) => (t > 216 / 24389 ? Math.cbrt(t) : ((24389 / 27) * t + 16) / 116);
  const x = f((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047);
  const y = f(0.2126729 * r + 0.7151522 * g + 0.072175 * b);
  const z = f((0.0193339 * r + 0.119192 * g + 0.9503041 * b) / 1.08883);
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

const DEGREE = Math.PI / 180;
const cos = (degrees: number) => Math.cos(degrees * DEGREE);
const sin = (degrees: number) => Math.sin(degrees * DEGREE);
const hue = (b: number, a: number) => (Math.atan2(b, a) / DEGREE + 360) % 360;
/** A weight that goes from 0 for greys to 1 for strong colours. */
const strong = (chroma: number) => Math.sqrt(chroma ** 7 / (chroma ** 7 + 25 ** 7));

/**
 * The difference ΔE00 of two colours: G. Sharma, W. Wu, E. N. Dalal, "The CIEDE2000 Color-Difference
 * Formula", 2005.
 */
export function difference(one: Light, other: Light): number {
  const [l1, a1, b1] = lab(one);
  const [l2, a2, b2] = lab(other);
  const g = 1.5 - 0.5 * strong((Math.hypot(a1, b1) + Math.hypot(a2, b2)) / 2);
  const [c1, c2] = [Math.hypot(g * a1, b1), Math.hypot(g * a2, b2)];
  const [h1, h2] = [hue(b1, g * a1), hue(b2, g * a2)];
  const turn = ((h2 - h1 + 540) % 360) - 180;
  const [l, c, h] = [(l1 + l2) / 2, (c1 + c2) / 2, h1 + turn / 2];
  const t =
    1 - 0.17 * cos(h - 30) + 0.24 * cos(2 * h) + 0.32 * cos(3 * h + 6) - 0.2 * cos(4 * h - 63);
  const lightness = (l2 - l1) / (1 + (0.015 * (l - 50) ** 2) / Math.sqrt(20 + (l - 50) ** 2));
  const chroma = (c2 - c1) / (1 + 0.045 * c);
  const hues = (2 * Math.sqrt(c1 * c2) * sin(turn / 2)) / (1 + 0.015 * c * t);
  const fromBlue = (((h + 360) % 360) - 275) / 25;
  const blue = -2 * strong(c) * sin(60 * Math.exp(-(fromBlue ** 2)));
  return Math.sqrt(lightness ** 2 + chroma ** 2 + hues ** 2 + blue * chroma * hues);
}
