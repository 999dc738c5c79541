// The script of a worker: makes meshes of files and soups, and sends their bytes. `halfedge/worker` is
// the other side.

import { load } from './loader.js';
import { HalfedgeMesh } from './mesh.js';
import { openPort } from './port.js';
import type { ParseStage } from './progress.js';
import type { RepairReport } from './repair.js';
import { isBlob, type Job, type Reply, type Request, toSent } from './worker-messages.js';

const port = openPort<Request, Reply>();
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
