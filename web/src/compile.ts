import { bytesOf, describe } from './arguments.js';
import { HalfedgeError } from './errors.js';
import { messageOf } from './loader.js';
import { nodeModule } from './node-module.js';
import { checkOptions, isPlain } from './options.js';

declare global {
  // The types of the browser have these. A consumer in Node may do without them, but not without names.
  interface URL {}
  namespace WebAssembly {
    interface Module {}
    interface Instance {}
    interface Memory {}
  }
}

/** Where the WebAssembly module comes from; by default `core.wasm` beside this file. */
export interface InitOptions {
  /**
   * An address (a `URL` or a string; in Node a string without a scheme is a file path), the bytes of
   * `core.wasm`, or a module compiled from them (such as one sent to a worker).
   */
  wasm?: URL | string | ArrayBuffer | Uint8Array | WebAssembly.Module | undefined;
}

/** What a module can be compiled from. */
type Source = URL | string | Uint8Array | WebAssembly.Module;

/** The `wasm` of the options, whatever was passed as options; undefined where it is left out. */
export function wasmOption(options: InitOptions): Source | undefined {
  if (!isPlain(options)) {
    throw new TypeError(`options is ${describe(options)}; expected an object such as { wasm }.`);
  }
  const { wasm } = checkOptions<InitOptions>(options, { wasm: true });
  if (wasm === undefined || typeof wasm === 'string' || isModule(wasm)) return wasm;
  if (Object.prototype.toString.call(wasm) === '[object URL]') return wasm as URL;
  const bytes = bytesOf('wasm', wasm);
  if (bytes !== undefined) return bytes;
  throw new TypeError(
    `wasm is ${describe(wasm)}; expected a URL, a string, an ArrayBuffer, a Uint8Array or a WebAssembly.Module.`,
  );
}

/** Also of a module of another realm. */
function isModule(source: unknown): source is WebAssembly.Module {
  const tag = Object.prototype.toString.call(source);
  return source instanceof WebAssembly.Module || tag === '[object WebAssembly.Module]';
}

/** Compiles what `init` was given. `name` is what bytes are called in messages. */
export async function moduleFrom(source: Source, name = 'wasm'): Promise<WebAssembly.Module> {
  if (isModule(source)) return source;
  if (typeof source === 'string') return moduleAt(resolve(source));
  const bytes = bytesOf(name, source);
  return bytes === undefined ? moduleAt(source as URL) : fromBytes(bytes, name);
}

function resolve(address: string): URL {
  try {
    // A scheme has two letters at least: C:\ is a drive.
    if (/^[a-z][a-z0-9+.-]+:/i.test(address)) return new URL(address);
    const fromPath = nodeModule('node:url')?.pathToFileURL;
    if (fromPath !== undefined) return fromPath(address);
    return new URL(address, globalThis.document?.baseURI ?? globalThis.location.href);
  } catch (cause) {
    throw new HalfedgeError(
      'init-failed',
      `wasm is ${describe(address)}; expected an address that can be resolved here.`,
      { cause },
    );
  }
}

/** Compiles what is at an address. `advice` follows where nothing is there, or something else. */
export async function moduleAt(url: URL, advice = ''): Promise<WebAssembly.Module> {
  const files = url.protocol === 'file:' ? nodeModule('node:fs/promises') : undefined;
  if (files !== undefined) {
    return fromBytes(await loaded(url, files.readFile(url), advice), url.href, advice);
  }
  // webpack and Turbopack make an address of this kind, which only a page can complete.
  if (url.protocol === '' && globalThis.location === undefined) {
    throw new HalfedgeError(
      'init-failed',
      `The WebAssembly module can't be loaded from ${shorten(url.href)}: a bundler has made that an address for pages, and this is a server. ` +
        "Import from 'halfedge/inline', or leave the package out of the server's bundle (in Next.js by serverExternalPackages).",
    );
  }
  const response = await loaded(url, fetch(url), advice);
  if (!response.ok) {
    const isGone = response.status === 404 || response.status === 410;
    throw new HalfedgeError(
      'init-failed',
      `The WebAssembly module can't be loaded from ${shorten(url.href)}: the server answered ${response.status} ${response.statusText}`.trimEnd() +
        `; expected core.wasm there.${isGone ? advice : ''}`,
    );
  }
  // Compiling while loading needs this type. If it fails, the bytes tell why.
  if (/^application\/wasm\b/i.test(response.headers.get('content-type') ?? '')) {
    try {
      return await WebAssembly.compileStreaming(response.clone());
    } catch {
      // As below: not WebAssembly, or a server that lies about its type.
    }
  }
  return fromBytes(new Uint8Array(await loaded(url, response.arrayBuffer())), url.href, advice);
}

