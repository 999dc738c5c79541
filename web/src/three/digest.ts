import type { Core } from '../loader.js';

// To find what an edit has changed among 35 MB of links and positions, a few milliseconds are enough to read
// them once, but not to compare them with a copy: so we keep a digest of 64 bits of each block. JavaScript
// takes ten times as long for that as WebAssembly, which is why this is a program for it, on the memory of
// the core. It is small enough to be written here by hand:
//
//   (func (param $at i32) (param $end i32) (result f64) (local $a i64) ... (local $d i64)
//     (loop while 32 bytes are left: mix the next four words of 8 bytes into $a, $b, $c and $d)
//     (loop while a byte is left: mix it into $a)
//     mix $b, $c and $d into $a, and return it as a number that is not NaN)
//
// where to mix x into y is y = rotl(y ^ x, 29) * MULTIPLIER: a bijection of y for each x.

const AT = 0;
const END = 1;
const FIRST = 2;
const MULTIPLIER = 0x9e3779b97f4a7c15n; // 2^64 divided by the golden ratio
const I32 = 0x7f;
const I64 = 0x7e;
const F64 = 0x7c;

/** A number as WebAssembly writes it (signed LEB128). */
function leb(value: bigint): number[] {
  const bytes: number[] = [];
  for (let rest = value; ; ) {
    const low = Number(rest & 0x7fn);
    rest >>= 7n;
    const isLast = (rest === 0n && low < 64) || (rest === -1n && low >= 64);
    bytes.push(isLast ? low : low | 0x80);
    if (isLast) return bytes;
  }
}

const get = (local: number) => [0x20, local];
const set = (local: number) => [0x21, local];
const i32 = (value: number) => [0x41, ...leb(BigInt(value))];
const i64 = (value: bigint) => [0x42, ...leb(BigInt.asIntN(64, value))];
const [ADD32, LESS_OR_EQUAL, XOR, ROTL, MUL, SHIFT, AS_F64] = [
  0x6a, 0x4d, 0x85, 0x89, 0x7e, 0x88, 0xbf,
];
const word = (offset: number) => [...get(AT), 0x29, 0, offset];
const byte = [...get(AT), 0x31, 0, 0];

const mix = (into: number, value: number[]) => [
  ...get(into),
  ...value,
  XOR,
  ...i64(29n),
  ROTL,
  ...i64(MULTIPLIER),
  MUL,
  ...set(into),
];

/** Does `body` and steps on, as long as so many bytes are left. */
const loop = (step: number, body: number[]) => [
  ...[0x02, 0x40, 0x03, 0x40], // block, loop
  ...[...get(AT), ...i32(step), ADD32, ...get(END), LESS_OR_EQUAL, 0x45, 0x0d, 1], // unless: leave
  ...body,
  ...[...get(AT), ...i32(step), ADD32, ...set(AT), 0x0c, 0], // again
  ...[0x0b, 0x0b],
];

const section = (id: number, content: number[]) => [id, ...leb(BigInt(content.length)), ...content];

function program(): Uint8Array<ArrayBuffer> {
  const code = [
    ...[1, 4, I64], // four locals
    ...loop(
      32,
      [0, 1, 2, 3].flatMap((i) => mix(FIRST + i, word(8 * i))),
    ),
    ...loop(1, mix(FIRST, byte)),
    ...[1, 2, 3].flatMap((i) => mix(FIRST, get(FIRST + i))),
    ...[...get(FIRST), ...i64(2n), SHIFT, AS_F64, 0x0b],
  ];
  return new Uint8Array([
    ...[0x00, 0x61, 0x73, 0x6d, 1, 0, 0, 0],
    ...section(1, [1, 0x60, 2, I32, I32, 1, F64]), // the type of the function
    ...section(2, [1, 1, 0x6d, 1, 0x6d, 2, 0, 0]), // the import "m" "m": a memory of any size
    ...section(3, [1, 0]),
    ...section(7, [1, 1, 0x66, 0, 0]), // the export "f"
    ...section(10, [1, ...leb(BigInt(code.length)), ...code]),
  ]);
}

type Hash = (at: number, end: number) => number;
let compiled: WebAssembly.Module | undefined;
const hashes = new WeakMap<Core, Hash>();

function hashFor(core: Core): Hash {
  let hash = hashes.get(core);
  if (hash === undefined) {
    compiled ??= new WebAssembly.Module(program());
    const { exports } = new WebAssembly.Instance(compiled, { m: { m: core.memory } });
    hash = exports.f as unknown as Hash;
    hashes.set(core, hash);
  }
  return hash;
}

/** The numbers of an array that are told apart: at most these many too many are looked at. */
const BLOCK = 512;

/** Tells which parts of an array in the memory of the core have changed since the last time. */
export class Digest {
  #hashes = new Float64Array(0);
  #length = 0;

  /**
   * Calls `changed` with the ranges of the array that may have changed; what lies outside of them has not,
   * but for one chance in 2^60. The first time, all has. Some 0.1 ms for a MB.
   */
  update(
    core: Core,
    view: ArrayBufferView & { length: number },
    changed: (from: number, to: number) => void,
  ): void {
    const hash = hashFor(core);
    const { length, byteOffset } = view;
    const width = length === 0 ? 1 : view.byteLength / length;
    const blocks = Math.ceil(length / BLOCK);
    const known = Math.min(blocks, this.#hashes.length);
    const before = this.#hashes;
    const old = this.#length;
    if (old !== length) {
      this.#hashes = new Float64Array(blocks);
      this.#hashes.set(before.subarray(0, known));
    }
    for (let i = 0; i < blocks; i++) {
      const end = Math.min(length, (i + 1) * BLOCK);
      const value = hash(byteOffset + width * BLOCK * i, byteOffset + width * end);
      // The hash doesn't tell how many zeros a block begins with, and so not whether one of them is gone.
      const isAsLong = end === Math.min(old, (i + 1) * BLOCK);
      if (i < known && isAsLong && value === this.#hashes[i]) continue;
      this.#hashes[i] = value;
      changed(i * BLOCK, end);
    }
    this.#length = length;
  }
}
