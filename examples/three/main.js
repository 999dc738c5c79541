// A mesh in three.js: read from a file, drawn with its halfedges, picked with the mouse and edited.
// Everything about the mesh is in this file; stage.js has the camera and the lights of any page.

import { HalfedgeMesh, init } from 'halfedge';
import { CirculatorHelper, HalfedgesHelper, MeshGeometry } from 'halfedge/three';
import { DoubleSide, Mesh, MeshStandardMaterial } from 'three';
import { Stage } from './stage.js';

const EDITS = {
  extrude: (f) => mesh.extrudeFace(f, 0.2),
  inset: (f) => mesh.insetFace(f, 0.3),
  poke: (f) => mesh.poke(f, 0.1),
  delete: (f) => mesh.deleteFace(f),
};

await init();
const file = await fetch(new URL('./rook.obj', import.meta.url));
const { mesh } = HalfedgeMesh.parse(await file.arrayBuffer());
mesh.history.enabled = true;
mesh.generations.enabled = true; // so that we notice when the face that was picked is gone

const geometry = new MeshGeometry(mesh, { normals: 'flat' });
const surface = new Mesh(geometry, new MeshStandardMaterial({ roughness: 0.9, side: DoubleSide }));
const arrows = new HalfedgesHelper(mesh, { linewidth: 1.25 });
const outline = new CirculatorHelper(mesh, 'faceHalfedges', 0, { linewidth: 3.5 });
outline.renderOrder = 1; // after the arrows, which lie in the same planes
surface.add(arrows, outline);

const stage = new Stage(document.querySelector('canvas'));
stage.scene.add(surface);
stage.lookAt(surface);

/** A reference to the face that is picked: `faceIndex` is a triangle that three.js draws, `face` one of the mesh. */
let picked;
stage.onClick(surface, (hit) => {
  picked = hit && mesh.generations.reference('face', geometry.face(hit.faceIndex));
  show();
});

const $ = (selector) => document.querySelector(selector);
const buttons = [...document.querySelectorAll('[data-edit]')];

/** Brings picture and text up to date. Returns how many bytes of the surface have changed. */
function show() {
  if (picked && !mesh.generations.isCurrent(picked)) picked = undefined;
  const { bytes } = geometry.update();
  arrows.update();
  outline.visible = picked !== undefined;
  if (picked) {
    outline.item = picked.index;
    outline.update();
  }
  stage.render();

  const { vertexCount, edgeCount, faceCount } = mesh;
  $('#counts').value = `${vertexCount} vertices, ${edgeCount} edges, ${faceCount} faces`;
  $('#picked').value = picked ? describe(picked.index) : 'No face is picked.';
  $('#undo').disabled = !mesh.history.canUndo;
  for (const button of buttons) button.disabled = picked === undefined;
  return bytes;
}

function describe(f) {
  const corners = [...mesh.faceVertices(f)];
  const beside = [...mesh.faceFaces(f)].filter((g) => g >= 0);
  return `Face ${f} has ${corners.length} corners: vertices ${corners.join(', ')}. Beside it: faces ${beside.join(', ')}.`;
}

/** Edits the mesh, or says why that can't be. */
function edit(change) {
  try {
    change();
    $('#uploaded').value = `Sent to the graphics card: ${show().toLocaleString('en')} bytes.`;
  } catch (refusal) {
    $('#uploaded').value = refusal.message;
  }
}

for (const button of buttons) {
  button.addEventListener('click', () => edit(() => EDITS[button.dataset.edit](picked.index)));
}
$('#undo').addEventListener('click', () => edit(() => mesh.history.undo()));

/** The colours of the helpers, which follow those of the page. */
const dark = matchMedia('(prefers-color-scheme: dark)');
function paint() {
  surface.material.color.set(dark.matches ? 0x4a5566 : 0xdfe5ee);
  arrows.color.set(dark.matches ? 0x87a6fb : 0x2485f7);
  arrows.boundaryColor.set(dark.matches ? 0xfe342e : 0x6c1f04);
  for (const color of [outline.color, outline.currentColor]) {
    color.set(dark.matches ? 0x58fecb : 0x046a53);
  }
  show();
}
dark.addEventListener('change', paint);
paint();
