import { fileError } from './container.js';
import { count, type GltfBuffer, type GltfView, reference, wrong, wrongly } from './document.js';

/** Both names of the extension for views whose bytes lie compressed in another buffer. */
export const MESHOPT = ['EXT_meshopt_compression', 'KHR_meshopt_compression'] as const;

/** The name that all versions of three.js know; what it says is the same. */
const [KNOWN] = MESHOPT;

/** More than that of rows which are decompressed: a few bytes can stand for very many. */
const MOST_BYTES = 2 ** 31;

/** What each mode compresses, and which sizes of rows there may be. */
const MODES: Record<string, (stride: number) => boolean> = {
  ATTRIBUTES: (stride) => stride % 4 === 0 && stride > 0 && stride <= 256,
  TRIANGLES: (stride) => stride === 2 || stride === 4,
  INDICES: (stride) => stride === 2 || stride === 4,
};

/** The name of an extension as three.js is told of it. */
export const knownName = (name: string): string =>
  (MESHOPT as readonly string[]).includes(name) ? KNOWN : name;

export const isCompressed = ({ extensions = {} }: GltfView): boolean => KNOWN in extensions;

/** Checks what a view says of its compressed bytes, and calls the extension by the name that is known. */
export function checkCompressed(
  view: GltfView,
  i: number,
  { buffers }: { readonly buffers: readonly GltfBuffer[] },
): GltfView {
  const { extensions = {}, byteLength } = view;
  const name = MESHOPT.find((candidate) => candidate in extensions);
  if (name === undefined) return view;
  const what = `bufferViews[${i}].extensions.${name}`;
  const {
    buffer,
    byteOffset = 0,
    byteLength: bytes,
    byteStride,
    count: rows,
    mode,
  } = extensions[name];
  const source = buffers[reference(`${what}.buffer`, buffer, buffers.length)];
  const end = count(`${what}.byteOffset`, byteOffset) + count(`${what}.byteLength`, bytes);
  if (end > source.byteLength) {
    throw wrongly(what, `bytes up to ${end}`, `at most ${source.byteLength} of buffer ${buffer}`);
  }
  const fits = Object.hasOwn(MODES, String(mode)) ? MODES[mode as string] : undefined;
  if (fits === undefined) throw wrong(`${what}.mode`, mode, Object.keys(MODES).join(', '));
  const stride = count(`${what}.byteStride`, byteStride);
  if (!fits(stride)) throw wrong(`${what}.byteStride`, stride, `a size of rows of ${mode}`);
  const size = count(`${what}.count`, rows) * stride;
  if (size < byteLength) {
    throw wrongly(
      what,
      `${size} bytes, ${rows} rows of ${stride}`,
      `${byteLength} as the view has`,
    );
  }
  if (size > MOST_BYTES) {
    throw fileError(
      'too-large',
      `glTF: ${what} has ${size} bytes, expected at most ${MOST_BYTES}.`,
    );
  }
  const { [name]: compressed, ...others } = extensions;
  return { ...view, extensions: { ...others, [KNOWN]: compressed } };
}
