import { type Browser, chromium } from 'playwright-core';

let connection: Promise<Browser> | undefined;

/** The Chromium of this worker of Jest, which the files that it runs share, one after the other. */
export function connect(): Promise<Browser> {
  const endpoints: string[] = JSON.parse(process.env.HALFEDGE_CHROMIUM ?? '[]');
  const worker = Number(process.env.JEST_WORKER_ID ?? 1);
  connection ??= chromium.connect(endpoints[(worker - 1) % endpoints.length]);
  return connection;
}

/** To be called after all tests of a file. */
export async function disconnect(): Promise<void> {
  await (await connection)?.close();
  connection = undefined;
}
