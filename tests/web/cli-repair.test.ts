import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { HalfedgeMesh, init } from 'halfedge';
import { folder, run, texts, written } from './support/cli.js';

const { SQUARE, CLASHING, QUAD } = texts;

beforeAll(() => init());

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

  test('tells once that there was nothing to do, and only if there was nothing at all', async () => {
    const options = ['--stitch', '0', '--remove-degenerate', '--orient'];
    const { out } = await run(
      ['repair', '-', 'same.obj', ...options],
      HalfedgeMesh.cube().write('obj'),
    );
    expect(out.split('\n')[0]).toBe(
      'standard input: OBJ: 8 vertices, 12 edges, 6 faces. Nothing to repair.',
    );
    const mended = await run(['repair', 'clashing.off', 'mended.off', '--stitch', '0']);
    expect(mended.out).toMatch(/ faces\. 1 face turned over\.$/m);
    const { out: closed } = await run(['repair', '-', 'c.obj', ...options], crackedCube());
    expect(closed).toMatch(/ faces\. 8 edges stitched\. 1 open component left\.$/m);
    const left = await run(['repair', 'bowtie.off', 'left.off', '--drop-small', '1']);
    expect(left.out).not.toContain('0 ');
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

test.each(['repair', 'convert'])(
  'halfedge %s prints JSON of a file that can not be read',
  async (command) => {
    const inputs: [name: string, error: string][] = [
      ['broken.off', 'Line 5'],
      ['nowhere.off', 'ENOENT'],
    ];
    for (const [name, error] of inputs) {
      const told = { file: name, readable: false, error: expect.stringContaining(error) };
      const named = await run([command, name, 'never.off', '--json']);
      expect(named).toMatchObject({ status: 2, err: '' });
      expect(JSON.parse(named.out)).toEqual(told);
      // Where the mesh would go to standard output, the report goes to standard error.
      const piped = await run([command, name, '--to=off', '--json']);
      expect(piped).toMatchObject({ status: 2, out: '' });
      expect(JSON.parse(piped.err)).toEqual(told);
    }
  },
);

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
