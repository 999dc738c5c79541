import { readFileSync } from 'node:fs';
import { filesBelow } from '../../scripts/lib/files.mjs';

const read = (path: string) => readFileSync(path, 'utf8');
const textsOf = (folder: string, name: RegExp) =>
  filesBelow(folder)
    .filter((path: string) => name.test(path))
    .map(read);
/** What stands in backticks or quotes and looks like a code. */
const codesIn = (text: string, quote = '`') =>
  Array.from(
    text.matchAll(RegExp(`${quote}([a-z]+(?:-[a-z]+)+)${quote}`, 'g')),
    ([, code]) => code,
  );

const SINGLE_WORDS = ['cancelled', 'disposed', 'truncated'];
const documented = new Set([...codesIn(read('docs/errors.md')), ...SINGLE_WORDS]);

describe('docs/errors.md', () => {
  test('lists each code that the types name', () => {
    const docs = textsOf('dist', /\.d\.ts$/).flatMap((text: string) => [
      ...text.matchAll(/@throws((?:(?!@|\*\/).)*)/gs),
    ]);
    const thrown = docs.flatMap(([, sentence]) => codesIn(sentence));
    expect(thrown.length).toBeGreaterThan(100);
    expect([...new Set(thrown)].filter((code) => !documented.has(code))).toEqual([]);
  });

  test('lists each code that the package throws by itself, that repairs report, and that validate finds', () => {
    const own = textsOf('web/src', /\.ts$/).flatMap((text: string) =>
      Array.from(text.matchAll(/Error\(\s*'([a-z]+(?:-[a-z]+)*)'/g), ([, code]) => code),
    );
    const [, repairs] = /const CODES = \[(.*?)\]/s.exec(read('web/src/repair.ts')) ?? ['', ''];
    const [, rules] =
      /kCodes = \{(.*?)\}/s.exec(read('src/halfedge/validate/problem_list.h')) ?? [];
    const all = [...own, ...codesIn(repairs, "'"), ...codesIn(rules ?? '', '"')];
    expect(all.length).toBeGreaterThan(50);
    expect([...new Set(all)].filter((code) => !documented.has(code))).toEqual([]);
  });

  test('lists none that there is not', () => {
    const core = textsOf('src/halfedge', /\.(h|cpp)$/).flatMap((text: string) =>
      codesIn(text, '"'),
    );
    const own = textsOf('web/src', /\.ts$/).flatMap((text: string) => codesIn(text, "'"));
    const known = new Set([...core, ...own, ...SINGLE_WORDS]);
    expect([...documented].filter((code) => !known.has(code))).toEqual([]);
  });
});
