import { HalfedgeError } from '../errors.js';
import { messageOf } from '../loader.js';

/** three.js, which is loaded when it is needed first: it is no dependency of the rest. */
export async function loadThree() {
  return orSentence(() => import('three'));
}

/** Its loader of glTF files. */
export async function loadLoader() {
  return orSentence(() => import('three/addons/loaders/GLTFLoader.js'));
}

/** The decoder of meshopt that comes with it. */
export async function loadMeshoptDecoder(): Promise<object> {
  const load = () => import('three/addons/libs/meshopt_decoder.module.js');
  return (await orSentence(load)).MeshoptDecoder;
}

/** Its writer of glTF files. */
export async function loadExporter() {
  return orSentence(() => import('three/addons/exporters/GLTFExporter.js'));
}

async function orSentence<T>(load: () => Promise<T>): Promise<T> {
  try {
    return await load();
  } catch (cause) {
    throw new HalfedgeError(
      'missing-dependency',
      `glTF files are read and written with three.js, which can't be loaded here (${messageOf(cause)}): \`npm install three\`.`,
      { cause },
    );
  }
}
