// The script of a worker: makes meshes of files and soups, and sends their bytes. `halfedge/worker` is
// the other side.

import { load } from './loader.js';
import { HalfedgeMesh } from './mesh.js';
import type { ParseStage } from './progress.js';
import type { RepairReport } from './repair.js';
import { isBlob, type Job, type Reply, type Request, toSent } from './worker-messages.js';

/** This end of the connection. */
interface Port {
  post(reply: Reply, transfer: object[]): void;
  listen(listener: (request: Request) => void): void;
}

/** In a browser the global object, in Node one of its modules: not imported, as a bundler would follow. */
function openPort(): Port {
  const { process } = globalThis as { process?: { getBuiltinModule?(name: string): unknown } };
  const threads = process?.getBuiltinModule?.('node:worker_threads');
  const { parentPort } = (threads ?? {}) as { parentPort?: NodePort };
  if (parentPort) {
    return {
      post: (reply, transfer) => parentPort.postMessage(reply, transfer),
      listen: (listener) => parentPort.on('message', listener),
    };
  }
  const scope = globalThis as unknown as WebScope;
  return {
    post: (reply, transfer) => scope.postMessage(reply, transfer),
    listen: (listener) => scope.addEventListener('message', ({ data }) => listener(data)),
  };
}

interface NodePort {
  postMessage(reply: Reply, transfer: object[]): void;
  on(type: 'message', listener: (request: Request) => void): void;
}
interface WebScope {
  postMessage(reply: Reply, transfer: object[]): void;
  addEventListener(type: 'message', listener: (event: { data: Request }) => void): void;
}

const port = openPort();
let started: Promise<void> = Promise.resolve();

port.listen((request) => {
  if (request.kind === 'start') {
    started = load(async () => request.module);
    started.catch(() => {}); // the first job tells
  } else {
    void answer(request);
  }
});

async function answer(job: Job): Promise<void> {
  try {
    await started;
    const { mesh, report } = await meshOf(job);
    let bytes: Uint8Array;
    try {
      bytes = mesh.toBytes();
    } finally {
      mesh.dispose();
    }
    const { vertexMap, vertexOrigin, faceMap } = report;
    const transfer = [bytes, vertexMap, vertexOrigin, faceMap].map(({ buffer }) => buffer);
    port.post({ kind: 'done', bytes, report }, transfer);
  } catch (error) {
    port.post({ kind: 'failed', error: toSent(error) }, []);
  }
}

async function meshOf(job: Job): Promise<{ mesh: HalfedgeMesh; report: RepairReport }> {
  if (job.kind === 'soup') {
    return HalfedgeMesh.fromSoup(job.positions as number[], job.faces as number[], job.options);
  }
  const data = isBlob(job.data) ? await job.data.arrayBuffer() : (job.data as Uint8Array);
  const onProgress = (fraction: number, stage: ParseStage) =>
    port.post({ kind: 'progress', fraction, stage }, []);
  return HalfedgeMesh.parse(data, job.tells ? { ...job.options, onProgress } : job.options);
}
