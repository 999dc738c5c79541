/** Options, as a module has them. */
export const storePrev = false;
