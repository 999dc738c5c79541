// The script of a worker: runs the program of a student, and tells what it did. It judges nothing, so that
// nothing that the program does here can change a verdict.

import { load } from '../loader.js';
import { HalfedgeMesh } from '../mesh.js';
import { openPort } from '../port.js';
import { attempt } from './judge/attempt.js';
import { compile, type Program } from './judge/program.js';
import type { Job, Reply } from './messages.js';

const port = openPort<Job, Reply>();
const tell = port.post.bind(port);

port.listen(async (job) => {
  await load(async () => job.module);
  tell({ kind: 'ready' }, []);
  const program = compile(job.code, job.call);
  if (typeof program === 'function') runAll(program, job);
  else tell({ kind: 'fault', fault: program }, []);
  tell({ kind: 'done' }, []);
});

function runAll(program: Program, { terms, trials }: Job): void {
  trials.forEach(({ bytes, calls }, trial) => {
    const mesh = HalfedgeMesh.fromBytes(bytes);
    for (let call = 0; call < calls.length; call++) {
      const outcome = attempt(program, terms, mesh, calls[call]);
      tell({ kind: 'outcome', trial, call, outcome }, []);
      // The first of a mesh is told; where a program hangs, each further call would take its time.
      if (outcome.kind !== 'returned') break;
    }
    mesh.dispose();
  });
}
