import { HalfedgeError, HalfedgeMesh, init } from 'halfedge';
import { Matrix4 } from 'three';
import { diagnose, FACE_FATES } from '../../web/explorer/app/diagnosis.js';
import { failureOf, openSource } from '../../web/explorer/app/documents.js';
import { fileName, fileOf, sizeWords } from '../../web/explorer/app/files.js';
import { brokenSamples } from '../../web/explorer/samples/broken.js';
import { SoupShape } from '../../web/explorer/scene/soup-shape.js';
import { bytesInUse } from './support/core.js';

beforeAll(() => init());

const broken = (id: string) => {
  const sample = brokenSamples.find((candidate) => candidate.id === id);
  if (!sample) throw new Error(`There is no sample ${id}.`);
  return sample;
};

const countsOf = async (id: string) => {
  const { diagnosis, mesh } = await openSource(broken(id));
  const findings = diagnosis?.findings ?? [];
  const counts = Object.fromEntries(findings.map(({ code, count }) => [code, count]));
  const loops = mesh.boundaryLoops().length;
  expect(mesh.validate(4).filter(({ severity }) => severity === 'error')).toEqual([]);
  mesh.dispose();
  return { ...counts, loops };
};

describe('broken samples', () => {
  test.each([
    ['three-faces', { 'edge-with-many-faces': 5, loops: 3 }],
    ['flipped-patch', { 'opposite-orientation': 27, loops: 0 }],
    ['moebius', { 'non-orientable': 6, loops: 1 }],
    ['klein', { 'non-orientable': 16, loops: 2 }],
    ['duplicates', { 'duplicate-face': 82, 'opposite-orientation': 15, loops: 0 }],
    ['touching-cubes', { 'pinched-vertex': 1, loops: 0 }],
    ['degenerate', { 'degree-below-three': 4, 'repeated-vertex': 9, loops: 8 }],
    ['not-there', { 'non-finite-position': 1, 'index-out-of-range': 3, loops: 5 }],
    ['crack', { loops: 2 }],
    ['t-junction', { loops: 31 }],
    ['isolated', { 'isolated-vertex': 40, loops: 0 }],
  ])('%s has what its lesson tells, and makes a valid mesh', async (id, counts) => {
    expect(await countsOf(id)).toEqual(counts);
  });

  test('the scan has more than 50,000 triangles, and everything wrong that it should', async () => {
    const { diagnosis, mesh } = await openSource(broken('scan'));
    expect(diagnosis?.soup.faces.sizes.length).toBeGreaterThan(50_000);
    const codes = diagnosis?.findings.map(({ code }) => code);
    expect(codes).toEqual(
      expect.arrayContaining(['duplicate-face', 'edge-with-many-faces', 'opposite-orientation']),
    );
    expect(mesh.validate(4).filter(({ severity }) => severity === 'error')).toEqual([]);
    mesh.dispose();
  });

  test('the one that is cut short is refused in a sentence, and tells why it is there', async () => {
    const sample = broken('cut-short');
    const error = await openSource(sample).catch((thrown: unknown) => thrown);
    expect(error).toBeInstanceOf(HalfedgeError);
    const failure = failureOf(error, sample);
    expect(failure.message).toMatch(
      /^Line \d+: expected .*found the end of the file .read as OFF.\.$/,
    );
    expect(failure.lesson).toBe(sample.lesson);
  });

  test('are told apart by id, and explained in a sentence', () => {
    expect(new Set(brokenSamples.map(({ id }) => id)).size).toBe(brokenSamples.length);
    for (const { lesson } of brokenSamples) expect(lesson).toMatch(/^[A-Z].{30,240}\.$/);
  });
});

test('A file that can not be diagnosed leaves no mesh behind', async () => {
  const before = bytesInUse();
  const reading = import.meta.jest.spyOn(HalfedgeMesh, 'parseSoup').mockImplementation(() => {
    throw new HalfedgeError('out-of-memory', 'No room.');
  });
  const opening = openSource(broken('touching-cubes'));
  await expect(opening).rejects.toMatchObject({ code: 'out-of-memory' });
  reading.mockRestore();
  expect(bytesInUse()).toBe(before);
});

