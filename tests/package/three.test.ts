import { mkdirSync, symlinkSync } from 'node:fs';
import { join } from 'node:path';
import { node, project, tool, tryNode } from './support/project.js';

/** A project in which three.js, its types and three-mesh-bvh are installed beside the package. */
function projectWithThree(name: string, files: Record<string, string>): string {
  const folder = project(name, files);
  for (const name of ['three', 'three-mesh-bvh']) {
    symlinkSync(tool(name), join(folder, 'node_modules', name));
  }
  mkdirSync(join(folder, 'node_modules/@types'));
  symlinkSync(tool('@types/three'), join(folder, 'node_modules/@types/three'));
  return folder;
}

const program = `
import { BoxGeometry, Mesh, Ray, Vector3 } from 'three';
import { type HalfedgeMesh, init } from 'halfedge';
import { fromBufferGeometry, type GeometryMaps, HalfedgesHelper, MeshGeometry, toBufferGeometry } from 'halfedge/three';
import { MeshPicker, type FaceHit } from 'halfedge/three/picking';

await init();
const { mesh, maps }: { mesh: HalfedgeMesh; maps: GeometryMaps } = fromBufferGeometry(new BoxGeometry(), { weld: true });
const geometry: MeshGeometry = new MeshGeometry(mesh, { normals: 'flat' });
const object = new Mesh(geometry);
object.add(new HalfedgesHelper(mesh));
mesh.splitEdge(0);
const { bytes } = geometry.update();
const hit: FaceHit | null = new MeshPicker(object).cast(new Ray(new Vector3(0.1, 0.2, 5), new Vector3(0, 0, -1)));
const back = toBufferGeometry(mesh);
const faces: Uint32Array = back.faces;
console.log(maps.vertices.length, mesh.faceCount, bytes > 0, faces.length, object.children.length, hit?.distance);
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
    expect(await node(folder, 'main.js')).toBe('24 14 true 14 1 4.5');
  });
});
