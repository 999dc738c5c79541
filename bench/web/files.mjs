// `npm run bench:files`: reading files, ours against three.js's loaders, in Node. CPU time, since it
// must not matter what else the machine does. Prints Markdown.
//   --quick        a small mesh and few rounds
//   --collection   without the mesh of a million triangles
//   --write        keeps the tables in bench/README.md

import { argv, versions } from 'node:process';
import { HalfedgeMesh, init } from 'halfedge';
import { groupsOfCollection } from './files-collection.mjs';
import { digits, measure, readersOf } from './files-readers.mjs';
import { grid } from './meshes.mjs';
import { keepReport } from './readme.mjs';

const quick = argv.includes('--quick');
const rounds = quick ? 3 : 7;
const HEAD = ['read', 'three.js reads', 'read and build', 'three.js reads and welds'];

await init();
console.warn = () => {}; // OBJLoader tells of each line that it doesn't know
if (!argv.includes('--collection')) tell('grid', gridTable(quick ? 64 : 708));
tell('collection', collectionTable());

function tell(which, report) {
  console.log(`${report}\n`);
  if (argv.includes('--write')) keepReport(`npm run bench:files, ${which}`, report);
}

/** The same mesh in every format. */
function gridTable(side) {
  const { positions, triangles } = grid(side);
  const mesh = HalfedgeMesh.fromTriangles(positions, triangles);
  const forms = [
    ['STL, binary', 'stl', 'binary'],
    ['STL, text', 'stl', 'text'],
    ['PLY, binary', 'ply', 'binary'],
    ['PLY, text', 'ply', 'text'],
    ['OBJ', 'obj', 'text'],
    ['OFF, text', 'off', 'text'],
    ['OFF, binary', 'off', 'binary'],
  ];
  const rows = forms.map(([title, format, encoding]) => {
    const written = mesh.write(format, { encoding });
    const bytes = typeof written === 'string' ? new TextEncoder().encode(written) : written.slice();
    const times = measure(readersOf(format), [bytes], rounds, mesh.faceCount);
    return [title, (bytes.length / 1e6).toFixed(0), ...cells(times)];
  });
  const count = mesh.faceCount.toLocaleString('en-GB');
  mesh.dispose();
  return `Node ${versions.node}; ${count} triangles\n\n${table(['ms of CPU', 'MB', ...HEAD], rows)}`;
}

/** The files that users have: all of a format, the largest one, and the mean of small ones. */
function collectionTable() {
  const { groups, told } = groupsOfCollection();
  if (groups.length === 0) return told;
  const rows = groups.map(({ title, format, files, each }) => {
    const size = files.reduce((sum, { length }) => sum + length, 0);
    const share = each ? 1 / files.length : 1;
    const times = measure(readersOf(format), files, rounds);
    const scaled = Object.fromEntries(Object.entries(times).map(([who, ms]) => [who, ms * share]));
    return [title, digits((size * share) / 1e6), ...cells(scaled)];
  });
  return `${told}\n\n${table(['ms of CPU', 'MB', ...HEAD], rows)}`;
}

/** Each of ours, and theirs beside it with how many times as long it takes. */
function cells(times) {
  const beside = (ours, theirs) =>
    theirs in times ? `${digits(times[theirs])} (${digits(times[theirs] / times[ours])}×)` : '–';
  const indexed = 'weld' in times ? 'weld' : 'load';
  return [
    ...[digits(times.read), beside('read', 'load')],
    ...[digits(times.build), beside('build', indexed)],
  ];
}

function table(head, rows) {
  const rule = ['---', ...head.slice(1).map(() => '---:')];
  return [head, rule, ...rows].map((row) => `| ${row.join(' | ')} |`).join('\n');
}
