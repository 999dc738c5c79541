import { spawn } from 'node:child_process';
import {
  chmodSync,
  readdirSync,
  readFileSync,
  readlinkSync,
  statSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { join } from 'node:path';
import { HalfedgeMesh, init } from 'halfedge';
import { readGltf } from 'halfedge/gltf';
import { capture } from '../../scripts/lib/run.mjs';
import { folder, program, run, texts, written } from './support/cli.js';

const { QUAD } = texts;

beforeAll(() => init());

describe('halfedge convert', () => {
  test('leaves a file as it was where it fails to write it anew', async () => {
    const mesh = HalfedgeMesh.icoSphere(4);
    const before = mesh.write('obj');
    writeFileSync(join(folder, 'ball.obj'), before);
    const child = spawn(
      'sh',
      ['-c', `ulimit -f 20; exec "${process.execPath}" "${program}" convert ball.obj ball.obj`],
      {
        cwd: folder,
        stdio: 'ignore',
      },
    );
    const status = await new Promise((resolve) => child.on('close', resolve));
    expect(status).toBe(2);
    expect(readFileSync(join(folder, 'ball.obj'), 'utf8')).toBe(before);
    expect(readdirSync(folder).filter((name) => name.includes('.part'))).toEqual([]);
    expect(await run(['convert', 'ball.obj', 'ball.obj'])).toMatchObject({ status: 0, err: '' });
    expect(written('ball.obj').mesh.faceCount).toBe(mesh.faceCount);
  });

  test('leaves nothing behind where it is ended while it writes', async () => {
    const before = HalfedgeMesh.icoSphere(7).write('obj');
    writeFileSync(join(folder, 'large.obj'), before);
    const drafts = () => readdirSync(folder).filter((name) => name.includes('.part'));
    const child = spawn(process.execPath, [program, 'convert', 'large.obj', 'large.obj'], {
      cwd: folder,
      stdio: 'ignore',
    });
    const ended = new Promise((resolve) => child.on('close', (_, signal) => resolve(signal)));
    while (child.exitCode === null && drafts().length === 0) {
      await new Promise((resolve) => setTimeout(resolve, 1));
    }
    child.kill('SIGINT');
    expect(['SIGINT', null]).toContain(await ended); // null if the file was written before
    expect(drafts()).toEqual([]);
    expect(readFileSync(join(folder, 'large.obj')).length).toBeGreaterThanOrEqual(before.length);
  });

  test('keeps the permissions of a file that it writes anew, and links to files', async () => {
    const modeOf = (name: string) => (statSync(join(folder, name)).mode & 0o777).toString(8);
    for (const mode of [0o664, 0o600]) {
      writeFileSync(join(folder, 'shared.obj'), QUAD);
      chmodSync(join(folder, 'shared.obj'), mode);
      expect(await run(['convert', 'shared.obj', 'shared.obj'])).toMatchObject({ status: 0 });
      expect(modeOf('shared.obj')).toBe(mode.toString(8));
    }
    for (const target of ['shared.obj', 'not-there-yet.obj']) {
      const link = join(folder, `link-to-${target}`);
      symlinkSync(target, link);
      expect(await run(['convert', 'square.off', link])).toMatchObject({ status: 0 });
      expect(readlinkSync(link)).toBe(target);
      expect(written(target).mesh.faceCount).toBe(2);
    }
  });

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

  test('says where glTF goes that Draco has compressed', async () => {
    const extensionsRequired = ['KHR_draco_mesh_compression'];
    const json = JSON.stringify({ asset: { version: '2.0' }, extensionsRequired });
    expect(await run(['convert', '-', 'packed.ply'], json)).toMatchObject({
      status: 2,
      err: expect.stringMatching(/Draco has compressed the geometry, .*: the explorer does, and /),
    });
  });

  test('says where buffers of glTF are looked for that standard input has not', async () => {
    const json = JSON.stringify({
      asset: { version: '2.0' },
      buffers: [{ uri: 'box.bin', byteLength: 1 }],
    });
    expect(await run(['info'], json)).toMatchObject({
      status: 2,
      err: 'halfedge: standard input: glTF: buffers[0] is in another file, "box.bin"; expected the name of the file, beside which it is looked for, instead of standard input.\n',
    });
  });

  test.each([
    ['ply', '--encoding text'],
    ['glb', '--to gltf'],
  ])('does not print binary %s on a terminal, and tells to ask for %s', async (format, inText) => {
    const terminal = 'data:text/javascript,process.stdout.isTTY = true';
    const args = ['--import', terminal, program, 'convert', 'quad.obj', '--to', format];
    expect(await capture(process.execPath, args, { cwd: folder })).toEqual({
      ok: false,
      output: `halfedge: Binary ${format.toUpperCase()} is nothing for a terminal; name a file for it, or ask for ${inText}.\n`,
      printed: '',
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
