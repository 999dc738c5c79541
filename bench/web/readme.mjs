// The tables that are kept in bench/README.md.

import { readFileSync, writeFileSync } from 'node:fs';

const README = new URL('../README.md', import.meta.url);

/** Puts a report where the last one of `command` stands. */
export function keepReport(command, report) {
  const [begin, end] = [`<!-- ${command} -- --write -->`, `<!-- end of ${command} -->`];
  const readme = readFileSync(README, 'utf8');
  const [before, rest] = readme.split(begin);
  const after = rest.split(end)[1];
  writeFileSync(README, `${before}${begin}\n\n${report}\n\n${end}${after}`);
}
