/**
 * In development, Vite up to 7 serves packages from copies of their JavaScript, without the files beside it:
 * in `node_modules/.vite/deps/`, or deeper in some other folder with a dot (Nuxt, Storybook, Angular).
 * Returns where a file of the package is then, or undefined for a script that is no such copy.
 */
export function originalOf(file: string, script: string): URL | undefined {
  const [, folder] = /^([^?#]*\/)\.[^/?#]+\/(?:[^?#]*\/)?deps\/[^/?#]+/.exec(script) ?? [];
  if (folder === undefined) return undefined;
  const packages = folder.endsWith('/node_modules/') ? folder : `${folder}node_modules/`;
  return new URL(`${packages}halfedge/dist/${file}`);
}
