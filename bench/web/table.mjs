// The results as Markdown.

const contenders = {
  hand: 'by hand, same arrays',
  flat: 'flat',
  tmh: 'three-mesh-halfedge',
  csg: 'three-bvh-csg',
  manifold: 'manifold-3d',
  three: 'three.js',
};

/**
 * One table for each mesh, in milliseconds: ours with how many times the loop by hand it takes, those
 * of the others with how many times ours they take.
 */
export function tables(results) {
  return results.map(tableOf).join('\n\n');
}

function tableOf({ mesh, vertices, faces, rows, bytes }) {
  const count = (n) => n.toLocaleString('en-GB');
  const head = `${mesh}: ${count(vertices)} vertices, ${count(faces)} faces; ms`;
  const present = Object.keys(contenders).filter((who) => rows.some(({ times }) => who in times));
  const lines = [
    [head, 'halfedge', ...present.map((who) => contenders[who])],
    ['---', ...['halfedge', ...present].map(() => '---:')],
  ];
  for (const { title, times } of rows) {
    const { halfedge: ours, hand } = times;
    const other = (who) => {
      if (!(who in times)) return '–';
      const ratio = who === 'hand' ? '' : ` (${digits(times[who] / ours)}×)`;
      return digits(times[who]) + ratio;
    };
    const ratio = hand === undefined ? '' : ` (${digits(ours / hand)}× by hand)`;
    lines.push([title, digits(ours) + ratio, ...present.map(other)]);
  }
  const memory = present.map((who) => (who in bytes ? digits(bytes[who]) : '–'));
  lines.push(['bytes of connectivity to a vertex', digits(bytes.halfedge), ...memory]);
  return lines.map((cells) => `| ${cells.join(' | ')} |`).join('\n');
}

const digits = (value) =>
  value >= 99.5 ? Math.round(value).toLocaleString('en-GB') : value.toPrecision(2);
