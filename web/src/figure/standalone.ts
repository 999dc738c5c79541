// The element in one file for pages without a bundler: the build puts Lit, three.js and the
// WebAssembly module into it.

import { init } from '../inline.js';
import { define } from './define.js';

define(init);

export * from '../inline.js';
export type { FigureStateName } from './attributes.js';
export type { FigureEventMap } from './define.js';
export { HalfedgeFigure } from './element.js';
export type { FigureEvents } from './events.js';
export type { Trail } from './trail-story.js';
