import { spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { HalfedgeMesh } from 'halfedge';

/** The command-line tool, as it is shipped. */
export const program = fileURLToPath(new URL('../../../dist/cli/main.js', import.meta.url));

const SQUARE = 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n';
/** The second face runs along the common edge in the same direction as the first. */
const CLASHING = SQUARE.replace('3 0 2 3', '3 0 3 2');
/** Two triangles that touch in vertex 0, and an isolated vertex. */
const BOWTIE = 'OFF\n6 2 0\n0 0 0\n1 0 0\n1 1 0\n-1 0 0\n-1 -1 0\n9 9 9\n3 0 1 2\n3 0 3 4\n';
const QUAD = 'v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\n';

/** The texts of some files. */
export const texts = { SQUARE, CLASHING, BOWTIE, QUAD };

/** Where the tool runs, among those files, until the tests are over. */
export const folder = mkdtempSync(join(tmpdir(), 'halfedge-cli-'));
const files = {
  'square.off': SQUARE,
  'clashing.off': CLASHING,
  'bowtie.off': BOWTIE,
  'quad.obj': QUAD,
  'broken.off': SQUARE.replace('1 1 0', '1 one 0'),
};
for (const [name, text] of Object.entries(files)) writeFileSync(join(folder, name), text);
afterAll(() => rmSync(folder, { recursive: true, force: true }));

interface Ended {
  status: number | null;
  out: string;
  err: string;
  /** Standard output as it is. */
  bytes: Buffer;
}

/** Runs the command-line tool with something on its standard input. */
export function run(args: string[], input: string | Uint8Array = ''): Promise<Ended> {
  return new Promise((resolve, reject) => {
    const child = spawn(process.execPath, [program, ...args], { cwd: folder });
    const out: Buffer[] = [];
    const err: Buffer[] = [];
    child.stdout.on('data', (chunk) => out.push(chunk));
    child.stderr.on('data', (chunk) => err.push(chunk));
    child.on('error', reject);
    child.stdin.on('error', () => {}); // a program that refuses its arguments doesn't read
    child.stdin.end(input);
    child.on('close', (status) => {
      const bytes = Buffer.concat(out);
      resolve({ status, bytes, out: bytes.toString(), err: Buffer.concat(err).toString() });
    });
  });
}

/** The mesh of a file that the tool has written, and what its reader reports. */
export const written = (name: string) => HalfedgeMesh.parse(readFileSync(join(folder, name)));
