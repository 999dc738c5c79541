import { type ChildProcess, spawn } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname, join } from 'node:path';
import { environment } from './project.js';

/** A policy under which the package must work: no eval, no inline scripts, WebAssembly allowed. */
export const STRICT_POLICY = "script-src 'self' 'wasm-unsafe-eval'";

const types: Record<string, string> = {
  '.html': 'text/html; charset=utf-8',
  '.css': 'text/css',
  '.js': 'text/javascript',
  '.mjs': 'text/javascript',
  '.json': 'application/json',
  '.wasm': 'application/wasm',
};

export interface Answer {
  status?: number;
  type?: string;
  body?: string;
}

export interface RunningServer {
  /** Ends with a slash. */
  readonly address: string;
  close(): Promise<void>;
}

/**
 * Serves the files below a folder. `policy` is sent as Content-Security-Policy, `origins` are those
 * whose scripts may read it all; `answers` replace (parts of) what is sent for paths that end so.
 */
export async function serve(
  folder: string,
  {
    policy,
    origins,
    answers = {},
  }: { policy?: string; origins?: string; answers?: Record<string, Answer> } = {},
): Promise<RunningServer> {
  const server = createServer((request, response) => {
    const path = new URL(request.url ?? '/', 'http://localhost').pathname;
    const file = path.endsWith('/') ? `${path}index.html` : path;
    const [, answer] = Object.entries(answers).find(([end]) => file.endsWith(end)) ?? [];
    if (policy !== undefined) response.setHeader('Content-Security-Policy', policy);
    if (origins !== undefined) response.setHeader('Access-Control-Allow-Origin', origins);
    try {
      const body = answer?.body ?? readFileSync(join(folder, decodeURIComponent(file)));
      response.setHeader('Content-Type', answer?.type ?? types[extname(file)] ?? 'text/plain');
      response.writeHead(answer?.status ?? 200).end(body);
    } catch {
      response.writeHead(404).end('Not found');
    }
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  const { port } = server.address() as AddressInfo;
  return {
    address: `http://127.0.0.1:${port}/`,
    close: () =>
      new Promise((resolve) => {
        server.close(() => resolve());
        server.closeAllConnections();
      }),
  };
}

/** Runs a Node program that serves a project and prints its address, such as Vite. */
export async function serveWith(cwd: string, ...args: string[]): Promise<RunningServer> {
  const child = spawn(process.execPath, args, {
    cwd,
    env: { ...process.env, ...environment },
    stdio: ['ignore', 'pipe', 'pipe'],
  });
  const ended = new Promise<void>((resolve) => child.on('close', () => resolve()));
  const close = async () => {
    child.kill();
    await ended;
  };
  try {
    return { address: await printedAddress(child), close };
  } catch (error) {
    await close();
    throw error;
  }
}

function printedAddress(child: ChildProcess): Promise<string> {
  return new Promise((resolve, reject) => {
    let output = '';
    const fail = (why: string) => reject(new Error(`The server ${why}:\n${output}`));
    const timer = setTimeout(() => fail('named no address in a minute'), 60_000);
    for (const stream of [child.stdout, child.stderr]) {
      stream?.setEncoding('utf8').on('data', (text: string) => {
        output += text;
        const address = /http:\/\/127\.0\.0\.1:\d+\//.exec(output)?.[0];
        if (address === undefined) return;
        clearTimeout(timer);
        resolve(address);
      });
    }
    child.on('close', (status) => {
      clearTimeout(timer);
      fail(`ended (${status})`);
    });
  });
}
