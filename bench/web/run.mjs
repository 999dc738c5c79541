// `npm run bench`: the JavaScript benchmark, in Node and in Chromium. Prints Markdown.
//   --node, --chromium   only there
//   --webkit             only in WebKit, the engine of Safari
//   --quick              small meshes, to see whether it works
//   --write              keeps the tables in bench/README.md

import { cpus } from 'node:os';
import { argv } from 'node:process';
import { inChromium } from './chromium.mjs';
import { inNode } from './node.mjs';
import { operationTable } from './operations.mjs';
import { inPrograms } from './programs.mjs';
import { keepReport } from './readme.mjs';
import { tables } from './table.mjs';
import { inWebKit } from './webkit.mjs';

const asked = new Set(argv.slice(2));
const options = {
  ...(asked.has('--quick') && { sizes: [64, 4], rounds: 5, warm: 30 }),
  say: (name) => console.error(`  ${name}`),
};
const PROGRAMS = asked.has('--quick') ? 1 : 3;
const ENGINES = { Node: inNode, Chromium: inChromium, WebKit: inWebKit };
const only = Object.keys(ENGINES).filter((name) => asked.has(`--${name.toLowerCase()}`));
const engines = only.length > 0 ? only : ['Node', 'Chromium'];

const processors = cpus();
const machine = `${processors[0].model.trim()}, ${processors.length} processors.`;
console.log(machine);
const sections = [machine];
for (const name of engines) {
  console.error(`In ${name}:`);
  const { engine, results, operations } = await inPrograms(PROGRAMS, ENGINES[name], options);
  const section = `### ${engine}\n\n${tables(results)}\n\n${operationTable(operations)}`;
  console.log(`\n${section}`);
  sections.push(section);
}
const report = sections.join('\n\n');

if (asked.has('--write')) keepReport('npm run bench', report);
