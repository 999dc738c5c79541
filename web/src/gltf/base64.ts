const LETTERS = new TextEncoder().encode(
  'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/',
);
const PADDING = 0x3d; // =

/** What `btoa` makes of the letters of bytes, of which making a string takes most of the time. */
export function base64Of(bytes: Uint8Array): string {
  const text = new Uint8Array(4 * Math.ceil(bytes.length / 3));
  for (let i = 0, to = 0; i < bytes.length; i += 3, to += 4) {
    const word = (bytes[i] << 16) | (bytes[i + 1] << 8) | bytes[i + 2]; // none count as 0
    text[to] = LETTERS[word >> 18];
    text[to + 1] = LETTERS[(word >> 12) & 63];
    text[to + 2] = LETTERS[(word >> 6) & 63];
    text[to + 3] = LETTERS[word & 63];
  }
  text.fill(PADDING, text.length - ((3 - (bytes.length % 3)) % 3));
  return new TextDecoder().decode(text);
}
