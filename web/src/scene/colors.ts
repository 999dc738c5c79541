/**
 * The colours of a light theme. The five roles (self, next, opposite, vertex, boundary) keep a contrast of 3:1
 * with the surface and stay apart under every simulated colour vision; their -text variants reach 4.5:1 on
 * panels. Those that begin with `gl-` are of the picture alone.
 */
export const LIGHT = {
  self: '#2485f7',
  next: '#046a53',
  opposite: '#e01297',
  vertex: '#998234',
  boundary: '#6c1f04',
  dropped: '#d3352b',
  'self-text': '#0b5fc0',
  'next-text': '#046a53',
  'opposite-text': '#b90d7c',
  'vertex-text': '#6f5d1c',
  'boundary-text': '#6c1f04',
  'on-color': '#ffffff',
  'gl-background': '#ffffff',
  'gl-surface': '#e6eaf0',
  'gl-back': '#d9cfc8',
  halo: '#f2f5f9',
  'gl-wire': '#b3bcc9',
  'gl-arrow': '#5d6876',
  'gl-arrow-far': '#99a4b3',
  page: '#ffffff',
  'page-far': '#eef1f6',
  panel: 'rgb(255 255 255 / 88%)',
  raised: '#ffffff',
  well: '#f1f3f7',
  line: '#dde2ea',
  'line-strong': '#8a94a3',
  text: '#171c23',
  muted: '#57616f',
  focus: '#0b5fc0',
  accent: '#0b5fc0',
  'accent-soft': '#e3effd',
  danger: '#b3261e',
  'danger-soft': '#fdeceb',
  shadow: '0 1px 2px rgb(23 28 35 / 5%), 0 8px 28px rgb(23 28 35 / 9%)',
} as const;

/** The same of a dark theme. */
export const DARK: Readonly<Record<keyof typeof LIGHT, string>> = {
  self: '#87a6fb',
  next: '#58fecb',
  opposite: '#b87a97',
  vertex: '#fed218',
  boundary: '#fe342e',
  dropped: '#fe342e',
  'self-text': '#a3bbfc',
  'next-text': '#58fecb',
  'opposite-text': '#dba3bd',
  'vertex-text': '#fed218',
  'boundary-text': '#ff8a85',
  'on-color': '#10131a',
  'gl-background': '#15181c',
  'gl-surface': '#2a313a',
  'gl-back': '#3a302b',
  halo: '#1b2027',
  'gl-wire': '#4d5866',
  'gl-arrow': '#97a3b2',
  'gl-arrow-far': '#566270',
  page: '#15181c',
  'page-far': '#0f1114',
  panel: 'rgb(27 31 36 / 88%)',
  raised: '#262c34',
  well: '#171a1f',
  line: '#333b45',
  'line-strong': '#76828f',
  text: '#e9ecf0',
  muted: '#a2adb9',
  focus: '#a3bbfc',
  accent: '#a3bbfc',
  'accent-soft': '#28334d',
  danger: '#ff9d97',
  'danger-soft': '#3a2322',
  shadow: '0 1px 2px rgb(0 0 0 / 30%), 0 10px 32px rgb(0 0 0 / 38%)',
};

/** Custom properties for a style sheet: `--self: #2485f7;` and so on. */
export function declarations(colors: Readonly<Record<string, string>>, prefix = ''): string {
  return Object.entries(colors)
    .map(([name, value]) => {
      // With a prefix, a page can set each by that name.
      const told = prefix ? `var(--${prefix}-${name}, ${value})` : value;
      return `--${name}: ${told};`;
    })
    .join('\n');
}

/** For a style sheet, where the system asks for more contrast: lines and lesser words nearly as strong as text. */
export const MORE_CONTRAST = `
  --muted: var(--text) !important;
  --line: color-mix(in srgb, var(--text) 60%, transparent) !important;
  --line-strong: var(--text) !important;`;