async function loaded<T>(url: URL, result: Promise<T>, advice = ''): Promise<T> {
  try {
    return await result;
  } catch (cause) {
    throw new HalfedgeError(
      'init-failed',
      `The WebAssembly module can't be loaded from ${shorten(url.href)}: ${reasonOf(cause)}.${mayBeMissing(url, cause) ? advice : ''}`,
      { cause },
    );
  }
}

/** What an error says, and its cause: `fetch` of Node says no more than that it failed. */
function reasonOf(error: unknown): string {
  const { cause } = Object(error) as { cause?: { message?: unknown } };
  return [error, ...(cause?.message ? [cause] : [])].map(messageOf).join(': ');
}

/** Whether that may be what failed. A server would have answered; an extension, say, doesn't tell. */
function mayBeMissing({ protocol }: URL, cause: unknown): boolean {
  const { code } = Object(cause) as { code?: unknown };
  if (typeof code === 'string') return code === 'ENOENT' || code === 'ENOTDIR';
  return !/^https?:$/.test(protocol);
}

async function fromBytes(
  bytes: Uint8Array,
  origin: string,
  advice = '',
): Promise<WebAssembly.Module> {
  if (bytes[0] !== 0 || bytes[1] !== 0x61 || bytes[2] !== 0x73 || bytes[3] !== 0x6d) {
    throw new HalfedgeError(
      'not-webassembly',
      `What was loaded from ${shorten(origin)} is not WebAssembly: ${opening(bytes)}; expected the bytes 00 61 73 6d. ` +
        `Is core.wasm deployed there, or does the server answer with a page?${advice}`,
    );
  }
  try {
    return await WebAssembly.compile(unshared(bytes));
  } catch (cause) {
    throw new HalfedgeError(
      'init-failed',
      `The WebAssembly module from ${shorten(origin)} can't be compiled: ${messageOf(cause)}.${remedy(cause)}`,
      { cause },
    );
  }
}

/** What to do where WebAssembly may not be compiled. */
function remedy(cause: unknown): string {
  const message = messageOf(cause);
  // What browsers say names other words of old, or none.
  if (/Content.Security.Policy|\bCSP\b/i.test(message)) {
    return " In that policy, script-src needs 'wasm-unsafe-eval'.";
  }
  if (!/disallowed by embedder/.test(message)) return '';
  return " Where programs may not compile, as in Cloudflare Workers, import the compiled module from 'halfedge/core.wasm' and pass it to init({ wasm }).";
}

/** Shared memory can't be compiled from. */
function unshared(bytes: Uint8Array): Uint8Array<ArrayBuffer> {
  const shared = Object.prototype.toString.call(bytes.buffer) === '[object SharedArrayBuffer]';
  return shared ? new Uint8Array(bytes) : (bytes as Uint8Array<ArrayBuffer>);
}

/** How a file begins, as text where it is text. */
function opening(bytes: Uint8Array): string {
  if (bytes.length === 0) return 'it is empty';
  const first = bytes.subarray(0, 24);
  if (first.every((byte) => (byte >= 0x20 && byte < 0x7f) || byte === 0x0a || byte === 0x0d)) {
    return `it begins with ${JSON.stringify(String.fromCharCode(...first))}`;
  }
  const hex = Array.from(first.subarray(0, 8), (byte) => byte.toString(16).padStart(2, '0'));
  return `it begins with the bytes ${hex.join(' ')}`;
}

const shorten = (address: string) =>
  address.length <= 200 ? address : `${address.slice(0, 197)}...`;
