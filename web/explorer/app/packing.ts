import { deflateSync, inflateSync, strFromU8, strToU8 } from 'fflate';

/** Bytes, compressed, in letters that an address can have. */
export function packed(bytes: Uint8Array): string {
  const text = btoa(strFromU8(deflateSync(bytes, { level: 9 }), true));
  return text.replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/** The bytes that were packed. Throws for letters that are cut off or changed. */
export function unpacked(text: string): Uint8Array {
  return inflateSync(strToU8(atob(text.replaceAll('-', '+').replaceAll('_', '/')), true));
}
