// `npm run bench`: the JavaScript benchmark, in Node and in Chromium. Prints Markdown.
//   --node, --chromium   only there
//   --quick              small meshes, to see whether it works
//   --write              keeps the tables in bench/README.md

import { readFileSync, writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { argv } from 'node:process';
import { inChromium } from './chromium.mjs';
import { inNode } from './node.mjs';
import { operationTable } from './operations.mjs';
import { tables } from './table.mjs';

const README = new URL('../README.md', import.meta.url);
const BEGIN = '<!-- npm run bench -- --write -->';
const END = '<!-- end of npm run bench -->';

const asked = new Set(argv.slice(2));
const options = {
  ...(asked.has('--quick') && { sizes: [64, 4], rounds: 5, warm: 30 }),
  say: (name) => console.error(`  ${name}`),
};
const engines = [];
if (!asked.has('--chromium')) engines.push(inNode);
if (!asked.has('--node')) engines.push(inChromium);

const processors = cpus();
const machine = `${processors[0].model.trim()}, ${processors.length} processors.`;
console.log(machine);
const sections = [machine];
for (const run of engines) {
  console.error(run === inNode ? 'In Node:' : 'In Chromium:');
  const { engine, results, operations } = await run(options);
  const section = `### ${engine}\n\n${tables(results)}\n\n${operationTable(operations)}`;
  console.log(`\n${section}`);
  sections.push(section);
}
const report = sections.join('\n\n');

if (asked.has('--write')) {
  const readme = readFileSync(README, 'utf8');
  const [before, rest] = readme.split(BEGIN);
  const after = rest.split(END)[1];
  writeFileSync(README, `${before}${BEGIN}\n\n${report}\n\n${END}${after}`);
}
