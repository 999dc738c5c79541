import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from '../../scripts/lib/run.mjs';

const read = (path: string) => readFileSync(join(root, path), 'utf8');

/** docs/structure-rows.md: from each row to the tests that it names. */
const rows = new Map(
  Array.from(read('docs/structure-rows.md').matchAll(/^\| (S\d+) \|.*\| (.*) \|$/gm), (line) => [
    line[1],
    Array.from(line[2].matchAll(/`([^`]+)`/g), ([, test]) => test),
  ]),
);

const cppTests = readdirSync(join(root, 'tests/cpp'), { recursive: true, encoding: 'utf8' })
  .filter((path) => path.endsWith('_test.cpp'))
  .flatMap((path) => {
    const tests = /^(?:TYPED_)?TEST(?:_[FP])?\(\s*(\w+),\s*(\w+)\)/gm;
    return Array.from(read(join('tests/cpp', path)).matchAll(tests), ([, a, b]) => `${a}.${b}`);
  });

/** Why there is no such test, or an empty string. */
function missing(test: string): string {
  const web = /^([\w-]+\.test\.ts): (.+)$/.exec(test);
  if (web !== null) {
    const title = new RegExp(`(test|describe)(\\.each\\(.*\\))?\\(\\s*'${escaped(web[2])}'`);
    return title.test(read(join('tests/web', web[1]))) ? '' : `${web[1]} has no test '${web[2]}'`;
  }
  const [suite, name] = test.split('.');
  if (suite === 'example') {
    const lacking = ['cpp', 'txt'].filter(
      (ending) => !existsSync(join(root, 'examples', `${name}.${ending}`)),
    );
    return lacking.map((ending) => `there is no examples/${name}.${ending}`).join(', ');
  }
  if (suite === 'missing_links') {
    const added = read('tests/cpp/CMakeLists.txt').includes(`add_missing_link_test(${name} `);
    return added ? '' : `tests/cpp/CMakeLists.txt adds no ${test}`;
  }
  return cppTests.includes(test) ? '' : `tests/cpp has no ${test}`;
}

const escaped = (text: string) => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');

test('The list has the 25 rows of the reference documents', () => {
  expect([...rows.keys()]).toEqual(Array.from({ length: 25 }, (_, i) => `S${i + 1}`));
});

test.each([...rows])('Row %s is shown by tests that exist', (_, tests) => {
  expect(tests).not.toEqual([]);
  expect(tests.map(missing).filter((reason) => reason !== '')).toEqual([]);
});

test('A test that does not exist is noticed', () => {
  expect(missing('Connectivity.Flies')).not.toBe('');
  expect(missing('example.nothing')).not.toBe('');
  expect(missing('missing_links.NOTHING')).not.toBe('');
  expect(missing('circulators.test.ts: no such title')).not.toBe('');
});
