import { spawnSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';

const path = (from: string) => fileURLToPath(new URL(`../../${from}`, import.meta.url));

test('The types need none of the browser, and none of Node', () => {
  const options = '--ignoreConfig --noEmit --strict --skipLibCheck false --skipDefaultLibCheck';
  const target = '--target es2022 --lib es2022 --module nodenext';
  const files = [path('dist/index.d.ts'), path('dist/worker.d.ts')];
  const { stdout } = spawnSync(
    process.execPath,
    [path('node_modules/typescript/bin/tsc'), ...`${options} ${target}`.split(' '), ...files],
    { encoding: 'utf8' },
  );
  expect(stdout).toBe('');
});
