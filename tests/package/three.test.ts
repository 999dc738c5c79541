import { mkdirSync, symlinkSync } from 'node:fs';
import { join } from 'node:path';
import { node, project, tool, tryNode } from './support/project.js';

/** A project in which three.js and its types are installed beside the package. */
function projectWithThree(name: string, files: Record<string, string>): string {
  const folder = project(name, files);
  symlinkSync(tool('three'), join(folder, 'node_modules/three'));
  mkdirSync(join(folder, 'node_modules/@types'));
  symlinkSync(tool('@types/three'), join(folder, 'node_modules/@types/three'));
  return folder;
}

const program = `
import { BoxGeometry, Mesh, type Vector3 } from 'three';
import { type HalfedgeMesh, init } from 'halfedge';
import { fromBufferGeometry, type GeometryMaps, HalfedgesHelper, MeshGeometry, toBufferGeometry } from 'halfedge/three';

await init();
const { mesh, maps }: { mesh: HalfedgeMesh; maps: GeometryMaps } = fromBufferGeometry(new BoxGeometry(), { weld: true });
const geometry: MeshGeometry = new MeshGeometry(mesh, { normals: 'flat' });
const object = new Mesh(geometry);
object.add(new HalfedgesHelper(mesh));
mesh.splitEdge(0);
const { bytes } = geometry.update();
const back = toBufferGeometry(mesh);
const faces: Uint32Array = back.faces;
console.log(maps.vertices.length, mesh.faceCount, bytes > 0, faces.length, object.children.length);
// @ts-expect-error There are three ways to make normals.
toBufferGeometry(mesh, { normals: 'soft' });
// @ts-expect-error A mesh is no geometry.
export const wrong = (v: Vector3) => fromBufferGeometry(mesh, v);
`;

describe('Installed, `halfedge/three`', () => {
  test('has types that go together with those of three.js, and runs in Node', async () => {
    const compilerOptions = {
      ...{ strict: true, exactOptionalPropertyTypes: true, skipLibCheck: true, types: [] },
      ...{ target: 'es2022', module: 'nodenext', lib: ['es2022', 'dom'] },
    };
    const folder = projectWithThree('three-node', {
      'package.json': '{ "type": "module", "private": true }',
      'tsconfig.json': JSON.stringify({ compilerOptions, files: ['main.ts'] }),
      'main.ts': program.replace(
        /toBufferGeometry\(mesh, \{ normals: 'soft' \}\);/,
        'export const soft = () => $&',
      ),
    });
    const { output } = await tryNode(folder, tool('typescript/bin/tsc'), '-p', '.');
    expect(output.trim()).toBe('');
    expect(await node(folder, 'main.js')).toBe('24 14 true 14 1');
  });
});
