import { HalfedgeError, init } from 'halfedge';

/** Something that is beside the page could not be fetched. */
export class NotFetched extends Error {}

/** What is fetched when it is needed for the first time. */
export const GLTF_READER = 'The part of the page that reads glTF';
export const LARGE_FILE_READER = 'The part of the page that reads large files';

/** What is fetched; throws a sentence about `what` where that fails. */
export async function fetching<T>(what: string, result: Promise<T>): Promise<T> {
  try {
    return await result;
  } catch (cause) {
    throw notFetched(what, cause);
  }
}

/** Makes the package ready, unless it is; after a failure it is tried again. */
export async function loadPackage(): Promise<void> {
  try {
    await init();
  } catch (error) {
    // Otherwise it came, but is no WebAssembly that runs here.
    if (!(error instanceof HalfedgeError && error.cause instanceof TypeError)) throw error;
    throw notFetched('The WebAssembly module of the page', error);
  }
}

/** An error of the package, as what it is in this page, which has all that the package needs: a part was not fetched. */
export function ofPage(error: unknown): unknown {
  if (!(error instanceof HalfedgeError)) return error;
  const { code, message } = error;
  if (code === 'missing-dependency') return notFetched(GLTF_READER, error);
  const isScript = code === 'worker-failed' && message.includes('script could not be loaded');
  return isScript ? notFetched(LARGE_FILE_READER, error) : error;
}

/** What can be done about an error; null where there is nothing but to open another mesh. */
export function adviceFor(error: unknown): string | null {
  if (error instanceof NotFetched) return 'Try again when you are online, or reload the page then.';
  if (!(error instanceof HalfedgeError)) return null;
  const isUnusable = error.code === 'init-failed' || error.code === 'not-webassembly';
  return isUnusable ? 'Reload the page, or open it in another browser.' : null;
}

function notFetched(what: string, cause: unknown): NotFetched {
  return new NotFetched(`${what} could not be fetched.`, { cause });
}
