// What lessons on halfedges are made of: queries as running code, operations with their refusals.
// The explorer and `halfedge/figure` use it; knows nothing of the DOM and of three.js.

export {
  type Circulator,
  type CirculatorName,
  circulators,
  hasDirection,
  type Query,
  type QueryGroup,
  queriesFor,
  queryCode,
  type View,
  type Walk,
} from './circulators.js';
export { type Deed, deedName, deedTitle, operandsOf, parseDeed, selectionAfter } from './deeds.js';
export {
  type Dialect,
  type DialectId,
  dialectOf,
  dialects,
  type Items,
  type Step,
} from './dialects.js';
export { type Link, type LinkRole, linksOf, type WalkKey } from './item-links.js';
export {
  factsOf,
  type Item,
  isLive,
  item,
  itemName,
  itemSlots,
  parseItemName,
  sameItem,
  verticesOf,
} from './items.js';
export {
  type Edit,
  motionOf,
  renumbering,
  reversed,
  type StateBefore,
  stateBefore,
} from './motion.js';
export {
  checkOperation,
  type Operands,
  type Operation,
  type Refusal,
  refusalOf,
  runOperation,
  witnessItems,
} from './operation.js';
export { operations, operationsFor } from './operations.js';
export { repairs } from './operations-that-repair.js';
export { CirculatorPlayer, type Visit } from './player.js';
export {
  arrives,
  canRun,
  type Hop,
  type Program,
  programOf,
  run,
  stepOf,
  stepsFirst,
  visit,
} from './program.js';
export { hopWords, startWords } from './words.js';