describe('diagnose', () => {
  const soup =
    'OFF\n5 5 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n5 5 5\n3 0 1 2\n3 0 3 2\n3 2 0 1\n2 0 1\n3 0 0 3\n';
  const bytes = new TextEncoder().encode(soup);

  test('groups what was found, counts it, and gives each face its fate', () => {
    const { mesh, report } = HalfedgeMesh.parse(bytes);
    const diagnosis = diagnose(bytes, undefined, report);
    mesh.dispose();
    const titles = diagnosis?.findings.map(({ title, fate }) => [title, fate]);
    expect(titles).toEqual([
      ['1 face has fewer than three corners', 'dropped'],
      ['1 face uses a vertex twice', 'mended'],
      ['1 face repeats another', 'dropped'],
      ['1 face points the wrong way', 'turned'],
      ['1 vertex has no face', 'noted'],
    ]);
    const fates = [...(diagnosis?.fates ?? [])].map((fate) => FACE_FATES[fate]);
    expect(fates.slice(2)).toEqual(['dropped', 'dropped', 'dropped']);
    expect(fates.slice(0, 2).filter((fate) => fate === 'turned')).toHaveLength(1);
    expect(diagnosis?.isRepaired).toBe(true);
  });

  test('tells which problems are somewhere: one that lies nowhere can’t be gone to', () => {
    const nowhere = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nv nan 1 1\nf 1 2 3\nf 1 2 4\nf 3 3 3\n';
    const content = new TextEncoder().encode(nowhere);
    const { mesh, report } = HalfedgeMesh.parse(content);
    mesh.dispose();
    const diagnosis = diagnose(content, 'obj', report);
    if (!diagnosis) throw new Error('Nothing was found.');
    const shape = new SoupShape(diagnosis.soup, new Matrix4());
    const problems = diagnosis.findings.flatMap((finding) => finding.problems);
    const told = problems.map((problem) => [problem.code, diagnosis.placed.has(problem)]);
    expect(told).toEqual([
      ['non-finite-position', false],
      ['non-finite-position', false],
      ['repeated-vertex', true],
    ]);
    for (const problem of problems) {
      expect(shape.place(problem) !== null).toBe(diagnosis.placed.has(problem));
    }
  });

  test('says nothing of a good file, and repairs nothing in one with remarks alone', () => {
    const good = new TextEncoder().encode('OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n');
    const { mesh, report } = HalfedgeMesh.parse(good);
    expect(diagnose(good, undefined, report)).toBeNull();
    mesh.dispose();
    const lonely = new TextEncoder().encode('v 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\nf 1 2 3\n');
    const file = HalfedgeMesh.parse(lonely);
    expect(diagnose(lonely, 'obj', file.report)?.isRepaired).toBe(false);
    file.mesh.dispose();
  });
});

describe('a file of the mesh', () => {
  test('keeps the names of its materials, groups and objects', async () => {
    const named = `mtllib wood.mtl\no table\ng legs\n${'v 0 0 0\nv 1 0 0\nv 0 1 0\n'}usemtl oak\nf 1 2 3\n`;
    const opened = await openSource(new File([named], 'table.obj'));
    const text = await fileOf(opened, 'obj').content.text();
    for (const line of ['mtllib wood.mtl', 'o table', 'g legs', 'usemtl oak']) {
      expect(text.split('\n')).toContain(line);
    }
    opened.mesh.dispose();
  });

  test.each([
    ['scan', true, 'scan-repaired.obj'],
    ['Grüße an die Höhle (2)', false, 'Grüße-an-die-Höhle-2.obj'],
    ['../../etc/passwd', true, 'etc-passwd-repaired.obj'],
    ['???', false, 'mesh.obj'],
  ])('of %s is called so that every system takes it', async (stem, isRepaired, name) => {
    const opened = await openSource(broken(isRepaired ? 'duplicates' : 'crack'));
    expect(fileName({ ...opened, stem }, 'obj')).toBe(name);
    opened.mesh.dispose();
  });

  test.each(['obj', 'off', 'ply', 'stl'] as const)('reads back strictly as %s', async (format) => {
    const opened = await openSource(broken('duplicates'));
    const { content } = fileOf(opened, format);
    const again = HalfedgeMesh.parse(await content.arrayBuffer(), { format, repair: false });
    expect(again.report.format).toBe(format);
    again.mesh.dispose();
    opened.mesh.dispose();
  });

  test('says that STL can’t keep doubled vertices apart', async () => {
    const opened = await openSource(broken('touching-cubes'));
    expect(fileOf(opened, 'obj').notes).toEqual([]);
    expect(fileOf(opened, 'stl').notes.join(' ')).toMatch(/with which readers of STL join /);
    opened.mesh.dispose();
  });

  test('tells its size', () => {
    expect([812, 1400, 45_600, 3_200_000, 123_456_789].map(sizeWords)).toEqual([
      '812 bytes',
      '1.4 kB',
      '46 kB',
      '3.2 MB',
      '123 MB',
    ]);
  });
});
