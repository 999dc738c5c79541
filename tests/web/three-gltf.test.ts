import { readFileSync } from 'node:fs';
import { basename } from 'node:path';
import { type HalfedgeMesh, init } from 'halfedge';
import { fromBufferGeometry, toBufferGeometry } from 'halfedge/three';
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { collected } from './support/collection.js';

beforeAll(() => init());

/** Files that bring their buffers along: indexed or not, interleaved, with colours in bytes. */
const collection = collected('good', /\.glb$/);

/** The geometries of a file as three.js's own loader makes them. */
async function geometriesOf(path: string): Promise<THREE.BufferGeometry[]> {
  const loader = new GLTFLoader();
  // Without materials: their images need a browser.
  loader.register(() => ({ name: 'plain', loadMaterial: async () => new THREE.Material() }));
  const bytes = new Uint8Array(readFileSync(path));
  const { scene } = await loader.parseAsync(bytes.buffer, '');
  const geometries: THREE.BufferGeometry[] = [];
  scene.traverse((object) => {
    if (object instanceof THREE.Mesh) geometries.push(object.geometry);
  });
  return geometries;
}

/** `getComponent` is younger than the oldest three.js. */
const GETTERS = ['getX', 'getY', 'getZ', 'getW'] as const;

/** The numbers of an attribute in the corner where a halfedge ends. */
function atCorner(mesh: HalfedgeMesh, name: string, h: number): number[] {
  if (name === 'position') return [...mesh.position(mesh.toVertex(h))];
  const isOfCorners = mesh.attributes.has('halfedge', name);
  return isOfCorners
    ? mesh.attributes.values('halfedge', name, h)
    : mesh.attributes.values('vertex', name, mesh.toVertex(h));
}

function expectAlike(
  geometry: THREE.BufferGeometry,
  { mesh, maps }: ReturnType<typeof fromBufferGeometry>,
): void {
  for (const [name, attribute] of Object.entries(geometry.attributes)) {
    // Welded positions may be those of a neighbour that rounding has put beside.
    const digits = name === 'position' ? 3 : 5;
    const isColor = name === 'color' && !(attribute.array instanceof Float32Array);
    const scale = isColor ? (attribute.array instanceof Uint8Array ? 255 : 65535) : 1;
    let worst = 0;
    for (const h of mesh.halfedges()) {
      const row = maps.corners[h];
      if (row < 0) continue;
      atCorner(mesh, name, h).forEach((value, k) => {
        worst = Math.max(worst, Math.abs(value / scale - attribute[GETTERS[k]](row)));
      });
    }
    expect([name, worst]).toEqual([name, expect.closeTo(0, digits)]);
  }
}

describe('fromBufferGeometry, of real files that GLTFLoader has read,', () => {
  collection.test.each(collection.files.map((path) => [basename(path), path]))(
    'keeps each corner of %s as it was',
    async (_name, path) => {
      const geometries = await geometriesOf(path);
      expect(geometries.length).toBeGreaterThan(0);
      for (const geometry of geometries) {
        const read = fromBufferGeometry(geometry);
        const { mesh, maps } = read;
        expect(mesh.validate()).toEqual([]);
        const elements = geometry.index?.count ?? geometry.attributes.position.count;
        expect(maps.faces).toHaveLength(elements / 3);
        const kept = maps.faces.filter((f) => f >= 0).length;
        expect([kept, kept > 0.9 * maps.faces.length]).toEqual([mesh.faceCount, true]);
        expectAlike(geometry, read);
        const back = toBufferGeometry(mesh).geometry;
        expect(Object.keys(back.attributes).sort()).toEqual(
          [...new Set([...Object.keys(geometry.attributes), 'normal'])].sort(),
        );
        expect(back.index?.count).toBe(3 * mesh.faceCount);
        mesh.dispose();
      }
    },
  );
});
