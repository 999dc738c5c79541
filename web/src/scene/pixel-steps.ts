// Lengths of a pixel go in steps, so that what is sized by them stays as it is while the camera moves a little: arrows
// come out an eighth of a pixel too large or too small at most.

/** Of the bits of a length as a 32-bit float, those that don't matter: 64 steps lie between it and its double. */
const FINER_BITS = 17;

const float = new Float32Array(1);
const bits = new Int32Array(float.buffer);

/** Which step is nearest to the length of a pixel: a positive integer of at most 14 bits. */
export function stepOfPixel(pixel: number): number {
  float[0] = pixel;
  return (bits[0] + (1 << (FINER_BITS - 1))) >> FINER_BITS;
}

export function pixelOfStep(step: number): number {
  bits[0] = step << FINER_BITS;
  return float[0];
}
