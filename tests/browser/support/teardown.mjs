export { cleanUp as default } from './setup.mjs';
