// Any input gives a mesh or an error with a sentence, and leaves the module as it was: no byte is
// lost, no memory is taken for what a file merely promises, and the next mesh is made as before.

import { readFileSync, statSync } from 'node:fs';
import { HalfedgeError, HalfedgeMesh, init } from 'halfedge';
import { collected } from './support/collection.js';
import { bytesInUse, memorySize } from './support/core.js';
import { random } from './support/random.js';

beforeAll(() => init());

const obj = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n';

/** What becomes of an input: a mesh, which is checked and let go, or the code of an error. */
function outcomeOf(make: () => HalfedgeMesh): string {
  let mesh: HalfedgeMesh;
  try {
    mesh = make();
  } catch (error) {
    if (!(error instanceof HalfedgeError)) throw error;
    expect(error.message).toMatch(/^[A-Z"].{15,}[.)]$/s);
    return error.code;
  }
  expect(mesh.validate().filter(({ severity }) => severity === 'error')).toEqual([]);
  const outcome = `${mesh.vertexCount} vertices, ${mesh.faceCount} faces`;
  mesh.dispose();
  return outcome;
}
const parsed = (data: string | Uint8Array) => outcomeOf(() => HalfedgeMesh.parse(data).mesh);

/** Runs `use`; then the module has what it had before, and works. */
function expectUnharmed(use: () => void): void {
  expect(parsed(obj)).toBe('4 vertices, 4 faces');
  const before = bytesInUse();
  use();
  expect(bytesInUse()).toBe(before);
  expect(parsed(obj)).toBe('4 vertices, 4 faces');
}

const utf16 = (text: string) => Uint8Array.from(Buffer.from(`\ufeff${text}`, 'utf16le'));
const plyHeader = (format: string, vertices: string, faces: string, list = 'uchar int') =>
  `ply\nformat ${format} 1.0\nelement vertex ${vertices}\nproperty float x\nproperty float y\n` +
  `property float z\nelement face ${faces}\nproperty list ${list} vertex_indices\nend_header\n`;

/** `count` triangles around vertex 0, which share their edges or not. */
function fan(count: number, joined: boolean): string {
  const rim = joined ? count : 2 * count;
  const lines = ['v 0 0 0'];
  for (let i = 0; i < rim; i++) {
    lines.push(`v ${Math.cos((2 * Math.PI * i) / rim)} ${Math.sin((2 * Math.PI * i) / rim)} 0`);
  }
  for (let i = 0; i < count; i++) {
    const a = joined ? i : 2 * i;
    lines.push(`f 1 ${a + 2} ${((a + 1) % rim) + 2}`);
  }
  return lines.join('\n');
}

const inputs: [name: string, data: string | Uint8Array, outcome: string][] = [
  ['no byte', '', 'unknown-format'],
  ['one byte', 'v', 'unknown-format'],
  ['a NUL', '\0', 'not-text'],
  ['UTF-16', utf16(obj), 'not-text'],
  ['a byte-order mark', `\ufeff${obj}`, '4 vertices, 4 faces'],
  ['lines that end in CR', obj.replaceAll('\n', '\r'), '4 vertices, 4 faces'],
  ['a line of 4 MiB', `#${'x'.repeat(4 << 20)}\n${obj}`, '4 vertices, 4 faces'],
  ['a number of 4 MiB', `v 0.${'3'.repeat(4 << 20)} 0 0\n`, '1 vertices, 0 faces'],
  ['a million brackets', '['.repeat(1e6), 'unknown-format'],
  ['4 billion vertices in OFF', 'OFF\n4294967295 1 0\n0 0 0\n', 'truncated'],
  ['4 billion faces in OFF', 'OFF\n1 4294967295 0\n0 0 0\n', 'truncated'],
  ['4 billion vertices in PLY', plyHeader('ascii', '4294967295', '1'), 'truncated'],
  [
    '4 billion faces in PLY',
    `${plyHeader('binary_little_endian', '0', '4294967295')}x`,
    'truncated',
  ],
  [
    'a list of 4 billion',
    Buffer.from(
      `${plyHeader('binary_little_endian', '0', '1', 'uint int')}\xff\xff\xff\xff0000`,
      'latin1',
    ),
    'truncated',
  ],
  [
    '4 billion triangles',
    Buffer.from(`${' '.repeat(80)}\xff\xff\xff\xff${'\0'.repeat(50)}`, 'latin1'),
    'unknown-format',
  ],
  ['an index of 65 bits', `${obj}f 1 2 18446744073709551617\n`, '4 vertices, 4 faces'],
  ['nan', obj.replace('v 0 0 0', 'v nan 0 0'), '3 vertices, 1 faces'],
  ['valence 5000', fan(5000, true), '5001 vertices, 5000 faces'],
  ['2000 fans at a vertex', fan(2000, false), '4001 vertices, 2000 faces'],
];

test.each(inputs)('%s', (_, data, outcome) => {
  expectUnharmed(() => expect(parsed(data)).toBe(outcome));
});

test('a file that promises 4 billion makes memory no larger', () => {
  const promises = inputs.filter(([name]) => /4 billion/.test(name));
  expect(promises.length).toBeGreaterThan(4);
  const size = memorySize();
  for (const [, data] of promises) parsed(data);
  expect(memorySize()).toBe(size);
});

const forms = [
  ['obj', 'text'],
  ['off', 'text'],
  ['off', 'binary'],
  ['ply', 'text'],
  ['ply', 'binary'],
  ['ply', 'binary-big-endian'],
  ['stl', 'text'],
  ['stl', 'binary'],
] as const;

test.each(forms)('%s, %s: cut at any byte', (format, encoding) => {
  const { mesh } = HalfedgeMesh.parse(obj);
  const file = mesh.write(format, { encoding });
  const bytes = typeof file === 'string' ? new TextEncoder().encode(file) : file;
  mesh.dispose();
  expectUnharmed(() => {
    for (let size = 0; size < bytes.length; size++) {
      const outcome = parsed(bytes.slice(0, size));
      if (encoding !== 'text')
        expect([size, outcome]).toEqual([size, expect.not.stringMatching(/faces/)]);
    }
    expect(parsed(bytes)).toBe('4 vertices, 4 faces');
  });
});

test('bytes of a mesh, cut and changed', () => {
  const { mesh } = HalfedgeMesh.parse(obj);
  mesh.attributes.add('vertex', 'weight', { components: 2 });
  const bytes = mesh.toBytes();
  mesh.dispose();
  const next = random(1);
  const outcomes = new Map<string, number>();
  expectUnharmed(() => {
    for (let i = 0; i < 3000; i++) {
      const damaged = bytes.slice(0, i < bytes.length ? i : undefined);
      for (let flips = i % 3; flips > 0 && damaged.length > 0; flips--) {
        damaged[Math.floor(next() * damaged.length)] = Math.floor(next() * 256);
      }
      let outcome = 'a mesh';
      try {
        HalfedgeMesh.fromBytes(damaged).dispose();
      } catch (error) {
        if (!(error instanceof HalfedgeError)) throw error;
        outcome = error.code;
      }
      outcomes.set(outcome, (outcomes.get(outcome) ?? 0) + 1);
    }
  });
  expect([...outcomes.keys()]).toEqual(
    expect.arrayContaining(['a mesh', 'truncated', 'parse-error', 'corrupt-connectivity']),
  );
});

test('any polygons, strict and repaired', () => {
  const next = random(2);
  const below = (count: number) => Math.floor(next() * count);
  const odd = [Number.NaN, Infinity, -0, 1e-45, 3e38];
  const outcomes = new Set<string>();
  expectUnharmed(() => {
    for (let i = 0; i < 2000; i++) {
      const vertices = below(12);
      const positions = Array.from({ length: 3 * vertices }, () =>
        below(60) === 0 ? odd[below(odd.length)] : below(4),
      );
      const faces = Array.from({ length: below(20) }, () =>
        Array.from({ length: below(10) === 0 ? below(7) : 3 }, () =>
          below(vertices + (below(50) === 0 ? 2 : 0)),
        ),
      );
      outcomes.add(outcomeOf(() => HalfedgeMesh.fromPolygons(positions, faces)));
      const weld = [false, true, 0.5][i % 3];
      outcomes.add(outcomeOf(() => HalfedgeMesh.fromSoup(positions, faces, { weld }).mesh));
    }
  });
  expect(outcomes.size).toBeGreaterThan(20);
});

const all = collected(['good', 'nasty']);
all.test('files of the collection, cut and with wrong bytes', () => {
  const next = random(3);
  let errors = 0;
  expectUnharmed(() => {
    for (const file of all.files) {
      if (statSync(file).size > 2e5) continue;
      const whole = readFileSync(file);
      for (let i = 0; i < 4; i++) {
        const cut = i % 2 === 0 ? Math.floor(next() * whole.length) : whole.length;
        const damaged = Uint8Array.from(whole.subarray(0, cut));
        if (i % 2 === 1) damaged[Math.floor(next() * cut)] = Math.floor(next() * 256);
        if (!/faces/.test(parsed(damaged))) errors++;
      }
    }
  });
  expect(errors).toBeGreaterThan(50);
});
