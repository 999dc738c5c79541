// `npm run reference`: writes docs/reference, the pages of everything public, from the declarations in dist.
//
// `npm run check` compares the pages with the declarations.

import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { buildWeb } from './build.mjs';
import { asProgram, Failure, isProgram, root } from './lib/run.mjs';
import { readPages } from './reference/declarations.mjs';
import { renderReference } from './reference/markdown.mjs';
import { pages } from './reference/pages.mjs';

const folder = join(root, 'docs/reference');

/** The files of docs/reference as they should be: a map from name to text. */
const referenceFiles = () => renderReference(readPages(root, pages));

/** Fails if a page says something else than the declarations. Returns how many pages there are. */
export function checkReference() {
  const files = referenceFiles();
  const stale = [...files].filter(([name, text]) => stored(name) !== text).map(([name]) => name);
  const extra = storedNames().filter((name) => !files.has(name));
  if (stale.length + extra.length > 0) {
    throw new Failure(
      `docs/reference differs from the declarations in ${[...stale, ...extra].join(', ')}: npm run reference writes it anew.`,
    );
  }
  return files.size;
}

function writeReference() {
  mkdirSync(folder, { recursive: true });
  for (const name of storedNames()) rmSync(join(folder, name));
  for (const [name, text] of referenceFiles()) writeFileSync(join(folder, name), text);
}

function storedNames() {
  try {
    return readdirSync(folder);
  } catch {
    return [];
  }
}

function stored(name) {
  try {
    return readFileSync(join(folder, name), 'utf8');
  } catch {
    return undefined;
  }
}

if (isProgram(import.meta.url)) {
  await asProgram(async () => {
    await buildWeb();
    writeReference();
  });
}
