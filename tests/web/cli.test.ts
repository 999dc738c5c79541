import { spawn } from 'node:child_process';
import { closeSync, existsSync, openSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { WriteStream } from 'node:tty';
import { HalfedgeMesh, init } from 'halfedge';
import { Progress } from '../../web/src/cli/progress.js';
import { folder, program, run, texts } from './support/cli.js';
import { collected } from './support/collection.js';

const { CLASHING, QUAD } = texts;

beforeAll(() => init());

describe('halfedge', () => {
  test('tells its version, which is that of the package', async () => {
    const manifest = new URL('../../package.json', import.meta.url);
    const { version } = JSON.parse(readFileSync(manifest, 'utf8'));
    expect(await run(['--version'])).toMatchObject({ status: 0, out: `${version}\n`, err: '' });
  });

  test('can be run from a folder that `npm link` points to', () => {
    expect(statSync(program).mode & 0o111).toBe(0o111);
    expect(readFileSync(program, 'utf8')).toMatch(/^#!\/usr\/bin\/env node\n/);
  });

  test('helps: on all commands, and on each', async () => {
    const { status, out } = await run(['--help']);
    expect(status).toBe(0);
    for (const command of ['info', 'check', 'repair', 'convert']) {
      expect(out).toMatch(new RegExp(`^  ${command} +[A-Z]`, 'm'));
      const help = await run([command, '--help']);
      expect(help).toMatchObject({ status: 0, err: '' });
      expect(help.out).toContain(`Usage: halfedge ${command} [options] <`);
      expect(help.out).toMatch(/^Exit status: 0/m);
      expect(await run(['help', command])).toMatchObject({ status: 0, out: help.out });
    }
  });

  test('without a command tells what there is, as an error', async () => {
    const { status, out, err } = await run([]);
    expect({ status, out }).toEqual({ status: 2, out: '' });
    expect(err).toContain('Usage: halfedge <command>');
  });

  test.each([
    [['chekc', 'a'], '"chekc" is no command of halfedge. Did you mean check?'],
    [['frobnicate'], '"frobnicate" is no command of halfedge. `halfedge --help` lists them.'],
    [['--vresion'], '"--vresion" is no option of halfedge. Did you mean --version?'],
    [['--json', 'info', 'a'], '--json follows the command: `halfedge <command> --json`.'],
    [['-o', 'b.obj', 'convert', 'a'], '-o follows the command: `halfedge <command> -o`.'],
    [['info', '--jsn', 'a'], '--jsn is no option of `halfedge info`. Did you mean --json?'],
    [['info', '-x'], '-x is no option of `halfedge info`. `halfedge info --help` lists them.'],
    [['info', '--constructor'], '--constructor is no option of'],
    [['info', '--json=yes', 'a'], '--json is "yes"; it takes no value.'],
    [['convert', 'a', '--to'], '--to has no value; expected --to <format>.'],
    [['convert', 'a', '--to', '--json'], '--to has no value; expected --to <format>.'],
    [
      ['convert', 'a', '--to', 'pyl'],
      '--to is "pyl"; expected obj, off, ply, stl, glb or gltf. Did you mean ply?',
    ],
    [
      ['convert', 'a', 'b.xyz'],
      'The name "b.xyz" doesn\'t tell the format to write; expected --to',
    ],
    [['convert', 'a', 'b.obj', 'c.obj'], '"c.obj" is one file too many'],
    [['convert', 'a', '-o', 'b.obj', 'c.obj'], '"c.obj" is one file too many'],
    [
      ['repair', 'a', '--keep-largest', 'many'],
      '--keep-largest is "many"; expected a number from 1.',
    ],
    [['info', '-', '-'], 'Standard input (-) is named twice'],
    [['check', 'quad.obj', ''], 'The name of a file is empty ("").'],
    [['convert', 'quad.obj', '', '--to', 'off'], 'The name of a file is empty ("").'],
    [['info', 'nowhere.obj'], "nowhere.obj can't be read: no such file or directory (ENOENT)."],
    [['info', '.'], '. is a folder; expected a file.'],
    [['info', 'broken.off'], 'broken.off: Line 5: '],
    [['convert', 'quad.obj', 'q.stl', '--encoding', 'binary-big-endian'], 'q.stl: STL has'],
    [['convert', 'quad.obj', 'no/such/folder.off'], "no/such/folder.off can't be written: no such"],
  ])('refuses %j in one sentence, with status 2', async (args, sentence) => {
    const { status, out, err } = await run(args);
    expect(err).toContain(`halfedge: ${sentence}`);
    expect(err.trimEnd()).not.toContain('\n');
    expect({ status, out }).toEqual({ status: 2, out: '' });
  });
});

describe('halfedge info', () => {
  test('tells counts, topology, validity and bounding box', async () => {
    expect(await run(['info', 'quad.obj'])).toMatchObject({
      status: 0,
      err: '',
      out: `format                OBJ
size                  42 bytes
vertices              4
halfedges             8
edges                 4
faces                 1 (1 quad)
Euler characteristic  1
components            1
boundary loops        1
genus                 0
isolated vertices     0
bounding box          0 0 0 to 2 1 0
extent                2 1 0
area                  2
volume                none
valid                 yes
`,
    });
  });

  test('reads standard input, named or not, in any format', async () => {
    const facts = {
      file: 'standard input',
      format: 'stl',
      vertices: 4,
      faces: 4,
      closed: true,
      volume: expect.closeTo(8 / 9 / Math.sqrt(3), 6),
    };
    const stl = HalfedgeMesh.tetrahedron().write('stl') as Uint8Array;
    for (const args of [
      ['info', '--json'],
      ['info', '-', '--json'],
    ]) {
      const { status, out } = await run(args, stl);
      expect(status).toBe(0);
      expect(JSON.parse(out)).toMatchObject({ ...facts, valid: true, bytes: stl.length });
    }
  });

  test('goes on after a file that can not be read, which has its line, too', async () => {
    const files = ['broken.off', 'quad.obj', 'nowhere.obj'];
    const text = await run(['info', ...files]);
    expect(text).toMatchObject({ status: 2, out: expect.stringMatching(/^quad\.obj\nformat /) });
    expect(text.err).toMatch(/^halfedge: broken\.off: Line 5: .*\nhalfedge: nowhere\.obj can't/);
    const { status, out, err } = await run(['info', '--json', ...files]);
    expect({ status, err }).toEqual({ status: 2, err: '' });
    const lines = out.trimEnd().split('\n');
    expect(lines.map((line) => JSON.parse(line))).toMatchObject([
      { file: 'broken.off', readable: false, error: expect.stringContaining('Line 5') },
      { file: 'quad.obj', readable: true, faces: 1 },
      { file: 'nowhere.obj', readable: false, error: expect.stringContaining('ENOENT') },
    ]);
  });

  test('counts no vertex as repaired that only has no face', async () => {
    const both = `${CLASHING.replace('4 2 0', '6 2 0').replace('0 1 0\n', '0 1 0\n7 7 7\n8 8 8\n')}`;
    const { out } = await run(['info'], both);
    expect(out).toMatch(/^valid +no \(1 repair; see halfedge check\)$/m);
  });

  test('believes the content of a file, not its name', async () => {
    writeFileSync(join(folder, 'really-an-obj.glb'), QUAD);
    const { status, out } = await run(['info', '--json', 'really-an-obj.glb']);
    expect(status).toBe(0);
    expect(JSON.parse(out)).toMatchObject({ format: 'obj', faces: 1 });
    writeFileSync(join(folder, 'nothing.glb'), 'nothing at all');
    expect((await run(['info', 'nothing.glb'])).err).toMatch(/^halfedge: nothing\.glb: .*glTF/);
    writeFileSync(join(folder, 'list.off'), '{\nOFF\n1 0 0\n0 0 0\n}\n');
    expect((await run(['info', 'list.off'])).err).toBe(
      'halfedge: list.off: This is a Geomview file with objects in braces, expected an OBJ, OFF, PLY or STL file.\n',
    );
  });

  test('tells of several files, in JSON a line for each', async () => {
    const { out } = await run(['info', '--json', 'clashing.off', 'bowtie.off']);
    const [clashing, bowtie, rest] = out.split('\n');
    expect(JSON.parse(clashing)).toMatchObject({
      file: 'clashing.off',
      valid: false,
      repairs: { 'opposite-orientation': 1 },
    });
    expect(JSON.parse(bowtie)).toMatchObject({
      valid: true,
      isolatedVertices: 1,
      boundingBox: { min: [-1, -1, 0], max: [9, 9, 9] },
      volume: null,
    });
    expect(rest).toBe('');
    const text = await run(['info', 'quad.obj', 'clashing.off']);
    expect(text.out).toMatch(/^quad\.obj\nformat [\s\S]*\n\nclashing\.off\nformat /);
    expect(text.out).toMatch(/^valid +no \(1 repair; see halfedge check\)$/m);
  });
});

describe('halfedge check', () => {
  test('ends with 0 for a valid mesh', async () => {
    expect(await run(['check', 'square.off'])).toMatchObject({
      status: 0,
      out: 'square.off: valid\n',
      err: '',
    });
  });

  test('ends with 1 for a mesh with problems, which it names with their lines', async () => {
    const { status, out } = await run(['check', 'clashing.off']);
    expect(status).toBe(1);
    expect(out).toMatch(
      /^clashing\.off: error: Face \d was turned over, .* \(Line \d\) \[opposite-orientation\]\nclashing\.off: 1 problem\n$/,
    );
  });

  test('looks at where the vertices lie if asked to', async () => {
    const flat = 'v 0 0 0\nv 2 0 0\nv 1 0 0\nf 1 2 3\n';
    expect(await run(['check', '--strict'], flat)).toMatchObject({ status: 0 });
    const warned = await run(['check', '--geometry'], flat);
    expect(warned.status).toBe(0);
    expect(warned.out).toContain('standard input: warning: Face 0 has no area to speak of: it is');
    expect(warned.out).toContain(' [degenerate-face]\n');
    expect(await run(['check', '--geometry', '--strict'], flat)).toMatchObject({ status: 1 });
  });

  test('takes warnings for problems if asked to', async () => {
    expect(await run(['check', 'bowtie.off'])).toMatchObject({
      status: 0,
      out: expect.stringMatching(/: warning: Vertex 0 is pinched: .* \[pinched-vertex\]$/m),
    });
    expect(await run(['check', '--strict', 'bowtie.off'])).toMatchObject({
      status: 1,
      out: expect.stringContaining('bowtie.off: 1 warning\n'),
    });
  });

  test('ends with 2 for a file that can not be read, and checks the others', async () => {
    const { status, out, err } = await run(['check', 'broken.off', 'clashing.off', 'square.off']);
    expect(status).toBe(2);
    expect(err).toMatch(/^halfedge: broken\.off: Line 5: /);
    expect(out).toMatch(/clashing\.off: 1 problem\nsquare\.off: valid\n$/);
  });

  test('prints JSON, also of a file that can not be read', async () => {
    const { status, out, err } = await run(['check', '--json', 'clashing.off', 'broken.off']);
    expect({ status, err }).toEqual({ status: 2, err: '' });
    const [clashing, broken] = out
      .trimEnd()
      .split('\n')
      .map((line) => JSON.parse(line));
    expect(clashing).toMatchObject({
      file: 'clashing.off',
      readable: true,
      valid: false,
      problems: [{ code: 'opposite-orientation', severity: 'error', kind: 'face' }],
    });
    expect(broken).toMatchObject({ file: 'broken.off', readable: false });
    expect(broken.error).toContain('Line 5');
  });

  test('says nothing with --quiet', async () => {
    expect(await run(['check', '-q', 'clashing.off'])).toMatchObject({
      status: 1,
      out: '',
      err: '',
    });
  });
});

describe('What is refused half-way', () => {
  /** A face that no triangulation can cut without a second edge between its corners. */
  const UNCUTTABLE = `OFF\n6 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 0.5 1\n0.5 0.5 -1\n4 0 1 2 3\n3 0 2 4\n3 1 3 5\n`;

  test.each([
    [['convert', '--to', 'obj', '--triangulate'], /^halfedge: standard input: .*Face 0/],
    [['repair', '-', 'y.off', '--keep-largest', '3000000000'], /^halfedge: --keep-largest is 3000/],
    [['repair', '-', 'y.off', '--fill-holes', '3000000000'], /^halfedge: --fill-holes is 3000/],
  ])('by %j is told in a sentence, with status 2', async (args, sentence) => {
    const { status, out, err } = await run(args, UNCUTTABLE);
    expect({ status, out }).toEqual({ status: 2, out: '' });
    expect(err).toMatch(sentence);
    expect(err.trimEnd()).not.toContain('\n');
  });

  test('by too little memory to start with is told without what only we understand', async () => {
    const little = '--wasm-max-mem-pages=10';
    const child = spawn(process.execPath, [little, program, 'info', 'quad.obj'], {
      cwd: folder,
      stdio: ['ignore', 'ignore', 'pipe'],
    });
    let err = '';
    child.stderr.on('data', (chunk) => {
      err += chunk;
    });
    expect(await new Promise((resolve) => child.on('close', resolve))).toBe(2);
    expect(err).toMatch(/^halfedge: The WebAssembly module can't be started: .*\n$/);
  });

  const full = '/dev/full';
  (existsSync(full) ? test : test.skip)(
    'by a full disk behind standard output is told',
    async () => {
      const told =
        "halfedge: Standard output can't be written: no space left on device (ENOSPC).\n";
      for (const args of [
        ['convert', 'quad.obj', '--to', 'obj'],
        ['info', 'quad.obj'],
      ]) {
        const file = openSync(full, 'w');
        const child = spawn(process.execPath, [program, ...args], {
          cwd: folder,
          stdio: ['ignore', file, 'pipe'],
        });
        let err = '';
        child.stderr?.on('data', (chunk) => {
          err += chunk;
        });
        const status = await new Promise((resolve) => child.on('close', resolve));
        closeSync(file);
        expect({ status, err }).toEqual({ status: 2, err: told });
      }
    },
  );
});

describe('Progress', () => {
  test('is told where it is asked for, and never with --quiet', async () => {
    const { err } = await run(['info', 'quad.obj', '--progress']);
    expect(err).toBe('quad.obj: reading 100 %\nquad.obj: building 0 %\nquad.obj: building 100 %\n');
    expect((await run(['info', 'quad.obj', '--progress', '--quiet'])).err).toBe('');
    expect((await run(['info', 'quad.obj'])).err).toBe('');
  });

  test('stays in one line of a terminal, however long the name', async () => {
    const lines: string[] = [];
    const terminal = { isTTY: true, columns: 40, write: (line: string) => lines.push(line) };
    const progress = new Progress('automatic', terminal as unknown as WriteStream);
    await new Promise((resolve) => setTimeout(resolve, 600)); // shorter work shows nothing
    progress.begin('short.obj');
    progress.update('reading', 0.5);
    await new Promise((resolve) => setTimeout(resolve, 150));
    progress.begin(`${'folder/'.repeat(10)}long.obj`);
    progress.update('reading', 0.5);
    expect(lines).toEqual([
      '\r\x1b[Kshort.obj: reading 50 %',
      '\r\x1b[K…r/folder/folder/long.obj: reading 50 %', // 39 letters
    ]);
  });
});

describe('The tool and the collection', () => {
  const meshes = { good: collected('good'), nasty: collected('nasty') };
  const files = (name: 'good' | 'nasty') => [...meshes[name].files];

  meshes.good.test('good ones are readable, nasty ones have a verdict each', async () => {
    const good = await run(['check', '--json', ...files('good')]);
    const verdicts = good.out
      .trimEnd()
      .split('\n')
      .map((line) => JSON.parse(line));
    expect(verdicts.map(({ file }) => file)).toEqual(files('good'));
    expect(verdicts.filter(({ readable }) => !readable)).toEqual([]);

    const nasty = await run(['check', '--json', ...files('nasty')]);
    expect(nasty.err).toBe('');
    expect(nasty.status).toBe(2);
    for (const line of nasty.out.trimEnd().split('\n')) {
      const { file, readable, error, valid, problems } = JSON.parse(line);
      if (!readable) expect(error).toMatch(/: \S.*[.)]$/);
      else if (!valid) expect([file, problems.length]).not.toEqual([file, 0]);
    }
    expect(nasty.out.trimEnd().split('\n')).toHaveLength(files('nasty').length);
  });
});
