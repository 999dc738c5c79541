/** Of a folder with more files, those are taken that come first: a disk that was dropped would take minutes. */
const MOST_FILES = 5000;

/** What was dropped. */
export interface Dropped {
  /** The name of the first folder; null where there are only files. */
  readonly folder: string | null;
  /** All files, with those in folders. */
  readonly files: Promise<File[]>;
}

/** To be called while the event is handled: what it carries is out of reach afterwards. */
export function dropped({ items, files }: DataTransfer): Dropped {
  const entries = [...items]
    .filter(({ kind }) => kind === 'file')
    .map((item) => item.webkitGetAsEntry())
    .filter((entry) => entry !== null);
  const folder = entries.find(({ isDirectory }) => isDirectory);
  if (!folder) return { folder: null, files: Promise.resolve([...files]) };
  return { folder: folder.name, files: filesOf(entries) };
}

/** Those that lie in fewer folders come first. */
async function filesOf(dropped: readonly FileSystemEntry[]): Promise<File[]> {
  const files: File[] = [];
  const queue = [...dropped];
  for (const entry of queue) {
    if (files.length === MOST_FILES) break;
    if (isFile(entry)) files.push(await new Promise((done, fail) => entry.file(done, fail)));
    else if (isFolder(entry)) queue.push(...(await entriesOf(entry)));
  }
  return files;
}

/** By name, as a browser lists them in an order of its own. */
async function entriesOf(folder: FileSystemDirectoryEntry): Promise<FileSystemEntry[]> {
  const reader = folder.createReader();
  const entries: FileSystemEntry[] = [];
  // It hands them out a hundred at a time, and none at the end.
  for (;;) {
    const some = await new Promise<FileSystemEntry[]>((done, fail) =>
      reader.readEntries(done, fail),
    );
    if (some.length === 0) break;
    entries.push(...some);
  }
  return entries.sort((a, b) => (a.name < b.name ? -1 : 1));
}

function isFile(entry: FileSystemEntry): entry is FileSystemFileEntry {
  return entry.isFile;
}

function isFolder(entry: FileSystemEntry): entry is FileSystemDirectoryEntry {
  return entry.isDirectory;
}
