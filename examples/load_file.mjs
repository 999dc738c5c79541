// Reads an OBJ, OFF, PLY or STL file and tells what is in it: counts, topology, validity, and what had
// to be repaired.
//
//   node examples/load_file.mjs model.obj

import { readFile } from 'node:fs/promises';
import { HalfedgeError, HalfedgeMesh, init } from 'halfedge';

function describe(mesh) {
  const { vertexCount, halfedgeCount, edgeCount, faceCount } = mesh;
  console.log(`vertices              ${vertexCount}`);
  console.log(`halfedges             ${halfedgeCount}`);
  console.log(`edges                 ${edgeCount}`);
  console.log(`faces                 ${faceCount}`);
  console.log(`Euler characteristic  ${mesh.eulerCharacteristic()}`);
  console.log(`components            ${mesh.components().length}`);
  console.log(`boundary loops        ${mesh.boundaryLoops().length}`);
  console.log(`genus                 ${mesh.genus()}`);

  const problems = mesh.validate();
  const isValid = problems.every(({ severity }) => severity !== 'error');
  console.log(`valid                 ${isValid ? 'yes' : 'no'}`);
  for (const { severity, message } of problems) console.log(`${severity}: ${message}`);
}

/** Runs the program; returns a sentence if it can't do what it was asked. */
async function main(path) {
  if (path === undefined) return 'Usage: node examples/load_file.mjs <OBJ, OFF, PLY or STL file>';
  await init();
  let read;
  try {
    read = HalfedgeMesh.parse(await readFile(path));
  } catch (error) {
    if (error instanceof HalfedgeError) return `${path}: ${error.message}`;
    return `${path} can't be read: ${error.message}.`;
  }
  const { mesh, report } = read;
  describe(mesh);
  for (const { message } of report.problems) console.log(`noticed: ${message}`);
  mesh.dispose();
  return undefined;
}

const complaint = await main(process.argv[2]);
if (complaint !== undefined) {
  console.error(complaint);
  process.exitCode = 1;
}
