// `<halfedge-figure>`: importing this entry defines the element. Lit, three.js and three-mesh-bvh are
// peer dependencies of it.

import { init } from '../init.js';
import { define } from './define.js';

define(init);

export type { FigureStateName } from './attributes.js';
export type { FigureEventMap } from './define.js';
export { HalfedgeFigure } from './element.js';
export type { FigureEvents } from './events.js';
export type { Trail } from './trail-story.js';
