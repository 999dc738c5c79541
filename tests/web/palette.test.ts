import { DARK, LIGHT } from 'halfedge/scene';
import { contrast, difference, lightOf, seenBy, VISIONS } from './support/colours.js';

const themes: Record<string, Readonly<Record<string, string>>> = { light: LIGHT, dark: DARK };
const ROLES = ['self', 'next', 'opposite', 'vertex', 'boundary'] as const;

test('The difference of colours is the one of the published test data', () => {
  // Blue and yellow of sRGB, and two greys.
  expect(difference(lightOf('#0000ff'), lightOf('#ffff00'))).toBeCloseTo(103.43, 1);
  expect(difference(lightOf('#ff0000'), lightOf('#00ff00'))).toBeCloseTo(86.61, 1);
  expect(difference(lightOf('#777777'), lightOf('#777777'))).toBe(0);
});

describe.each(Object.entries(themes))('The %s palette', (name, colours) => {
  test('is the one that was chosen', () => {
    const chosen = {
      light: ['#2485f7', '#046a53', '#e01297', '#998234', '#6c1f04', '#ffffff', '#e6eaf0'],
      dark: ['#87a6fb', '#58fecb', '#b87a97', '#fed218', '#fe342e', '#15181c', '#2a313a'],
    };
    const shown = [...ROLES, 'gl-background', 'gl-surface'].map((role) => colours[role]);
    expect(shown).toEqual(chosen[name as 'light' | 'dark']);
  });

  test('keeps its five roles apart under every colour vision, by ΔE00 19.6', () => {
    for (const vision of Object.keys(VISIONS) as (keyof typeof VISIONS)[]) {
      ROLES.forEach((one, i) => {
        for (const other of ROLES.slice(i + 1)) {
          const [a, b] = [one, other].map((role) => seenBy(vision, lightOf(colours[role])));
          const apart = difference(a, b) >= 19.6;
          expect({ vision, one, other, apart }).toEqual({ vision, one, other, apart: true });
        }
      });
    }
  });

  test('has a contrast of 3:1 for lines, and of 4.5:1 for text', () => {
    const low: string[] = [];
    const check = (least: number, names: readonly string[], grounds: readonly string[]) => {
      for (const one of names) {
        for (const ground of grounds) {
          const ratio = contrast(colours[one], colours[ground]);
          if (ratio < least) low.push(`${one} on ${ground}: ${ratio.toFixed(2)}`);
        }
      }
    };
    check(3, [...ROLES, 'gl-arrow', 'dropped'], ['gl-background', 'gl-surface']);
    check(3, ['line-strong', 'focus'], ['page', 'raised']);
    const text = ['text', 'muted', 'accent', 'danger', ...ROLES.map((role) => `${role}-text`)];
    check(4.5, text, ['page', 'raised', 'well']);
    check(4.5, ['text', 'accent'], ['accent-soft']);
    check(4.5, ['on-color'], [...ROLES.map((role) => `${role}-text`), 'muted', 'accent']);
    expect(low).toEqual([]);
  });
});
