import { HalfedgeError } from '../index.js';

/** What the program can't do as asked, in one sentence for its user: it ends with status 2. */
export class Complaint extends Error {}

/** Does a part of the work on a file; what the package refuses becomes a complaint that names the file. */
export function orComplain<T>(file: string, work: () => T): T {
  const complain = (error: unknown): never => {
    if (!(error instanceof HalfedgeError)) throw error;
    throw new Complaint(`${file}: ${error.message}`, { cause: error });
  };
  try {
    const done = work();
    return done instanceof Promise ? (done.catch(complain) as T) : done;
  } catch (error) {
    return complain(error);
  }
}

/** Whether an error is one of the operating system, about a file. */
export function isSystemError(error: unknown): error is NodeJS.ErrnoException {
  return error instanceof Error && typeof (error as NodeJS.ErrnoException).code === 'string';
}

/** "no such file or directory (ENOENT)", without the path that Node repeats. */
export function reasonOf(error: NodeJS.ErrnoException): string {
  const reason = /^\w+: ([^,]*)/.exec(error.message)?.[1] ?? error.message;
  return `${reason} (${error.code})`;
}

/** Why nothing could be written there. */
export function unwritable(where: string, error: NodeJS.ErrnoException): string {
  return `${where} can't be written: ${reasonOf(error)}.`;
}
