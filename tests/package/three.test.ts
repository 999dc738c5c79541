import { mkdirSync, readFileSync, symlinkSync } from 'node:fs';
import { join } from 'node:path';
import { node, packed, project, tool, tryNode } from './support/project.js';

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
import { BoxGeometry, Mesh, Ray, Raycaster, Vector3 } from 'three';
import { type Face, type HalfedgeMesh, init, type Vertex } from 'halfedge';
import { CirculatorHelper, fromBufferGeometry, type GeometryMaps, HalfedgesHelper, MeshGeometry, toBufferGeometry } from 'halfedge/three';
import { MeshPicker, type FaceHit } from 'halfedge/three/picking';
import { webgpuLines } from 'halfedge/three/webgpu';

await init();
const { mesh, maps }: { mesh: HalfedgeMesh; maps: GeometryMaps } = fromBufferGeometry(new BoxGeometry(), { weld: true });
const geometry: MeshGeometry = new MeshGeometry(mesh, { normals: 'flat' });
const object = new Mesh(geometry);
object.add(new HalfedgesHelper(mesh, { lines: webgpuLines }));
mesh.splitEdge(0);
const { bytes } = geometry.update();
const [found] = new Raycaster(new Vector3(0.1, 0.2, 5), new Vector3(0, 0, -1)).intersectObject(object);
const pointedAt: Face = geometry.face(found.faceIndex);
geometry.triangles(pointedAt);
const hit: FaceHit | null = new MeshPicker(object).cast(new Ray(new Vector3(0.1, 0.2, 5), new Vector3(0, 0, -1)));
const back = toBufferGeometry(mesh);
const faces: Uint32Array = back.faces;
console.log(maps.vertices.length, mesh.faceCount, bytes > 0, faces.length, object.children.length, hit?.distance);
/** Options that are handed on, given or not. */
export const view = (weld?: number, normals?: 'flat', color?: number) => {
  const shown = fromBufferGeometry(geometry, { weld }).mesh;
  return [new MeshGeometry(shown, { normals }), new HalfedgesHelper(shown, { color })];
};
export const trace = (v: Vertex) => new CirculatorHelper(mesh, 'vertexFaces', v, { steps: 2 }).trace();
// @ts-expect-error A face is no vertex.
export const traceOf = (f: Face) => new CirculatorHelper(mesh, 'vertexFaces', f);
// @ts-expect-error A vertex is no face.
geometry.triangles(mesh.toVertex(0));
// @ts-expect-error There are three ways to make normals.
toBufferGeometry(mesh, { normals: 'soft' });
// @ts-expect-error Lines are made by what makes lines.
export const drawn = () => new HalfedgesHelper(mesh, { lines: 'webgpu' });
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

  test('does what the README says, its blocks run one after the other', async () => {
    const readme = readFileSync(
      join(packed.folder, 'installed/node_modules/halfedge/README.md'),
      'utf8',
    );
    const [, section] = /^## three\.js$(.*?)^## /ms.exec(readme) ?? [];
    const blocks = [...section.matchAll(/^```js\n(.*?)^```$/gms)].map(([, block]) => block);
    expect(blocks.length).toBeGreaterThanOrEqual(4);
    const folder = projectWithThree('three-readme', { 'main.mjs': around(blocks.join('\n')) });
    expect(JSON.parse(await node(folder, 'main.mjs'))).toEqual({
      vertices: 9,
      faces: 14,
      children: 2,
      steps: 3,
      picked: 'face',
    });
  });
});

/** What a page has that the README takes for granted, and what there is in the end. */
const around = (blocks: string) => `
import { PerspectiveCamera, Raycaster, Scene, Vector3 } from 'three';

const scene = new Scene();
const camera = new PerspectiveCamera();
camera.position.z = 5;
camera.updateMatrixWorld();
const canvas = { clientWidth: 640, clientHeight: 480 };
const [x, y] = [327, 231];
const raycaster = new Raycaster(new Vector3(0.1, 0.2, 5), new Vector3(0, 0, -1));
const { ray } = raycaster;
${blocks}
console.log(JSON.stringify({
  vertices: mesh.vertexCount,
  faces: mesh.faceCount,
  children: object.children.length,
  steps: trace.trace().length,
  picked: picker.pick(x, y, view, { mode: 'face' }).kind,
}));
`;
