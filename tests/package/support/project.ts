import { cpSync, mkdirSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { capture, root } from '../../../scripts/lib/run.mjs';

/** What setup.mjs has made. */
interface Packed {
  /** The temporary folder. */
  folder: string;
  tarball: string;
  /** The paths in the tarball, sorted. */
  files: string[];
}

export const packed: Packed = JSON.parse(process.env.HALFEDGE_PACKED ?? '{}');

/**
 * A new folder with the given files, in which the package is installed: somebody's project.
 * `files` are texts by path.
 */
export function project(name: string, files: Record<string, string>): string {
  const folder = join(packed.folder, name);
  rmSync(folder, { recursive: true, force: true });
  cpSync(join(packed.folder, 'installed'), folder, { recursive: true });
  for (const [path, text] of Object.entries(files)) {
    mkdirSync(dirname(join(folder, path)), { recursive: true });
    writeFileSync(join(folder, path), text);
  }
  return folder;
}

/** The path of a tool among the repository's own packages: projects have none of their own. */
export const tool = (path: string) => join(root, 'node_modules', path);

/** Installs packages in a project beside ours: links to those of the repository, `others` for some of them. */
export function install(
  folder: string,
  names: readonly string[],
  others: Record<string, string> = {},
): void {
  for (const name of names) {
    const path = join(folder, 'node_modules', name);
    mkdirSync(dirname(path), { recursive: true });
    symlinkSync(tool(others[name] ?? name), path);
  }
}

/** Jest's own settings are not those of somebody's project. */
export const environment = {
  NODE_ENV: undefined,
  FORCE_COLOR: undefined,
  NO_COLOR: '1',
};

/** Runs Node in a project. Returns what it wrote; throws if it failed. */
export async function node(cwd: string, ...args: string[]): Promise<string> {
  const { ok, output } = await tryNode(cwd, ...args);
  if (!ok) throw new Error(`node ${args.join(' ')} failed:\n${output}`);
  return output.trim();
}

/** Runs Node in a project, whether it fails or not. */
export function tryNode(cwd: string, ...args: string[]): Promise<{ ok: boolean; output: string }> {
  return capture(process.execPath, args, { cwd, env: environment });
}
