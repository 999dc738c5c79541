import { spawn } from 'node:child_process';
import {
  closeSync,
  existsSync,
  mkdtempSync,
  openSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { HalfedgeMesh, init } from 'halfedge';
import { readGltf } from 'halfedge/gltf';
import { collected } from './support/collection.js';

const program = fileURLToPath(new URL('../../dist/cli/main.js', import.meta.url));

interface Ended {
  status: number | null;
  out: string;
  err: string;
  /** Standard output as it is. */
  bytes: Buffer;
}

/** Runs the command-line tool with something on its standard input. */
function run(args: string[], input: string | Uint8Array = ''): Promise<Ended> {
  return new Promise((resolve, reject) => {
    const child = spawn(process.execPath, [program, ...args], { cwd: folder });
    const out: Buffer[] = [];
    const err: Buffer[] = [];
    child.stdout.on('data', (chunk) => out.push(chunk));
    child.stderr.on('data', (chunk) => err.push(chunk));
    child.on('error', reject);
    child.stdin.on('error', () => {}); // a program that refuses its arguments doesn't read
    child.stdin.end(input);
    child.on('close', (status) => {
      const bytes = Buffer.concat(out);
      resolve({ status, bytes, out: bytes.toString(), err: Buffer.concat(err).toString() });
    });
  });
}

const SQUARE = 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n';
/** The second face runs along the common edge in the same direction as the first. */
const CLASHING = SQUARE.replace('3 0 2 3', '3 0 3 2');
/** Two triangles that touch in vertex 0, and an isolated vertex. */
const BOWTIE = 'OFF\n6 2 0\n0 0 0\n1 0 0\n1 1 0\n-1 0 0\n-1 -1 0\n9 9 9\n3 0 1 2\n3 0 3 4\n';
const QUAD = 'v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\n';

let folder: string;
beforeAll(async () => {
  await init();
  folder = mkdtempSync(join(tmpdir(), 'halfedge-cli-'));
  const files = {
    'square.off': SQUARE,
    'clashing.off': CLASHING,
    'bowtie.off': BOWTIE,
    'quad.obj': QUAD,
    'broken.off': SQUARE.replace('1 1 0', '1 one 0'),
  };
  for (const [name, text] of Object.entries(files)) writeFileSync(join(folder, name), text);
});
afterAll(() => rmSync(folder, { recursive: true, force: true }));

const written = (name: string) => HalfedgeMesh.parse(readFileSync(join(folder, name)));

describe('halfedge', () => {
  test('tells its version, which is that of the package', async () => {
    const manifest = new URL('../../package.json', import.meta.url);
    const { version } = JSON.parse(readFileSync(manifest, 'utf8'));
    expect(await run(['--version'])).toMatchObject({ status: 0, out: `${version}\n`, err: '' });
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
valid                 yes
`,
    });
  });

  test('reads standard input, named or not, in any format', async () => {
    const facts = { file: 'standard input', format: 'stl', vertices: 4, faces: 4, closed: true };
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

describe('halfedge repair', () => {
  test('writes a valid mesh and prints the report', async () => {
    const { status, out, err } = await run(['repair', 'clashing.off', 'mended.ply']);
    expect({ status, err }).toEqual({ status: 0, err: '' });
    expect(out).toMatch(
      /^Face \d was turned over, .*\nclashing\.off: OFF: .* 1 face turned over\./,
    );
    expect(out).toMatch(/\nmended\.ply: PLY: 4 vertices, 5 edges, 2 faces\.\n$/);
    const { mesh, report } = written('mended.ply');
    expect(report).toMatchObject({ format: 'ply', problems: [] });
    expect(mesh.faceCount).toBe(2);
    expect(await run(['check', 'mended.ply'])).toMatchObject({ status: 0 });
  });

  test('can mend a file in place, and be asked for JSON', async () => {
    writeFileSync(join(folder, 'here.off'), CLASHING);
    const { out } = await run(['repair', 'here.off', '-o', 'here.off', '--json']);
    expect(JSON.parse(out)).toMatchObject({
      input: 'here.off',
      output: 'here.off',
      faces: 2,
      counts: { 'opposite-orientation': 1 },
    });
    expect(written('here.off').report.problems).toEqual([]);
  });

  test('without an output keeps the format, and the report out of standard output', async () => {
    const { status, out, err } = await run(['repair'], CLASHING);
    expect(status).toBe(0);
    expect(out).toMatch(/^OFF\n4 2 /);
    expect(err).toContain('1 face turned over.');
    expect((await run(['repair', '--quiet'], CLASHING)).err).toBe('');
  });

  test('drops what it is asked to drop', async () => {
    const { out } = await run(['repair', 'bowtie.off', 'kept.off', '--drop-isolated']);
    expect(out).toContain('1 vertex without faces dropped.');
    expect(written('kept.off').mesh.vertexCount).toBe(5);
    const two = `${SQUARE.replace('4 2 0', '7 3 0').replace('0 1 0\n', '0 1 0\n5 5 5\n6 5 5\n6 6 5\n')}3 4 5 6\n`;
    const largest = await run(['repair', '-', 'largest.off', '--keep-largest', '1'], two);
    expect(largest.out).toContain('1 smaller component dropped.');
    expect(written('largest.off').mesh.faceCount).toBe(2);
  });
});

describe('halfedge repair, asked for more,', () => {
  /** A cube of six separate quads, one of them missing, the others turned inward. */
  const crackedCube = () => {
    const cube = HalfedgeMesh.cube();
    cube.reverse();
    const rows = [...cube.faces()].slice(0, 5).map((f) => [...cube.faceVertices(f)]);
    const positions = rows.flat().map((v) => `v ${cube.position(v).join(' ')}`);
    const faces = rows.map((_, i) => `f ${[1, 2, 3, 4].map((k) => 4 * i + k).join(' ')}`);
    return [...positions, ...faces, ''].join('\n');
  };

  test('stitches, fills holes and orients', async () => {
    const options = ['--stitch', '0', '--fill-holes', '8', '--orient'];
    const { status, out } = await run(['repair', '-', 'box.obj', ...options], crackedCube());
    expect(status).toBe(0);
    expect(out).toContain('box.obj: OBJ: 8 vertices, 13 edges, 7 faces.');
    const { mesh } = written('box.obj');
    expect(mesh.isClosed()).toBe(true);
    const { indices } = mesh.toTriangles();
    let volume = 0;
    for (let i = 0; i < indices.length; i += 3) {
      const [a, b, c] = [0, 1, 2].map((k) => mesh.position(indices[i + k]));
      volume +=
        (a[0] * (b[1] * c[2] - b[2] * c[1]) +
          a[1] * (b[2] * c[0] - b[0] * c[2]) +
          a[2] * (b[0] * c[1] - b[1] * c[0])) /
        6;
    }
    expect(volume).toBeCloseTo(1);
  });

  test('drops small components and faces without area', async () => {
    const two = `${QUAD}v 5 0 0\nv 6 0 0\nv 7 0 0\nf 5 6 7\n`;
    const degenerate = await run(['repair', '-', 'flat.off', '--remove-degenerate'], two);
    expect(degenerate.status).toBe(0);
    expect(written('flat.off').mesh.faceCount).toBe(1);
    await run(['repair', '-', 'small.off', '--drop-small', '2', '--drop-isolated'], two);
    expect(written('small.off').mesh.vertexCount).toBe(0);
  });

  test('tells what it could not do, and refuses wrong numbers', async () => {
    const { out } = await run(['repair', '-', 'left.obj', '--orient'], crackedCube());
    expect(out).toMatch(/^The component of face 0, .*what is open has no inside\.$/m);
    expect(out).toContain('5 open components left');
    for (const [option, value] of [
      ['stitch', '-1'],
      ['fill-holes', '2.5'],
      ['drop-small', '0'],
    ]) {
      const { status, err } = await run(['repair', '-', 'x.obj', `--${option}=${value}`], QUAD);
      expect(status).toBe(2);
      expect(err).toContain(`--${option} is `);
    }
  });
});

test('halfedge repair --stitch tells of the pinched vertices that it splits', async () => {
  const { out } = await run(['repair', 'bowtie.off', 'untied.off', '--stitch', '0']);
  expect(out).toContain('1 pinched vertex split.\n');
  const { out: json } = await run(['repair', 'bowtie.off', 'x.off', '--stitch=0', '--json', '-q']);
  expect(JSON.parse(json)).toMatchObject({
    steps: [{ step: 'stitch', counts: { 'split-vertex': 1 } }],
    notes: [],
  });
  expect((await run(['repair', '--help'])).out).toMatch(/splits pinched vertices, then glues/);
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

describe('halfedge convert', () => {
  test.each(['obj', 'off', 'ply', 'stl'] as const)(
    'writes %s by the name of the output',
    async (format) => {
      const name = `converted.${format.toUpperCase()}`;
      expect(await run(['convert', 'square.off', name])).toMatchObject({
        status: 0,
        out: '',
        err: '',
      });
      const { mesh, report } = written(name);
      expect(report.format).toBe(format);
      expect([mesh.vertexCount, mesh.faceCount]).toEqual([4, 2]);
    },
  );

  test('writes to standard output what --to says, bit for bit what the package writes', async () => {
    const { mesh } = HalfedgeMesh.parse(QUAD);
    const { status, bytes } = await run(['convert', '--to', 'ply'], QUAD);
    expect(status).toBe(0);
    expect(new Uint8Array(bytes)).toEqual(mesh.write('ply'));
    const text = await run(['convert', 'quad.obj', '-', '--to=ply', '--encoding', 'text']);
    expect(text.out).toBe(mesh.write('ply', { encoding: 'text' }));
  });

  test('goes to glTF and back, texture coordinates the right way up', async () => {
    const mesh = HalfedgeMesh.tetrahedron();
    const uv = mesh.attributes.add('vertex', 'uv', { components: 2 });
    uv.set([0, 0, 1, 0, 1, 1, 0.25, 0.75]);
    writeFileSync(join(folder, 'uv.ply'), mesh.write('ply'));
    expect(await run(['convert', 'uv.ply', 'uv.glb'])).toMatchObject({ status: 0, err: '' });
    const { mesh: read } = await readGltf(readFileSync(join(folder, 'uv.glb')));
    expect([...read.attributes.get('vertex', 'uv')]).toEqual([0, 1, 1, 1, 1, 0, 0.25, 0.25]);
    const info = await run(['info', '--json'], readFileSync(join(folder, 'uv.glb')));
    expect(JSON.parse(info.out)).toMatchObject({ format: 'glb', vertices: 4, closed: true });
    expect(await run(['convert', 'uv.glb', '--to', 'gltf', '--encoding', 'text'])).toMatchObject({
      status: 2,
      err: expect.stringContaining('--encoding is for OBJ, OFF, PLY and STL'),
    });
  });

  test('cuts polygons into triangles if asked to', async () => {
    await run(['convert', 'quad.obj', 'cut.off', '--triangulate']);
    expect(written('cut.off').mesh.faceCount).toBe(2);
  });

  test('keeps the names of materials, and tells what the output has no place for', async () => {
    const named = QUAD.replace('f 1', 'usemtl oak\nf 1');
    const { out, err } = await run(['convert', '--to', 'obj'], named);
    expect(out).toContain('usemtl oak\nf 1 2 3 4');
    expect(err).toBe('');
    const stl = await run(['convert', '-', 'named.stl'], named);
    expect(stl).toMatchObject({ status: 0, err: expect.stringMatching(/^named\.stl: .*material/) });
    expect((await run(['convert', '-', 'named.stl', '-q'], named)).err).toBe('');
  });

  test('tells what glTF has no place for, and in JSON with all else', async () => {
    const named = QUAD.replace('f 1', 'usemtl oak\nf 1');
    const { err } = await run(['convert', '-', 'named.glb'], named);
    expect(err).toBe(
      'named.glb: Cut 1 face into 2 triangles: glTF has no polygons.\n' +
        'named.glb: Left out the face attribute "material": glTF has no place for it.\n',
    );
    const json = await run(['convert', '-', 'named.glb', '--json', '--quiet'], named);
    expect(json.err).toBe('');
    expect(JSON.parse(json.out)).toMatchObject({
      notes: [expect.stringMatching(/^Cut 1 face/), expect.stringMatching(/^Left out the face/)],
    });
  });

  test('tells on standard error what it had to repair', async () => {
    const { status, out, err } = await run(['convert', 'clashing.off', '--to', 'obj']);
    expect(status).toBe(0);
    expect(out).toMatch(/^v 0 0 0\n/);
    expect(err).toBe('clashing.off: OFF: 4 vertices, 5 edges, 2 faces. 1 face turned over.\n');
  });

  test('ends without a word when nobody reads its output any more', async () => {
    const { mesh } = HalfedgeMesh.parse(HalfedgeMesh.icoSphere(6).write('obj'));
    writeFileSync(join(folder, 'sphere.obj'), mesh.write('obj'));
    const child = spawn(process.execPath, [program, 'convert', 'sphere.obj', '--to', 'obj'], {
      cwd: folder,
    });
    let err = '';
    child.stderr.on('data', (chunk) => {
      err += chunk;
    });
    child.stdout.once('data', () => child.stdout.destroy());
    const status = await new Promise((resolve) => child.on('close', resolve));
    expect({ status, err }).toEqual({ status: 141, err: '' });
  });
});

describe('Progress', () => {
  test('is told where it is asked for, and never with --quiet', async () => {
    const { err } = await run(['info', 'quad.obj', '--progress']);
    expect(err).toBe('quad.obj: reading 100 %\nquad.obj: building 0 %\nquad.obj: building 100 %\n');
    expect((await run(['info', 'quad.obj', '--progress', '--quiet'])).err).toBe('');
    expect((await run(['info', 'quad.obj'])).err).toBe('');
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
