/** What the program can't do as asked, in one sentence for its user: it ends with status 2. */
export class Complaint extends Error {}

/** Whether an error is one of the operating system, about a file. */
export function isSystemError(error: unknown): error is NodeJS.ErrnoException {
  return error instanceof Error && typeof (error as NodeJS.ErrnoException).code === 'string';
}

/** "no such file or directory (ENOENT)", without the path that Node repeats. */
export function reasonOf(error: NodeJS.ErrnoException): string {
  const reason = /^\w+: ([^,]*)/.exec(error.message)?.[1] ?? error.message;
  return `${reason} (${error.code})`;
}
