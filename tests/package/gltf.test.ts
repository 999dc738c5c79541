import { symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { disconnect, visit } from './support/browser.js';
import { page, TITLE } from './support/programs.js';
import { node, project, tool, tryNode } from './support/project.js';
import { STRICT_POLICY, serve } from './support/server.js';

/** Writes a mesh as GLB and reads it back, and hands a line about that to `show`. */
const program = (show: string) => `
import { HalfedgeMesh, init } from 'halfedge';
import { readGltf, writeGltf } from 'halfedge/gltf';

const show = ${show};

async function roundTrip() {
  await init();
  const { mesh, report } = await readGltf(await writeGltf(HalfedgeMesh.icosahedron()));
  return report.format + ': ' + mesh.faceCount + ' faces, ' + (mesh.isClosed() ? 'closed' : 'open');
}

roundTrip().then(show, (error) => show(error.name + ' ' + error.code + ': ' + error.message));
`;
const EXPECTED = 'glb: 20 faces, closed';

/** A project in which three.js is installed beside the package. */
function projectWithThree(name: string, files: Record<string, string>): string {
  const folder = project(name, files);
  symlinkSync(tool('three'), join(folder, 'node_modules/three'));
  return folder;
}

afterAll(disconnect);

describe('Installed, `halfedge/gltf`', () => {
  test('reads and writes in Node, where three.js is installed', async () => {
    const folder = projectWithThree('gltf-node', { 'main.mjs': program('console.log') });
    expect(await node(folder, 'main.mjs')).toBe(EXPECTED);
  });

  test('says what to install where three.js is missing', async () => {
    const folder = project('gltf-alone', { 'main.mjs': program('console.log') });
    expect(await node(folder, 'main.mjs')).toMatch(
      /^HalfedgeError missing-dependency: .*'three'.*`npm install three`\.$/,
    );
  });

  test('is what the command-line tool reads and writes glTF with', async () => {
    const bin = 'node_modules/halfedge/dist/cli/main.js';
    const square = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n';
    const folder = projectWithThree('gltf-cli', { 'square.obj': square });
    expect(await node(folder, bin, 'convert', 'square.obj', 'square.glb')).toBe(
      'square.glb: Cut 1 face into 2 triangles: glTF has no polygons.',
    );
    expect(await node(folder, bin, 'convert', 'square.glb', 'square.gltf')).toBe('');
    expect(JSON.parse(await node(folder, bin, 'info', '--json', 'square.gltf'))).toMatchObject({
      format: 'gltf',
      vertices: 4,
      faces: 2,
      valid: true,
    });
    const alone = project('gltf-cli-alone', {});
    writeFileSync(join(alone, 'a.gltf'), '{ "asset": { "version": "2.0" } }');
    const { ok, output } = await tryNode(alone, bin, 'info', 'a.gltf');
    expect(ok).toBe(false);
    expect(output).toMatch(/^halfedge: a\.gltf: glTF files are read .* `npm install three`\.\n$/);
  });

  test('runs in a page through Vite, under the strict policy', async () => {
    const folder = projectWithThree('gltf-vite', {
      'package.json': '{ "private": true, "type": "module" }',
      'index.html': page('/src/index.js'),
      'src/index.js': program(TITLE),
    });
    const output = await node(folder, tool('vite/bin/vite.js'), 'build');
    expect(output).not.toMatch(/externalized|node:/i);
    const server = await serve(join(folder, 'dist'), { policy: STRICT_POLICY });
    try {
      const { title, complaints } = await visit(server.address);
      expect(complaints).toEqual([]);
      expect(title).toBe(EXPECTED);
    } finally {
      await server.close();
    }
  });
});
