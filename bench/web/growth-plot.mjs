// The plot of bench/growth.svg: a panel for each pass, nanoseconds a face over the number of faces. A
// level line is linear growth. Colours follow the reader's scheme; lines also differ in their dashes.

const WIDTH = 840;
const PANEL = { width: 330, height: 170 };
const MARGIN = { left: 66, top: 64, right: 48, bottom: 64 };
const WHO = { native: 'native', wasm: 'WebAssembly in Node', flat: 'flat baseline, native' };
const HEIGHT = 2 * (MARGIN.top + PANEL.height) + 48;

const STYLE = `
  .paper { fill: #ffffff; } .text { fill: #24292f; } .faint { fill: #57606a; }
  .grid { stroke: #d0d7de; } .native { stroke: #0550ae; fill: #0550ae; }
  .wasm { stroke: #bc4c00; fill: #bc4c00; } .flat { stroke: #6e7781; fill: #6e7781; }
  @media (prefers-color-scheme: dark) {
    .paper { fill: #0d1117; } .text { fill: #e6edf3; } .faint { fill: #9198a1; }
    .grid { stroke: #30363d; } .native { stroke: #79c0ff; fill: #79c0ff; }
    .wasm { stroke: #ffa657; fill: #ffa657; } .flat { stroke: #8b949e; fill: #8b949e; }
  }
  text { font: 12px system-ui, sans-serif; } .title { font-weight: 600; font-size: 14px; }
  polyline { fill: none; stroke-width: 2; } .wasm polyline { stroke-dasharray: 6 3; }
  .flat polyline { stroke-dasharray: 2 3; } .number { text-anchor: end; } .middle { text-anchor: middle; }`;

/** The SVG of `rows`, each `{ faces, native, flat, wasm }` with nanoseconds a face by pass. */
export function drawGrowth(passes, rows) {
  const panels = passes.map((pass, i) => {
    const x = MARGIN.left + (i % 2) * (PANEL.width + MARGIN.left + 10);
    const y = MARGIN.top + Math.floor(i / 2) * (PANEL.height + MARGIN.bottom);
    return `<g transform="translate(${x} ${y})">\n${panel(pass, rows)}\n</g>`;
  });
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img"
  aria-label="Nanoseconds a face over the number of faces, for ${passes.join(', ')}">
<style>${STYLE}
</style>
<rect class="paper" width="${WIDTH}" height="${HEIGHT}" rx="6"/>
${legend()}
${panels.join('\n')}
</svg>
`;
}

function legend() {
  const entries = Object.entries(WHO).map(([who, words], i) => {
    const x = MARGIN.left + 190 * i;
    return `<g class="${who}"><polyline points="${x},24 ${x + 28},24"/></g>
<text class="text" x="${x + 36}" y="28">${words}</text>`;
  });
  return entries.join('\n');
}

function panel(pass, rows) {
  const curves = Object.keys(WHO).filter((who) => pass in rows[0][who]);
  const values = rows.flatMap((row) => curves.map((who) => row[who][pass]));
  const { top, step } = scaleFor(Math.max(...values));
  const [first, last] = [rows[0], rows.at(-1)].map(({ faces }) => Math.log10(faces));
  const across = (faces) =>
    (((Math.log10(faces) - first) / (last - first)) * PANEL.width).toFixed(1);
  const up = (value) => (PANEL.height * (1 - value / top)).toFixed(1);

  const parts = [`<text class="text title" y="-12">${pass}, ns a face</text>`];
  for (let value = 0; value <= top; value += step) {
    parts.push(`<line class="grid" x2="${PANEL.width}" y1="${up(value)}" y2="${up(value)}"/>
<text class="faint number" x="-8" y="${Number(up(value)) + 4}">${value}</text>`);
  }
  for (const { faces } of rows) {
    parts.push(
      `<text class="faint middle" x="${across(faces)}" y="${PANEL.height + 18}">${short(faces)}</text>`,
    );
  }
  for (const who of curves) {
    const points = rows.map((row) => [across(row.faces), up(row[who][pass])]);
    const dots = points.map(([x, y]) => `<circle cx="${x}" cy="${y}" r="2.5"/>`).join('');
    parts.push(`<g class="${who}"><polyline points="${points.join(' ')}"/>${dots}</g>`);
  }
  return parts.join('\n');
}

/** Round numbers along the vertical axis, from 0 to above the largest. */
function scaleFor(largest) {
  const power = 10 ** Math.floor(Math.log10(largest / 4));
  const step = [1, 2, 5, 10].map((digit) => digit * power).find((it) => largest / it <= 5);
  return { top: step * Math.ceil(largest / step), step };
}

const short = (faces) =>
  faces >= 999_500
    ? `${(faces / 1e6).toFixed(faces < 5e6 ? 1 : 0)} M`
    : `${Math.round(faces / 1000)} k`;
