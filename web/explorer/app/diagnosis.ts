import {
  type FileFormat,
  type FileSoup,
  HalfedgeMesh,
  type ParseReport,
  type Problem,
  type RepairCode,
} from 'halfedge';

/** What became of something in a file: how it is coloured where the file is shown as it was. */
export type Fate = 'dropped' | 'turned' | 'cut' | 'mended' | 'noted';

/** The fates of faces, by their number in `Diagnosis.fates`; 0 is that of a sound face. */
export const FACE_FATES = [null, 'dropped', 'turned', 'cut', 'mended'] as const;

/** All that was found of one kind. */
export interface Finding {
  readonly code: string;
  /** `3 faces point the wrong way`. */
  readonly title: string;
  /** What was done about it. */
  readonly deed: string;
  readonly fate: Fate;
  readonly count: number;
  /** One sentence each. The package lists a hundred; `count` counts all. */
  readonly problems: readonly Problem[];
  /** How many have no sentence. */
  readonly unlisted: number;
}

/** What was wrong in a file, and the file as it was. */
export interface Diagnosis {
  readonly findings: readonly Finding[];
  /** Whether anything was repaired; otherwise there are only remarks. */
  readonly isRepaired: boolean;
  /** All of it in one line. */
  readonly summary: string;
  /** The polygons as they stand in the file. Problems name its vertices and faces. */
  readonly soup: FileSoup;
  /** The problems that one can go to: of the others, nothing that they name has a position. */
  readonly placed: ReadonlySet<Problem>;
  /** By face of the file: an index into `FACE_FATES`. */
  readonly fates: Uint8Array;
}

/** One and several of a kind, what was done, and what that is called. */
type Words = readonly [one: string, many: string, deed: string, fate: Fate];

const WORDS: Record<RepairCode, Words> = {
  'non-finite-position': [
    'vertex is nowhere',
    'vertices are nowhere',
    'A coordinate is no finite number: left out, with all faces there.',
    'dropped',
  ],
  'index-out-of-range': [
    'face uses a vertex that is not there',
    'faces use vertices that are not there',
    'Left out.',
    'dropped',
  ],
  'degree-below-three': [
    'face has fewer than three corners',
    'faces have fewer than three corners',
    'Left out.',
    'dropped',
  ],
  'repeated-vertex': [
    'face uses a vertex twice',
    'faces use a vertex twice',
    'Simplified; left out where nothing remained.',
    'mended',
  ],
  'duplicate-face': [
    'face repeats another',
    'faces repeat others',
    'Left out; one of each is kept.',
    'dropped',
  ],
  'edge-with-many-faces': [
    'edge has more than two faces',
    'edges have more than two faces',
    'Doubled, so that no copy has more than two.',
    'cut',
  ],
  'opposite-orientation': [
    'face points the wrong way',
    'faces point the wrong way',
    'Turned over, to agree with the neighbours.',
    'turned',
  ],
  'non-orientable': [
    'edge joins a front to a back',
    'edges join a front to a back',
    'Cut open: the surface has one side only.',
    'cut',
  ],
  'neighbours-cut': [
    'edge beside such an edge had to be cut',
    'edges beside such edges had to be cut',
    'Cut open: two copies of one edge would have been the same.',
    'cut',
  ],
  'pinched-vertex': [
    'vertex joins parts that share no edge',
    'vertices join parts that share no edge',
    'Doubled: each part has a vertex of its own.',
    'cut',
  ],
  'coincident-position': [
    'vertex lay where another did',
    'vertices lay where others did',
    'Joined.',
    'noted',
  ],
  'isolated-vertex': ['vertex has no face', 'vertices have no face', 'Kept.', 'noted'],
};

/** Reads the file once more, as it stands, if there is anything to say about it; otherwise null. */
export function diagnose(
  content: Uint8Array,
  format: FileFormat | undefined,
  report: ParseReport,
): Diagnosis | null {
  if (report.problems.length === 0) return null;
  const soup = HalfedgeMesh.parseSoup(content, { attributes: false, ...(format && { format }) });
  const findings = findingsOf(report);
  return {
    findings,
    isRepaired: findings.some(({ fate }) => fate !== 'noted'),
    summary: report.summary,
    soup,
    placed: placedIn(soup, report.problems),
    fates: fatesOf(report, soup.faces.sizes.length),
  };
}

/** Whether a file has such a vertex, at a finite position. */
export function hasPosition({ positions }: FileSoup, vertex: number): boolean {
  const [x, y, z] = [0, 1, 2].map((axis) => positions[3 * vertex + axis]);
  return Number.isFinite(x + y + z);
}

/** Where the corners of each face of a file begin, and the end. */
export function cornersFrom({ faces: { sizes } }: FileSoup): Uint32Array {
  const first = new Uint32Array(sizes.length + 1);
  for (let f = 0; f < sizes.length; f++) first[f + 1] = first[f] + sizes[f];
  return first;
}

function placedIn(soup: FileSoup, problems: readonly Problem[]): Set<Problem> {
  const first = cornersFrom(soup);
  const cornersOf = (face: number) => soup.faces.corners.subarray(first[face], first[face + 1]);
  const isPlaced = (vertex: number) => hasPosition(soup, vertex);
  const placed = problems.filter(
    ({ witness }) =>
      witness?.vertices.some(isPlaced) || witness?.faces.some((f) => cornersOf(f).some(isPlaced)),
  );
  return new Set(placed);
}

function findingsOf({ problems, counts, unlisted }: ParseReport): Finding[] {
  const findings: Finding[] = [];
  for (const [code, words] of Object.entries(WORDS) as [RepairCode, Words][]) {
    const count = counts[code] ?? 0;
    if (count === 0) continue;
    const [one, many, deed, fate] = words;
    const title = `${count.toLocaleString('en-US')} ${count === 1 ? one : many}`;
    findings.push({
      ...{ code, title, deed, fate, count },
      problems: listed(problems, code),
      unlisted: unlisted[code] ?? 0,
    });
  }
  const notes = listed(problems, 'note');
  if (notes.length > 0) {
    const title = notes.length === 1 ? '1 remark' : `${notes.length} remarks`;
    const deed = 'The mesh does not depend on it.';
    findings.push({
      code: 'note',
      title,
      deed,
      fate: 'noted',
      count: notes.length,
      problems: notes,
      unlisted: 0,
    });
  }
  return findings;
}

const listed = (problems: readonly Problem[], of: string) =>
  problems.filter(({ code }) => code === of);

/** The worst that happened to each face: it was left out, turned, cut off, or mended otherwise. */
function fatesOf({ verdicts }: ParseReport, faces: number): Uint8Array {
  const fates = new Uint8Array(faces);
  for (const { face, kept, codes } of verdicts) {
    const found = new Set(codes.map((code) => WORDS[code][3]));
    const worst = FACE_FATES.findIndex((fate) => fate && fate !== 'dropped' && found.has(fate));
    fates[face] = kept ? Math.max(0, worst) : FACE_FATES.indexOf('dropped');
  }
  return fates;
}
